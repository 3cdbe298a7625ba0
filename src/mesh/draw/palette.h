// Colours that show which line or which tool cut a face: equal meshes have equal colours, which
// colour-blind people distinguish too.
#pragma once

#include "mesh/solid/mesh_source.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace mrsim {

using Rgb = std::array<std::uint8_t, 3>;  ///< sRGB

inline constexpr Rgb kStockColor = {178, 182, 188};

struct PaletteEntry {
  Rgb color = kStockColor;
  std::string label;        ///< "stock", "tool 4", "PRIMER_2F.MPF:12"
  std::int32_t owner = -1;  ///< the first owner that has it
};

struct FacePalette {
  std::vector<PaletteEntry> entries;  ///< stock first where it occurs, then by program order
  std::vector<std::uint32_t> index;   ///< #F: into entries; empty without colours
};

/// The colours of a mesh, looked up by owner.
struct OwnerColors {
  std::vector<PaletteEntry> entries;
  std::map<std::int32_t, std::uint32_t> entry_of;  ///< by owner, the stock's being -1
  bool empty() const { return entry_of.empty(); }
  std::uint32_t entry(std::int32_t owner) const { return entry_of.at(owner < -1 ? -1 : owner); }
};
/// `owners`: ascending, each once.
OwnerColors color_owners(const std::vector<std::int32_t>& owners, const OwnerTable& table,
                         ColorBy by);

/// The owners that a mesh names, ascending.
std::vector<std::int32_t> owners_of(const MeshSource& mesh);

/// Tools: a set of colours made for colour blindness (after Okabe and Ito), by the order of the
/// tool list. Lines: a ramp from blue to ochre that grows steadily lighter, from the first line to
/// the last, every second line a little darker. Empty where the mesh has no owners or `by` is none.
FacePalette make_palette(const TriMesh& mesh, ColorBy by);

/// The entry of `owner`, null for the stock and for owners without one.
const FaceOrigin* find_origin(const OwnerTable& table, std::int32_t owner);

/// "PRIMER_2F.MPF:12, tool 4", "stock", "motion 7" (nothing known but the index).
std::string owner_label(const OwnerTable& table, std::int32_t owner);

}  // namespace mrsim
