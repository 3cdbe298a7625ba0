// The exact part as a function: d(p) = max(d_stock(p), -min_i d_i(p)), and its restriction to a
// ball.
//
// d is negative in the material and 1-Lipschitz; |d| is a lower bound of the distance to the
// surface, exact near it. Nothing here knows a grid: the carver samples this function into OpenVDB,
// the mesher evaluates it for crossings and normals.
//
// Candidates. A caller that works its way down from large blocks to small ones keeps, for each, the
// list of sweeps that can matter in it (restrict_to). Every query takes such a list; a longer list
// never changes a result inside the box it was made for.
#pragma once

#include "removal/field/field_sample.h"
#include <mrsim/types.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace mrsim {

class ExactField {
 public:
  enum class Region : std::uint8_t { air, material, mixed };

  ExactField() = default;
  ExactField(const ExactField&) = delete;
  ExactField& operator=(const ExactField&) = delete;
  virtual ~ExactField() = default;

  /// All sweeps: the candidates of the whole space.
  virtual Candidates all() const = 0;

  /// Which of `in` can decide d within `band` mm of the surface in the box. Region air (or
  /// material): d > band (or < -band) in the whole box, `out` is then empty. `out` may not alias
  /// `in`. Sharpest for cubes.
  virtual Region restrict_to(const Box3& box, double band, std::span<const std::uint32_t> in,
                             Candidates& out) const = 0;

  /// A way down from a region to its parts, and theirs: tier 0 is the whole, each part is one tier
  /// below what it is a part of. The lists of all tiers on the way are kept, so that a list is
  /// narrowed and not made anew. For one thread.
  class Descent {
   public:
    Descent() = default;
    Descent(const Descent&) = delete;
    Descent& operator=(const Descent&) = delete;
    virtual ~Descent() = default;
    /// Does what restrict_to does with the candidates that tier - 1 has left. Requires: the last
    /// region entered at tier - 1 holds this one; tier >= 1. The list that is left may still
    /// contain packs; with `last`, when d is evaluated next, it holds single sweeps.
    virtual Region enter(std::size_t tier, const Box3& box, double band, bool last) = 0;
    /// Does what enter() does for a region that is not divided further: writes the candidates that
    /// are left to `out`, ascending. Requires: the last region was entered at tier - 1 with
    /// `last`.
    virtual Region finish(std::size_t tier, const Box3& box, double band, Candidates& out) = 0;
    /// Whether so few candidates are left that narrowing the list costs more than it saves.
    virtual bool is_short(std::size_t tier) const = 0;
    /// The candidates that the last region entered at this tier has left, ascending.
    virtual void candidates(std::size_t tier, Candidates& out) const = 0;
  };
  /// A descent with the candidates `in` at tier 0, for regions about the point `origin`.
  virtual std::unique_ptr<Descent> descent(const Vec3& origin,
                                           std::span<const std::uint32_t> in) const;

  /// d, its owner and the owner's face at p. Ties: stock before sweep, then the least index.
  virtual FieldSample sample(const Vec3& p, std::span<const std::uint32_t> candidates) const = 0;

  /// Whether |d| <= tolerance at p; may be found without d itself. Requires: tolerance >= 0.
  virtual bool is_on_surface(const Vec3& p, std::span<const std::uint32_t> candidates,
                             double tolerance) const {
    return std::fabs(sample(p, candidates).distance) <= tolerance;
  }

