#include "outputs.h"

#include "core/suggest.h"
#include "core/text_io.h"
#include "mesh/stl.h"
#include <mrsim/mrsim.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

namespace mrsim {
namespace {

using MeshWriter = void (*)(const TriMesh&, const ByteSink&);

struct Format {
  std::string_view extension;
  MeshWriter writer;
};
constexpr Format kFormats[] = {{".stl", write_stl}};

MeshWriter find_writer(const std::string& path) {
  const std::string extension = file_extension(path);
  for (const Format& format : kFormats)
    if (format.extension == extension) return format.writer;
  std::vector<std::string_view> known;
  std::string all;
  for (const Format& format : kFormats) {
    known.push_back(format.extension);
    all += std::string(format.extension) + " ";
  }
  throw Error("format-unknown",
              fmt::format("cannot write {}: {}{} (known: {}.vdb)", path,
                          extension.empty() ? "its name has no extension to tell the format"
                                            : "unknown format " + extension,
                          suggestion(extension, known), all),
              Error::Kind::usage);
}

}  // namespace

std::string file_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

void check_outputs(const std::vector<std::string>& paths) {
  std::set<std::string> seen;
  for (const std::string& path : paths) {
    if (file_extension(path) != ".vdb") find_writer(path);
    check_writable(path);
    if (!seen.insert(std::filesystem::absolute(path).lexically_normal().string()).second)
      throw Error("output-twice", fmt::format("{} is given as output twice", path),
                  Error::Kind::usage);
  }
}

void write_outputs(const std::vector<std::string>& paths, const TriMesh& mesh, const Stock& stock,
                   const StockRecipe& recipe) {
  std::vector<OutputFile> files;
  for (const std::string& path : paths) {
    if (file_extension(path) == ".vdb")
      files.push_back({path, [&](const ByteSink& out) { write_vdb(stock, recipe, out); }});
    else
      files.push_back(
          {path, [&, writer = find_writer(path)](const ByteSink& out) { writer(mesh, out); }});
  }
  write_files_atomically(files);
}

TriMesh read_mesh(const std::string& path) {
  const std::string extension = file_extension(path);
  if (extension == ".stl") return parse_stl(read_file(path), path);
  throw Error("format-unknown", fmt::format("cannot read {}: unknown format (known: .stl)", path));
}

void write_mesh(const std::string& path, const TriMesh& mesh) {
  const MeshWriter writer = find_writer(path);
  write_file_atomically(path, [&](const ByteSink& out) { writer(mesh, out); });
}

}  // namespace mrsim
