#include "compare/blame/blame.h"

#include "core/numbers/vec.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

LineKey key_of(std::int32_t owner, const OwnerTable& table) {
  if (owner < 0) return {};
  const auto at = std::lower_bound(
      table.origins.begin(), table.origins.end(), owner,
      [](const FaceOrigin& origin, std::int32_t value) { return origin.owner < value; });
  if (at == table.origins.end() || at->owner != owner) return {-1, -owner - 2, -1};
  return {at->file, at->line, at->tool};
}

}  // namespace

FaceLines::FaceLines(const TriMesh& part) : index_(part.triangles.size(), 0) {
  if (part.owners.size() != part.triangles.size()) {
    lines_ = {LineKey{}};
    return;
  }
  std::map<std::int32_t, LineKey> keys;
  for (const std::int32_t owner : part.owners)
    if (!keys.count(owner)) keys.emplace(owner, key_of(owner, part.origin));
  for (const auto& [owner, key] : keys) lines_.push_back(key);
  std::sort(lines_.begin(), lines_.end());
  lines_.erase(std::unique(lines_.begin(), lines_.end()), lines_.end());
  std::map<std::int32_t, std::uint32_t> places;
  for (const auto& [owner, key] : keys) {
    const auto at = std::lower_bound(lines_.begin(), lines_.end(), key) - lines_.begin();
    places[owner] = static_cast<std::uint32_t>(at);
    any_cut_ = any_cut_ || !key.is_stock();
  }
  std::int32_t last = -1;
  std::uint32_t place = places.count(-1) ? places[-1] : 0;
  for (std::size_t f = 0; f < index_.size(); ++f) {
    if (part.owners[f] != last || f == 0) place = places[last = part.owners[f]];
    index_[f] = place;
  }
}

std::vector<LineFigures> line_figures(const DeviationField& part, const FaceLines& lines,
                                      const Acceptance& band) {
  std::vector<LineFigures> out(lines.lines().size());
  std::vector<bool> seen(out.size(), false);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const LineKey& key = lines.lines()[i];
    out[i].file = key.file;
    out[i].line = key.line;
    out[i].tool = key.tool;
  }
  for (std::size_t i = 0; i < part.hits.size(); ++i) {
    const std::uint32_t at = lines.index(part.samples.faces[i]);
    LineFigures& f = out[at];
    const double d = part.hits[i].distance;
    f.min = seen[at] ? std::min(f.min, d) : d;
    f.max = seen[at] ? std::max(f.max, d) : d;
    seen[at] = true;
    if (i >= part.samples.spread) continue;  // vertices have no area
    f.area += part.samples.weight;
    f.mean += part.samples.weight * d;
    if (d < band.lo || d > band.hi) f.out_area += part.samples.weight;
  }
  for (LineFigures& f : out)
    if (f.area > 0) f.mean /= f.area;
  return out;
}

CutSurface::CutSurface(const TriMesh& part, const FaceLines& lines) : lines_(lines) {
  TriMesh cut;
  cut.vertices = part.vertices;
  for (std::uint32_t f = 0; f < part.triangles.size(); ++f) {
    if (lines.of(f).is_stock()) continue;
    cut.triangles.push_back(part.triangles[f]);
    faces_.push_back(f);
  }
  if (!faces_.empty()) tree_ = std::make_unique<TriangleTree>(cut);
}

CutSurface::Nearest CutSurface::nearest(const Vec3& p) const {
  const TriangleTree::Hit hit = tree_->nearest(p);
  return {lines_.of(faces_[hit.triangle]), std::sqrt(hit.distance2)};
}

BlamedLine name_line(const LineKey& key, const OwnerTable& table,
                     const std::vector<std::vector<std::string>>& texts) {
  BlamedLine out;
  const auto file = static_cast<std::size_t>(key.file);
  out.line = key.line > 0 ? key.line : 0;
  if (key.file >= 0 && file < table.files.size()) out.file = table.files[file];
  if (key.line < 0) out.file = "move " + std::to_string(-key.line - 2);
  if (key.tool >= 0 && static_cast<std::size_t>(key.tool) < table.tools.size())
    out.tool = table.tools[static_cast<std::size_t>(key.tool)];
  if (key.file >= 0 && file < texts.size() && key.line >= 1 &&
      static_cast<std::size_t>(key.line) <= texts[file].size())
    out.text = texts[file][static_cast<std::size_t>(key.line) - 1];
  return out;
}

}  // namespace mrsim