  /// out[k] = sample(points[k], candidates), the same bits; cheaper together.
  virtual void samples(std::span<const Vec3> points, std::span<const std::uint32_t> candidates,
                       FieldSample* out) const {
    for (std::size_t k = 0; k < points.size(); ++k) out[k] = sample(points[k], candidates);
  }
  /// out[k] = sample(points[k], candidates).distance, the same bits. `deciders`, where not null,
  /// gets what decides each: a candidate, a sweep of a candidate that is a pack, or kStockDecides.
  virtual void distances(std::span<const Vec3> points, std::span<const std::uint32_t> candidates,
                         double* out, std::uint32_t* deciders = nullptr) const {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const FieldSample s = sample(points[k], candidates);
      out[k] = s.distance;
      if (deciders) deciders[k] = s.owner == kStockOwner ? kStockDecides : candidate(s.owner);
    }
  }

  /// Gradient of d at p for the owner and patch that sample(p) gave: unit length, out of the
  /// material.
  virtual Vec3 gradient(const Vec3& p, const FieldSample& at) const = 0;

  /// Signed distance of p from the surface of one smooth face (`at.owner`, `at.patch`), which is
  /// continued smoothly beyond its creases: equal to d where the nearest point of the part's
  /// surface lies on that face, negative on the material's side. gradient(p, at) is its gradient.
  /// The mesher solves for edges and corners as common zeros of two or three of these, so p may lie
  /// on the other side of the crease (a box's side: the distance of its plane; a slot's wall: R -
  /// rho; its floor: z - z_floor, all with d's sign).
  virtual double patch_distance(const Vec3& p, const FieldSample& at) const = 0;

  /// What Newton's method on a face asks for, cheaper than both queries above: the value and the
  /// normal of a smooth function that is 0 where patch_distance is, and equals it to first order.
  virtual FacePlane face_plane(const Vec3& p, const FieldSample& at) const {
    return {gradient(p, at), patch_distance(p, at)};
  }

  /// Encloses patch_distance(p, face) for all p of a triangle, mm: proven up to rounding, not
  /// sampled (removal/field/face_range.h). Infinite where no bound is known: for other faces than
  /// planes and those drawn by lines and circles, and where the triangle reaches a crease of
  /// patch_distance. Costs four to ten values of it.
  virtual FaceRange patch_range(const Corners3&, const FieldSample&) const { return {}; }

  /// The number that means this owner's sweep, and no other, in a list of candidates. Requires: not
  /// the stock.
  virtual std::uint32_t candidate(std::int32_t owner) const = 0;

  /// Replaces packs among the candidates by their sweeps and drops sweeps that can not decide d
  /// within `band` mm of the surface in the box. False where they are too many to be of use.
  virtual bool expand_packs(const Box3& box, double band, std::span<const std::uint32_t> candidates,
                            Candidates& out) const = 0;

  /// True where d, with these candidates, depends on the distance from the Z axis and on z alone.
  virtual bool is_turned(std::span<const std::uint32_t>) const { return false; }

  /// Whether the stock before the first cut is a box with sides along the axes.
  virtual bool has_box_stock() const { return false; }
  /// Figures of the facets of a stock that is a mesh; 0 for other stocks.
  virtual StockFacets facets() const { return {}; }

  /// A box that holds the whole part.
  virtual Box3 bounds() const = 0;
};

/// The descent of any field, by restrict_to.
class ListDescent final : public ExactField::Descent {
 public:
  ListDescent(const ExactField& field, std::span<const std::uint32_t> in)
      : field_(field), lists_(1, Candidates(in.begin(), in.end())) {}
  ExactField::Region enter(std::size_t tier, const Box3& box, double band, bool) override {
    if (lists_.size() <= tier) lists_.resize(tier + 1);
    return field_.restrict_to(box, band, lists_[tier - 1], lists_[tier]);
  }
  ExactField::Region finish(std::size_t tier, const Box3& box, double band,
                            Candidates& out) override {
    return field_.restrict_to(box, band, lists_[tier - 1], out);
  }
  bool is_short(std::size_t tier) const override { return lists_[tier].size() <= 1; }
  void candidates(std::size_t tier, Candidates& out) const override { out = lists_[tier]; }

 private:
  const ExactField& field_;
  std::vector<Candidates> lists_;
};

inline std::unique_ptr<ExactField::Descent> ExactField::descent(
    const Vec3&, std::span<const std::uint32_t> in) const {
  return std::make_unique<ListDescent>(*this, in);
}

}  // namespace mrsim
