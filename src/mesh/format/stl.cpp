#include "mesh/format/stl.h"

#include "core/process/memory_limit.h"
#include "core/text/bytes.h"
#include "mesh/format/item_writer.h"
#include "mesh/format/mesh_builder.h"
#include "mesh/format/text_scan.h"
#include "mesh/solid/half_edges.h"
#include "mesh/solid/weld.h"

#include <bit>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

using detail::TextScan;

constexpr std::size_t kHeader = 84;    // 80 bytes of anything and the count
constexpr std::size_t kTriangle = 50;  // normal, three points, two unused bytes
// Bytes after the last triangle that are taken for padding or a stray line end.
constexpr std::size_t kTrailingAllowed = kTriangle - 1;

using Corners = std::array<std::array<float, 3>, 3>;

// The mesh of a file's triangles, welded. Asks for its memory.
class Solid {
 public:
  explicit Solid(const std::string& name) : name_(name) {}

  // `triangles` that the file has the bytes of.
  void reserve(std::size_t triangles) {
    constexpr double kWelded = 16;  // a solid has half as many points, each with 32 bytes
    require_memory((sizeof mesh_.triangles[0] + kWelded) * double(triangles), "reading " + name_);
    mesh_.triangles.reserve(triangles);
  }
  void add(const Corners& c) {
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return;
    detail::require_growth(mesh_.triangles, sizeof mesh_.triangles[0], name_);
    mesh_.triangles.push_back({point(c[0]), point(c[1]), point(c[2])});
  }
  std::size_t triangles() const { return mesh_.triangles.size(); }

  TriMesh take() {
    mesh_.vertices = welder_.take();
    if (mesh_.triangles.empty())
      throw Error("stl-empty",
                  fmt::format("{} holds no triangles; export the solid again from CAD", name_));
    return std::move(mesh_);
  }

 private:
  std::uint32_t point(const std::array<float, 3>& corner) {
    const std::size_t before = welder_.size();
    const std::uint32_t index = welder_.add(corner);
    if (welder_.size() > before) require_welder(welder_.size());
    return index;
  }
  // A welder doubles its points and their slots when they are a power of two; what is reserved for
  // triangles and not yet in use comes on top.
  void require_welder(std::size_t points) {
    constexpr std::size_t kSmall = 4096;
    constexpr double kGrown = 2 * 12 + 4 * 4;
    if (points < kSmall || !std::has_single_bit(points)) return;
    require_memory(
        kGrown * double(points) + double(sizeof mesh_.triangles[0] *
                                         (mesh_.triangles.capacity() - mesh_.triangles.size())),
        "reading " + name_);
  }

  const std::string& name_;
  TriMesh mesh_;
  Welder welder_;
};

[[noreturn]] void fail_truncated(const std::string& name, std::uint64_t claimed, std::size_t size) {
  const std::size_t room = size < kHeader ? 0 : (size - kHeader) / kTriangle;
  throw Error("stl-truncated",
              fmt::format("{} is cut short: its header claims {} triangles, its {} bytes hold {}; "
                          "copy or export it again",
                          name, claimed, size, room));
}

[[noreturn]] void fail_far(const std::string& name, std::size_t triangle, double x) {
  throw Error("stl-too-far",
              fmt::format("{}: triangle {} has {}", name, triangle, detail::too_far(x)));
}

TriMesh parse_binary(std::string_view bytes, const std::string& name) {
  const auto claimed = detail::load<std::uint32_t>(bytes.data() + 80);
  const std::uint64_t needed = kHeader + std::uint64_t(claimed) * kTriangle;
  if (needed > bytes.size()) fail_truncated(name, claimed, bytes.size());
  if (bytes.size() - needed > kTrailingAllowed)
    throw Error("stl-size",
                fmt::format("{} has {} bytes after the {} triangles its header claims; header and "
                            "content disagree, export it again",
                            name, bytes.size() - needed, claimed));
  Solid solid(name);
  solid.reserve(claimed);
  for (std::size_t i = 0; i < claimed; ++i) {
    const char* at = bytes.data() + kHeader + i * kTriangle + 12;
    Corners corners;
    for (auto& corner : corners)
      for (float& x : corner) {
        x = detail::load<float>(at);
        at += 4;
        if (!std::isfinite(x))
          throw Error("stl-nan",
                      fmt::format("{}: triangle {} has a coordinate that is not a number; "
                                  "repair or export the mesh again",
                                  name, i + 1));
        if (std::fabs(x) > detail::kFarthest) fail_far(name, i + 1, x);
      }
    solid.add(corners);
  }
  return solid.take();
}

