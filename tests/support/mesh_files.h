// A part as the bytes of every mesh format, and what reading says of bytes.
#pragma once

#include "mesh/format/glb.h"
#include "mesh/format/mesh_io.h"
#include "mesh/format/obj.h"
#include "mesh/format/off.h"
#include "mesh/format/ply.h"
#include "mesh/format/threemf.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <string>

namespace mrsim::testing {

/// A tube whose faces have owners, and an origin with names that formats have to quote.
inline TriMesh format_part() {
  TriMesh m = tube_mesh(30, 10, 5, 0.1, 7);
  for (std::size_t f = 0; f < m.triangles.size(); ++f) m.owners.push_back(int(f / 40) * 3 - 1);
  m.origin.files = {"data/PRIMER_2F.MPF", "a & <b>.spf"};
  m.origin.tools = {"4", "T \"7\""};
  for (int owner = 2; owner < 17; owner += 3)
    m.origin.origins.push_back({owner, owner % 2, 10 + owner, (owner + 1) % 2});
  return m;
}

inline std::string bytes_as(MeshFormat format, const TriMesh& m, ColorBy color = ColorBy::none) {
  return bytes_of([&](const ByteSink& out) {
    if (format == MeshFormat::obj) write_obj(m, out);
    if (format == MeshFormat::off) write_off(m, out);
    if (format == MeshFormat::ply) write_ply(m, color, out);
    if (format == MeshFormat::threemf) write_3mf(m, color, out);
    if (format == MeshFormat::glb) write_glb(m, {.color = color}, out);
  });
}
/// Code of the error with which `bytes` are refused, "" where they are read.
inline std::string parse_code(const std::string& bytes, MeshFormat format) {
  return error_code([&] { parse_mesh(bytes, format, "part"); });
}

}  // namespace mrsim::testing
