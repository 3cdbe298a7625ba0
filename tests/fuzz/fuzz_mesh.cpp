// Any bytes as a file of the other formats; the first byte chooses which. A mesh that can be
// checked, taken to pieces and recognised, or an Error.
#include "core/process/error.h"
#include "mesh/format/mesh_io.h"
#include "mesh/solid/check.h"
#include "mesh/solid/pieces.h"
#include "mesh/solid/solid_repair.h"
#include "removal/stock/recognise_stock.h"

#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  constexpr mrsim::MeshFormat kFormats[] = {mrsim::MeshFormat::obj, mrsim::MeshFormat::ply,
                                            mrsim::MeshFormat::off, mrsim::MeshFormat::threemf,
                                            mrsim::MeshFormat::glb};
  try {
    mrsim::TriMesh mesh = mrsim::parse_mesh(bytes, kFormats[data[0] % 5], "fuzz");
    const mrsim::MeshSummary summary = mrsim::check_mesh(mesh, 1);
    MRSIM_ASSERT(summary.components > 0);
    mrsim::recognise_stock(mesh);
    if (summary.closed && summary.oriented) mrsim::find_pieces(mesh);
    if (mesh.triangles.size() > 10000) return 0;
    mrsim::make_solid(mesh, "fuzz");  // or an Error
    MRSIM_ASSERT(mrsim::check_mesh(mesh, 1).oriented);
    mrsim::require_clean_bodies(mesh, "fuzz");
  } catch (const mrsim::Error&) {
  }
  return 0;
}
