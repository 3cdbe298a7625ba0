#include "removal/sweep/sweep_table.h"

#include "core/process/heap.h"
#include "removal/columns/build_columns.h"
#include "removal/sweep/sweep_faces.h"
#include "removal/sweep/sweep_lists.h"
#include "removal/sweep/sweep_numbers.h"
#include "removal/sweep/sweep_range.h"

#include <algorithm>
#include <limits>

namespace mrsim {

SweepTable::SweepTable(std::span<const Motion> motions, std::span<const Tool> tools,
                       const SweepSelection& selection, int threads)
    : columns_(std::make_unique<SweepColumns>()) {
  build_columns(motions, tools, selection, threads, *columns_);
}
SweepTable::SweepTable(SweepTable&&) noexcept = default;
SweepTable& SweepTable::operator=(SweepTable&&) noexcept = default;
SweepTable::~SweepTable() = default;

std::size_t SweepTable::size() const { return columns_->refs.size(); }
std::int32_t SweepTable::motion(std::size_t i) const { return columns_->motions[i]; }
bool SweepTable::is_turned() const { return columns_->all_turned; }
const TurnTree& SweepTable::turn_tree() const { return columns_->turn_tree; }
double SweepTable::max_error() const { return columns_->max_error; }
double SweepTable::smallest_radius() const { return columns_->smallest_radius; }
double SweepTable::ball_radius(std::size_t i) const {
  const SweepRef& ref = columns_->refs[i];
  if (ref.kind == SweepKind::turn) return std::numeric_limits<double>::infinity();
  const Profile& tool = columns_->cutter(ref);
  return std::min(tool.max_radius(), 0.5 * (tool.top() - tool.bottom()));
}
std::size_t SweepTable::segments() const { return columns_->segments.size(); }
std::size_t SweepTable::memory() const {
  const SweepColumns& c = *columns_;
  std::size_t bytes = c.packs.memory() + c.turn_tree.memory();
  for (const std::vector<Box3>& boxes : c.bounds) bytes += bytes_of(boxes);
  return bytes + bytes_of(c.refs) + bytes_of(c.motions) + bytes_of(c.tags) +
         bytes_of(c.ball_lines) + bytes_of(c.plane_lines) + bytes_of(c.plane_arcs) +
         bytes_of(c.ball_arcs) + bytes_of(c.profiles) + bytes_of(c.outline_edges) +
         bytes_of(c.outlines) + c.paths.memory() + bytes_of(c.chain_lines) + c.run_chords.memory() +
         bytes_of(c.slant_lines) + bytes_of(c.bores) + bytes_of(c.upright_quarters) +
         bytes_of(c.first_quarter) + bytes_of(c.turns) + bytes_of(c.segments) +
         bytes_of(c.first_segment) + bytes_of(c.class_of) + bytes_of(c.height_numbers);
}
Box3 SweepTable::bounds(std::size_t i) const { return columns_->bounds_of_number(i); }

double SweepTable::distance(std::size_t i, const Vec3& p) const { return columns_->distance(i, p); }
SweepSample SweepTable::sample(std::size_t i, const Vec3& p) const {
  return sweep_sample(*columns_, i, p);
}
std::int32_t SweepTable::patch(std::size_t i, const Vec3& p, std::optional<double> t) const {
  if (columns_->refs[i].kind == SweepKind::ball_line) return 0;
  return t ? sweep_patch(*columns_, i, p, *t) : sample(i, p).patch;
}
Vec3 SweepTable::gradient(std::size_t i, const Vec3& p, std::int32_t patch) const {
  return sweep_gradient(*columns_, i, p, patch);
}
FacePlane SweepTable::face_plane(std::size_t i, const Vec3& p, std::int32_t patch) const {
  return sweep_face_plane(*columns_, i, p, patch);
}

double SweepTable::patch_distance(std::size_t i, const Vec3& p, std::int32_t patch) const {
  return sweep_patch_distance(*columns_, i, p, patch);
}
FaceRange SweepTable::patch_range(std::size_t i, const Corners3& t, std::int32_t patch) const {
  return sweep_range(*columns_, i, t, patch);
}
std::optional<SweepTable::FlatFloor> SweepTable::flat_floor(std::size_t i, const Vec3& p) const {
  return mrsim::flat_floor(*columns_, i, p);
}

std::vector<std::uint32_t> SweepTable::all(double longest) const {
  return all_numbers(*columns_, longest);
}
std::vector<std::uint32_t> SweepTable::expanded(std::span<const std::uint32_t> list,
                                                const Box3& box) const {
  return sweeps_bounded(*columns_, list, box);
}
std::vector<std::uint32_t> SweepTable::meeting(std::span<const std::uint32_t> list,
                                               const Box3& box) const {
  return sweeps_meeting(*columns_, list, box);
}
SweepTable::Nearest SweepTable::nearest(std::span<const std::uint32_t> list, const Vec3& p,
                                        double enough) const {
  return nearest_sweep(*columns_, list, p, enough);
}
void SweepTable::distances(std::span<const std::uint32_t> ids, const Vec3& p, double* out) const {
  sweep_distances(*columns_, ids, p, out);
}

void SweepTable::near_distances(std::span<const std::uint32_t> ids, const Vec3& p, double margin,
                                double* out) const {
  mrsim::near_distances(*columns_, ids, p, margin, out);
}
void SweepTable::least(std::span<const std::uint32_t> ids, PointColumns& points) const {
  least_distances(*columns_, ids, points);
}

}  // namespace mrsim
