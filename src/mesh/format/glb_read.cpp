// Reading GLB: the triangles of the scene, node transforms applied, in mm with Z up.
#include "core/numbers/vec.h"
#include "core/text/bytes.h"
#include "mesh/draw/picture.h"
#include "mesh/format/glb.h"
#include "mesh/format/mesh_builder.h"
#include "mesh/format/origin_text.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostNodes = 100'000;

// Columns of a 3 x 4 matrix.
struct Frame {
  std::array<Vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3 origin;
  Vec3 turn(const Vec3& p) const { return p.x * axes[0] + p.y * axes[1] + p.z * axes[2]; }
  Vec3 operator()(const Vec3& p) const { return turn(p) + origin; }
  Frame operator*(const Frame& inner) const {
    return {{turn(inner.axes[0]), turn(inner.axes[1]), turn(inner.axes[2])}, (*this)(inner.origin)};
  }
  bool mirrors() const { return dot(axes[0], cross(axes[1], axes[2])) < 0; }
};

// The axes that a unit quaternion x, y, z, w turns X, Y and Z to.
std::array<Vec3, 3> axes_of(double x, double y, double z, double w) {
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
           {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
           {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}}};
}

// The numbers of one accessor.
struct Numbers {
  const char* data = nullptr;
  std::size_t count = 0, stride = 0, width = 0;
  std::size_t type = 0;
  bool normalized = false;

  double at(std::size_t i, std::size_t k) const {
    const char* p = data + i * stride;
    switch (type) {
      case 5120:
        return scaled(detail::load<std::int8_t>(p + k), 127);
      case 5121:
        return scaled(detail::load<std::uint8_t>(p + k), 255);
      case 5122:
        return scaled(detail::load<std::int16_t>(p + 2 * k), 32767);
      case 5123:
        return scaled(detail::load<std::uint16_t>(p + 2 * k), 65535);
      case 5125:
        return double(detail::load<std::uint32_t>(p + 4 * k));
      default:
        return double(detail::load<float>(p + 4 * k));
    }
  }

 private:
  double scaled(double value, double full) const {
    return normalized ? std::max(value / full, -1.0) : value;
  }
};

class GlbReader {
 public:
  GlbReader(std::string_view bytes, const std::string& name)
      : bytes_(bytes), builder_("glb", name) {}

  TriMesh read() {
    try {
      split_chunks();
      // Counted before anything is added: nodes may repeat a mesh.
      std::size_t vertices = 0, triangles = 0;
      for_each_primitive([&](const Json& primitive, const Frame&) {
        const std::size_t count = numbers(primitive.at("attributes").at("POSITION")).count;
        vertices += count;
        triangles +=
            (primitive.contains("indices") ? numbers(primitive["indices"]).count : count) / 3;
      });
      builder_.expect(vertices, triangles);
      for (const Json& mesh : json_.value("meshes", Json::array())) read_extras(mesh);
      for_each_primitive(
          [&](const Json& primitive, const Frame& frame) { add_primitive(primitive, frame); });
    } catch (const Json::exception& fault) {
      builder_.fail("syntax", fmt::format("its description does not hold together ({})",
                                          std::string_view(fault.what()).substr(0, 120)));
    }
    builder_.mesh().origin = origin_.take();
    return builder_.take();
  }

 private:
  void split_chunks();
  using Visitor = std::function<void(const Json& primitive, const Frame&)>;
  void for_each_primitive(const Visitor& visit);
  void visit_node(std::size_t index, const Frame& outer, int depth, const Visitor& visit);
  void add_primitive(const Json& primitive, const Frame& frame);
  void add_faces(const Numbers& positions, const Json& primitive, const Frame& frame,
                 std::size_t first);
  void add_colors(const Json& attributes, std::size_t count);
  void read_extras(const Json& mesh);
  template <typename Int = std::size_t>
  Int whole(const Json& value) const;
  std::size_t whole_or(const Json& object, const char* key, std::size_t otherwise) const;
  Numbers numbers(const Json& accessor) const;
  Frame frame_of(const Json& node) const;

  std::string_view bytes_, binary_;
  Json json_;
  detail::MeshBuilder builder_;
  OriginReader origin_;
  std::size_t nodes_ = 0;
};

