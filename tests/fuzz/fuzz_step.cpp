// Any bytes as a STEP file: a closed mesh that is recognised as a stock, or an Error. Each is read
// in a process of its own, which tells libFuzzer nothing of what it reached: the corpus does not
// grow, and a second sees some tens of inputs.
#include "fuzz_files.h"
#include <mrsim/solid_files.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mrsim;
  const std::string path = fuzz::write("part.step", {reinterpret_cast<const char*>(data), size});
  try {
    const TriMesh mesh = read_step(path, 0.5);
    fuzz::require(!mesh.triangles.empty());
    for (const auto& vertex : mesh.vertices)
      for (const float x : vertex) fuzz::require(std::isfinite(x));
  } catch (const Error&) {
  }
  return 0;
}
