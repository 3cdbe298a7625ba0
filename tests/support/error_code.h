// What a call throws, as tests compare it.
#pragma once

#include "core/process/error.h"

#include <functional>
#include <string>

#include <gtest/gtest.h>

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

/// Text of the usage Error of that code that `body` throws, "" when it throws none.
inline std::string usage_fault(const char* code, const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    EXPECT_EQ(error.kind(), Error::Kind::usage);
    return error.what();
  }
  return "";
}

/// "line:column code text" of the fault in `file` that `body` throws, "" when it throws none.
inline std::string placed_fault(const char* file, const std::function<void()>& body) {
  try {
    body();
  } catch (const PlacedError& error) {
    const Diagnostic& d = error.diagnostic();
    EXPECT_EQ(d.place.file, file);
    return std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " + d.code +
           " " + d.text;
  }
  return "";
}

}  // namespace mrsim::testing
