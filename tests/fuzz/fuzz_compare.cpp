// Any bytes as the mesh of a part, compared with a cube and the cube with it: figures that are
// numbers and bounds in order, or an Error. The first byte chooses format and alignment.
#include "core/process/error.h"
#include "mesh/format/mesh_io.h"
#include <mrsim/compare.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

using namespace mrsim;

TriMesh cube() {
  TriMesh mesh;
  for (unsigned i = 0; i < 8; ++i)
    mesh.vertices.push_back({i & 1 ? 10.0F : 0, i & 2 ? 10.0F : 0, i & 4 ? 10.0F : 0});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

void check(const Comparison& found) {
  for (const DeviationFigures* f : {&found.part, &found.nominal})
    MRSIM_ASSERT(std::isfinite(f->min) && f->min <= f->max && std::isfinite(f->max));
  for (const HausdorffBound* h : {&found.part_to_nominal, &found.nominal_to_part})
    MRSIM_ASSERT(h->lower >= 0 && h->lower <= h->upper && std::isfinite(h->upper));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr MeshFormat kFormats[] = {MeshFormat::stl, MeshFormat::obj, MeshFormat::ply,
                                     MeshFormat::off};
  CompareOptions options;
  options.samples = 200;
  options.threads = 1;
  options.align = static_cast<Alignment>(data[0] / 4 % 3);
  try {
    const TriMesh mesh =
        parse_mesh({reinterpret_cast<const char*>(data) + 1, size - 1}, kFormats[data[0] % 4], "f");
    if (mesh.triangles.size() > 200) return 0;
    check(compare(mesh, cube(), options));
    check(compare(cube(), mesh, options));
  } catch (const Error&) {
  }
  return 0;
}
