#include "mesh/format/off.h"

#include "core/text/bytes.h"
#include "mesh/format/item_writer.h"
#include "mesh/format/mesh_builder.h"
#include "mesh/format/text_scan.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

using detail::MeshBuilder;
using detail::TextScan;

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name)
      : scan_(text), size_(text.size()), builder_("off", name) {}

  TriMesh read() {
    const std::string_view header = word();
    const bool colored = header == "COFF", normals = header == "NOFF";
    if (header != "OFF" && !colored && !normals)
      builder_.fail("syntax", "it does not begin with OFF");
    const std::int64_t vertices = count(), faces = count();
    integer();  // edges, which nobody counts
    // A vertex takes at least six characters and a face eight: no more are believed.
    if (vertices > std::int64_t(size_ / 6 + 1) || faces > std::int64_t(size_ / 6 + 1))
      builder_.fail("truncated", fmt::format("its header claims {} vertices and {} faces, more "
                                             "than its {} bytes can hold",
                                             vertices, faces, size_));
    for (std::int64_t i = 0; i < vertices; ++i) {
      const double x = number(), y = number(), z = number();
      builder_.add_vertex(x, y, z);
      skip_line();
    }
    for (std::int64_t i = 0; i < faces; ++i) read_face();
    return builder_.take();
  }

 private:
  std::string_view word() {
    for (;;) {
      const std::string_view w = scan_.word();
      if (w.empty()) builder_.fail("truncated", "it is cut short");
      if (w.front() != '#') return w;
      scan_.rest_of_line();
    }
  }
  double number() {
    const auto value = detail::to_float(word());
    if (!value)
      builder_.fail("nan",
                    fmt::format("line {} has a coordinate that is not a number", scan_.line()));
    return *value;
  }
  std::int64_t integer() {
    const auto value = detail::to_integer(word());
    if (!value)
      builder_.fail("syntax", fmt::format("line {}: a whole number is expected", scan_.line()));
    return *value;
  }
  std::int64_t count() {
    const std::int64_t n = integer();
    if (n < 0) builder_.fail("syntax", "a count is negative");
    return n;
  }
  void skip_line() { scan_.rest_of_line(); }  // colours, normals

  void read_face() {
    const std::int64_t corners = count();
    if (corners > std::int64_t(size_)) builder_.fail("truncated", "it is cut short");
    corners_.clear();
    for (std::int64_t k = 0; k < corners; ++k) corners_.push_back(integer());
    builder_.add_face(corners_, -1);
    skip_line();
  }

  TextScan scan_;
  std::size_t size_;
  MeshBuilder builder_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

TriMesh parse_off(std::string_view text, const std::string& name) {
  return OffReader(text, name).read();
}

void write_off(const MeshSource& mesh, const ByteSink& out, int threads) {
  detail::write_text(fmt::format("OFF\n{} {} 0\n", mesh.vertices(), mesh.triangles()), out);
  mesh.for_each_block([&](const MeshBlock& block) {
    const auto fresh = block.fresh();
    detail::write_items(fresh.size(), threads, out, [&](std::string& text, std::size_t v) {
      for (std::size_t k = 0; k < 3; ++k) {
        detail::append_number(text, fresh[v][k]);
        text += k < 2 ? ' ' : '\n';
      }
    });
  });
  mesh.for_each_block([&](const MeshBlock& block) {
    detail::write_items(block.triangles.size(), threads, out,
                        [&](std::string& text, std::size_t f) {
                          text += '3';
                          for (const std::uint32_t v : block.triangles[f]) {
                            text += ' ';
                            detail::append_number(text, std::int64_t(block.number(v)));
                          }
                          text += '\n';
                        });
  });
}

}  // namespace mrsim
