// job.toml: any bytes give a job or an Error with its place.
#include "setup/job_file.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    mrsim::parse_job({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
  } catch (const mrsim::Error&) {
  }
  return 0;
}
