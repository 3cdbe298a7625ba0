// A .vdb stock: the file's head and metadata, and the recipe without the check sum that would
// refuse nearly all mutants. What is read is written again, the same.
#include "core/process/error.h"
#include "removal/part/recipe_codec.h"
#include "removal/part/stock_file.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    mrsim::read_vdb(bytes, "fuzz.vdb");
  } catch (const mrsim::Error&) {
  }
  try {
    const std::string again = mrsim::encode_recipe(mrsim::decode_recipe(bytes, "fuzz.vdb"));
    MRSIM_ASSERT(mrsim::encode_recipe(mrsim::decode_recipe(again, "again")) == again);
  } catch (const mrsim::Error&) {
  }
  return 0;
}
