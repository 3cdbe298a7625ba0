#include "run/files/vdb_files.h"

#include "core/process/child_process.h"
#include "core/process/error.h"
#include "core/text/text_io.h"
#include "run/files/voxel_module.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr const char* kUnreadable = "vdb-unreadable";

ChildParcel read_parcel(const std::string& path) {
  LevelSetSurface found;
  try {
    read_level_set(path, found);
  } catch (const Error& error) {
    if (error.code() != kUnreadable) throw;
    throw Error(kUnreadable, path + ": " + error.what());
  }
  return {{found.voxel}, {found.grid, found.hash}, std::move(found.surface)};
}

// The module is opened there, too: a library that it needs starts threads while it is loaded, and a
// process that is copied while threads start may wait for ever.
LevelSetSurface read_voxels(const std::string& path, std::size_t size) {
  ChildLimits limits;
  limits.what = "reading " + path;
  limits.seconds = 60 + static_cast<int>(std::min<std::size_t>(size >> 20, 1000)) * 5;
  limits.bytes = (std::size_t(3) << 29) + 100 * size;
  ChildDelivery delivery = deliver_from_child(limits, [&] { return read_parcel(path); });
  using End = ChildOutcome::End;
  if (delivery.end == End::done) {
    ChildParcel& parcel = delivery.parcel;
    return {parcel.texts[0], parcel.numbers[0], parcel.texts[1], std::move(parcel.mesh)};
  }
  throw Error(
      kUnreadable,
      path +
          (delivery.end == End::too_long        ? ": OpenVDB takes too long to read it"
           : delivery.end == End::out_of_memory ? ": OpenVDB takes too much memory to read it"
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
