#include "mesh/format/glb.h"

#include "core/text/bytes.h"
#include "mesh/draw/palette.h"
#include "mesh/draw/picture.h"
#include "mesh/solid/creases.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr double kCrease = 25;  // degrees
enum : int {
  kByte = 5120,
  kUnsignedByte = 5121,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126,
  kArrayBuffer = 34962,
  kElementBuffer = 34963
};

// All in which two vertices of the file can differ.
struct Corner {
  std::uint32_t vertex = 0;
  std::array<std::int8_t, 3> normal{};
  std::int32_t owner = -1;
  std::uint32_t entry = 0;  // of the palette
  friend auto operator<=>(const Corner&, const Corner&) = default;
};

struct Vertices {
  std::vector<Corner> corners;
  std::vector<std::uint32_t> indices;
};

Vertices split_vertices(const TriMesh& mesh, const FacePalette& palette) {
  const SurfaceShape shape = find_surface_shape(mesh, kCrease);
  Vertices out;
  // Corners of one vertex are few: found by walking its list, in the order of first use.
  constexpr std::uint32_t kEnd = ~0u;
  std::vector<std::uint32_t> first(mesh.vertices.size(), kEnd), next;
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    Corner c;
    c.vertex = origin_of(mesh, h);
    for (int k = 0; k < 3; ++k)
      c.normal[k] = std::int8_t(std::lround(std::clamp(shape.normals[h][k], -1.0f, 1.0f) * 127));
    if (!mesh.owners.empty()) c.owner = mesh.owners[h / 3];
    if (!palette.index.empty()) c.entry = palette.index[h / 3];
    std::uint32_t at = first[c.vertex];
    while (at != kEnd && out.corners[at] != c) at = next[at];
    if (at == kEnd) {
      at = std::uint32_t(out.corners.size());
      out.corners.push_back(c);
      next.push_back(first[c.vertex]);
      first[c.vertex] = at;
    }
    out.indices.push_back(at);
  }
  return out;
}

// The binary part, with the views and accessors that describe it.
class Binary {
 public:
  OrderedJson views = OrderedJson::array(), accessors = OrderedJson::array();
  std::string bytes;

  int add(const std::string& data, int stride, int target, OrderedJson accessor) {
    OrderedJson view = {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}};
    if (stride > 0) view["byteStride"] = stride;
    view["target"] = target;
    accessor["bufferView"] = views.size();
    views.push_back(std::move(view));
    accessors.push_back(std::move(accessor));
    bytes += data;
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    return int(accessors.size()) - 1;
  }
};

OrderedJson accessor(int type, const char* shape, std::size_t count, bool normalized = false) {
  OrderedJson a = {{"componentType", type}, {"count", count}, {"type", shape}};
  if (normalized) a["normalized"] = true;
  return a;
}

int add_positions(const TriMesh& mesh, const Vertices& vertices, Binary& binary) {
  std::string data;
  Box3 box;
  for (const Corner& c : vertices.corners) {
    const std::array<float, 3>& p = mesh.vertices[c.vertex];
    for (const float x : p) detail::store(data, x);
    extend(box, to_vec(p));
  }
  OrderedJson a = accessor(kFloat, "VEC3", vertices.corners.size());
  if (is_empty(box)) box = {{}, {}};
  a["min"] = {box.lo.x, box.lo.y, box.lo.z};
  a["max"] = {box.hi.x, box.hi.y, box.hi.z};
  return binary.add(data, 12, kArrayBuffer, a);
}

int add_normals(const Vertices& vertices, Binary& binary) {
  std::string data;
  for (const Corner& c : vertices.corners) {
    for (const std::int8_t n : c.normal) detail::store(data, n);
    detail::store(data, std::int8_t(0));
  }
  return binary.add(data, 4, kArrayBuffer, accessor(kByte, "VEC3", vertices.corners.size(), true));
}

// glTF's vertex colours are linear light.
int add_colors(const TriMesh& mesh, const Vertices& vertices, const FacePalette& palette,
               Binary& binary) {
  std::string data;
  for (const Corner& c : vertices.corners) {
    const Color linear =
        to_linear(mesh.colors.empty() ? palette.entries[c.entry].color : mesh.colors[c.vertex]);
    for (const float x : {linear.r, linear.g, linear.b, 1.0f})
      detail::store(data, std::uint8_t(std::lround(x * 255)));
  }
  return binary.add(data, 4, kArrayBuffer,
                    accessor(kUnsignedByte, "VEC4", vertices.corners.size(), true));
}

int add_owners(const Vertices& vertices, Binary& binary) {
  std::string data;
  for (const Corner& c : vertices.corners) detail::store(data, float(c.owner));
  return binary.add(data, 4, kArrayBuffer, accessor(kFloat, "SCALAR", vertices.corners.size()));
}

