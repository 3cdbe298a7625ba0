// Milling cutters as profiles. Every type is a chain of lines and arcs from the axis at the tip
// upwards; without a flute length it goes on along the shank for ever, with one it is cut off
// there, because only the flutes cut.
#include "removal/tool/tool.h"

#include "core/numbers/rounding.h"
#include "core/numbers/tool_point.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/process/error.h"

#include <cmath>

namespace mrsim {
namespace {

class Outline {
 public:
  explicit Outline(Vec2 start) : at_(start) {}
  void line(Vec2 to) {
    if (length(to - at_) > kRounding) edges_.push_back({.a = at_, .b = to});
    at_ = to;
  }
  void arc(Vec2 to, Vec2 center, double radius, bool convex) {
    if (length(to - at_) > kRounding)
      edges_.push_back({.a = at_, .b = to, .center = center, .radius = radius, .convex = convex});
    at_ = to;
  }
  Vec2 at() const { return at_; }
  std::vector<ProfileEdge> edges() && { return std::move(edges_); }

 private:
  Vec2 at_;
  std::vector<ProfileEdge> edges_;
};

// The arc's point at height z, on the side where the arc lies.
Vec2 at_height(const ProfileEdge& e, double z) {
  if (e.radius == 0) {
    const double t = (z - e.a.y) / (e.b.y - e.a.y);
    return {e.a.x + t * (e.b.x - e.a.x), z};
  }
  const double dz = z - e.center.y, dr = std::sqrt(std::max(0.0, e.radius * e.radius - dz * dz));
  return {e.convex ? e.center.x + dr : e.center.x - dr, z};
}

// Ends a chain that never goes down at height h (flat, to the axis), or, for h = 0, along the
// shank.
Profile finish(Outline&& outline, double h) {
  const Vec2 end = outline.at();
  if (h <= 0) {
    if (end.x > kRounding) outline.line({end.x, kInfinity});
    return Profile(std::move(outline).edges());
  }
  if (end.y < h) outline.line({end.x, h});
  std::vector<ProfileEdge> kept;
  for (ProfileEdge e : std::move(outline).edges()) {
    if (e.a.y >= h) break;
    if (e.b.y > h) e.b = at_height(e, h);
    kept.push_back(e);
  }
  if (kept.back().b.x > kRounding) kept.push_back({.a = kept.back().b, .b = {0, kept.back().b.y}});
  return Profile(std::move(kept));
}

// Bottom of radius `tip`, rounded by `round` towards a flank that leans out by `lean` from the
// axis.
Outline rounded_tip(double tip, double round, double lean) {
  const SinCos sc = sincos(lean);
  Outline o({0, 0});
  if (round <= 0) {
    o.line({tip, 0});
    return o;
  }
  const double center = std::max(0.0, tip - round * (1 - sc.sin) / sc.cos);
  o.line({center, 0});
  const Vec2 end = lean == 0 ? Vec2{center + round, round}
                             : Vec2{center + round * sc.cos, round - round * sc.sin};
  o.arc(end, {center, round}, round, true);
  return o;
}

void require_shape(bool ok, const Tool& tool, const char* why) {
  if (!ok) invalid_tool(tool, why);
}

constexpr double kRoundedUp = 1 + 1e-12;  // sizes of inches, as mm

Profile straight_mill(const Tool& tool, double round) {
  const double r = tool.diameter / 2;
  require_shape(round >= 0 && round <= r * kRoundedUp, tool,
                "the corner radius is larger than half the diameter");
  return finish(rounded_tip(r, std::min(round, r), 0), tool.flute_length);
}

// A cone from `tip` radius up to the diameter.
Profile pointed_mill(const Tool& tool, double half_angle, double tip) {
  require_shape(half_angle > 0 && half_angle < kPi / 2, tool,
                "the tip angle is not between 0 and 180°");
  const double r = tool.diameter / 2;
  require_shape(tip >= 0 && tip < r, tool, "the tip diameter is not smaller than the diameter");
  const SinCos sc = sincos(half_angle);
  Outline o = rounded_tip(tip, tool.corner_radius, half_angle);
  if (tool.corner_radius > 0 && tip == 0) {  // a rounded point: the arc starts on the axis
    o = Outline({0, 0});
    o.arc({tool.corner_radius * sc.cos, tool.corner_radius * (1 - sc.sin)}, {0, tool.corner_radius},
          tool.corner_radius, true);
  }
  require_shape(o.at().x < r, tool, "the rounding of the tip is larger than the diameter");
  o.line({r, o.at().y + (r - o.at().x) * sc.cos / sc.sin});
  return finish(std::move(o), tool.flute_length);
}

Profile taper_mill(const Tool& tool) {
  const double r = tool.diameter / 2, lean = tool.taper_angle;
  require_shape(lean > 0 && lean < kPi / 2, tool, "a taper needs a taper angle between 0 and 90°");
  const bool to_diameter = tool.tip_diameter > 0;
  const double tip = to_diameter ? tool.tip_diameter / 2 : r;
  require_shape(to_diameter ? tip < r : tool.flute_length > 0, tool,
                "a taper needs a flute length, or a tip diameter below the diameter");
  const SinCos sc = sincos(lean);
  Outline o = rounded_tip(tip, tool.corner_radius, lean);
  if (tool.corner_radius >= tip * (1 - kShareRounding)) {  // ball-nosed
    o = Outline({0, 0});
    const double c = tool.corner_radius;
    o.arc({c * sc.cos, c - c * sc.sin}, {0, c}, c, true);
  }
  const Vec2 from = o.at();
  const double rise = to_diameter ? (r - from.x) * sc.cos / sc.sin : tool.flute_length - from.y;
  require_shape(rise > 0, tool, "the rounding of the tip leaves no flank");
  o.line({to_diameter ? r : from.x + rise * sc.sin / sc.cos, from.y + rise});
  return finish(std::move(o), tool.flute_length);
}

Profile tslot_mill(const Tool& tool) {
  const double r = tool.diameter / 2, c = tool.corner_radius;
  const double h = tool.width > 0 ? tool.width : tool.flute_length;
  require_shape(h > 0, tool,
                "a T-slot cutter needs a width (the height of its head) or a flute length");
  require_shape(tool.neck_diameter < tool.diameter, tool, "the neck is not thinner than the head");
  require_shape(tool.flute_length <= 0 || h <= tool.flute_length, tool,
                "the width of the head is larger than the flute length");
  require_shape(c >= 0 && c <= r && 2 * c <= h, tool, "the corner radius does not fit the head");
  Outline o({0, 0});
  o.line({r - c, 0});
  if (c > 0) o.arc({r, c}, {r - c, c}, c, true);
  o.line({r, h - c});
  if (c > 0) o.arc({r - c, h}, {r - c, h - c}, c, true);
  o.line({0, h});
  return Profile(std::move(o).edges());
}

// The ball up to its neck; only the ball cuts.
Profile lollipop_mill(const Tool& tool) {
  const double r = tool.diameter / 2, n = tool.neck_diameter / 2;
  require_shape(n >= 0 && n < r, tool, "the neck is not thinner than the ball");
  Outline o({0, 0});
  const double top = r + std::sqrt(r * r - n * n);
  o.arc({r, r}, {0, r}, r, true);
  o.arc({n, top}, {0, r}, r, true);
  o.line({0, top});
  Profile whole(std::move(o).edges());
  if (tool.flute_length <= 0 || tool.flute_length >= top) return whole;
  Outline cut({0, 0});
  for (const ProfileEdge& e : whole.edges())
    if (e.radius > 0) cut.arc(e.b, e.center, e.radius, e.convex);
  return finish(std::move(cut), tool.flute_length);
}

// A flank of radius `profile_radius` that is widest at the diameter and joins the tip smoothly.
Profile barrel_mill(const Tool& tool) {
  const double r = tool.diameter / 2, flank = tool.profile_radius, c = tool.corner_radius;
  const double tip = tool.tip_diameter / 2;
  require_shape(flank > r && flank > c, tool,
                "a barrel needs a profile radius above its own radius");
  const double span = (flank - c) * (flank - c) - (flank - r + tip) * (flank - r + tip);
  require_shape(span > 0 && c < r, tool, "tip and flank of the barrel do not meet");
  const Vec2 center{r - flank, c + std::sqrt(span)};
  Outline o({0, 0});
  o.line({tip, 0});
  if (c > 0) {
    const Vec2 tip_center{tip, c};
    const Vec2 out = (1 / (flank - c)) * (tip_center - center);
    o.arc(center + flank * out, tip_center, c, true);
  }
  o.arc({r, center.y}, center, flank, true);
  if (tool.flute_length > center.y) {  // the flank falls back towards the shank
    const double over = tool.flute_length - center.y;
    require_shape(over < flank, tool, "the flute length is beyond the end of the flank");
    const double top = center.x + std::sqrt(flank * flank - over * over);
    require_shape(top > 0, tool, "the flute length is beyond the end of the flank");
    o.arc({top, tool.flute_length}, center, flank, true);
  }
  return finish(std::move(o), tool.flute_length);
}

void form_arc(const Tool& tool, Outline& o, Vec2 b, double bulge) {
  const Vec2 a = o.at(), chord = b - a;
  const double s = (1 - bulge * bulge) / (4 * bulge);
  const Vec2 center = 0.5 * (a + b) + s * Vec2{-chord.y, chord.x};
  const double radius = length(a - center);
  // Going down starts or ends where the tangent points down.
  const double way = bulge > 0 ? 1 : -1;
  require_shape(way * (a.x - center.x) >= -kRounding && way * (b.x - center.x) >= -kRounding, tool,
                "the profile goes down (an arc beyond its lowest or highest point)");
  o.arc(b, center, radius, bulge > 0);
}

Profile form_mill(const Tool& tool) {
  require_shape(tool.profile.size() >= 2, tool,
                "a form tool needs a profile of two points or more");
  require_shape(tool.profile.front().r == 0, tool,
                "the profile does not start on the axis (r = 0)");
  Outline o({0, tool.profile.front().z});
  for (std::size_t i = 1; i < tool.profile.size(); ++i) {
    const ProfilePoint &from = tool.profile[i - 1], &to = tool.profile[i];
    require_shape(std::isfinite(to.r) && std::isfinite(to.z) && std::isfinite(from.bulge), tool,
                  "the profile holds a number that is not finite");
    require_shape(to.r >= 0, tool, "the profile crosses the axis");
    require_shape(to.z >= from.z, tool, "the profile goes down");
    require_shape(to.r > 0 || i + 1 == tool.profile.size(), tool,
                  "the profile touches the axis before its end");
    const double back = i > 1 ? (to.r - from.r) * (from.r - tool.profile[i - 2].r) : 0;
    require_shape(i < 2 || to.z > from.z || from.z > tool.profile[i - 2].z || back >= 0, tool,
                  "the profile runs back along itself");
    require_shape(from.bulge > -1.0001 && from.bulge < 1.0001, tool, "an arc beyond half a turn");
    if (from.bulge == 0)
      o.line({to.r, to.z});
    else
      form_arc(tool, o, {to.r, to.z}, from.bulge);
  }
  require_shape(o.at().y > tool.profile.front().z, tool, "the profile has no height");
  return finish(std::move(o), tool.flute_length);
}

// Cylinders and cones stacked from height z, each a convex piece of its own.
std::vector<Profile> stack(const Tool& tool, const std::vector<ToolSegment>& segments, double z) {
  std::vector<Profile> pieces;
  for (const ToolSegment& s : segments) {
    require_shape(s.diameter_low > 0 && s.diameter_high > 0 && s.length > 0, tool,
                  "a piece of shank or holder has no diameter or length");
    Outline o({0, z});
    o.line({s.diameter_low / 2, z});
    o.line({s.diameter_high / 2, z + s.length});
    o.line({0, z + s.length});
    pieces.emplace_back(std::move(o).edges());
    z += s.length;
  }
  return pieces;
}

}  // namespace

void invalid_tool(const Tool& tool, const std::string& why) {
  throw Error("tool-invalid",
              "tool " + (tool.id.empty() ? "(without name)" : tool.id) + ": " + why);
}

Profile make_cutter(const Tool& tool) {
  const auto finite = {tool.diameter,       tool.corner_radius, tool.taper_angle,
                       tool.tip_angle,      tool.tip_diameter,  tool.neck_diameter,
                       tool.profile_radius, tool.flute_length,  tool.width};
  for (double value : finite)
    require_shape(std::isfinite(value) && value >= 0, tool, "a size is negative or not a number");
  require_shape(tool.diameter > 0 || tool.type == ToolType::form, tool, "the diameter is missing");
  switch (tool.type) {
    case ToolType::endmill:
    case ToolType::bullmill:
      return straight_mill(tool, tool.corner_radius);
    case ToolType::ballmill:
      return straight_mill(tool, tool.diameter / 2);
    case ToolType::chamfer:
      return pointed_mill(tool, point_half_angle(tool), tool.tip_diameter / 2);
    case ToolType::drill:
      return pointed_mill(tool, point_half_angle(tool), 0);
    case ToolType::taper:
      return taper_mill(tool);
    case ToolType::tslot:
      return tslot_mill(tool);
    case ToolType::lollipop:
      return lollipop_mill(tool);
    case ToolType::barrel:
      return barrel_mill(tool);
    case ToolType::form:
      return form_mill(tool);
    default:
      invalid_tool(tool, "not a milling tool");
  }
}

ToolShape make_tool_shape(const Tool& tool) {
  ToolShape shape;
  shape.turning = is_turning(tool.type);
  if (shape.turning) {
    shape.insert = make_insert(tool);
    shape.radius = shape.insert.round;
    return shape;
  }
  shape.cutter = make_cutter(tool);
  shape.radius = shape.cutter.max_radius();
  // Without a flute length nobody knows where the shank begins: above all that is cut.
  double z = shape.cutter.top();
  if (std::isinf(z)) return shape;
  shape.shank = stack(tool, tool.shank, z);
  for (const ToolSegment& s : tool.shank) z += s.length;
  shape.holder = stack(tool, tool.holder, z);
  return shape;
}

}  // namespace mrsim
