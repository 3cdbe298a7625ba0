// Faults: mrsim::Error (types.h) for files, options and machines; Diagnostic for findings in a
// program; MRSIM_ASSERT for our own.
#pragma once

#include <mrsim/types.h>

namespace mrsim {

/// Thrown by MRSIM_ASSERT: a broken invariant, never the user's fault (exit 3).
class MRSIM_API InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
  ~InternalError() override;
};

[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace mrsim

#define MRSIM_ASSERT(condition) \
  ((condition) ? void() : ::mrsim::assertion_failed(#condition, __FILE__, __LINE__))
