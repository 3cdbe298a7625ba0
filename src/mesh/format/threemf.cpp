#include "mesh/format/threemf.h"

#include "core/numbers/vec.h"
#include "core/text/ascii.h"
#include "core/text/zip.h"
#include "mesh/draw/palette.h"
#include "mesh/format/item_writer.h"
#include "mesh/format/mesh_builder.h"
#include "mesh/format/origin_text.h"
#include "mesh/format/text_scan.h"
#include "mesh/format/xml_scan.h"

#include <algorithm>
#include <functional>
#include <map>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr const char* kXml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
constexpr const char* kContentTypes =
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" "
    "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
constexpr const char* kRelations =
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

using Bases = std::map<std::int32_t, std::size_t>;  // each owner with its base material

Bases bases_of(const std::vector<std::int32_t>& owners) {
  Bases base;
  for (const std::int32_t owner : owners) base.emplace(owner, base.size());
  return base;
}

std::string metadata(const MeshSource& mesh, const Bases& bases) {
  std::string text = "bases";
  for (const auto& [owner, index] : bases) text += fmt::format(" {}", owner);
  for (const std::string& line : origin_lines(mesh.origin())) text += "\n" + to_utf8(line);
  return "<metadata name=\"mrsim:origin\">" + xml_escaped(text) + "\n</metadata>\n";
}

std::string materials(const MeshSource& mesh, const OwnerColors& colors, const Bases& bases) {
  std::string xml = "<basematerials id=\"1\">\n";
  for (const auto& [owner, index] : bases) {
    const Rgb c = colors.empty() ? kStockColor : colors.entries[colors.entry(owner)].color;
    xml += fmt::format("<base name=\"{}\" displaycolor=\"#{:02X}{:02X}{:02X}\"/>\n",
                       xml_escaped(to_utf8(owner_label(mesh.origin(), owner))), c[0], c[1], c[2]);
  }
  return xml + "</basematerials>\n";
}

void write_geometry(const MeshSource& mesh, const Bases& bases, int threads, const ByteSink& out) {
  detail::write_text("<mesh>\n<vertices>\n", out);
  mesh.for_each_block([&](const MeshBlock& block) {
    const auto fresh = block.fresh();
    detail::write_items(fresh.size(), threads, out, [&](std::string& xml, std::size_t v) {
      const char* names[] = {"<vertex x=\"", "\" y=\"", "\" z=\""};
      for (std::size_t k = 0; k < 3; ++k) {
        xml += names[k];
        detail::append_number(xml, fresh[v][k]);
      }
      xml += "\"/>\n";
    });
  });
  detail::write_text("</vertices>\n<triangles>\n", out);
  mesh.for_each_block([&](const MeshBlock& block) {
    detail::write_items(block.triangles.size(), threads, out, [&](std::string& xml, std::size_t f) {
      const char* names[] = {"<triangle v1=\"", "\" v2=\"", "\" v3=\""};
      for (std::size_t k = 0; k < 3; ++k) {
        xml += names[k];
        detail::append_number(xml, std::int64_t(block.number(block.triangles[f][k])));
      }
      if (!bases.empty())
        xml += fmt::format("\" pid=\"1\" p1=\"{}", bases.find(block.owners[f])->second);
      xml += "\"/>\n";
    });
  });
  detail::write_text("</triangles>\n</mesh>\n", out);
}

}  // namespace

void write_3mf(const MeshSource& mesh, ColorBy color, const ByteSink& out, int threads) {
  const std::vector<std::int32_t> owners = owners_of(mesh);
  const Bases bases = bases_of(owners);
  std::string head = kXml;
  head +=
      "<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
      "xmlns:mrsim=\"urn:mrsim:origin\">\n<metadata name=\"Application\">mrsim</metadata>\n";
  if (!bases.empty()) head += metadata(mesh, bases);
  head += "<resources>\n";
  if (!bases.empty()) head += materials(mesh, color_owners(owners, mesh.origin(), color), bases);
  head += bases.empty() ? "<object id=\"2\" type=\"model\">\n"
                        : "<object id=\"2\" type=\"model\" pid=\"1\" pindex=\"0\">\n";
  detail::ZipWriter zip(out);
  zip.add("[Content_Types].xml", std::string(kXml) + kContentTypes);
  zip.add("_rels/.rels", std::string(kXml) + kRelations);
  zip.add("3D/3dmodel.model", [&](const ByteSink& model) {
    detail::write_text(head, model);
    write_geometry(mesh, bases, threads, model);
    detail::write_text(
        "</object>\n</resources>\n<build>\n<item objectid=\"2\"/>\n</build>\n</model>\n", model);
  });
  zip.finish();
}

