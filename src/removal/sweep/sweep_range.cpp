// Which faces have an enclosure, and from what it follows (docs/mesh.md, Tolerance).
#include "removal/sweep/sweep_range.h"

#include "removal/field/face_range.h"
#include "removal/forms/tool_at_rest.h"
#include "removal/sweep/sweep_faces.h"
#include "removal/tool/profile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace mrsim {
namespace {

// Faces of a tool at rest: chains of lines and arcs that join smoothly.
FaceRange edge_range(const ProfileEdge& e, const Section& s) {
  if (!e.is_arc()) {
    const auto side = [&e](Vec2 q) { return -cross(e.direction, q - e.a); };
    return widened(range_of({side(s.at[0]), side(s.at[1]), side(s.at[2])}), s,
                   {e.direction.y, e.direction.y});
  }
  const FaceRange circle = convex_section_range(
      s, e.radius, [&](Vec2 q) { return length(q - e.center) - e.radius; },
      [&](Vec2 q) {
        const double n = length(q - e.center);
        return n > 0 ? (1 / n) * (q - e.center) : Vec2{};
      });
  return e.convex ? circle : negated(circle);
}

bool same_circle(const ProfileEdge& e, const ProfileEdge& f) {
  return e.is_arc() && e.center == f.center && e.radius == f.radius && e.convex == f.convex;
}

// Direction of travel at the ends of an edge that is a line or bulges out.
Vec2 along(const ProfileEdge& e, Vec2 at) {
  return e.is_arc() ? (1 / e.radius) * Vec2{e.center.y - at.y, at.x - e.center.x} : e.direction;
}
Vec2 start_of(const ProfileEdge& e) { return along(e, e.a); }
Vec2 end_of(const ProfileEdge& e) { return along(e, e.b); }

// Encloses Profile::face_distance() of all (r, z) in a section; infinite where the nearest edge of
// the patch may change with a jump.
// Arcs that bulge out and lines that join smoothly, and never go down, bound a convex region of the
// plane when the ends are continued: the distance is that from the region, a convex function. True
// where the nearest point of its border is not on what is added: between the normals at the ends,
// less deep than an arc's centre.
FaceRange profile_face_range(const Profile& profile, const Section& s, std::int32_t patch) {
  const std::vector<ProfileEdge>& edges = profile.edges();
  const auto of_patch = [patch](const ProfileEdge& e) { return e.patch == patch; };
  const auto first = std::find_if(edges.begin(), edges.end(), of_patch);
  if (first == edges.end()) return {};
  const auto last = std::prev(std::find_if_not(first, edges.end(), of_patch));
  if (std::all_of(first, last + 1,
                  [&](const ProfileEdge& e) { return &e == &*first || same_circle(*first, e); }))
    return edge_range(*first, s);
  double least_radius = std::numeric_limits<double>::infinity();
  for (auto e = first; e <= last; ++e) {
    if (e->is_arc() && !e->convex) return {};
    if (e->is_arc()) least_radius = std::min(least_radius, e->radius);
  }
  const bool from_axis = first->a.x == 0 && start_of(*first).y == 0;
  for (const Vec2& q : s.hull) {
    if (!from_axis && dot(q - first->a, start_of(*first)) < -kBorder) return {};
    if (!std::isinf(last->b.y) && dot(q - last->b, end_of(*last)) > kBorder) return {};
  }
  const FaceRange range = convex_section_range(
      s, least_radius, [&](Vec2 q) { return profile.face_distance(q, patch); },
      [&](Vec2 q) { return profile.gradient(q, patch); });
  return range.lo > -least_radius ? range : FaceRange{};
}

constexpr double kUprightNormal = 1e-12;  // sine: rounding of a wall's normal
constexpr double kMostAcross = 2e-5;  // mm: rounding of corners, and the sagitta of small chords

std::array<double, 3> heights(const Corners3& t, double z) {
  return {t[0].z - z, t[1].z - z, t[2].z - z};
}

// The wall, floor or chain of floor, quarter circle and wall of an end mill.
FaceRange slab_range(const Profile& tool, const Section& s) {
  const double core = tool.core(), round = tool.round();
  if (round == 0)
    return widened({std::min({s.at[0].x, s.at[1].x, s.at[2].x}) - core,
                    std::max({s.at[0].x, s.at[1].x, s.at[2].x}) - core},
                   s, {1, 1});
  const bool under = std::all_of(s.hull.begin(), s.hull.end(), [&](Vec2 q) {
    return std::fabs(q.x) <= core && round - q.y >= 0;
  });
  if (under) return negated(range_of({s.at[0].y, s.at[1].y, s.at[2].y}));
  return convex_section_range(
      s, round, [&](Vec2 q) { return slab_face_distance(tool, std::fabs(q.x), q.y, 0); },
      [&](Vec2 q) {
        const Vec2 g = slab_face_gradient(tool, std::fabs(q.x), q.y, 0);
        return Vec2{q.x < 0 ? -g.x : g.x, g.y};
      });
}

class RangeOf {
 public:
  RangeOf(const SweepColumns& columns, std::size_t i, const Corners3& t, std::int32_t patch)
      : columns_(columns), ref_(columns.refs[i]), i_(i), t_(t), patch_(patch) {
    local_ = t;
    if (ref_.frame > 0)
      for (Vec3& p : local_) p = columns.frames[ref_.frame - 1].in(p);
  }