void GlbReader::split_chunks() {
  const auto word = [&](std::size_t at) { return detail::load<std::uint32_t>(bytes_.data() + at); };
  if (bytes_.size() < 20 || word(0) != 0x46546c67 || word(4) != 2)
    builder_.fail("syntax", "it is not a binary glTF 2.0 file");
  if (word(8) > bytes_.size()) builder_.fail("truncated", "it is cut short");
  std::string_view text;
  for (std::size_t at = 12; at + 8 <= bytes_.size();) {
    const std::size_t length = word(at);
    const std::uint32_t kind = word(at + 4);
    if (length > bytes_.size() - at - 8) builder_.fail("truncated", "it is cut short");
    if (kind == 0x4e4f534a && text.empty()) text = bytes_.substr(at + 8, length);
    if (kind == 0x004e4942 && binary_.empty()) binary_ = bytes_.substr(at + 8, length);
    at += 8 + length;
  }
  json_ = Json::parse(text, nullptr, false);
  if (!json_.is_object()) builder_.fail("syntax", "its description is no JSON");
  for (const Json& extension : json_.value("extensionsRequired", Json::array()))
    if (extension != "KHR_mesh_quantization")
      throw Error("glb-unsupported", fmt::format("the GLB file needs {}, which is not read; export "
                                                 "it without compression",
                                                 extension.dump().substr(0, 60)));
}

// A whole number, which may be written 5.0. The library's own conversion drops fractions and signs,
// and of 1e300 it is undefined.
template <typename Int>
Int GlbReader::whole(const Json& value) const {
  constexpr double kExact = 9007199254740992;  // 2^53
  const double number = value.get<double>();
  if (number != std::floor(number) || number < double(std::numeric_limits<Int>::min()) ||
      number > std::min(kExact, double(std::numeric_limits<Int>::max())))
    builder_.fail("syntax", fmt::format("it has {} where a count or an index stands", number));
  return Int(number);
}

std::size_t GlbReader::whole_or(const Json& object, const char* key, std::size_t otherwise) const {
  return object.contains(key) ? whole(object.at(key)) : otherwise;
}

Numbers GlbReader::numbers(const Json& accessor) const {
  const Json& a = json_.at("accessors").at(whole(accessor));
  const Json& view = json_.at("bufferViews").at(whole(a.at("bufferView")));
  if (a.contains("sparse") || view.at("buffer") != 0)
    throw Error("glb-unsupported",
                "the GLB file keeps its numbers sparse or in other files, which is not read");
  constexpr std::pair<std::string_view, std::size_t> kShapes[] = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  Numbers out;
  const std::string shape = a.at("type");
  for (const auto& [known, width] : kShapes)
    if (known == shape) out.width = width;
  out.type = whole(a.at("componentType"));
  out.normalized = a.value("normalized", false);
  out.count = whole(a.at("count"));
  const std::size_t size = out.type == 5125 || out.type == 5126   ? 4
                           : out.type == 5122 || out.type == 5123 ? 2
                           : out.type == 5120 || out.type == 5121 ? 1
                                                                  : 0;
  const std::size_t row = size * out.width;
  if (row == 0) builder_.fail("syntax", "it has numbers of an unknown kind");
  out.stride = whole_or(view, "byteStride", row);
  const std::size_t begin = whole_or(view, "byteOffset", 0);
  const std::size_t inner = whole_or(a, "byteOffset", 0);
  if (begin > binary_.size() || inner > binary_.size() - begin || out.stride < row ||
      out.stride > 255 || out.count > binary_.size() ||
      (out.count > 0 && (out.count - 1) * out.stride + row > binary_.size() - begin - inner))
    builder_.fail("truncated", "it names more numbers than it holds");
  out.data = binary_.data() + begin + inner;
  return out;
}

Frame GlbReader::frame_of(const Json& node) const {
  Frame out;
  const auto list = [&](const char* key, std::vector<double> otherwise) {
    if (node.contains(key)) {
      const std::size_t wanted = otherwise.size();
      otherwise = node.at(key).get<std::vector<double>>();
      if (otherwise.size() != wanted)
        builder_.fail("syntax", fmt::format("a node has a {} of {} numbers instead of {}", key,
                                            otherwise.size(), wanted));
    }
    return otherwise;
  };
  if (node.contains("matrix")) {
    const std::vector<double> m = list("matrix", std::vector<double>(16, 0));
    return {{{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}}, {m[12], m[13], m[14]}};
  }
  const std::vector<double> t = list("translation", {0, 0, 0}), s = list("scale", {1, 1, 1}),
                            q = list("rotation", {0, 0, 0, 1});
  out.axes = axes_of(q[0], q[1], q[2], q[3]);
  for (std::size_t k = 0; k < 3; ++k) out.axes[k] = s[k] * out.axes[k];
  out.origin = {t[0], t[1], t[2]};
  return out;
}

void GlbReader::for_each_primitive(const Visitor& visit) {
  nodes_ = 0;
  const Json& scenes = json_.at("scenes");
  for (const Json& node : scenes.at(whole_or(json_, "scene", 0)).at("nodes"))
    visit_node(whole(node), {}, 0, visit);
}