namespace {

using detail::XmlScan;

constexpr std::size_t kMostBytes = std::size_t(1) << 30;
constexpr int kDeepest = 16;
constexpr std::size_t kMostPlacements = 100'000;

// p' = p M, rows as in the file: the fourth is the shift.
struct Transform {
  double m[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  Vec3 operator()(const Vec3& p) const {
    return {p.x * m[0] + p.y * m[3] + p.z * m[6] + m[9],
            p.x * m[1] + p.y * m[4] + p.z * m[7] + m[10],
            p.x * m[2] + p.y * m[5] + p.z * m[8] + m[11]};
  }
  // Whether it mirrors: triangles must then be turned.
  bool mirrors() const {
    return dot(Vec3{m[0], m[1], m[2]}, cross(Vec3{m[3], m[4], m[5]}, Vec3{m[6], m[7], m[8]})) < 0;
  }
};

struct Placement {
  std::int64_t object = 0;
  Transform transform;
};

struct Object {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::int64_t, 3>> triangles;
  std::vector<std::int32_t> owners;
  std::vector<Placement> components;
};

class ModelReader {
 public:
  ModelReader(std::string_view xml, const std::string& name)
      : name_(name), xml_(xml, name), builder_("3mf", name) {}
  TriMesh read();

 private:
  std::int64_t integer(const char* attribute) const;
  double number(const char* attribute) const;
  Placement placement() const;
  void open_tag();
  void read_triangle();
  void read_metadata();
  using Visitor = std::function<void(const Object&, const std::vector<Transform>& chain)>;
  void for_each_object(const Visitor& visit);
  void place(std::int64_t id, const std::vector<Transform>& chain, const Visitor& visit);
  void add_mesh(const Object& object, const std::vector<Transform>& chain);

