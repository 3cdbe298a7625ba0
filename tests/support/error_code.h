// What a call throws, as tests compare it.
#pragma once

#include "core/process/error.h"

#include <functional>
#include <string>

namespace mrsim::testing {

/// Code of the Error that `body` throws, "" when it throws none.
inline std::string error_code(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    return error.code();
  }
  return "";
}

}  // namespace mrsim::testing
