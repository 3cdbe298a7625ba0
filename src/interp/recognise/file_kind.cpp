#include "interp/recognise/file_kind.h"

namespace mrsim {
namespace {

constexpr std::size_t kStlHeader = 80, kStlTriangle = 50;

struct Kind {
  std::string_view start, name;
};
using namespace std::string_view_literals;
constexpr Kind kKinds[] = {{"\x20\x42\x44\x56\0\0\0\0"sv, "an OpenVDB file"},
                           {"\x89PNG"sv, "a picture (PNG)"},
                           {"\xFF\xD8\xFF"sv, "a picture (JPEG)"},
                           {"%PDF-"sv, "a PDF document"},
                           {"PK\x03\x04"sv, "a ZIP archive, as 3MF and FreeCAD's files are"},
                           {"\x1F\x8B"sv, "compressed by gzip"},
                           {"glTF"sv, "a mesh (GLB)"},
                           {"ply\n"sv, "a mesh (PLY)"},
                           {"ply\r"sv, "a mesh (PLY)"},
                           {"OFF\n"sv, "a mesh (OFF)"},
                           {"OFF\r"sv, "a mesh (OFF)"},
                           {"ISO-10303-21"sv, "a solid (STEP)"},
                           {"\x7F"
                            "ELF"sv,
                            "a program of this computer"},
                           {"<?xml"sv, "an XML file"},
                           {"<!DOCTYPE"sv, "an HTML page"},
                           {"<!doctype"sv, "an HTML page"},
                           {"<html"sv, "an HTML page"},
                           {"<svg"sv, "a drawing (SVG)"}};

// 80 bytes, the number of triangles, and these.
bool is_binary_stl(std::string_view head, std::uint64_t size) {
  if (head.size() < kStlHeader + 4) return false;
  std::uint64_t triangles = 0;
  for (int k = 3; k >= 0; --k)
    triangles = 256 * triangles +
                static_cast<unsigned char>(head[kStlHeader + static_cast<std::size_t>(k)]);
  return triangles > 0 && size == kStlHeader + 4 + kStlTriangle * triangles;
}

bool is_text_stl(std::string_view head) {
  return head.starts_with("solid") && head.find("facet") != head.npos;
}

// `{"name": ...`; a brace alone may be CODESYS'.
bool is_json(std::string_view head) {
  const std::size_t brace = head.find_first_not_of(" \t\r\n");
  if (brace == head.npos || (head[brace] != '{' && head[brace] != '[')) return false;
  const std::size_t next = head.find_first_not_of(" \t\r\n{[", brace + 1);
  if (next == head.npos || head[next] != '"') return false;
  const std::size_t end = head.find('"', next + 1);
  return end != head.npos && end + 1 < head.size() &&
         (head[end + 1] == ':' || head[end + 1] == ' ');
}

// "  0", "SECTION": group code and name.
bool is_dxf(std::string_view head) {
  const std::size_t zero = head.find_first_not_of(" \t");
  if (zero == head.npos || head[zero] != '0') return false;
  const std::size_t name = head.find_first_not_of(" \t\r\n", zero + 1);
  return name != head.npos && name > zero + 1 && head.substr(name).starts_with("SECTION");
}

}  // namespace

std::string_view kind_of_file(std::string_view head, std::uint64_t size) {
  for (const Kind& kind : kKinds)
    if (head.starts_with(kind.start)) return kind.name;
  if (is_binary_stl(head, size) || is_text_stl(head)) return "a mesh (STL)";
  if (is_json(head)) return "a JSON file";
  if (is_dxf(head)) return "a drawing (DXF)";
  return {};
}

}  // namespace mrsim
