#include "mesh/surface/vertex_placer.h"

#include "core/process/parallel.h"
#include "mesh/surface/input_hash.h"
#include "mesh/surface/sample_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mrsim::detail {
namespace {

constexpr double kPlaneCosine = 1 - 1e-9;  ///< between normals of one plane
constexpr double kPlaneRoom = 1e-5;        ///< mm: of its points, rounded

void add_crossing(InputHash& hash, const Crossing& c) {
  hash.add(c.position);
  hash.add(c.at);
}

}  // namespace

void VertexPlacer::place() {
  find_creases();
  place_loops();
  flatten_loops();
}

void VertexPlacer::count_segments() {
  segments_in_face_.assign(faces_.size(), 0);
  for (const Segment& s : segments_) ++segments_in_face_[static_cast<std::size_t>(s.face)];
}

// Segments between faces of the part that meet in a crease, and where it passes the faces of the
// cells.
void VertexPlacer::find_creases() {
  creases_.clear();
  count_segments();
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    Segment& s = segments_[k];
    s.crease = s.is_crease ? static_cast<std::int32_t>(creases_.size()) : -1;
    if (s.is_crease) creases_.push_back({static_cast<std::int32_t>(k), {}, {}});
  }
  std::vector<std::uint64_t> keys(creases_.size(), 0);
  std::vector<KnownPoints::Result> results(creases_.size());
  std::vector<std::uint8_t> is_known(creases_.size());
  const auto place = [&](std::size_t k) {
    const Segment& s = at(segments_, creases_[k].segment);
    if (options_.remember) keys[k] = key_of(s);
    const KnownPoints::Result* known = options_.remember ? known_creases_.find(keys[k]) : nullptr;
    is_known[k] = known != nullptr;
    results[k] = known ? *known : place_crease(s);
  };
  // Creases of cells with the same candidates follow each other.
  std::vector<std::int32_t> all(creases_.size());
  std::iota(all.begin(), all.end(), 0);
  const Groups groups(all, cells_.lists(), [&](std::int32_t k) {
    return cells_.list_of(face_cell(at(faces_, at(segments_, at(creases_, k).segment).face)));
  });
  parallel_for(
      groups.size(), options_.threads,
      [&](std::size_t g) {
        for (const std::int32_t k : groups[g]) place(static_cast<std::size_t>(k));
      },
      16);
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (options_.remember && !is_known[k]) known_creases_.add(keys[k], results[k]);
    creases_[k].point = results[k].point, creases_[k].outside = results[k].outside;
    if (results[k].smooth) segments_[static_cast<std::size_t>(creases_[k].segment)].crease = -1;
  }
}

KnownPoints::Result VertexPlacer::place_crease(const Segment& s) const {
  KnownPoints::Result result;
  const Crossing &a = at(crossings_, s.from), &b = at(crossings_, s.to);
  const CellFace& face = at(faces_, s.face);
  const Box3 box = face_box(face);
  const Probe p = probe(face_cell(face));
  const auto point = crease_in_face(p, box, face.axis, a.position, a.at, b.position, b.at);
  result.smooth = !point;
  if (result.smooth) return result;
  result.point = *point;
  const FieldSample ends[2] = {a.at, b.at};
  const Vec3 between = 0.5 * (a.position + b.position);
  if (options_.sharpen && is_crowded(s)) keep_apart(p, between, result.point);
  if (options_.sharpen && result.point.count == 0)
    result.outside = crease_near(p, box, face.axis, between, ends);
  return result;
}