  // The second flank of a groove is the first one's face, on the other side of the path: the
  // enclosure of that holds up to twice the way that the triangle reaches across the path.
  FaceRange operator()() const {
    if (!ref_.grooves || (patch_ & (kFlankPatch - 1)) != 0) return of_face();
    const double reach = across();
    if (reach > kMostAcross) return {};
    const FaceRange range = RangeOf(columns_, i_, t_, patch_ & ~kFlankPatch).of_face();
    return {range.lo - 2 * reach, range.hi + 2 * reach};
  }

 private:
  // How far points of the triangle lie beyond the bottom of the flank's groove, mm.
  double across() const {
    double least = std::numeric_limits<double>::infinity();
    const double side = (patch_ & kFlankPatch) != 0 ? 1 : -1;
    GrooveSide at;
    for (const Vec3& p : local_) {
      at = groove_side(columns_, ref_, p);
      least = std::min(least, side * at.off);
    }
    // A chord of the outer flank of an arc is nearer to the centre than its ends.
    if (side > 0 && std::isfinite(at.most)) {
      const double far = std::max(0.0, at.most + least);
      least = std::sqrt(std::max(0.0, far * far - smallest_circle(local_).squared)) - at.most;
    }
    return std::max(0.0, -least);
  }

  FaceRange of_face() const {
    switch (ref_.kind) {
      case SweepKind::ball_line:  // within R of a convex set
        return convex();
      case SweepKind::ball_arc:
        return ball_arc();
      case SweepKind::path:
        return path();
      case SweepKind::turn:
        return turn_face_range(columns_.turns[ref_.row], local_, patch_);
      case SweepKind::plane_line:
        return horizontal(false, columns_.plane_lines[ref_.row].c,
                          columns_.plane_lines[ref_.row].c[LineSlot::low] -
                              columns_.plane_lines[ref_.row].c[LineSlot::round]);
      case SweepKind::plane_arc:
        return horizontal(true, columns_.plane_arcs[ref_.row].c,
                          columns_.plane_arcs[ref_.row].c[ArcSlot::low] -
                              columns_.plane_arcs[ref_.row].c[ArcSlot::round]);
      case SweepKind::profile: {
        const ProfileRow& row = columns_.profiles[ref_.row];
        return horizontal(row.arc, row.c, row.z);
      }
    }
    return {};
  }

  // patch_distance is a convex function of space.
  FaceRange convex() const {
    const Vec3 m = weighted(smallest_circle(t_), t_);
    return convex_range(t_,
                        {sweep_patch_distance(columns_, i_, t_[0], patch_),
                         sweep_patch_distance(columns_, i_, t_[1], patch_),
                         sweep_patch_distance(columns_, i_, t_[2], patch_)},
                        m, sweep_patch_distance(columns_, i_, m, patch_),
                        sweep_gradient(columns_, i_, m, patch_));
  }

