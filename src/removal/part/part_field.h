// The exact part: stock less sweeps, as ExactField.
#pragma once

#include "removal/columns/sweep_packs.h"
#include "removal/field/field.h"
#include "removal/prune/candidate_list.h"
#include "removal/stock/stock_solid.h"
#include "removal/sweep/sweep_table.h"

#include <array>

namespace mrsim {

class PartField final : public ExactField {
 public:
  PartField(StockSolid solid, SweepTable sweeps, int threads = 1);

  Candidates all() const override;
  Region restrict_to(const Box3& box, double band, std::span<const std::uint32_t> in,
                     Candidates& out) const override;
  /// restrict_to() of a list that was made for a larger region. `in_stock`: the whole region lies
  /// deep in the stock, which then never decides; kept from the larger region, set for this one.
  Region restrict_to(const PruneRegion& region, double band, const CandidateList& in,
                     bool& in_stock, CandidateList& out) const;
  /// restrict_to() for a region without parts: indices of sweeps, ascending. `in` has no packs of
  /// milling sweeps.
  Region restrict_to(const PruneRegion& region, double band, const CandidateList& in,
                     bool& in_stock, Candidates& out) const;
  /// restrict_to() for the four columns of a block, side by side in the order of
  /// CandidateKernels::strip_quarters, whose list is `in`.
  struct Quarter {
    PruneRegion region;
    Region found = Region::mixed;
    bool in_stock = false;
    Candidates left;
  };
  using Quarters = std::array<Quarter, 4>;
  void restrict_quarters(const PruneRegion& block, double band, const CandidateList& in,
                         bool in_stock, Quarters& quarters) const;
  std::unique_ptr<Descent> descent(const Vec3& origin,
                                   std::span<const std::uint32_t> in) const override;
  FieldSample sample(const Vec3& p, std::span<const std::uint32_t> candidates) const override;
  bool is_on_surface(const Vec3& p, std::span<const std::uint32_t> candidates,
                     double tolerance) const override;
  void samples(std::span<const Vec3> points, std::span<const std::uint32_t> candidates,
               FieldSample* out) const override;
  void distances(std::span<const Vec3> points, std::span<const std::uint32_t> candidates,
                 double* out, std::uint32_t* deciders) const override;
  Vec3 gradient(const Vec3& p, const FieldSample& at) const override;
  double patch_distance(const Vec3& p, const FieldSample& at) const override;
  FacePlane face_plane(const Vec3& p, const FieldSample& at) const override;
  FaceRange patch_range(const Corners3& t, const FieldSample& face) const override;
  std::uint32_t candidate(std::int32_t owner) const override {
    return static_cast<std::uint32_t>(sweep_of(owner));
  }
  bool expand_packs(const Box3& box, double band, std::span<const std::uint32_t> candidates,
                    Candidates& out) const override;
  bool is_turned(std::span<const std::uint32_t> candidates) const override {
    return solid_.is_turned() &&
           (sweeps_.is_turned() || candidates.empty() ||
            (candidates.front() >= sweeps_.size() && candidates.back() < kFirstPack));
  }
  bool has_box_stock() const override { return solid_.is_box(); }
  StockFacets facets() const override { return solid_.facets(); }
  Box3 bounds() const override { return solid_.bounds(); }

  const StockSolid& solid() const { return solid_; }
  const SweepTable& sweeps() const { return sweeps_; }
  /// mm: what rounding may change in a difference of two distances.
  double slack() const { return slack_; }

 private:
  /// Whether the stock leaves anything: false for air. Finds `in_stock`.
  bool reaches_stock(const PruneRegion& region, double reach, bool& in_stock) const;
  /// What a strip near the region leaves of a list of strips.
  Region restrict_strips(const PruneRegion& region, double band, const CandidateList& in,
                         std::size_t near, bool& in_stock, Candidates& out) const;
  FieldSample decide(const Vec3& p, const SweepTable::Nearest& cut) const;
  std::size_t sweep_of(std::int32_t motion) const {
    return sweep_of_[static_cast<std::size_t>(motion)];
  }

  StockSolid solid_;
  SweepTable sweeps_;
  std::vector<std::uint32_t> sweep_of_;  ///< by motion
  double slack_;
};

}  // namespace mrsim
