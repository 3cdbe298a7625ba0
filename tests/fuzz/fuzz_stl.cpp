// Any bytes as an STL file: a mesh whose indices hold, or an Error; and what was read is written
// and read the same again.
#include "core/process/error.h"
#include "mesh/format/stl.h"
#include "mesh/solid/check.h"

#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    const mrsim::TriMesh mesh = mrsim::parse_stl(bytes, "fuzz.stl");
    const mrsim::MeshSummary summary = mrsim::check_mesh(mesh, 1);
    MRSIM_ASSERT(summary.components > 0);
    std::string again;
    mrsim::write_stl(mesh, [&](const void* part, std::size_t n) {
      again.append(static_cast<const char*>(part), n);
    });
    const mrsim::TriMesh back = mrsim::parse_stl(again, "fuzz.stl");
    MRSIM_ASSERT(back.vertices == mesh.vertices && back.triangles == mesh.triangles);
  } catch (const mrsim::Error&) {
  }
  return 0;
}