  // A function of the distance in plan from the path and of the height above the tip.
  FaceRange horizontal(bool arc, const double* c, double z) const {
    const Profile& tool = columns_.cutter(ref_);
    const std::int32_t face = patch_ & (kBranchPatch - 1);
    const std::array<double, 3> height = heights(local_, z);
    const int side = !ref_.split ? 0 : patch_ >= kBranchPatch ? 1 : -1;
    if (tool.is_end_mill()) {
      const std::int32_t wall = tool.round() > 0 ? 0 : 1;
      if (face > wall) return range_of(heights(local_, z + tool.top()));
      if (tool.round() == 0 && face == 0) return negated(range_of(height));
      const ArcView view = arc ? view_of(c) : ArcView{ArcView::Part::end, 0};
      if (view.side != 0 && side != 0 && view.side != side) return {};
      if (view.part == ArcView::Part::end) return convex();
      if (view.part == ArcView::Part::both && tool.round() > 0) return bent(c, tool.round());
    }
    const Envelope rho =
        arc ? arc_envelope(c, local_, tool.round() > 0, side) : line_envelope(c, local_);
    if (!rho.is_known) return {};
    const Section s = section_of(rho, height);
    return tool.is_end_mill() ? slab_range(tool, s) : profile_face_range(tool, s, face);
  }

  // Beyond an end of its path a convex tool stands still: that is convex, too.
  ArcView view_of(const double* c) const {
    Corners2 w;
    for (int k = 0; k < 3; ++k) w[k] = {local_[k].x - c[ArcSlot::x], local_[k].y - c[ArcSlot::y]};
    return arc_view(c, w);
  }

  // The distance s from the path's core, from where the tool passes to where it has stopped: its
  // second derivatives are at most 1 / s, and, about the arc's axis, 1 / w. s^2 less the square of
  // the place is concave, whatever the core is, which bounds s from below.
  FaceRange bent(const double* c, double round) const {
    const Envelope w =
        length_envelope({Vec2{local_[0].x - c[ArcSlot::x], local_[0].y - c[ArcSlot::y]},
                         {local_[1].x - c[ArcSlot::x], local_[1].y - c[ArcSlot::y]},
                         {local_[2].x - c[ArcSlot::x], local_[2].y - c[ArcSlot::y]}});
    const double circle = smallest_circle(t_).squared;
    std::array<double, 3> value, squares;
    for (std::size_t k = 0; k < 3; ++k) {
      value[k] = sweep_patch_distance(columns_, i_, t_[k], patch_);
      const double s = std::max(0.0, value[k] + round);
      squares[k] = s * s;
    }
    const double least =
        std::min(std::sqrt(std::max(0.0, range_of(squares).lo - circle)), whole_range(w).lo);
    if (!(least > 0)) return {};
    const FaceRange corners = range_of(value);
    return {corners.lo - 0.5 * circle / least, corners.hi + 0.5 * circle / least};
  }

  FaceRange ball_arc() const {
    const BallArc& arc = columns_.ball_arcs[ref_.row];
    const Curtain& part = columns_.ball_arc_face(ref_, patch_);
    if (is_valley(part)) return convex();
    return hill_range(arc, part, local_);
  }

  FaceRange path() const {
    if (is_moved_wall(columns_, i_, patch_)) return convex();
    const bool moved_body = columns_.paths.is_line(ref_.row) && columns_.cutter(ref_).is_convex();
    return moved_body ? straight(columns_.cutter(ref_), columns_.paths.line(ref_.row))
                      : FaceRange{};
  }

  // A convex tool on a line sweeps a convex body: its signed distance is at most that of the
  // corners, and at least that of any half space about the body, here one that touches it near the
  // triangle.
  FaceRange straight(const Profile& tool, const PathColumn::Line& path) const {
    const Vec3 at = weighted(smallest_circle(t_), t_);
    Vec3 n = sweep_gradient(columns_, i_, at, sweep_sample(columns_, i_, at).patch);
    if (ref_.frame > 0) n = columns_.frames[ref_.frame - 1].in(n);
    if (std::fabs(n.z) < kUprightNormal) n.z = 0;
    const double ahead = std::max(0.0, dot(n, path.travel));
    const double body =
        dot(n, path.start) + ahead + tool.support({std::sqrt(n.x * n.x + n.y * n.y), n.z});
    FaceRange range;
    range.lo = range_of({dot(n, local_[0]), dot(n, local_[1]), dot(n, local_[2])}).lo - body;
    range.hi = range_of({columns_.distance(i_, t_[0]), columns_.distance(i_, t_[1]),
                         columns_.distance(i_, t_[2])})
                   .hi;
    return range;
  }

  const SweepColumns& columns_;
  const SweepRef& ref_;
  const std::size_t i_;
  const Corners3& t_;
  const std::int32_t patch_;
  Corners3 local_;  ///< in the tool's frame
};

}  // namespace

FaceRange sweep_range(const SweepColumns& c, std::size_t i, const Corners3& t, std::int32_t patch) {
  return RangeOf(c, i, t, patch)();
}

}  // namespace mrsim
