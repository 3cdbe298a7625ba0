#include "mesh/draw/studio.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kKeyLight = 0.98, kFillLight = 0.34, kSkyLight = 0.40, kGloss = 0.10;
constexpr double kKeyRadius = 0.11;  // of the light's disc at distance 1: soft shadows

// Evenly spread points of the unit square (the plastic-number sequence of Roberts).
Vec2 spread_point(int i) {
  const double u = 0.5 + i * 0.75487766624669276, v = 0.5 + i * 0.56984029099805327;
  return {u - std::floor(u), v - std::floor(v)};
}

// Uniform in the unit disc.
Vec2 disc_point(int i) {
  const Vec2 p = spread_point(i);
  const SinCos a = sincos(kTwoPi * p.y);
  return std::sqrt(p.x) * Vec2{a.cos, a.sin};
}

// The turn of the pixel within its tile, in an order that puts neighbours far apart.
int turn_of(int x, int y) {
  static constexpr int kOrder[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  return kOrder[(y % kTile) * kTile + x % kTile];
}

// A number without pattern for each tile.
std::uint32_t scrambled(int x, int y) {
  std::uint32_t n = std::uint32_t(x) * 0x9e3779b1u ^ std::uint32_t(y) * 0x85ebca77u;
  n = (n ^ (n >> 15)) * 0x2c1b3c6du;
  return n ^ (n >> 13);
}

// Two unit vectors across n, without a jump anywhere but at n = -z (after Frisvad).
void make_frame(const Vec3& n, Vec3& x, Vec3& y) {
  const double s = n.z < 0 ? -1 : 1, a = -1 / (s + n.z), b = n.x * n.y * a;
  x = {1 + s * n.x * n.x * a, s * b, -s * n.x};
  y = {b, s + n.y * n.y * a, -n.y};
}

// max(0, x) with a smooth start: no line may show on a round wall where a light begins to reach it.
double reached(double x) {
  constexpr double kSoft = 0.25;
  if (x <= -kSoft) return 0;
  return x >= kSoft ? x : (x + kSoft) * (x + kSoft) / (4 * kSoft);
}

// Where the light only grazes, facets shadow each other: there the cosine alone decides.
double softened(double seen, double cosine) {
  const double t = std::clamp(cosine / 0.25, 0.0, 1.0);
  return 1 - (1 - seen) * t * t * (3 - 2 * t);
}

}  // namespace

Studio::Studio(const View& view) {
  const Vec3 right = view.right, up{0, 0, 1}, ahead = cross(up, right);
  key_ = normalized(-0.62 * right - 0.50 * ahead + up);
  fill_ = normalized(0.90 * right - 0.45 * ahead + 0.30 * up);
  make_frame(key_, key_x_, key_y_);
  for (int i = 0; i < kTile * kTile * kSkyRays; ++i) {
    const Vec2 d = disc_point(i);
    sky_pattern_.push_back({d.x, d.y, std::sqrt(std::max(0.0, 1 - dot(d, d)))});
  }
  constexpr int kTurns = 16;
  for (int i = 0; i < kTurns; ++i) {
    const SinCos turn = sincos_deg(360.0 * ((i * 7) % kTurns) / kTurns);
    tile_turns_.push_back({turn.cos, turn.sin});
  }
  for (int i = 0; i < kTile * kTile * kKeyRays; ++i)
    key_pattern_.push_back(kKeyRadius * disc_point(i));
}

Vec3 Studio::sky_direction(const Vec3& normal, int x, int y, int i) const {
  const Vec3& d = sky_pattern_[i * kTile * kTile + turn_of(x, y)];
  // Every tile turns the pattern; otherwise its few directions would show as bands on round walls.
  const Vec2& turn = tile_turns_[scrambled(x / kTile, y / kTile) % tile_turns_.size()];
  Vec3 across, along;
  make_frame(normal, across, along);
  return (d.x * turn.x - d.y * turn.y) * across + (d.x * turn.y + d.y * turn.x) * along +
         d.z * normal;
}

Vec3 Studio::key_direction(int x, int y, int i) const {
  const Vec2& d = key_pattern_[i * kTile * kTile + turn_of(x, y)];
  return normalized(key_ + d.x * key_x_ + d.y * key_y_);
}

Color Studio::shade(const Color& paint, const Vec3& n, const Vec3& to_eye, float sky,
                    float key) const {
  const double to_key = dot(n, key_);
  const double key_part = kKeyLight * softened(key, to_key) * reached(to_key);
  const double fill_part = kFillLight * (0.35 + 0.65 * sky) * reached(dot(n, fill_));
  const double sky_part = kSkyLight * sky * (0.62 + 0.38 * n.z);
  const Vec3 half = normalized(key_ + to_eye);
  double gloss = std::max(0.0, dot(n, half));
  for (int i = 0; i < 5; ++i) gloss *= gloss;  // to the power of 32
  const double graze = 1 - std::max(0.0, dot(n, to_eye));
  const double sheen = kGloss * (gloss * key + 0.5 * sky * graze * graze * graze * graze);
  // Key a little warm, sky a little cool: faces keep apart in grey, too.
  const double r = key_part * 1.02 + fill_part * 0.98 + sky_part * 0.97;
  const double g = key_part + fill_part + sky_part;
  const double b = key_part * 0.97 + fill_part * 1.03 + sky_part * 1.05;
  return {float(paint.r * r + sheen), float(paint.g * g + sheen), float(paint.b * b + sheen)};
}

}  // namespace mrsim
