#include "mesh/format/ply.h"

#include "core/text/bytes.h"
#include "mesh/draw/palette.h"
#include "mesh/format/item_writer.h"
#include "mesh/format/mesh_builder.h"
#include "mesh/format/origin_text.h"
#include "mesh/format/text_scan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace mrsim {
namespace {

using detail::MeshBuilder;
using detail::TextScan;

enum class Type : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };
constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
constexpr std::pair<std::string_view, Type> kTypes[] = {
    {"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
    {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
    {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
    {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64}};

std::optional<Type> type_of(std::string_view word) {
  for (const auto& [name, type] : kTypes)
    if (name == word) return type;
  return {};
}

// What a property means to a mesh.
enum class Role : std::uint8_t {
  none,
  x,
  y,
  z,
  red,
  green,
  blue,
  corners,
  owner,
  file,
  line,
  tool
};
constexpr std::pair<std::string_view, Role> kRoles[] = {{"x", Role::x},
                                                        {"y", Role::y},
                                                        {"z", Role::z},
                                                        {"red", Role::red},
                                                        {"green", Role::green},
                                                        {"blue", Role::blue},
                                                        {"vertex_indices", Role::corners},
                                                        {"vertex_index", Role::corners},
                                                        {"owner", Role::owner},
                                                        {"file", Role::file},
                                                        {"line", Role::line},
                                                        {"tool", Role::tool}};

struct Property {
  Type type = Type::f32;
  std::optional<Type> count;  // of a list
  Role role = Role::none;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

enum class Form : std::uint8_t { text, little, big };

// The values of one element, by role.
struct Record {
  double value[12] = {};
  bool given[12] = {};
  std::vector<std::int64_t> corners;
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& name)
      : bytes_(bytes), scan_(bytes), builder_("ply", name) {}

  TriMesh read() {
    read_header();
    for (const Element& element : elements_) read_element(element);
    TriMesh& mesh = builder_.mesh();
    mesh.origin = origin_.take();
    return builder_.take();
  }

 private:
  [[noreturn]] void fail(const char* fault, const std::string& text) const {
    builder_.fail(fault, text);
  }
  [[noreturn]] void fail_syntax() const {
    fail("syntax", fmt::format("line {} of its header is not understood", scan_.line()));
  }

  void read_header();
  void read_property();
  void read_comment(std::string_view line);
  void require_room(const Element& element) const;
  void read_element(const Element& element);
  void take(const Element& element, const Record& record);
  double value(Type type);
  double binary_value(Type type);

  std::string_view bytes_;
  TextScan scan_;       // header and text form
  std::size_t at_ = 0;  // binary form
  Form form_ = Form::text;
  std::vector<Element> elements_;
  MeshBuilder builder_;
  OriginReader origin_;
};

void PlyReader::read_property() {
  if (elements_.empty()) fail_syntax();
  Property p;
  std::string_view word = scan_.word_in_line();
  if (word == "list") {
    p.count = type_of(scan_.word_in_line());
    if (!p.count) fail_syntax();
    word = scan_.word_in_line();
  }
  const auto type = type_of(word);
  if (!type) fail_syntax();
  p.type = *type;
  const std::string_view name = scan_.word_in_line();
  for (const auto& [known, role] : kRoles)
    if (known == name && p.count.has_value() == (role == Role::corners)) p.role = role;
  if (elements_.back().properties.size() > 1000) fail_syntax();
  elements_.back().properties.push_back(p);
}

void PlyReader::read_comment(std::string_view line) {
  std::vector<ColorLabel>& legend = builder_.mesh().legend;
  if (auto label = read_legend_line(line); label && legend.size() < kMostLegend)
    legend.push_back(std::move(*label));
  else
    origin_.read(line);
}

void PlyReader::read_header() {
  if (scan_.word_in_line() != "ply") fail("syntax", "it does not begin with \"ply\"");
  bool has_format = false;
  for (;;) {
    if (!scan_.next_line()) fail("truncated", "its header has no end");
    const std::string_view word = scan_.word_in_line();
    if (word == "end_header") break;
    if (word == "format") {
      const std::string_view form = scan_.word_in_line();
      form_ = form == "ascii" ? Form::text : form == "binary_big_endian" ? Form::big : Form::little;
      if (form_ == Form::little && form != "binary_little_endian") fail_syntax();
      has_format = true;
    } else if (word == "comment") {
      if (scan_.word_in_line() == "mrsim") read_comment(scan_.rest_of_line());
    } else if (word == "element") {
      Element e;
      e.name = scan_.word_in_line();
      const auto count = detail::to_integer(scan_.word_in_line());
      if (!count || *count < 0 || elements_.size() > 100) fail_syntax();
      e.count = std::uint64_t(*count);
      elements_.push_back(std::move(e));
    } else if (word == "property") {
      read_property();
    } else if (!word.empty() && word != "obj_info") {
      fail_syntax();
    }
  }
  if (!has_format) fail("syntax", "its header names no format");
  scan_.next_line();
  at_ = scan_.position();
}

// Before the loop: an element takes at least its scalars and the counts of its lists, so that a
// header cannot claim more than there is.
void PlyReader::require_room(const Element& element) const {
  std::uint64_t least = 0;
  for (const Property& p : element.properties)
    least += form_ == Form::text ? 2 : kSizes[std::size_t(p.count.value_or(p.type))];
  const std::uint64_t room = bytes_.size() - (form_ == Form::text ? scan_.position() : at_) + 1;
  if (least > 0 && element.count > room / least)
    fail("truncated", fmt::format("its header claims {} elements \"{}\", more than its {} bytes "
                                  "hold",
                                  element.count, element.name.substr(0, 40), bytes_.size()));
}

double PlyReader::binary_value(Type type) {
  const std::size_t size = kSizes[std::size_t(type)];
  if (bytes_.size() - at_ < size) fail("truncated", "it is cut short");
  const char* data = bytes_.data() + at_;
  at_ += size;
  const bool big = form_ == Form::big;
  switch (type) {
    case Type::i8:
      return detail::load<std::int8_t>(data);
    case Type::u8:
      return detail::load<std::uint8_t>(data);
    case Type::i16:
      return detail::load<std::int16_t>(data, big);
    case Type::u16:
      return detail::load<std::uint16_t>(data, big);
    case Type::i32:
      return detail::load<std::int32_t>(data, big);
    case Type::u32:
      return detail::load<std::uint32_t>(data, big);
    case Type::f32:
      return detail::load<float>(data, big);
    case Type::f64:
      break;
  }
  return detail::load<double>(data, big);
}

double PlyReader::value(Type type) {
  if (form_ != Form::text) return binary_value(type);
  const std::string_view word = scan_.word();
  if (word.empty()) fail("truncated", "it is cut short");
  const auto number = parse_number(word.front() == '+' ? word.substr(1) : word, true);
  if (!number) fail("nan", fmt::format("line {} holds a word that is not a number", scan_.line()));
  return *number;
}

void PlyReader::read_element(const Element& element) {
  require_room(element);
  if (element.properties.empty()) return;
  Record record;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (const Property& p : element.properties) {
      if (!p.count) {
        record.value[std::size_t(p.role)] = value(p.type);
        record.given[std::size_t(p.role)] = true;
        continue;
      }
      const double length = value(*p.count);
      if (!(length >= 0 && length <= double(bytes_.size())))
        fail("truncated", "a list is longer than the file");
      if (p.role == Role::corners) record.corners.clear();
      for (std::uint64_t k = 0; k < std::uint64_t(length); ++k) {
        const double v = value(p.type);
        if (p.role == Role::corners)
          record.corners.push_back(std::fabs(v) < 1e15 ? std::int64_t(v) : -1);
      }
    }
    take(element, record);
  }
}

void PlyReader::take(const Element& element, const Record& record) {
  const auto get = [&](Role role) { return record.value[std::size_t(role)]; };
  const auto given = [&](Role role) { return record.given[std::size_t(role)]; };
  if (element.name == "vertex") {
    if (!given(Role::x) || !given(Role::y) || !given(Role::z))
      fail("syntax", "its vertices have no x, y and z");
    builder_.add_vertex(get(Role::x), get(Role::y), get(Role::z));
    if (!given(Role::red) || !given(Role::green) || !given(Role::blue)) return;
    const auto byte = [&](Role role) {
      return std::uint8_t(std::clamp(std::isfinite(get(role)) ? get(role) : 0.0, 0.0, 255.0));
    };
    builder_.mesh().colors.push_back({byte(Role::red), byte(Role::green), byte(Role::blue)});
  } else if (element.name == "face") {
    const double owner = get(Role::owner);
    const bool known = given(Role::owner) && owner >= 0 && owner <= 2147483647;
    builder_.add_face(record.corners, known ? std::int32_t(owner) : -1);
  }
}

std::string header_of(const MeshSource& mesh, bool colors) {
  std::string h = "ply\nformat binary_little_endian 1.0\ncomment mrsim part, mm\n";
  for (const std::string& line : origin_lines(mesh.origin())) h += "comment mrsim " + line + "\n";
  if (mesh.has_colors())
    for (const std::string& line : legend_lines(mesh.legend())) h += "comment mrsim " + line + "\n";
  h += fmt::format("element vertex {}\nproperty float x\nproperty float y\nproperty float z\n",
                   mesh.vertices());
  const char* rgb = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (mesh.has_colors()) h += rgb;
  h += fmt::format("element face {}\nproperty list uchar int vertex_indices\n", mesh.triangles());
  if (mesh.has_owners())
    h += "property int owner\nproperty int file\nproperty int line\nproperty int tool\n";
  if (colors) h += rgb;
  return h + "end_header\n";
}

void append_face(const MeshBlock& block, std::size_t f, const OwnerTable& table,
                 const OwnerColors& colors, std::string& text) {
  char record[32] = {3};
  char* at = record + 1;
  for (const std::uint32_t v : block.triangles[f])
    at = detail::store(at, std::int32_t(block.number(v)));
  if (!block.owners.empty()) {
    const FaceOrigin* known = find_origin(table, block.owners[f]);
    const FaceOrigin origin = known ? *known : FaceOrigin{};
    for (const std::int32_t n : {block.owners[f], origin.file, origin.line, origin.tool})
      at = detail::store(at, n);
  }
  if (!colors.empty())
    for (const std::uint8_t c : colors.entries[colors.entry(block.owners[f])].color)
      at = detail::store(at, c);
  text.append(record, std::size_t(at - record));
}

}  // namespace

TriMesh parse_ply(std::string_view bytes, const std::string& name) {
  return PlyReader(bytes, name).read();
}

void write_ply(const MeshSource& mesh, ColorBy color, const ByteSink& out, int threads) {
  OwnerColors colors;
  if (color != ColorBy::none) colors = color_owners(owners_of(mesh), mesh.origin(), color);
  detail::write_text(header_of(mesh, !colors.empty()), out);
  mesh.for_each_block([&](const MeshBlock& block) {
    const auto fresh = block.fresh();
    detail::write_items(fresh.size(), threads, out, [&](std::string& text, std::size_t v) {
      char record[16];
      char* at = record;
      for (const float x : fresh[v]) at = detail::store(at, x);
      if (!block.colors.empty())
        for (const std::uint8_t c : block.colors[v]) at = detail::store(at, c);
      text.append(record, std::size_t(at - record));
    });
  });
  mesh.for_each_block([&](const MeshBlock& block) {
    detail::write_items(block.triangles.size(), threads, out,
                        [&](std::string& text, std::size_t f) {
                          append_face(block, f, mesh.origin(), colors, text);
                        });
  });
}

}  // namespace mrsim
