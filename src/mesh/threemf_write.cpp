#include "mesh/origin_text.h"
#include "mesh/palette.h"
#include "mesh/text_scan.h"
#include "mesh/threemf.h"
#include "mesh/zip.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr const char* kXml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
constexpr const char* kTypes =
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" "
    "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
constexpr const char* kRelations =
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

// Each owner of the mesh with its base material.
std::map<std::int32_t, std::size_t> bases_of(const TriMesh& mesh) {
  std::map<std::int32_t, std::size_t> base;
  for (const std::int32_t owner : mesh.owners) base.try_emplace(owner, 0);
  std::size_t count = 0;
  for (auto& [owner, index] : base) index = count++;
  return base;
}

std::string metadata(const TriMesh& mesh, const std::map<std::int32_t, std::size_t>& bases) {
  std::string text = "bases";
  for (const auto& [owner, index] : bases) text += fmt::format(" {}", owner);
  for (const std::string& line : origin_lines(mesh.origin)) text += "\n" + to_utf8(line);
  return "<metadata name=\"mrsim:origin\">" + xml_escaped(text) + "\n</metadata>\n";
}

std::string materials(const TriMesh& mesh, ColorBy color,
                      const std::map<std::int32_t, std::size_t>& bases) {
  std::map<std::int32_t, Rgb> color_of;
  const FacePalette palette = make_palette(mesh, color);
  for (std::size_t f = 0; f < palette.index.size(); ++f)
    color_of.try_emplace(mesh.owners[f], palette.entries[palette.index[f]].color);
  std::string xml = "<basematerials id=\"1\">\n";
  for (const auto& [owner, index] : bases) {
    const auto found = color_of.find(owner);
    const Rgb c = found == color_of.end() ? kStockColor : found->second;
    xml += fmt::format("<base name=\"{}\" displaycolor=\"#{:02X}{:02X}{:02X}\"/>\n",
                       xml_escaped(to_utf8(owner_label(mesh.origin, owner))), c[0], c[1], c[2]);
  }
  return xml + "</basematerials>\n";
}

void append_geometry(const TriMesh& mesh, const std::map<std::int32_t, std::size_t>& bases,
                     std::string& xml) {
  xml += "<mesh>\n<vertices>\n";
  for (const auto& v : mesh.vertices) {
    const char* names[] = {"<vertex x=\"", "\" y=\"", "\" z=\""};
    for (int k = 0; k < 3; ++k) {
      xml += names[k];
      detail::append_number(xml, v[k]);
    }
    xml += "\"/>\n";
  }
  xml += "</vertices>\n<triangles>\n";
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const char* names[] = {"<triangle v1=\"", "\" v2=\"", "\" v3=\""};
    for (int k = 0; k < 3; ++k) {
      xml += names[k];
      detail::append_number(xml, std::int64_t(mesh.triangles[f][k]));
    }
    if (!bases.empty())
      xml += fmt::format("\" pid=\"1\" p1=\"{}", bases.find(mesh.owners[f])->second);
    xml += "\"/>\n";
  }
  xml += "</triangles>\n</mesh>\n";
}

}  // namespace

void write_3mf(const TriMesh& mesh, ColorBy color, const ByteSink& out) {
  const std::map<std::int32_t, std::size_t> bases = bases_of(mesh);
  std::string xml = kXml;
  xml +=
      "<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
      "xmlns:mrsim=\"urn:mrsim:origin\">\n<metadata name=\"Application\">mrsim</metadata>\n";
  if (!bases.empty()) xml += metadata(mesh, bases);
  xml += "<resources>\n";
  if (!bases.empty()) xml += materials(mesh, color, bases);
  xml += bases.empty() ? "<object id=\"2\" type=\"model\">\n"
                       : "<object id=\"2\" type=\"model\" pid=\"1\" pindex=\"0\">\n";
  append_geometry(mesh, bases, xml);
  xml += "</object>\n</resources>\n<build>\n<item objectid=\"2\"/>\n</build>\n</model>\n";
  const std::string bytes = detail::zip({{"[Content_Types].xml", std::string(kXml) + kTypes},
                                         {"_rels/.rels", std::string(kXml) + kRelations},
                                         {"3D/3dmodel.model", std::move(xml)}});
  out(bytes.data(), bytes.size());
}

}  // namespace mrsim
