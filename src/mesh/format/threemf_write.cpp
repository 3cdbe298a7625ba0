#include "core/text/zip.h"
#include "mesh/draw/palette.h"
#include "mesh/format/item_writer.h"
#include "mesh/format/origin_text.h"
#include "mesh/format/text_scan.h"
#include "mesh/format/threemf.h"

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

}  // namespace mrsim
