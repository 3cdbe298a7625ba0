// tools.toml and the words of --tool and --stock: any bytes give a table or an Error.
#include "setup/stock_spec.h"
#include "setup/tool_spec.h"
#include "setup/tools_file.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

template <class Body>
static void expect_error_at_most(Body body) {
  try {
    body();
  } catch (const mrsim::Error&) {
  }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  expect_error_at_most([&] { mrsim::parse_tools(text, "fuzz.toml"); });
  const std::string line = text.substr(0, text.find('\n'));
  expect_error_at_most([&] { mrsim::parse_tool_spec(line); });
  expect_error_at_most([&] { mrsim::parse_stock_spec(line); });
  return 0;
}
