// The outline of a tool, lines and arcs in (r, z), revolved about its axis: its exact signed
// distance.
//
// The nearest point decides the sign. Inside an edge: the side of the edge. At a corner: outside
// when the corner is convex, inside when it is reflex (the points nearest to a corner lie in its
// normal cone, which is on that side), the side of the tangent when it is smooth.
#pragma once

#include "core/numbers/vec.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace mrsim {

/// A piece of a profile: the solid lies on the left of its direction.
struct ProfileEdge {
  Vec2 a, b;               ///< ends, x = r, y = z; b.y is infinite on a ray towards the shank
  Vec2 direction{};        ///< line: unit vector from a to b
  double length = 0;       ///< line: mm, infinite on a ray
  Vec2 center{};           ///< arc
  double radius = 0;       ///< arc: mm, 0 = line
  bool convex = true;      ///< arc: counter-clockwise, bulging out of the solid
  std::int32_t patch = 0;  ///< smooth chain of edges, from 0 at the tip
  bool is_arc() const { return radius > 0; }
};

/// Unit, out of the solid: across the edge at q, a point of it or of the edge continued.
Vec2 outward(const ProfileEdge& e, Vec2 q);

struct ProfileSample {
  double distance = 0;
  Vec2 gradient;  ///< unit, d(distance) / d(r, z)
  std::int32_t patch = 0;
  double curvature = 0;  ///< 1/mm, of the line of equal distance there; positive where it bulges
};

/// The outline of a revolved solid in the half plane r >= 0, from the axis at the tip upwards.
class Profile {
 public:
  enum class Corner : std::uint8_t { smooth, convex, reflex };

  Profile() = default;
  /// Joins edges that follow one another, from the axis; finds corners, patches and the flags
  /// below. Requires: edges are not empty and never go down.
  explicit Profile(std::vector<ProfileEdge> edges);

  /// Signed distance of (r, z), r >= 0, from the profile: exact inside and outside.
  double distance(Vec2 q) const;
  ProfileSample sample(Vec2 q) const;
  /// Gradient of the distance to the nearest edge of one patch, that edge continued beyond its
  /// ends.
  Vec2 gradient(Vec2 q, std::int32_t patch) const;
  /// Signed distance to that edge, continued beyond its ends: what gradient() is the gradient of.
  double face_distance(Vec2 q, std::int32_t patch) const;

  /// Largest n.p over the solid's points p, n having the parts `n.x` >= 0 across the axis and `n.y`
  /// along it. Infinite for n.y > 0 and an open top.
  double support(Vec2 n) const;

  /// Convex corners draw surfaces of their own when the tool moves across them. Index of the one
  /// nearest to q (-1: none), whether it is q's nearest point, and its outward direction.
  int nearest_corner(Vec2 q) const;
  bool foot_is_corner(Vec2 q) const;
  Vec2 corner_direction(int corner) const;
  /// Where all normals of a convex corner point: -1 down or sideways, 1 up or sideways, otherwise
  /// 0.
  int corner_side(int corner) const;
  /// The corner at the start of edge i; i = number of edges: at the end of the last one.
  Corner corner(std::size_t i) const { return corners_[i]; }
  Vec2 corner_point(int corner) const { return edges_[static_cast<std::size_t>(corner)].a; }

  /// Convex solids whose union this is, which overlap wherever they meet: the least of their
  /// distances is this one's outside, 0 on its surface, and no deeper inside. Of an outline with
  /// concave arcs they are what the tangents at the arcs' ends bound; between tangents and arc the
  /// solid goes on (removal/forms/fillet_search.h). Empty for a convex profile, where an arc turns
  /// by more than 150 degrees, and where pieces would only touch.
  std::span<const Profile> convex_pieces() const {
    return pieces_ ? std::span<const Profile>(*pieces_) : std::span<const Profile>();
  }
  /// The convex piece that has this face. Requires: convex_pieces() is not empty.
  const Profile& piece_of_patch(std::int32_t patch) const;
  const Profile& piece_of_corner(int corner) const;
  /// An edge of the patch is a concave arc, which no piece has.
  bool bends_in(std::int32_t patch) const;

  /// What the tool sweeps when it travels up by `travel`: its widest place drawn out. Requires:
  /// is_unimodal(), a closed top.
  Profile drawn_out(double travel) const;
  /// The tool that goes on above its flat top for ever, as wide as there. Requires: a closed top.
  Profile extended_up() const;

  const std::vector<ProfileEdge>& edges() const { return edges_; }
  bool empty() const { return edges_.empty(); }
  bool open_top() const { return open_top_; }     ///< reaches to z = +infinity
  bool is_convex() const { return is_convex_; }   ///< the revolved solid is convex
  bool is_unimodal() const { return unimodal_; }  ///< r rises to the widest place, then falls
  /// Open top, r never falls: raising the tool sweeps nothing new.
  bool is_rising() const { return rising_; }
  /// The outline leaves the axis at an angle, so that a move leaves a groove with a sharp bottom.
  bool has_sharp_tip() const;
  /// Largest r of all points up to z: what cuts when the tip is that far below the stock's top.
  double max_radius_below(double z) const;
  double max_radius() const { return max_radius_; }
  double widest() const { return widest_; }  ///< least z at which r = max_radius
  double bottom() const { return bottom_; }  ///< z of the tip
  double top() const { return top_; }        ///< infinite when open

  /// An end mill, flat (round = 0), ball (core = 0) or bull-nose: a disc of radius `core` with its
  /// centre at z = `round`, thickened by `round`, with a straight wall up to the flat or open top.
  bool is_end_mill() const { return is_end_mill_; }
  double core() const { return core_; }
  double round() const { return round_; }
  bool is_ball_end() const { return is_end_mill_ && core_ == 0 && open_top_; }

  /// Cutters with a straight wall that end above, such as slot mills: a disc of radius `core`
  /// thickened by `round` below half the height `top`, and one of `lid_core` and `lid_round`, from
  /// the top downwards, above it.
  struct Disc {
    double core = 0, round = 0, lid_core = 0, lid_round = 0, top = 0;
  };
  const std::optional<Disc>& disc() const { return disc_; }

 private:
  struct Foot;
  Foot nearest(Vec2 q) const;
  bool is_outside(const Foot& foot, Vec2 q) const;
  const ProfileEdge* nearest_edge(Vec2 q, std::int32_t patch) const;
  void find_patches();
  void find_flags();
  void find_slab();
  void find_disc();
  const Profile& piece_of_edge(std::size_t edge) const;

  std::vector<ProfileEdge> edges_;
  std::vector<Corner> corners_;  ///< #edges + 1: corner i is the start of edge i
  bool open_top_ = false, is_convex_ = true, unimodal_ = true, rising_ = true, is_end_mill_ = false;
  double max_radius_ = 0, widest_ = 0, bottom_ = 0, top_ = 0, core_ = 0, round_ = 0;
  std::optional<Disc> disc_;
  std::shared_ptr<const std::vector<Profile>> pieces_;
};

}  // namespace mrsim