void GlbReader::visit_node(std::size_t index, const Frame& outer, int depth, const Visitor& visit) {
  if (depth > 64 || ++nodes_ > kMostNodes)
    builder_.fail("syntax", "its nodes are nested too deep or without an end");
  const Json& node = json_.at("nodes").at(index);
  const Frame frame = outer * frame_of(node);
  if (node.contains("mesh")) {
    const Json& mesh = json_.at("meshes").at(whole(node.at("mesh")));
    for (const Json& primitive : mesh.at("primitives")) visit(primitive, frame);
  }
  if (!node.contains("children")) return;
  for (const Json& child : node.at("children")) visit_node(whole(child), frame, depth + 1, visit);
}

void GlbReader::read_extras(const Json& mesh) {
  if (!mesh.contains("extras") || !mesh["extras"].is_object() || !mesh["extras"].contains("mrsim"))
    return;
  const Json& told = mesh["extras"]["mrsim"];
  std::size_t i = 0;
  for (const Json& file : told.value("files", Json::array()))
    origin_.read(fmt::format("file {} {}", i++, file.get<std::string>()));
  i = 0;
  for (const Json& tool : told.value("tools", Json::array()))
    origin_.read(fmt::format("tool {} {}", i++, tool.get<std::string>()));
  for (const Json& o : told.value("origins", Json::array()))
    origin_.read(fmt::format("owner {} {} {} {}", whole<int>(o.at(0)), whole<int>(o.at(1)),
                             whole<int>(o.at(2)), whole<int>(o.at(3))));
  for (const Json& l : told.value("legend", Json::array()))
    if (builder_.mesh().legend.size() < kMostLegend)
      if (auto label = read_legend_line(fmt::format("legend {} {} {} {}", whole<int>(l.at(0)),
                                                    whole<int>(l.at(1)), whole<int>(l.at(2)),
                                                    l.at(3).get<std::string>())))
        builder_.mesh().legend.push_back(std::move(*label));
}

void GlbReader::add_primitive(const Json& primitive, const Frame& frame) {
  if (whole_or(primitive, "mode", 4) != 4)
    throw Error(
        "glb-unsupported",
        "the GLB file holds lines, points or strips, which bound no part; export triangles");
  const Json& attributes = primitive.at("attributes");
  const Numbers positions = numbers(attributes.at("POSITION"));
  if (positions.width != 3) builder_.fail("syntax", "a position is not three numbers");
  const std::size_t first = builder_.vertex_count();
  for (std::size_t i = 0; i < positions.count; ++i) {
    const Vec3 p = frame({positions.at(i, 0), positions.at(i, 1), positions.at(i, 2)});
    builder_.add_vertex(1000 * p.x, -1000 * p.z, 1000 * p.y);  // metres, Y up
  }
  add_colors(attributes, positions.count);
  add_faces(positions, primitive, frame, first);
}

// Only colours that a legend explains: others are those of owners, which are known as such.
void GlbReader::add_colors(const Json& attributes, std::size_t count) {
  if (builder_.mesh().legend.empty() || !attributes.contains("COLOR_0")) return;
  const Numbers colors = numbers(attributes.at("COLOR_0"));
  if (colors.count < count || colors.width < 3) return;
  for (std::size_t i = 0; i < count; ++i)
    builder_.mesh().colors.push_back(
        to_srgb({float(colors.at(i, 0)), float(colors.at(i, 1)), float(colors.at(i, 2))}));
}

void GlbReader::add_faces(const Numbers& positions, const Json& primitive, const Frame& frame,
                          std::size_t first) {
  const Json& attributes = primitive.at("attributes");
  std::optional<Numbers> indices, owners;
  if (primitive.contains("indices")) indices = numbers(primitive.at("indices"));
  if (attributes.contains("_OWNER")) owners = numbers(attributes.at("_OWNER"));
  const std::size_t corners = indices ? indices->count : positions.count;
  for (std::size_t h = 0; h + 2 < corners; h += 3) {
    std::array<std::int64_t, 3> face;
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = indices ? indices->at(h + k, 0) : double(h + k);
      if (!(at >= 0 && at < double(positions.count)))
        builder_.fail("index", fmt::format("triangle {} names vertex {}, there are {}", h / 3 + 1,
                                           at, positions.count));
      face[k] = std::int64_t(first) + std::int64_t(at);
    }
    const std::size_t corner = std::size_t(face[0]) - first;
    const double owner = owners && corner < owners->count ? owners->at(corner, 0) : -1;
    if (frame.mirrors()) std::swap(face[1], face[2]);
    builder_.add_face(face, owner >= 0 && owner <= 2147483647 ? std::int32_t(owner) : -1);
  }
}

}  // namespace

TriMesh parse_glb(std::string_view bytes, const std::string& name) {
  return GlbReader(bytes, name).read();
}

}  // namespace mrsim
