// Any bytes as a program, recognised and in three of ten dialects and machines that its bytes
// choose.
#include "interp_checks.h"

#include <cstdint>
#include <functional>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mrsim::fuzz;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  write_program(text);
  mrsim::InterpOptions options;
  options.max_blocks = 3000;
  read_program(options);
  const std::size_t chosen = std::hash<std::string_view>()(text);
  for (int i = 0; i < 3; ++i) read_program(options_of(static_cast<int>((chosen + 3 * i) % 10)));
  return 0;
}
