#include "mesh/format/mesh_io.h"

#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/text/text_io.h"
#include "mesh/format/glb.h"
#include "mesh/format/obj.h"
#include "mesh/format/off.h"
#include "mesh/format/ply.h"
#include "mesh/format/stl.h"
#include "mesh/format/text_scan.h"
#include "mesh/format/threemf.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::pair<std::string_view, MeshFormat> kExtensions[] = {
    {".stl", MeshFormat::stl}, {".obj", MeshFormat::obj},     {".ply", MeshFormat::ply},
    {".off", MeshFormat::off}, {".3mf", MeshFormat::threemf}, {".glb", MeshFormat::glb}};

// Bytes that a .glb takes while it is written, as measured.
constexpr double kGlbTriangle = 160;

}  // namespace

MeshFormat mesh_format_of(const std::string& path, std::string_view also) {
  const std::size_t slash = path.find_last_of('/');
  const std::string file = slash == path.npos ? path : path.substr(slash + 1);
  const std::size_t dot = file.find_last_of('.');
  if (dot != file.npos)
    for (const auto& [extension, format] : kExtensions)
      if (detail::equals_ignoring_case(std::string_view(file).substr(dot), extension))
        return format;
  throw Error("mesh-format",
              fmt::format("{}: the format of a mesh is told by the end of its name, one of .stl "
                          ".obj .ply .off .3mf .glb{}",
                          path, also),
              Error::Kind::usage);
}

TriMesh parse_mesh(std::string_view bytes, MeshFormat format, const std::string& name) {
  switch (format) {
    case MeshFormat::stl:
      return parse_stl(bytes, name);
    case MeshFormat::obj:
      return parse_obj(detail::without_mark(bytes), name);
    case MeshFormat::ply:
      return parse_ply(detail::without_mark(bytes), name);
    case MeshFormat::off:
      return parse_off(detail::without_mark(bytes), name);
    case MeshFormat::threemf:
      return parse_3mf(bytes, name);
    case MeshFormat::glb:
      break;
  }
  return parse_glb(bytes, name);
}

bool is_streamed(MeshFormat format) { return format != MeshFormat::glb; }

void encode_mesh(const MeshSource& mesh, MeshFormat format, const MeshFileOptions& options,
                 const ByteSink& out) {
  switch (format) {
    case MeshFormat::stl:
      return options.ascii ? write_stl_ascii(mesh, out, options.threads)
                           : write_stl(mesh, out, options.threads);
    case MeshFormat::obj:
      return write_obj(mesh, out, options.threads);
    case MeshFormat::ply:
      return write_ply(mesh, options.color, out, options.threads);
    case MeshFormat::off:
      return write_off(mesh, out, options.threads);
    case MeshFormat::threemf:
      return write_3mf(mesh, options.color, out, options.threads);
    case MeshFormat::glb: {
      const TriMesh* whole = mesh.in_memory();
      MRSIM_ASSERT(whole != nullptr);
      require_memory(
          kGlbTriangle * double(whole->triangles.size()), "writing a .glb",
          "--max-memory allows more, .stl .ply .obj .off and .3mf are written in blocks");
      return write_glb(*whole, options, out);
    }
  }
}

TriMesh load_mesh(const std::string& path) {
  const MeshFormat format = mesh_format_of(path);
  TriMesh mesh = parse_mesh(read_file(path), format, path);
  release_freed_memory();  // the text's, before what the mesh is read for
  return mesh;
}

void save_mesh(const std::string& path, const TriMesh& mesh, const MeshFileOptions& options) {
  const MeshFormat format = mesh_format_of(path);
  if (mesh.triangles.empty())
    throw Error("mesh-empty", fmt::format("{} is not written: nothing is left of the part", path));
  write_file_atomically(
      path, [&](const ByteSink& out) { encode_mesh(MemoryMesh(mesh), format, options, out); });
}

}  // namespace mrsim
