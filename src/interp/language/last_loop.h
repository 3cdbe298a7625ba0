// The loop that came back last: what to look at where a program runs into its limit of steps.
// Private to src/interp.
#pragma once

#include "interp/language/program_outline.h"

#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace mrsim {

class LastLoop {
 public:
  /// A jump leads back to `begin` in this file of the program.
  void come_back(int file, const Place& begin) {
    if (file_ != file || begin_ != begin) passes_ = 0;
    file_ = file;
    begin_ = begin;
    ++passes_;
  }
  /// ": the loop ...", or nothing, where the program is in another file now or most of its `steps`
  /// were taken by others.
  std::string text(int file, std::uint64_t steps) const {
    constexpr std::uint64_t kMostSteps = 100;  // of a pass
    if (file_ != file || kMostSteps * passes_ < steps) return "";
    return fmt::format(": the loop that begins in line {} has come back {} times", begin_.line + 1,
                       passes_);
  }

 private:
  int file_ = -1;
  Place begin_;
  std::uint64_t passes_ = 0;  ///< in a row
};

}  // namespace mrsim