[[noreturn]] void fail_syntax(const std::string& name, std::size_t line, std::string_view wanted,
                              std::string_view found) {
  if (found.empty())
    throw Error("stl-truncated",
                fmt::format("{} is cut short: line {} should go on with \"{}\"; copy or export it "
                            "again",
                            name, line, wanted));
  std::string shown;
  for (const char c : found.substr(0, 40)) shown += c >= ' ' && c <= '~' ? c : '?';
  throw Error("stl-syntax", fmt::format("{}:{}: \"{}\" expected, found \"{}\"; the file is not a "
                                        "proper ASCII STL, export it again",
                                        name, line, wanted, shown));
}

void expect(TextScan& scan, std::string_view wanted, const std::string& name) {
  const std::string_view found = scan.word();
  if (!detail::equals_ignoring_case(found, wanted)) fail_syntax(name, scan.line(), wanted, found);
}

float coordinate(TextScan& scan, const std::string& name) {
  const std::string_view found = scan.word();
  if (const auto value = detail::to_float(found)) return *value;
  for (const std::string_view bad : {"nan", "-nan", "inf", "-inf", "infinity", "+nan", "+inf"})
    if (detail::equals_ignoring_case(found, bad))
      throw Error("stl-nan", fmt::format("{}:{}: \"{}\" is not a coordinate; repair or export the "
                                         "mesh again",
                                         name, scan.line(), found));
  fail_syntax(name, scan.line(), "a number", found);
}

void parse_facet(TextScan& scan, const std::string& name, Solid& solid) {
  expect(scan, "normal", name);
  for (int i = 0; i < 3; ++i)  // often nan for slivers, and never needed
    if (scan.word().empty()) fail_syntax(name, scan.line(), "a number", "");
  expect(scan, "outer", name);
  expect(scan, "loop", name);
  Corners corners;
  for (auto& corner : corners) {
    expect(scan, "vertex", name);
    for (float& x : corner) {
      x = coordinate(scan, name);
      if (std::fabs(x) > detail::kFarthest) fail_far(name, solid.triangles() + 1, x);
    }
  }
  expect(scan, "endloop", name);
  expect(scan, "endfacet", name);
  solid.add(corners);
}

TriMesh parse_ascii(std::string_view bytes, const std::string& name) {
  Solid solid(name);
  TextScan scan(bytes);
  bool in_solid = false;
  for (;;) {
    const std::string_view word = scan.word();
    if (word.empty()) break;
    if (detail::equals_ignoring_case(word, in_solid ? "endsolid" : "solid")) {
      in_solid = !in_solid;  // several solids in one file are one stock
      scan.rest_of_line();   // the name of the solid
    } else if (in_solid && detail::equals_ignoring_case(word, "facet")) {
      parse_facet(scan, name, solid);
    } else {
      fail_syntax(name, scan.line(), in_solid ? "facet or endsolid" : "solid", word);
    }
  }
  if (in_solid) fail_syntax(name, scan.line(), "endsolid", "");
  return solid.take();
}

bool starts_with_solid(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  return begin != bytes.npos && detail::equals_ignoring_case(bytes.substr(begin, 5), "solid");
}

