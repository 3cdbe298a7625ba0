#include "removal/tool/insert.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/words/tool_types.h"
#include "removal/tool/tool.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kDefaultEdge = 16;   // mm
constexpr double kDefaultAngle = 35;  // degrees: a finishing insert
constexpr double kDefaultLead = 93;   // degrees
constexpr double kDefaultGroove = 3;  // mm: width of a blade

struct InsertSide {
  double x = 0, z = 0;  // theoretical tip as seen from the nose centre, -1, 0 or 1
};

InsertSide tip_side(int orientation) {
  static constexpr InsertSide kSides[] = {{0, 0}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1},
                                          {0, 1}, {1, 0}, {0, -1}, {-1, 0},  {0, 0}};
  return kSides[orientation];
}

void require(bool ok, const Tool& tool, const char* why) {
  if (!ok) invalid_tool(tool, why);
}

int orientation_of(const Tool& tool) {
  require(tool.tip >= 0 && tool.tip <= 9, tool, "the tip orientation is not 1 to 9");
  Tool sided = tool;
  if (tool.tip == 9) sided.tip = 0;  // the point is the nose's centre; the side is that of the kind
  return tip_orientation(sided);
}

char shape_letter(const Tool& tool) {
  if (tool.insert.empty()) return tool.type == ToolType::threading ? 'T' : 'V';
  const char c = tool.insert.front();
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

double corner_angle(const Tool& tool, char letter) {
  if (tool.insert_angle > 0) return tool.insert_angle;
  switch (letter) {
    case 'C':
    case 'W':
      return radians(80);
    case 'D':
    case 'K':
      return radians(55);
    case 'T':
      return radians(60);
    case 'S':
      return radians(90);
    case 'V':
      return radians(kDefaultAngle);
    default:
      invalid_tool(tool, "insert shape '" + tool.insert + "' is not one of C D K R S T V W");
  }
}

Vec2 polar(double length, double angle) {
  const SinCos sc = sincos(angle);
  return {length * sc.cos, length * sc.sin};
}

// Sharp outline with its corner at the origin, main edge along +x, body to the left of it.
std::vector<Vec2> sharp_insert(char letter, double edge, double angle) {
  const Vec2 main = {edge, 0}, minor = polar(edge, angle);
  switch (letter) {
    case 'T':
      return {{0, 0}, main, minor};
    case 'K':  // parallelogram; inscribed circle 9.52 on an edge of 16
      return {{0, 0}, main, main + 0.73 * minor, 0.73 * minor};
    case 'W': {  // trigon: three corners of `angle`, three obtuse ones between them
      const double obtuse = 4 * kPi / 3 - angle;
      Vec2 at = {0, 0};
      double heading = 0;
      std::vector<Vec2> p;
      for (int i = 0; i < 6; ++i) {
        p.push_back(at);
        at = at + polar(edge, heading);
        heading += kPi - (i % 2 == 0 ? obtuse : angle);
      }
      return p;
    }
    default:
      return {{0, 0}, main, main + minor, minor};
  }
}

// Moves every side of a convex counter-clockwise polygon inwards by r.
std::vector<Vec2> inset(const Tool& tool, const std::vector<Vec2>& p, double r) {
  if (r <= 0) return p;
  const std::size_t n = p.size();
  std::vector<Vec2> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = p[i] - p[(i + n - 1) % n], on = p[(i + 1) % n] - p[i];
    const Vec2 u = (1 / length(in)) * in, v = (1 / length(on)) * on;
    // The corner moves along v - u until it is r away from both sides.
    out[i] = p[i] + (r / cross(u, v)) * (v - u);
  }
  for (std::size_t i = 0; i < n; ++i)
    require(dot(out[(i + 1) % n] - out[i], p[(i + 1) % n] - p[i]) > 0, tool,
            "the nose radius is too large for the insert");
  return out;
}

// Mirrors the nominal external right-hand polygon where needed and keeps it counter-clockwise.
void mirror(std::vector<Vec2>& p, bool x, bool z) {
  for (Vec2& v : p) v = {x ? -v.x : v.x, z ? -v.y : v.y};
  if (x != z) std::vector<Vec2>(p.rbegin(), p.rend()).swap(p);
}

std::vector<Vec2> rotated(std::vector<Vec2> p, double angle) {
  const SinCos sc = sincos(angle);
  for (Vec2& v : p) v = {sc.cos * v.x - sc.sin * v.y, sc.sin * v.x + sc.cos * v.y};
  return p;
}

