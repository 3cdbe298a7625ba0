#include "mesh/format/obj.h"

#include "core/text/bytes.h"
#include "mesh/draw/palette.h"
#include "mesh/format/item_writer.h"
#include "mesh/format/mesh_builder.h"
#include "mesh/format/origin_text.h"
#include "mesh/format/text_scan.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace mrsim {
namespace {

using detail::MeshBuilder;
using detail::TextScan;

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name)
      : scan_(text), name_(name), builder_("obj", name) {}

  TriMesh read() {
    do {
      const std::string_view word = scan_.word_in_line();
      if (word == "v") read_vertex();
      if (word == "f") read_face();
      if (word == "#") read_comment();
      if (word == "g" || word == "o") owner_ = pending_owner_, pending_owner_ = -1;
    } while (scan_.next_line());
    builder_.mesh().origin = origin_.take();
    return builder_.take();
  }

 private:
  [[noreturn]] void fail(const std::string& text) const {
    builder_.fail("syntax", fmt::format("line {}: {}", scan_.line(), text));
  }

  void read_vertex() {
    float x[7];
    int count = 0;
    for (std::string_view w = scan_.word_in_line(); !w.empty() && w.front() != '#' && count < 7;
         w = scan_.word_in_line()) {
      const auto value = detail::to_float(w);
      if (!value) fail("a vertex has a coordinate that is not a number");
      x[count++] = *value;
    }
    if (count < 3) fail("a vertex needs three coordinates");
    builder_.add_vertex(x[0], x[1], x[2]);
    if (count < 6) return;
    std::array<std::uint8_t, 3> color;
    for (int k = 0; k < 3; ++k)
      color[k] = std::uint8_t(std::lround(std::min(1.0f, std::max(0.0f, x[3 + k])) * 255));
    builder_.mesh().colors.push_back(color);
  }

  // "7", "7/1", "7//2", "-1/-1/-1": the vertex's part, counted from 1 or back from the last.
  std::int64_t corner(std::string_view word) const {
    const auto index = detail::to_integer(word.substr(0, word.find('/')));
    if (!index || *index == 0) fail("a face has a corner that is not an index");
    return *index > 0 ? *index - 1 : std::int64_t(builder_.vertex_count()) + *index;
  }

  void read_face() {
    corners_.clear();
    for (std::string_view w = scan_.word_in_line(); !w.empty(); w = scan_.word_in_line()) {
      if (w.front() == '#') break;
      if (w == "\\") {
        scan_.next_line();
        continue;
      }
      corners_.push_back(corner(w));
    }
    if (corners_.size() < 3) fail("a face needs three corners");
    builder_.add_face(corners_, owner_);
  }

  void read_comment() {
    if (scan_.word_in_line() != "mrsim") return;
    if (const auto owner = origin_.read(scan_.rest_of_line())) pending_owner_ = *owner;
  }

  TextScan scan_;
  const std::string& name_;
  MeshBuilder builder_;
  OriginReader origin_;
  std::int32_t owner_ = -1, pending_owner_ = -1;
  std::vector<std::int64_t> corners_;
};

// Group names have no blanks.
std::string group_name(const OwnerTable& table, std::int32_t owner) {
  std::string name = owner_label(table, owner);
  for (char& c : name)
    if (c == ' ' || c == ',' || static_cast<unsigned char>(c) < ' ') c = '_';
  return name;
}

void write_vertices(const MeshSource& mesh, const ByteSink& out, int threads) {
  mesh.for_each_block([&](const MeshBlock& block) {
    const auto fresh = block.fresh();
    detail::write_items(fresh.size(), threads, out, [&](std::string& text, std::size_t v) {
      text += 'v';
      for (const float x : fresh[v]) {
        text += ' ';
        detail::append_number(text, x);
      }
      if (!block.colors.empty())
        for (const std::uint8_t c : block.colors[v]) {
          text += ' ';
          detail::append_number(text, float(c) / 255);
        }
      text += '\n';
    });
  });
}

// A group begins where the owner changes.
void write_faces(const MeshSource& mesh, const ByteSink& out, int threads) {
  std::optional<std::int32_t> last;  // owner of the last triangle of the block before
  mesh.for_each_block([&](const MeshBlock& block) {
    const auto begins_group = [&](std::size_t f) {
      const std::optional<std::int32_t> before = f == 0 ? last : block.owners[f - 1];
      return before != block.owners[f];
    };
    detail::write_items(block.triangles.size(), threads, out,
                        [&](std::string& text, std::size_t f) {
                          if (!block.owners.empty() && begins_group(f)) {
                            if (block.owners[f] >= 0)
                              text += fmt::format("# mrsim group {}\n", block.owners[f]);
                            text += "g " + group_name(mesh.origin(), block.owners[f]) + "\n";
                          }
                          text += 'f';
                          for (const std::uint32_t v : block.triangles[f]) {
                            text += ' ';
                            detail::append_number(text, std::int64_t(block.number(v)) + 1);
                          }
                          text += '\n';
                        });
    if (!block.owners.empty()) last = block.owners.back();
  });
}

}  // namespace

TriMesh parse_obj(std::string_view text, const std::string& name) {
  return ObjReader(text, name).read();
}

void write_obj(const MeshSource& mesh, const ByteSink& out, int threads) {
  std::string head = "# mrsim, mm\n";
  for (const std::string& line : origin_lines(mesh.origin())) head += "# mrsim " + line + "\n";
  detail::write_text(head, out);
  write_vertices(mesh, out, threads);
  write_faces(mesh, out, threads);
}

}  // namespace mrsim