// Text has no control bytes but blanks; every binary STL of a real solid has zeros in its floats.
bool looks_like_text(std::string_view bytes) {
  for (const char c : bytes.substr(0, 1024))
    if (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\r' && c != '\t') return false;
  return true;
}

// Viewers shade by it; zero for a triangle without area.
std::array<float, 3> facet_normal(const MeshBlock& block, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = to_vec(block.points[t[0]]);
  const Vec3 n = normalized(cross(to_vec(block.points[t[1]]) - a, to_vec(block.points[t[2]]) - a));
  return {float(n.x), float(n.y), float(n.z)};
}

char* store_point(char* at, const std::array<float, 3>& point) {
  for (const float x : point) at = detail::store(at, x);
  return at;
}

std::string header_of(std::uint64_t triangles) {
  if (triangles > 0xffffffff)
    throw Error("stl-too-large", "the mesh has more triangles than an STL file counts");
  std::string header = "mrsim binary STL, mm";
  header.resize(80, ' ');
  detail::store(header, std::uint32_t(triangles));
  return header;
}

void write_triangles(const MeshBlock& block, int threads, const ByteSink& out) {
  detail::write_items(block.triangles.size(), threads, out, [&](std::string& text, std::size_t f) {
    const auto& t = block.triangles[f];
    char record[kTriangle] = {};
    char* at = store_point(record, facet_normal(block, t));
    for (const std::uint32_t v : t) at = store_point(at, block.points[v]);
    text.append(record, kTriangle);
  });
}

void append_point(std::string& text, const std::array<float, 3>& point) {
  for (const float x : point) {
    text += ' ';
    detail::append_number(text, x);
  }
}

}  // namespace

TriMesh parse_stl(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) throw Error("stl-empty", fmt::format("{} is empty", name));
  // The count of a text file read as binary would be printable characters, more than 4 GB of
  // triangles: a file whose size fits its count is binary, whatever its first word.
  const bool binary_fits =
      bytes.size() >= kHeader &&
      bytes.size() >=
          kHeader + std::uint64_t(detail::load<std::uint32_t>(bytes.data() + 80)) * kTriangle;
  const std::string_view text = detail::without_mark(bytes);
  if (starts_with_solid(text) && looks_like_text(text) && !binary_fits)
    return parse_ascii(text, name);
  if (bytes.size() < kHeader) {
    if (looks_like_text(bytes))
      throw Error("stl-syntax", fmt::format("{} is not an STL file: it begins neither with "
                                            "\"solid\" nor with a binary header",
                                            name));
    throw Error("stl-truncated", fmt::format("{} is cut short: {} bytes are less than the header "
                                             "of a binary STL; copy or export it again",
                                             name, bytes.size()));
  }
  return parse_binary(bytes, name);
}

void write_stl(const MeshSource& mesh, const ByteSink& out, int threads) {
  detail::write_text(header_of(mesh.triangles()), out);
  mesh.for_each_block([&](const MeshBlock& block) { write_triangles(block, threads, out); });
}

StlStream::StlStream(DraftFile& draft, int threads)
    : draft_(draft), sink_(draft.sink()), threads_(threads) {
  detail::write_text(header_of(0), sink_);
}

void StlStream::take(const MeshBlock& block) {
  write_triangles(block, threads_, sink_);
  triangles_ += block.triangles.size();
}

void StlStream::restart() {
  draft_.clear();
  triangles_ = 0;
  detail::write_text(header_of(0), sink_);
}

void StlStream::finish() {
  draft_.patch(header_of(triangles_));
  draft_.finish();
}

void write_stl_ascii(const MeshSource& mesh, const ByteSink& out, int threads) {
  detail::write_text("solid mrsim\n", out);
  mesh.for_each_block([&](const MeshBlock& block) {
    detail::write_items(block.triangles.size(), threads, out,
                        [&](std::string& text, std::size_t f) {
                          const auto& t = block.triangles[f];
                          text += "facet normal";
                          append_point(text, facet_normal(block, t));
                          text += "\n outer loop\n";
                          for (const std::uint32_t v : t) {
                            text += "  vertex";
                            append_point(text, block.points[v]);
                            text += '\n';
                          }
                          text += " endloop\nendfacet\n";
                        });
  });
  detail::write_text("endsolid mrsim\n", out);
}

}  // namespace mrsim
