#include "core/output/real_path.h"

#include <algorithm>
#include <system_error>

namespace mrsim {

namespace fs = std::filesystem;

fs::path real_path(const fs::path& path) {
  std::error_code failed, ignored;
  fs::path at = fs::absolute(path, failed);
  // A link to what does not exist yet, which weakly_canonical() leaves as it is.
  for (int k = 0; k < kMostLinks && !failed && fs::is_symlink(at, ignored); ++k)
    at = at.parent_path() / fs::read_symlink(at, failed);
  if (!failed) at = fs::weakly_canonical(at, failed);
  return failed ? path : at;
}

bool lies_in(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

}  // namespace mrsim
