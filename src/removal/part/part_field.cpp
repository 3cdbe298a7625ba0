#include "removal/part/part_field.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "core/process/parallel.h"
#include "removal/columns/sweep_columns.h"
#include "removal/field/face_range.h"
#include "removal/prune/list_candidates.h"
#include "removal/prune/prune.h"
#include "removal/prune/prune_bores.h"
#include "removal/prune/prune_strips.h"
#include "removal/prune/prune_turned.h"
#include "removal/simd/sweep_kernels.h"

#include <algorithm>

namespace mrsim {
namespace {

constexpr double kNearlyCube = 1.01;  ///< ratio of the radii of a cube about a box and of the box
constexpr std::size_t kPointsTogether = 3;  ///< points that are worth columns
constexpr std::size_t kShortList =
    64;  ///< sweeps in closed form that are cheaper evaluated than pruned
constexpr std::size_t kShortCostly = 16;  ///< other milling sweeps, likewise
constexpr std::size_t kShortTurned = 16;  ///< turning sweeps, likewise

// The first of the points, as many as there is room for.
void fill(PointColumns& columns, std::span<const Vec3> points) {
  columns.count = std::min(points.size(), PointColumns::kMost);
  const std::size_t padded =
      (columns.count + PointColumns::kPad - 1) / PointColumns::kPad * PointColumns::kPad;
  for (std::size_t k = 0; k < padded; ++k) {
    const Vec3& p = points[std::min(k, columns.count - 1)];
    columns.x[k] = p.x, columns.y[k] = p.y, columns.z[k] = p.z;
    columns.least[k] = kInfinity, columns.nearest[k] = 0;
  }
}

void sort_if_needed(Candidates& list) {
  if (!std::is_sorted(list.begin(), list.end())) std::sort(list.begin(), list.end());
}

void append_ids(const CandidateList& list, Candidates& out) {
  for (const CandidateList::Slice& slice : list.slices())
    for (std::size_t k = 0; k < slice.count; ++k) out.push_back(list.number(slice, k));
  sort_if_needed(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());  // one for each segment of a path
}

// A cube about it bounds a box that is nearly one more sharply than its ball.
PruneRegion region_of(const Box3& box) {
  const Vec3 half = 0.5 * (box.hi - box.lo), center = box.lo + half;
  const double most = std::max({half.x, half.y, half.z}), radius = length(half);
  const PruneRegion cube = PruneRegion::cube(center, most);
  return cube.radius <= kNearlyCube * radius ? cube : PruneRegion::ball(center, radius);
}

class CandidateDescent final : public ExactField::Descent {
 public:
  CandidateDescent(const PartField& field, const Vec3& origin, std::span<const std::uint32_t> in)
      : field_(field), tiers_(1) {
    list_candidates(field.sweeps(), in, origin, tiers_[0].left);
  }

  ExactField::Region enter(std::size_t tier, const Box3& box, double band, bool last) override {
    if (tiers_.size() <= tier) tiers_.resize(tier + 1);
    Tier& own = tiers_[tier];
    own.in_stock = tiers_[tier - 1].in_stock;
    own.region = region_of(box);
    own.region.expand_packs = last;
    own.reach = own.region.radius + band + field_.slack();
    return field_.restrict_to(own.region, band, tiers_[tier - 1].left, own.in_stock, own.left);
  }
  ExactField::Region finish(std::size_t tier, const Box3& box, double band,
                            Candidates& out) override {
    const Tier& whole = tiers_[tier - 1];
    bool in_stock = whole.in_stock;
    if (is_of_strips(field_.sweeps(), whole.left)) {
      PruneRegion region = region_of(box);
      region.expand_packs = true;
      return field_.restrict_to(region, band, whole.left, in_stock, out);
    }
    const ExactField::Region found = enter(tier, box, band, true);
    out.clear();
    if (found == ExactField::Region::mixed) candidates(tier, out);
    return found;
  }
  bool is_short(std::size_t tier) const override {
    const CandidateList& left = tiers_[tier].left;
    if (left.closed) return left.size() <= kShortList;
    if (left.size() > kShortCostly) return false;
    static thread_local Candidates expanded;
    return left.size() <= 1 || list(tiers_[tier], expanded);
  }
  void candidates(std::size_t tier, Candidates& out) const override { list(tiers_[tier], out); }