void VertexPlacer::place_loops() {
  std::vector<std::uint64_t> keys(options_.remember ? loops_.size() : 0);
  std::vector<std::uint8_t> is_placed(loops_.size());
  outside_.assign(options_.sharpen ? loops_.size() : 0, {});
  parallel_for(
      loops_.size(), options_.threads,
      [&](std::size_t k) {
        Loop& loop = loops_[k];
        is_placed[k] = loop.point.count > 0 || !is_complete(loop.cell);
        if (is_placed[k] || !options_.remember) return;
        keys[k] = key_of(loop);
        const KnownPoints::Result* known = known_loops_.find(keys[k]);
        if (known == nullptr) return;
        is_placed[k] = 1;
        loop.point = known->point;
        if (options_.sharpen) outside_[k] = known->outside;
      },
      256);
  std::vector<std::int32_t> fresh;
  fresh.reserve(loops_.size());
  for (std::size_t k = 0; k < loops_.size(); ++k)
    if (!is_placed[k]) fresh.push_back(static_cast<std::int32_t>(k));
  const Groups groups(fresh, cells_.lists(),
                      [&](std::int32_t k) { return cells_.list_of(at(loops_, k).cell); });
  parallel_for(
      groups.size(), options_.threads, [&](std::size_t g) { place_loops_of(groups[g]); }, 16);
  if (!options_.remember) return;
  for (const std::int32_t k : fresh) {
    const auto i = static_cast<std::size_t>(k);
    known_loops_.add(keys[i], {loops_[i].point, options_.sharpen ? outside_[i] : SurfacePoint{}});
  }
}

// Cells and their candidates stay as long as the tree: the rest is told by the crossings.
std::uint64_t VertexPlacer::key_of(const Segment& s) const {
  const CellFace& face = at(faces_, s.face);
  const std::int32_t cell = face_cell(face);
  InputHash hash(
      static_cast<std::uint64_t>(cell) * 16 +
      static_cast<std::uint64_t>(4 * face.axis + 2 * (cell == face.low) + is_crowded(s)));
  for (const std::int32_t k : {s.from, s.to}) add_crossing(hash, at(crossings_, k));
  return hash.value();
}

std::uint64_t VertexPlacer::key_of(const Loop& loop) const {
  InputHash hash(static_cast<std::uint64_t>(loop.cell) * 2 + is_crowded(loop));
  for (const std::int32_t k : crossings_of(loop)) add_crossing(hash, at(crossings_, k));
  for (const std::int32_t k : segments_of(loop)) {
    const std::int32_t c = at(segments_, k).crease;
    const SurfacePoint* point = c >= 0 ? &at(creases_, c).point : nullptr;
    hash.add(point ? 1u << 8 | static_cast<unsigned>(point->count) : 0u);
    if (point && point->count > 0) hash.add(point->position);
  }
  return hash.value();
}

// Neighbouring crossings lie on one face of the part or on faces that join smoothly.
bool VertexPlacer::is_smooth(const Loop& loop) const {
  for (const std::int32_t k : segments_of(loop))
    if (at(segments_, k).crease >= 0) return false;
  return true;
}

bool VertexPlacer::is_crowded(const Segment& s) const {
  return segments_in_face_[static_cast<std::size_t>(s.face)] > 1;
}

bool VertexPlacer::is_crowded(const Loop& loop) const {
  return loops_in_cell_[static_cast<std::size_t>(loop.cell)] > 1;
}

Vec3 VertexPlacer::mean_crossing(const Loop& loop) const {
  Vec3 sum;
  for (const std::int32_t k : crossings_of(loop)) sum += at(crossings_, k).position;
  return (1.0 / static_cast<double>(loop.crossings)) * sum;
}

// Between the crossings of the earliest owner, whose face no other one cuts into, and the rest,
// where all lie on one plane.
std::optional<BorderSearch> VertexPlacer::owner_border(const Loop& loop) const {
  const std::span<const std::int32_t> crossings = crossings_of(loop);
  const Crossing& first = at(crossings_, crossings[0]);
  std::int32_t owner = first.at.owner;
  for (const std::int32_t k : crossings) owner = std::min(owner, at(crossings_, k).at.owner);
  Vec3 own, others;
  double count = 0;
  for (const std::int32_t k : crossings) {
    const Crossing& c = at(crossings_, k);
    if (dot(c.normal, first.normal) < kPlaneCosine ||
        std::abs(dot(c.position - first.position, first.normal)) > kPlaneRoom)
      return {};
    const bool is_own = c.at.owner == owner;
    (is_own ? own : others) += c.position;
    count += is_own;
  }
  const double rest = static_cast<double>(crossings.size()) - count;
  if (rest == 0) return {};
  return BorderSearch((1 / count) * own, (1 / rest) * others, owner);
}