  const std::string& name_;
  XmlScan xml_;
  detail::MeshBuilder builder_;
  OriginReader origin_;
  std::vector<std::int32_t> owner_of_base_;
  std::map<std::int64_t, Object> objects_;
  Object* object_ = nullptr;
  std::vector<Placement> build_;
  std::string metadata_;
  double unit_ = 1;
  std::size_t placements_ = 0;
};

std::int64_t ModelReader::integer(const char* attribute) const {
  const auto text = xml_.attribute(attribute);
  const auto value = text ? detail::to_integer(*text) : std::nullopt;
  if (!value) xml_.fail(fmt::format("<{}> needs a whole number \"{}\"", xml_.name(), attribute));
  return *value;
}

double ModelReader::number(const char* attribute) const {
  const auto text = xml_.attribute(attribute);
  const auto value = text ? detail::to_float(*text) : std::nullopt;
  if (!value)
    builder_.fail("nan", fmt::format("<{}> has no number \"{}\"", xml_.name(), attribute));
  return *value;
}

Placement ModelReader::placement() const {
  if (xml_.attribute("p:path"))
    throw Error("3mf-unsupported",
                "the 3MF file keeps its parts in several models, which is not read; export it "
                "without the production extension");
  Placement p;
  p.object = integer("objectid");
  const auto text = xml_.attribute("transform");
  if (!text) return p;
  detail::TextScan scan(*text);
  for (double& m : p.transform.m) {
    const auto value = detail::to_float(scan.word());
    if (!value) builder_.fail("nan", "a transform is not twelve numbers");
    m = *value;
  }
  return p;
}

std::optional<double> unit_in_mm(std::string_view unit) {
  constexpr std::pair<std::string_view, double> kUnits[] = {{"micron", 0.001},  {"millimeter", 1},
                                                            {"centimeter", 10}, {"inch", 25.4},
                                                            {"foot", 304.8},    {"meter", 1000}};
  for (const auto& [name, mm] : kUnits)
    if (name == unit) return mm;
  return std::nullopt;
}

void ModelReader::read_triangle() {
  constexpr std::size_t kOwnedTriangle = sizeof object_->triangles[0] + sizeof object_->owners[0];
  detail::require_growth(object_->triangles, kOwnedTriangle, name_);
  object_->triangles.push_back({integer("v1"), integer("v2"), integer("v3")});
  const auto base = xml_.attribute("p1");
  const auto index = base ? detail::to_integer(*base) : std::nullopt;
  const bool known = index && *index >= 0 && std::size_t(*index) < owner_of_base_.size();
  object_->owners.push_back(known ? owner_of_base_[std::size_t(*index)] : -1);
}

// "owner ..", "file ..", "tool ..", "base 3 37" on lines of their own.
void ModelReader::read_metadata() {
  if (metadata_ != "mrsim:origin") return;
  const std::string text = detail::xml_unescaped(xml_.text());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = std::string_view(text).substr(at, end - at);
    if (line.starts_with("bases")) {
      detail::TextScan scan(line.substr(5));
      for (std::string_view w = scan.word(); !w.empty(); w = scan.word())
        owner_of_base_.push_back(std::int32_t(
            std::clamp<std::int64_t>(detail::to_integer(w).value_or(-1), -1, 2147483647)));
    } else {
      origin_.read(line);
    }
    at = end + 1;
  }
}

void ModelReader::open_tag() {
  const std::string_view tag = xml_.name();
  if (tag == "vertex" && object_) {
    detail::require_growth(object_->vertices, sizeof(Vec3), name_);
    object_->vertices.push_back({number("x"), number("y"), number("z")});
  } else if (tag == "triangle" && object_) {
    read_triangle();
  } else if (tag == "object") {
    object_ = &objects_[integer("id")];
  } else if (tag == "component" && object_) {
    object_->components.push_back(placement());
  } else if (tag == "item") {
    build_.push_back(placement());
  } else if (tag == "model") {
    const auto unit = unit_in_mm(xml_.attribute("unit").value_or("millimeter"));
    if (!unit) builder_.fail("unit", "its unit of length is not one of 3MF's");
    unit_ = *unit;
  } else if (tag == "metadata") {
    metadata_ = xml_.attribute("name").value_or("");
  }
}

void ModelReader::add_mesh(const Object& object, const std::vector<Transform>& chain) {
  const auto base = std::int64_t(builder_.vertex_count());
  const bool mirrored =
      std::count_if(chain.begin(), chain.end(), [](const Transform& t) { return t.mirrors(); }) %
          2 ==
      1;
  for (Vec3 p : object.vertices) {
    for (auto t = chain.rbegin(); t != chain.rend(); ++t) p = (*t)(p);
    builder_.add_vertex(unit_ * p.x, unit_ * p.y, unit_ * p.z);
  }
  for (std::size_t i = 0; i < object.triangles.size(); ++i) {
    std::array<std::int64_t, 3> t = object.triangles[i];
    for (std::int64_t& v : t) {
      if (v < 0 || std::size_t(v) >= object.vertices.size())
        builder_.fail("index", fmt::format("triangle {} names vertex {}, there are {}", i + 1,
                                           v + 1, object.vertices.size()));
      v += base;
    }
    if (mirrored) std::swap(t[1], t[2]);
    builder_.add_face(t, object.owners[i]);
  }
}

void ModelReader::for_each_object(const Visitor& visit) {
  placements_ = 0;
  for (const Placement& p : build_) place(p.object, {p.transform}, visit);
}

void ModelReader::place(std::int64_t id, const std::vector<Transform>& chain,
                        const Visitor& visit) {
  const auto found = objects_.find(id);
  if (found == objects_.end()) builder_.fail("index", fmt::format("there is no object {}", id));
  if (chain.size() > kDeepest || ++placements_ > kMostPlacements)
    builder_.fail("too-large", "its components are nested or repeated too often");
  visit(found->second, chain);
  for (const Placement& p : found->second.components) {
    std::vector<Transform> longer = chain;
    longer.push_back(p.transform);
    place(p.object, longer, visit);
  }
}

TriMesh ModelReader::read() {
  for (XmlScan::Event e = xml_.next(); e != XmlScan::Event::end; e = xml_.next()) {
    if (e == XmlScan::Event::open) open_tag();
    if (e == XmlScan::Event::close && xml_.name() == "metadata") read_metadata();
    if (e == XmlScan::Event::close && xml_.name() == "object") object_ = nullptr;
  }
  if (build_.empty()) {  // no build: every object that is not part of another
    std::map<std::int64_t, bool> used;
    for (const auto& [id, object] : objects_)
      for (const Placement& p : object.components) used[p.object] = true;
    for (const auto& [id, object] : objects_)
      if (!used[id]) build_.push_back({id, {}});
  }
  // Counted before anything is added: components may repeat an object.
  std::size_t vertices = 0, triangles = 0;
  for_each_object([&](const Object& object, const std::vector<Transform>&) {
    vertices += object.vertices.size();
    triangles += object.triangles.size();
  });
  builder_.expect(vertices, triangles);
  for_each_object(
      [&](const Object& object, const std::vector<Transform>& chain) { add_mesh(object, chain); });
  builder_.mesh().origin = origin_.take();
  return builder_.take();
}

// Names of parts are compared without regard to case.
std::string part(std::string_view bytes, const std::vector<detail::ZipEntry>& entries,
                 const std::string& wanted, const std::string& name) {
  for (const detail::ZipEntry& e : entries)
    if (lower_case(e.name) == lower_case(wanted)) return detail::unzip(bytes, e, kMostBytes, name);
  throw Error("3mf-zip", fmt::format("{}: it holds no \"{}\"; is it a 3MF file?", name, wanted));
}

// The part that the package names as its model.
std::string model_path(std::string_view relations, const std::string& name) {
  XmlScan xml(relations, name);
  for (XmlScan::Event e = xml.next(); e != XmlScan::Event::end; e = xml.next()) {
    if (e != XmlScan::Event::open || xml.name() != "Relationship") continue;
    const std::string_view type = xml.attribute("Type").value_or("");
    if (!type.ends_with("/3dmodel")) continue;
    std::string target = detail::xml_unescaped(xml.attribute("Target").value_or(""));
    return target.starts_with("/") ? target.substr(1) : target;
  }
  return "3D/3dmodel.model";
}

}  // namespace

TriMesh parse_3mf(std::string_view bytes, const std::string& name) {
  const std::vector<detail::ZipEntry> entries = detail::zip_directory(bytes, name);
  const std::string path = model_path(part(bytes, entries, "_rels/.rels", name), name);
  return ModelReader(part(bytes, entries, path, name), name).read();
}

}  // namespace mrsim
