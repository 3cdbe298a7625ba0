#include "core/process/error.h"

#include <fmt/format.h>

namespace mrsim {

Error::Error(std::string code, const std::string& text, Kind kind)
    : std::runtime_error(text), code_(std::move(code)), kind_(kind) {}
Error::~Error() = default;
PlacedError::PlacedError(Diagnostic diagnostic, Kind kind)
    : Error(diagnostic.code, diagnostic.text, kind), diagnostic_(std::move(diagnostic)) {}
PlacedError::~PlacedError() = default;
InternalError::~InternalError() = default;

void assertion_failed(const char* condition, const char* file, int line) {
  throw InternalError(
      fmt::format("internal error: {} does not hold ({}:{})", condition, file, line));
}

}  // namespace mrsim