int add_indices(const Vertices& vertices, Binary& binary) {
  std::string data;
  const bool narrow = vertices.corners.size() <= 65535;  // the last index restarts strips
  for (const std::uint32_t i : vertices.indices) {
    if (narrow)
      detail::store(data, std::uint16_t(i));
    else
      detail::store(data, i);
  }
  return binary.add(
      data, 0, kElementBuffer,
      accessor(narrow ? kUnsignedShort : kUnsignedInt, "SCALAR", vertices.indices.size()));
}

OrderedJson extras_of(const TriMesh& mesh) {
  const OwnerTable& table = mesh.origin;
  OrderedJson files = OrderedJson::array(), tools = OrderedJson::array(),
              origins = OrderedJson::array();
  for (const std::string& file : table.files) files.push_back(to_utf8(file));
  for (const std::string& tool : table.tools) tools.push_back(to_utf8(tool));
  for (const FaceOrigin& o : table.origins) origins.push_back({o.owner, o.file, o.line, o.tool});
  OrderedJson out = {{"files", files}, {"tools", tools}, {"origins", origins}};
  if (!mesh.colors.empty())
    for (const ColorLabel& l : mesh.legend)
      out["legend"].push_back({l.color[0], l.color[1], l.color[2], to_utf8(l.text)});
  return {{"mrsim", out}};
}

// The node that takes the part to metres with Y up: (x, y, z) mm -> (x, z, -y) / 1000. Its matrix
// stands by columns.
OrderedJson node_of_part() {
  constexpr double kMetre = 0.001;
  return {{"mesh", 0},
          {"name", "part"},
          {"matrix", {kMetre, 0, 0, 0, 0, 0, -kMetre, 0, 0, kMetre, 0, 0, 0, 0, 0, 1}}};
}

OrderedJson document(const TriMesh& mesh, const OrderedJson& primitive, const Binary& binary) {
  const bool colored = primitive["attributes"].contains("COLOR_0");
  const double gray = to_linear(kStockColor).r;
  const OrderedJson base =
      colored ? OrderedJson{1, 1, 1, 1} : OrderedJson{gray, gray, gray * 1.04, 1};
  OrderedJson part = {{"name", "part"}, {"primitives", {primitive}}};
  if (!mesh.owners.empty() || !mesh.colors.empty()) part["extras"] = extras_of(mesh);
  return {{"asset", {{"version", "2.0"}, {"generator", "mrsim"}}},
          {"extensionsUsed", {"KHR_mesh_quantization"}},
          {"extensionsRequired", {"KHR_mesh_quantization"}},
          {"scene", 0},
          {"scenes", {{{"nodes", {0}}}}},
          {"nodes", {node_of_part()}},
          {"meshes", {part}},
          {"materials",
           {{{"name", "part"},
             {"pbrMetallicRoughness",
              {{"baseColorFactor", base}, {"metallicFactor", 0.1}, {"roughnessFactor", 0.55}}}}}},
          {"buffers", {{{"byteLength", binary.bytes.size()}}}},
          {"bufferViews", binary.views},
          {"accessors", binary.accessors}};
}

}  // namespace

void write_glb(const TriMesh& mesh, const MeshFileOptions& options, const ByteSink& out) {
  const FacePalette palette = make_palette(mesh, options.color);
  const Vertices vertices = split_vertices(mesh, palette);
  Binary binary;
  OrderedJson attributes;
  attributes["POSITION"] = add_positions(mesh, vertices, binary);
  attributes["NORMAL"] = add_normals(vertices, binary);
  if (!mesh.colors.empty() || !palette.index.empty())
    attributes["COLOR_0"] = add_colors(mesh, vertices, palette, binary);
  if (!mesh.owners.empty()) attributes["_OWNER"] = add_owners(vertices, binary);
  const OrderedJson primitive = {
      {"attributes", attributes}, {"indices", add_indices(vertices, binary)}, {"material", 0}};
  std::string json = document(mesh, primitive, binary).dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t total = 12 + 8 + json.size() + 8 + binary.bytes.size();
  if (total > 0xffffffff)
    throw Error("glb-too-large", "the mesh is too large for a GLB file; write .ply or .stl");
  std::string head;
  for (const std::uint32_t n :
       {0x46546c67u, 2u, std::uint32_t(total), std::uint32_t(json.size()), 0x4e4f534au})
    detail::store(head, n);
  head += json;
  detail::store(head, std::uint32_t(binary.bytes.size()));
  detail::store(head, std::uint32_t(0x004e4942));
  out(head.data(), head.size());
  out(binary.bytes.data(), binary.bytes.size());
}

}  // namespace mrsim