 private:
  struct Tier {
    CandidateList left;
    PruneRegion region;
    double reach = 0;
    bool in_stock = false;
  };
  // Turning sweeps one by one where they are few: side by side they cost less than their tree.
  // False where packs are left.
  bool list(const Tier& tier, Candidates& out) const {
    out.clear();
    append_ids(tier.left, out);
    return expand_turned(field_.sweeps(), tier.region, tier.reach, kShortTurned, out);
  }
  const PartField& field_;
  std::vector<Tier> tiers_;
};

}  // namespace

PartField::PartField(StockSolid solid, SweepTable sweeps, int threads)
    : solid_(std::move(solid)),
      sweeps_(std::move(sweeps)),
      slack_(2 * sweeps_.max_error() + kRounding) {
  const std::size_t count = sweeps_.size();
  if (count == 0) return;
  sweep_of_.resize(static_cast<std::size_t>(sweeps_.motion(count - 1)) + 1);
  // The last sweep of each motion.
  parallel_for((count + kSweepsOfThread - 1) / kSweepsOfThread, threads, [&](std::size_t part) {
    const std::size_t end = std::min((part + 1) * kSweepsOfThread, count);
    std::int32_t own = sweeps_.motion(part * kSweepsOfThread);
    for (std::size_t i = part * kSweepsOfThread; i < end; ++i) {
      const std::int32_t next = i + 1 < count ? sweeps_.motion(i + 1) : -1;
      if (next != own) sweep_of_[static_cast<std::size_t>(own)] = static_cast<std::uint32_t>(i);
      own = next;
    }
  });
}

Candidates PartField::all() const { return sweeps_.all(); }

bool PartField::reaches_stock(const PruneRegion& region, double reach, bool& in_stock) const {
  if (in_stock) return true;
  double stock = 0;
  if (region.box && solid_.is_box()) {
    stock = solid_.plane_distance(region.center);
    reach += std::max(region.half, region.tall) - region.radius;
  } else {
    stock = solid_.distance(region.center);
  }
  in_stock = stock < -reach;
  return stock <= reach;
}

ExactField::Region PartField::restrict_to(const PruneRegion& region, double band,
                                          const CandidateList& in, bool& in_stock,
                                          CandidateList& out) const {
  const double reach = region.radius + band + slack_;
  if (!reaches_stock(region, reach, in_stock)) return Region::air;
  if (!prune(sweeps_, region, reach, band, in, out)) return Region::air;
  return out.empty() && in_stock ? Region::material : Region::mixed;
}

ExactField::Region PartField::restrict_to(const PruneRegion& region, double band,
                                          const CandidateList& in, bool& in_stock,
                                          Candidates& out) const {
  if (is_of_strips(sweeps_, in)) {
    const std::size_t near = nearest_strips(region, 0, in)[0];
    return restrict_strips(region, band, in, near, in_stock, out);
  }
  static thread_local CandidateList left;
  out.clear();
  const Region found = restrict_to(region, band, in, in_stock, left);
  if (found != Region::mixed) return found;
  append_ids(left, out);
  drop_later_turns(sweeps_.columns(), region, out);
  return found;
}

ExactField::Region PartField::restrict_strips(const PruneRegion& region, double band,
                                              const CandidateList& in, std::size_t near,
                                              bool& in_stock, Candidates& out) const {
  out.clear();
  const double reach = region.radius + band + slack_;
  if (!reaches_stock(region, reach, in_stock)) return Region::air;
  if (!prune_strips(sweeps_, region, reach, in, near, out)) return Region::air;
  sort_if_needed(out);
  return out.empty() && in_stock ? Region::material : Region::mixed;
}

void PartField::restrict_quarters(const PruneRegion& block, double band, const CandidateList& in,
                                  bool in_stock, Quarters& quarters) const {
  const bool strips = is_of_strips(sweeps_, in);
  std::array<std::size_t, kStripQuarters> near{};
  if (strips) near = nearest_strips(block, quarters.back().region.center.x - block.center.x, in);
  for (std::size_t k = 0; k < quarters.size(); ++k) {
    Quarter& c = quarters[k];
    c.in_stock = in_stock;
    c.found = strips ? restrict_strips(c.region, band, in, near[k], c.in_stock, c.left)
                     : restrict_to(c.region, band, in, c.in_stock, c.left);
  }
}

ExactField::Region PartField::restrict_to(const Box3& box, double band,
                                          std::span<const std::uint32_t> in,
                                          Candidates& out) const {
  static thread_local CandidateList list;
  PruneRegion region = region_of(box);
  region.expand_packs = true;
  list_candidates(sweeps_, in, region.center, list);
  bool in_stock = false;
  return restrict_to(region, band, list, in_stock, out);
}

std::unique_ptr<ExactField::Descent> PartField::descent(const Vec3& origin,
                                                        std::span<const std::uint32_t> in) const {
  return std::make_unique<CandidateDescent>(*this, origin, in);
}

bool PartField::expand_packs(const Box3& box, double band,
                             std::span<const std::uint32_t> candidates, Candidates& out) const {
  out.assign(candidates.begin(), candidates.end());
  const PruneRegion region = region_of(box);
  return expand_turned(sweeps_, region, region.radius + band + slack_, kShortTurned, out);
}

// d at p from the distance of the nearest sweep.
FieldSample PartField::decide(const Vec3& p, const SweepTable::Nearest& cut) const {
  const StockSolid::Sample stock = solid_.sample(p, -cut.distance);
  if (stock.distance >= -cut.distance) return {stock.distance, kStockOwner, stock.patch};
  return {-cut.distance, sweeps_.motion(cut.sweep), sweeps_.patch(cut.sweep, p, cut.t)};
}

FieldSample PartField::sample(const Vec3& p, std::span<const std::uint32_t> candidates) const {
  return decide(p, candidates.empty() ? SweepTable::Nearest{} : sweeps_.nearest(candidates, p));
}

// Outside of the stock or in any sweep: no other sweep can bring p to the surface.
bool PartField::is_on_surface(const Vec3& p, std::span<const std::uint32_t> candidates,
                              double tolerance) const {
  const double stock = solid_.sample(p).distance;
  if (stock > tolerance) return false;
  const double cut =
      candidates.empty() ? kInfinity : sweeps_.nearest(candidates, p, -tolerance).distance;
  return std::fabs(std::max(stock, -cut)) <= tolerance;
}

void PartField::samples(std::span<const Vec3> points, std::span<const std::uint32_t> candidates,
                        FieldSample* out) const {
  PointColumns columns;
  if (points.size() < kPointsTogether) return ExactField::samples(points, candidates, out);
  for (; !points.empty(); points = points.subspan(columns.count), out += columns.count) {
    fill(columns, points);
    sweeps_.least(candidates, columns);
    for (std::size_t k = 0; k < columns.count; ++k)
      out[k] =
          decide(points[k], {columns.least[k], static_cast<std::uint32_t>(columns.nearest[k]), {}});
  }
}

void PartField::distances(std::span<const Vec3> points, std::span<const std::uint32_t> candidates,
                          double* out, std::uint32_t* deciders) const {
  PointColumns columns;
  double stock[PointColumns::kMost];
  for (; !points.empty(); points = points.subspan(columns.count), out += columns.count) {
    fill(columns, points);
    if (candidates.empty()) {
      solid_.distances(columns.count, columns.x, columns.y, columns.z, out);
      if (deciders != nullptr) deciders = std::fill_n(deciders, columns.count, kStockDecides);
      continue;
    }
    sweeps_.least(candidates, columns);
    solid_.distances(columns.count, columns.x, columns.y, columns.z, stock, columns.least);
    for (std::size_t k = 0; k < columns.count; ++k)
      out[k] = stock[k] >= -columns.least[k] ? stock[k] : -columns.least[k];
    if (deciders == nullptr) continue;
    for (std::size_t k = 0; k < columns.count; ++k)
      deciders[k] = stock[k] >= -columns.least[k] ? kStockDecides
                                                  : static_cast<std::uint32_t>(columns.nearest[k]);
    deciders += columns.count;
  }
}

Vec3 PartField::gradient(const Vec3& p, const FieldSample& at) const {
  if (at.owner == kStockOwner) return solid_.gradient(p, at.patch);
  return -sweeps_.gradient(sweep_of(at.owner), p, at.patch);
}

double PartField::patch_distance(const Vec3& p, const FieldSample& at) const {
  if (at.owner == kStockOwner) return solid_.patch_distance(p, at.patch);
  return -sweeps_.patch_distance(sweep_of(at.owner), p, at.patch);
}

FacePlane PartField::face_plane(const Vec3& p, const FieldSample& at) const {
  if (at.owner == kStockOwner)
    return {solid_.gradient(p, at.patch), solid_.patch_distance(p, at.patch)};
  const FacePlane plane = sweeps_.face_plane(sweep_of(at.owner), p, at.patch);
  return {-plane.normal, -plane.distance};
}

FaceRange PartField::patch_range(const Corners3& t, const FieldSample& face) const {
  if (face.owner == kStockOwner) return solid_.patch_range(t, face.patch);
  return negated(sweeps_.patch_range(sweep_of(face.owner), t, face.patch));
}

}  // namespace mrsim
