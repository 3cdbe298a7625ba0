#include "interp/moves/center_hints.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kAgree = 0.01;    // mm: two radii that differ by less are the same
constexpr double kDisagree = 0.1;  // mm: two radii that differ by more are not

}  // namespace

void CenterHints::full_circle(const ArcBlock& arc, Vec2 center) {
  if (modal_.plane == kPlaneOfNormal || modal_.center_absolute) return;
  sign(arc, center);
  if (!is(Dialect::sinumerik) && !modal_.center_told) absolute_center(arc, center);
}

// Warns of a full circle whose centre, with the other sign, would lie on the zero point: "I12.5
// puts the centre at X25; I-12.5 would close on X0".
void CenterHints::sign(const ArcBlock& arc, Vec2 center) {
  const Vec2 d = center - arc.start, zero = arc.start - d;
  const double far = length(center);
  if (length(zero) > kSamePoint || far <= kSamePoint) return;
  const bool first = std::abs(d.x) >= std::abs(d.y);
  const int axis = first ? kFirstOfPlane[modal_.plane] : kSecondOfPlane[modal_.plane];
  const double word = first ? d.x : d.y, at = first ? center.x : center.y;
  note_once("arc-center-sign",
            fmt::format("{0}{1:.6g} puts the centre at {2}{3:.6g}; {0}{4:.6g} would close on {2}0",
                        "IJK"[axis], word, "XYZ"[axis], at, -word),
            *arc.where, fmt::format("{}:{}", block_.file, block_.line_number));
}

void CenterHints::learn(const ArcBlock& arc, Vec2 center) {
  if (modal_.center_absolute) return;
  const Vec2 place = center - arc.start;
  const double apart = std::abs(length(arc.start - place) - length(arc.end - place));
  offsets_ = offsets_ || apart > kDisagree;
}

// Warns where I and J are probably a place: they name the place that the tool comes from with a
// feed, the middle of the hole that it is in. As offsets they would lead to a point where it never
// was. I and J of "X85.8381 Y47.6087 I49.2642 J47.6087" are a place, too. Not where they have named
// the tool's own place, which is no centre.
void CenterHints::absolute_center(const ArcBlock& arc, Vec2 center) {
  const Vec2 at = center - arc.start, from = in_plane(arc.basis, position_.before);
  const double radius = length(at);
  if (length(arc.start) <= kAgree) return;  // offset and place are the same
  offsets_ = offsets_ || length(arc.start - at) <= kAgree;
  if (offsets_) return;
  const bool comes_from = position_.has_before && length(from - at) <= kAgree;
  if (comes_from && std::abs(length(from - center) - radius) <= kAgree) return;  // across
  if (!comes_from && !repeats_the_start(arc.start, at)) return;
  const char first = "XYZ"[kFirstOfPlane[modal_.plane]],
             second = "XYZ"[kSecondOfPlane[modal_.plane]];
  const std::string place = fmt::format("{}{:.6g} {}{:.6g}", first, at.x, second, at.y);
  reporter_.once(
      Severity::warning, "arc-center-place",
      fmt::format(
          "the circle is read about {}{:.6g} {}{:.6g}, radius {:.6g}; {}: if that is the centre, "
          "write {} before it (radius {:.6g})",
          first, center.x, second, center.y, radius,
          comes_from ? fmt::format("the tool comes from {}", place)
                     : fmt::format("{} and {} are {}, level with the tool",
                                   "IJK"[kFirstOfPlane[modal_.plane]],
                                   "IJK"[kSecondOfPlane[modal_.plane]], place),
          absolute_mode(), length(arc.start - at)),
      *arc.where, "arc-center-place");
}

// Whether I or J repeats a coordinate of the tool's own place that is no round number.
bool CenterHints::repeats_the_start(Vec2 start, Vec2 at) {
  constexpr double kSame = 1e-6, kRound = 0.1;  // mm
  const auto repeats = [](double number, double place) {
    const double steps = number / kRound;
    return std::abs(number - place) <= kSame && std::abs(steps - std::round(steps)) > 0.01;
  };
  return at.x != 0 && at.y != 0 && repeats(at.x, start.x) != repeats(at.y, start.y);
}

const char* CenterHints::absolute_mode() const { return is(Dialect::codesys) ? "G98" : "G90.1"; }

// Says what would make radii agree that differ by `apart`: another sign, or the centre as a place.
std::string CenterHints::for_radii(const ArcBlock& arc, Vec2 c, double apart) const {
  const Vec2 d = c - arc.start;
  const int first = kFirstOfPlane[modal_.plane], second = kSecondOfPlane[modal_.plane];
  const auto radii = [&](Vec2 center) {
    return std::pair(length(arc.start - center), length(arc.end - center));
  };
  const auto [absolute_start, absolute_end] = radii(d);
  if (!is(Dialect::sinumerik) && !modal_.center_absolute &&
      std::abs(absolute_start - absolute_end) <= kAgree)
    return fmt::format(
        "; about {}{:.6g} {}{:.6g} both would be {:.6g}: do {} and {} say where the centre is "
        "({})?",
        "XYZ"[first], d.x, "XYZ"[second], d.y, absolute_start, "IJK"[first], "IJK"[second],
        absolute_mode());
  for (const Vec2 flip : {Vec2{-1, 1}, Vec2{1, -1}, Vec2{-1, -1}}) {
    const Vec2 other = arc.start + Vec2{flip.x * d.x, flip.y * d.y};
    const auto [rs, re] = radii(other);
    if (std::abs(rs - re) > std::min(0.02 * rs, apart / 4)) continue;
    std::string words;
    if (flip.x < 0 && d.x != 0) words += fmt::format("{}{:.6g}", "IJK"[first], -d.x);
    if (flip.y < 0 && d.y != 0)
      words += fmt::format("{}{}{:.6g}", words.empty() ? "" : " ", "IJK"[second], -d.y);
    return fmt::format("; {} would give {:.6g} and {:.6g}, is a sign wrong?", words, rs, re);
  }
  return {};
}

}  // namespace mrsim