// Direction in which the body of a neutral insert lies.
double angle_away(const InsertSide& side) {
  if (side.x != 0) return side.x < 0 ? 0 : kPi;
  return side.z < 0 ? kPi / 2 : -kPi / 2;
}

// The outline of one tooth of a threading insert, as wide as the tool. The centre of its nose is
// the origin.
std::vector<Vec2> thread_tooth(const Tool& tool, const InsertSide& side, double round,
                               double edge) {
  const double angle = tool.insert_angle > 0 ? tool.insert_angle : radians(60);
  const SinCos half = sincos(angle / 2);
  const double out = tool.width / 2, flank = out * half.cos / half.sin;
  edge = std::max(edge, 2 * flank);
  std::vector<Vec2> p =
      inset(tool, {{0, 0}, {flank, -out}, {edge, -out}, {edge, out}, {flank, out}}, round);
  const Vec2 nose = p.front();
  for (Vec2& v : p) v = v - nose;
  return rotated(p, angle_away(side));
}

// Points of an insert with its nose centre (or sharp corner) at the origin.
std::vector<Vec2> oriented_insert(const Tool& tool, const InsertSide& side, double round) {
  const char letter = shape_letter(tool);
  const double angle = tool.type == ToolType::threading && tool.insert_angle <= 0
                           ? radians(60)
                           : corner_angle(tool, letter);
  require(angle > 0 && angle < kPi, tool, "the insert angle is not between 0 and 180°");
  const double edge = tool.edge_length > 0 ? tool.edge_length : kDefaultEdge;
  if (tool.type == ToolType::threading && tool.width > 0)
    return thread_tooth(tool, side, round, edge);
  std::vector<Vec2> p = inset(tool, sharp_insert(letter, edge, angle), round);
  const Vec2 nose = p.front();
  for (Vec2& v : p) v = v - nose;
  const bool diagonal = side.x != 0 && side.z != 0;
  if (!diagonal && tool.lead_angle <= 0)  // neutral: the body points away from the tip
    return rotated(p, angle_away(side) - angle / 2);
  const double fallback = radians(kDefaultLead) + angle < kPi ? radians(kDefaultLead) : kPi / 4;
  const double lead = tool.lead_angle > 0 ? tool.lead_angle : fallback;
  require(lead < kPi, tool, "the lead angle is not below 180°");
  // (sin k, -cos k) is the +x axis turned by k - 90 degrees; the body lies to its left (+Z).
  p = rotated(p, lead - kPi / 2);
  mirror(p, side.x > 0, side.z > 0);
  return p;
}

// A rectangular blade, its working end at the tip.
std::vector<Vec2> blade(const Tool& tool, const InsertSide& side, double round) {
  const double w = (tool.width > 0 ? tool.width : kDefaultGroove) - 2 * round;
  const double l = (tool.edge_length > 0 ? tool.edge_length : kDefaultEdge) - 2 * round;
  require(w >= 0 && l > 0, tool, "the corner radius is too large for the blade");
  const double across = side.x != 0 && side.z != 0 ? 0 : -w / 2;
  // External: X is the depth. Along Z: face grooving.
  std::vector<Vec2> p = {{0, across}, {l, across}, {l, across + w}, {0, across + w}};
  if (side.x != 0) {
    mirror(p, side.x > 0, side.z > 0);
    return p;
  }
  for (Vec2& v : p) v = {v.y, v.x};
  std::vector<Vec2>(p.rbegin(), p.rend()).swap(p);
  mirror(p, false, side.z > 0);
  return p;
}

}  // namespace

InsertOutline make_insert(const Tool& tool) {
  for (double value : {tool.nose_radius, tool.lead_angle, tool.edge_length, tool.width,
                       tool.insert_angle, tool.diameter})
    require(std::isfinite(value) && value >= 0, tool, "a size is negative or not a number");
  InsertOutline out;
  const InsertSide side = tip_side(orientation_of(tool));
  out.inside = side.x > 0;
  out.round = nose_radius(tool);
  if (tool.type == ToolType::grooving) {
    out.core = blade(tool, side, out.round);
  } else if (shape_letter(tool) == 'R') {
    require(out.round > 0, tool, "a round insert needs a diameter or a nose radius");
    out.core = {{0, 0}};
  } else {
    out.core = oriented_insert(tool, side, out.round);
  }
  const bool centre = tool.tip == 9 || tool.tip_is_nose_centre;
  if (!centre)
    for (Vec2& v : out.core) v = v - out.round * Vec2{side.x, side.z};
  return out;
}

}  // namespace mrsim
