#include "mesh/draw/palette.h"

#include "mesh/solid/owner_set.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr Rgb kToolColors[] = {{86, 180, 233}, {230, 159, 0},  {0, 158, 115}, {204, 121, 167},
                               {0, 114, 178},  {240, 228, 66}, {213, 94, 0}};

// Control points of the ramp for lines, equally spaced.
constexpr Rgb kRamp[] = {{58, 98, 172},  {48, 128, 168},  {62, 152, 144}, {132, 168, 96},
                         {190, 162, 66}, {232, 170, 110}, {250, 190, 170}};

std::uint8_t blend(int a, int b, std::size_t share, std::size_t whole) {
  return std::uint8_t((std::size_t(a) * (whole - share) + std::size_t(b) * share + whole / 2) /
                      whole);
}

Rgb scaled(const Rgb& c, int percent) {
  Rgb out;
  for (int k = 0; k < 3; ++k) out[k] = std::uint8_t(std::min(255, c[k] * percent / 100));
  return out;
}

Rgb ramp(std::size_t i, std::size_t count) {
  constexpr std::size_t kSteps = std::size(kRamp) - 1;
  const std::size_t whole = std::max<std::size_t>(count - 1, 1);
  const std::size_t scaled_index = i * kSteps;
  const std::size_t step = std::min(scaled_index / whole, kSteps - 1);
  Rgb out;
  for (int k = 0; k < 3; ++k)
    out[k] = blend(kRamp[step][k], kRamp[step + 1][k], scaled_index - step * whole, whole);
  return i % 2 == 0 ? out : scaled(out, 86);
}

// After the seven colours follow their darker shades.
Rgb tool_color(std::size_t tool) {
  constexpr std::size_t kCount = std::size(kToolColors);
  return scaled(kToolColors[tool % kCount],
                100 - 18 * int(std::min<std::size_t>(tool / kCount, 3)));
}

// What owners must agree in to have one colour; the stock sorts first.
using Key = std::tuple<int, std::int32_t, std::int32_t>;

Key key_of(const OwnerTable& table, ColorBy by, std::int32_t owner) {
  if (owner < 0) return {0, 0, 0};
  const FaceOrigin* origin = find_origin(table, owner);
  if (!origin) return {2, owner, 0};
  return by == ColorBy::tool ? Key{1, origin->tool, 0} : Key{1, origin->file, origin->line};
}

std::string label_of(const OwnerTable& table, ColorBy by, std::int32_t owner) {
  const FaceOrigin* origin = find_origin(table, owner);
  if (!origin || by != ColorBy::tool) {
    const std::string label = owner_label(table, owner);
    return label.substr(0, label.find(", tool"));
  }
  const bool known = origin->tool >= 0 && std::size_t(origin->tool) < table.tools.size();
  return known && !table.tools[origin->tool].empty()
             ? fmt::format("tool {}", table.tools[origin->tool])
             : "tool";
}

}  // namespace

const FaceOrigin* find_origin(const OwnerTable& table, std::int32_t owner) {
  const auto at =
      std::lower_bound(table.origins.begin(), table.origins.end(), owner,
                       [](const FaceOrigin& a, std::int32_t wanted) { return a.owner < wanted; });
  return at != table.origins.end() && at->owner == owner && owner >= 0 ? &*at : nullptr;
}

std::string owner_label(const OwnerTable& table, std::int32_t owner) {
  if (owner < 0) return "stock";
  const FaceOrigin* origin = find_origin(table, owner);
  if (!origin) return fmt::format("motion {}", owner);
  std::string file = "program";
  if (origin->file >= 0 && std::size_t(origin->file) < table.files.size())
    file = table.files[origin->file].substr(table.files[origin->file].find_last_of('/') + 1);
  std::string label = fmt::format("{}:{}", file, origin->line);
  if (origin->tool >= 0 && std::size_t(origin->tool) < table.tools.size() &&
      !table.tools[origin->tool].empty())
    label += fmt::format(", tool {}", table.tools[origin->tool]);
  return label;
}

OwnerColors color_owners(const std::vector<std::int32_t>& owners, const OwnerTable& table,
                         ColorBy by) {
  OwnerColors out;
  if (by == ColorBy::none || owners.empty()) return out;
  for (const std::int32_t owner : owners) out.entry_of.try_emplace(std::max(owner, -1), 0);
  std::map<Key, std::uint32_t> entry_of_key;
  for (const auto& [owner, entry] : out.entry_of)
    entry_of_key.try_emplace(key_of(table, by, owner), 0);
  std::uint32_t count = 0;
  for (auto& [key, entry] : entry_of_key) entry = count++;
  out.entries.resize(count);
  const bool has_stock = entry_of_key.begin()->first == Key{0, 0, 0};
  for (auto item = out.entry_of.rbegin(); item != out.entry_of.rend(); ++item) {
    const Key key = key_of(table, by, item->first);
    PaletteEntry& entry = out.entries[item->second = entry_of_key[key]];
    entry.owner = item->first;
    entry.label = label_of(table, by, item->first);
    if (item->first < 0) continue;
    entry.color = by == ColorBy::tool
                      ? tool_color(std::size_t(std::max(std::get<1>(key), std::int32_t(0))))
                      : ramp(item->second - has_stock, count - has_stock);
  }
  return out;
}

std::vector<std::int32_t> owners_of(const MeshSource& mesh) {
  OwnerSet owners;
  mesh.for_each_block([&](const MeshBlock& block) { owners.add(block.owners); });
  return owners.sorted();
}

FacePalette make_palette(const TriMesh& mesh, ColorBy by) {
  FacePalette out;
  if (by == ColorBy::none || mesh.owners.size() != mesh.triangles.size()) return out;
  const OwnerColors colors = color_owners(owners_of(MemoryMesh(mesh)), mesh.origin, by);
  out.entries = colors.entries;
  out.index.reserve(mesh.owners.size());
  for (const std::int32_t owner : mesh.owners) out.index.push_back(colors.entry(owner));
  return out;
}

}  // namespace mrsim
