#include "vdb_files.h"

#include "core/bytes.h"
#include "core/child_process.h"
#include "core/error.h"
#include "core/heap.h"
#include "core/text_io.h"
#include "voxel_module.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr const char* kUnreadable = "vdb-unreadable";

// What goes through the pipe: numbers, then the texts, vertices and triangles.
struct SurfaceHeader {
  double voxel = 0;
  std::uint64_t code = 0, fault = 0, grid = 0, hash = 0, vertices = 0, triangles = 0;
};

void send(const LevelSetSurface& found, const std::string& code, const std::string& fault,
          const ByteSink& sink) {
  const SurfaceHeader header{found.voxel,
                             code.size(),
                             fault.size(),
                             found.grid.size(),
                             found.hash.size(),
                             found.surface.vertices.size(),
                             found.surface.triangles.size()};
  sink(&header, sizeof header);
  sink(code.data(), code.size());
  sink(fault.data(), fault.size());
  sink(found.grid.data(), found.grid.size());
  sink(found.hash.data(), found.hash.size());
  sink(found.surface.vertices.data(), bytes_of(found.surface.vertices));
  sink(found.surface.triangles.data(), bytes_of(found.surface.triangles));
}

// Empty where the bytes are fewer than their header says: the process died while it wrote.
std::optional<LevelSetSurface> receive(const std::string& bytes, const std::string& path) {
  SurfaceHeader header;
  if (bytes.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, bytes.data(), sizeof header);
  LevelSetSurface found;
  const std::size_t texts = header.code + header.fault + header.grid + header.hash;
  if (bytes.size() != sizeof header + texts + header.vertices * sizeof(found.surface.vertices[0]) +
                          header.triangles * sizeof(found.surface.triangles[0]))
    return std::nullopt;
  const char* at = bytes.data() + sizeof header;
  const auto take = [&](std::size_t size) {
    at += size;
    return std::string(at - size, size);
  };
  const std::string code = take(header.code), fault = take(header.fault);
  if (code == kUnreadable) throw Error(code, path + ": " + fault);
  if (!code.empty()) throw Error(code, fault);
  found.voxel = header.voxel;
  found.grid = take(header.grid);
  found.hash = take(header.hash);
  found.surface.vertices.resize(header.vertices);
  found.surface.triangles.resize(header.triangles);
  std::memcpy(found.surface.vertices.data(), at, bytes_of(found.surface.vertices));
  at += bytes_of(found.surface.vertices);
  std::memcpy(found.surface.triangles.data(), at, bytes_of(found.surface.triangles));
  return found;
}

// The module is opened there, too: a library that it needs starts threads while it is loaded, and a
// process that is copied while threads start may wait for ever.
LevelSetSurface read_voxels(const std::string& path, std::size_t size) {
  ChildLimits limits;
  limits.what = "reading " + path;
  limits.seconds = 60 + static_cast<int>(std::min<std::size_t>(size >> 20, 1000)) * 5;
  limits.bytes = (std::size_t(3) << 29) + 100 * size;
  const ChildOutcome outcome = run_in_child(limits, [&](const ByteSink& sink) {
    LevelSetSurface found;
    std::string code, fault;
    try {
      read_level_set(path, found);
    } catch (const Error& error) {
      code = error.code();
      fault = error.what();
    }
    send(found, code, fault, sink);
  });
  using End = ChildOutcome::End;
  if (outcome.end == End::done)
    if (std::optional<LevelSetSurface> found = receive(outcome.bytes, path))
      return *std::move(found);
  throw Error(kUnreadable, path +
                               (outcome.end == End::too_long ? ": OpenVDB takes too long to read it"
                                : outcome.end == End::out_of_memory
                                    ? ": OpenVDB takes too much memory to read it"
                                    : ": the file is damaged: OpenVDB crashed "
                                      "while it read it") +
                               "; write it again, or give the stock as a mesh");
}

std::string accuracy_of(const LevelSetSurface& found) {
  return fmt::format(
      "the surface of the level set \"{}\", whose voxels are {:.4g} mm: edges are off by up to "
      "half "
      "of one, and what is thinner than one is lost",
      found.grid, found.voxel);
}

}  // namespace

VdbContent read_vdb_file(const std::string& path) {
  const std::string bytes = read_file(path);
  VdbFile file = read_vdb(bytes, path);
  VdbContent content;
  if (file.recipe && !file.rewritten) {
    content.recipe = std::move(file.recipe);
    return content;
  }
  LevelSetSurface found = read_voxels(path, bytes.size());
  if (file.recipe && found.hash == file.voxels) {
    content.recipe = std::move(file.recipe);
    return content;
  }
  content.accuracy = path + ": " + accuracy_of(found);
  if (file.recipe)
    content.accuracy +=
        "; another program has changed the voxels since mrsim saved them, so the cuts and the "
        "exact surface that came with them are not used";
  content.surface = std::move(found.surface);
  return content;
}

}  // namespace mrsim
