// How far what a motion removes reaches along the tool and across the feed: depth and width of cut,
// and the arc of the cutter that is in material (docs/history.md, Depth and width).
#pragma once

#include "core/numbers/vec.h"
#include "removal/tool/profile.h"
#include <mrsim/history.h>
#include <mrsim/types.h>

#include <algorithm>
#include <limits>

namespace mrsim {

/// Whether a mill's line goes along its axis: up, down or nowhere.
bool is_along_axis(const Motion& line);

/// The directions of one motion. A turning tool has no width: what it removes is measured across
/// the feed, in the plane of the X and Z axes.
class CutFrame {
 public:
  CutFrame() = default;
  /// `radius`: of a mill where it is widest, mm.
  CutFrame(const Motion& motion, const Tool& tool, double radius);

  bool is_turning() const { return kind_ == Kind::turning; }
  bool is_plunge() const { return kind_ == Kind::plunge; }
  /// mm along the tool's axis.
  double along(const Vec3& p) const;
  /// mm to the left of the path in plan; from the axis of an arc, outwards, but of one that stands
  /// upright (G18, G19) along its axis; of a plunge along X.
  double across(const Vec3& p) const;
  /// The direction in plan in which `across` grows at p.
  Vec2 direction_across(const Vec3& p) const;
  /// The distance across the feed to which the cutter reaches.
  double reach() const { return reach_; }
  /// The angle about the axis of a cutter of radius r, from the feed, of a place that lies so far
  /// across it, at the cutter's front.
  double angle(double across, double r) const;
  /// Least distance across the feed of the front of a cutter of radius r. On an arc of a radius R
  /// below r the front runs from r - R to r + R about the arc's axis.
  double inner_end(double r) const {
    return kind_ == Kind::arc && radius_ < r ? r - 2 * radius_ : -r;
  }

 private:
  enum class Kind : std::uint8_t { line, arc, plunge, turning };
  Kind kind_ = Kind::line;
  bool is_arc_ = false;  ///< `across` is counted from the axis of an arc
  Vec3 origin_, side_{0, 1, 0}, axis_{0, 0, 1}, turns_about_{0, 0, 1};
  double radius_ = 0, reach_ = std::numeric_limits<double>::infinity();
};

/// A stretch across the feed, mm.
struct PlanBand {
  double left = 0, right = 0;
};

/// A straight line cuts a rectangle about the origin with these half sides; dot(out, u) + d <= 0
/// holds on the side that stays. The extent of that side along the unit vector `across`. Requires:
/// that side is not empty.
PlanBand band_within(const Vec2& across, const Vec2& half, const Vec2& out, double d);
/// The share of the rectangle's area on that side.
double share_within(const Vec2& half, const Vec2& out, double d);

/// What one motion removes, in its own directions.
struct CutExtent {
  double low = std::numeric_limits<double>::infinity(), high = -low;     ///< along the axis, mm
  double left = std::numeric_limits<double>::infinity(), right = -left;  ///< across, mm
  double area = 0;  ///< mm^2 in plan; 0 where voxels give the extent

  bool is_empty() const { return !(low < high); }
  void add(const CutExtent& o) {
    low = std::min(low, o.low), high = std::max(high, o.high);
    left = std::min(left, o.left), right = std::max(right, o.right);
    area += o.area;
  }
};

/// What a plunge on the axis of a turned part removes, from its extent in the half plane.
CutExtent turned_about_axis(const CutExtent& half);

/// `mill`: none for a turning tool. A band that ends within `error` mm of the cutter's edge ends
/// there: the angle of the last few hundredths of a millimetre is some degrees.
CutShape cut_shape(const CutFrame& frame, const CutExtent& extent, const Profile* mill,
                   double error);

}  // namespace mrsim