// Loops of cells with the same candidates.
void VertexPlacer::place_loops_of(std::span<const std::int32_t> loops) {
  struct Memory {
    std::vector<SmoothSearch> searches;
    std::vector<BorderSearch> borders;
    std::vector<std::int32_t> searched, bordered;
  };
  static thread_local Memory memory;
  auto& [searches, borders, searched, bordered] = memory;
  searches.clear();
  borders.clear();
  searched.clear();
  bordered.clear();
  for (const std::int32_t k : loops) {
    const Loop& loop = at(loops_, k);
    const std::span<const std::int32_t> crossings = crossings_of(loop);
    const FieldSample& first = at(crossings_, crossings[0]).at;
    const bool one_face = std::all_of(crossings.begin(), crossings.end(), [&](std::int32_t c) {
      return same_face(at(crossings_, c).at, first);
    });
    if (!one_face && !is_smooth(loop)) continue;
    const std::optional<BorderSearch> border = one_face ? std::nullopt : owner_border(loop);
    if (border) {
      borders.push_back(*border);
      bordered.push_back(k);
      continue;
    }
    searches.emplace_back(field_, cells_.box(loop.cell), mean_crossing(loop),
                          one_face ? &first : nullptr);
    searched.push_back(k);
  }
  const Probe p = probe(at(loops_, loops[0]).cell);
  run_together(p, std::span(borders));
  for (std::size_t i = 0; i < bordered.size(); ++i) {
    searches.emplace_back(field_, cells_.box(at(loops_, bordered[i]).cell), borders[i].point());
    searched.push_back(bordered[i]);
  }
  run_together(p, std::span(searches));
  for (std::size_t i = 0; i < searched.size(); ++i)
    loops_[static_cast<std::size_t>(searched[i])].point = searches[i].result();
  for (const std::int32_t k : loops) finish_loop(k);
}

void VertexPlacer::finish_loop(std::int32_t id) {
  Loop& loop = loops_[static_cast<std::size_t>(id)];
  const Box3 box = cells_.box(loop.cell);
  if (loop.point.count == 0 || options_.sharpen) {
    static thread_local std::vector<Vec3> crossings;
    static thread_local std::vector<SurfacePoint> creases;
    static thread_local std::vector<FieldSample> faces;
    crossings.clear();
    creases.clear();
    faces.clear();
    for (const std::int32_t k : crossings_of(loop)) {
      crossings.push_back(at(crossings_, k).position);
      faces.push_back(at(crossings_, k).at);
    }
    for (const std::int32_t k : segments_of(loop)) {
      const std::int32_t c = at(segments_, k).crease;
      if (c >= 0 && at(creases_, c).point.count == 2) creases.push_back(at(creases_, c).point);
    }
    const Probe p = probe(loop.cell);
    if (loop.point.count == 0) loop.point = point_in_cell(p, box, {crossings, faces, creases});
    if (options_.sharpen && is_crowded(loop)) keep_apart(p, mean_crossing(loop), loop.point);
    if (options_.sharpen && loop.point.count < 2)
      outside_[static_cast<std::size_t>(id)] = crease_near(p, box, -1, mean_crossing(loop), faces);
    if (loop.point.count == 0) {
      std::vector<Vec3> ends;
      for (const std::int32_t k : crossings_of(loop))
        ends.insert(ends.end(), {at(crossings_, k).low_end(), at(crossings_, k).high_end()});
      loop.point = point_towards_middle(p, box, ends);
    }
  }
  // Any point in the cell keeps pieces apart; how far it is from the part is measured later.
  if (loop.point.count == 0)
    loop.point = {mean_crossing(loop), {at(crossings_, crossings_of(loop)[0]).at}, 1};
  loop.point.position = snap_into(loop.point.position, cells_.inner_box(loop.cell));
}

bool VertexPlacer::flatten(std::span<const std::int32_t> cells) {
  const std::size_t before = flat_cells_.size();
  flat_cells_.insert(cells.begin(), cells.end());
  return flat_cells_.size() > before;
}

void VertexPlacer::flatten_loops() {
  if (flat_cells_.empty()) return;
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    Loop& loop = loops_[k];
    if (flat_cells_.count(loop.cell) == 0) continue;
    loop.point = {mean_crossing(loop), {at(crossings_, crossings_of(loop)[0]).at}, 1};
    loop.point.position = snap_into(loop.point.position, cells_.inner_box(loop.cell));
    if (options_.sharpen) outside_[k] = {};
  }
}

}  // namespace mrsim::detail
