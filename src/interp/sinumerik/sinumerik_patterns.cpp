// SINUMERIK's patterns of holes, and CYCLE800: the other half of SinumerikCycles.
#include "core/rounding.h"
#include "core/trig.h"
#include "core/units.h"
#include "interp/sinumerik/sinumerik_cycles.h"
#include "interp/words/unread_modes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMostHolesOfPattern = 10'000;

}  // namespace

bool SinumerikCycles::pattern(const Call& call) {
  if (!reads_all_of(call)) return false;
  if (statements_ && statements_->has_modal_call() && call.name != "CYCLE800")
    return error("not-supported",
                 fmt::format("{} under MCALL of a program is not supported: write the places as "
                             "blocks",
                             call.name),
                 where());
  if (call.name == "HOLES1") return row(call);
  if (call.name == "HOLES2") return circle(call);
  if (call.name == "CYCLE800") return swivel(call);
  return call.name == "CYCLE801" ? grid(call) : points(call);
}

// Which places HIDE leaves out, and how a grid is sheared (ANG1, ANG2), is not confirmed; XA and YA
// of CYCLE802 say for each place whether it counts from the one before (2).
bool SinumerikCycles::reads_all_of(const Call& call) {
  const auto refuse = [&](const char* what) {
    return error("not-supported", fmt::format("{} with {} is not supported", call.name, what),
                 where());
  };
  const bool grid = call.name == "CYCLE801";
  if ((grid || call.name == "HOLES1" || call.name == "HOLES2") && !call.text(grid ? 11 : 8).empty())
    return refuse("hidden positions (HIDE)");
  if (grid && (call.get(9) != 0 || call.get(10) != 0)) return refuse("sheared rows (ANG1, ANG2)");
  if (call.name != "CYCLE802") return true;
  for (int place = 0; place < 9; ++place)
    if (call.digit(0, place) == 2 || call.digit(1, place) == 2)
      return refuse("incremental positions (a 2 in XA or YA)");
  return true;
}

// FR TC ST MODE X0 Y0 Z0 A B C X1 Y1 Z1; MODE says in pairs of bits about which axes A B C turn.
bool SinumerikCycles::swivel(const Call& call) {
  const auto mode = static_cast<unsigned>(std::clamp(call.get(3), 0.0, 255.0));
  double angle = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const double turn = call.get(7 + i);
    if (turn != 0 && (mode >= 64 || (mode >> (2 * i) & 3U) != 3)) {
      UnreadModes(control_).begin_swivel();
      return error(
          "not-supported",
          "CYCLE800 with a tilt (a swivelled plane) is not supported: no move is run up to "
          "the next CYCLE800",
          where());
    }
    angle += turn;
  }
  const auto shift = [&](std::size_t i) {
    return shift_frame(scale() * Vec3{call.get(i), call.get(i + 1), call.get(i + 2)});
  };
  const Frame turned = angle != 0 ? rotation_frame(2, angle) : Frame{};
  frame_words_.swivel(compose(compose(shift(4), turned), shift(10)), call.digit(2, 0) == 1,
                      where());
  return true;
}

// SPCA SPCO STA1 FDIS DBH NUM: holes on a line.
bool SinumerikCycles::row(const Call& call) {
  const double count = call.get(5), unit = scale();
  if (count < 0 || count > kMostHolesOfPattern)
    return error("value-range", "HOLES1: the number of holes is 1 to 10000", where());
  const SinCos sc = sincos_deg(call.get(2));
  std::vector<Vec2> list;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double along = (call.get(3) + i * call.get(4)) * unit;
    list.push_back({call.get(0) * unit + along * sc.cos, call.get(1) * unit + along * sc.sin});
  }
  const Vec2 from = in_plane(basis(), position_.programmed);  // it begins at the end that is nearer
  if (!list.empty() && length(list.back() - from) < length(list.front() - from) - kRounding)
    std::reverse(list.begin(), list.end());
  return at_points(list);
}

// CPA CPO RAD STA1 INDA NUM: holes on a circle; INDA 0: all round.
bool SinumerikCycles::circle(const Call& call) {
  const double count = call.get(5), unit = scale();
  if (count < 1 || count > kMostHolesOfPattern)
    return error("value-range", "HOLES2: the number of holes is 1 to 10000", where());
  const double step = call.get(4) != 0 ? call.get(4) : 360 / std::floor(count);
  std::vector<Vec2> list;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const SinCos sc = sincos_deg(call.get(3) + i * step);
    list.push_back(
        {(call.get(0) + call.get(2) * sc.cos) * unit, (call.get(1) + call.get(2) * sc.sin) * unit});
  }
  return at_points(list);
}

// SPCA SPCO STA DIS1 DIS2 NUM1 NUM2: a grid, or its frame alone (VARI 1).
bool SinumerikCycles::grid(const Call& call) {
  const double columns = call.get(5), rows = call.get(6), unit = scale();
  if (columns < 1 || rows < 1 || columns * rows > kMostHolesOfPattern)
    return error("value-range", "CYCLE801: the number of holes is 1 to 10000", where());
  const bool frame = static_cast<int>(call.get(7)) % 10 == 1;
  const int nu = static_cast<int>(columns), nv = static_cast<int>(rows);
  const SinCos sc = sincos_deg(call.get(2));
  std::vector<Vec2> list;
  for (int j = 0; j < nv; ++j)
    for (int k = 0; k < nu; ++k) {
      const int i = j % 2 ? nu - 1 - k : k;  // there and back
      if (frame && i > 0 && i < nu - 1 && j > 0 && j < nv - 1) continue;
      const Vec2 d{i * call.get(3) * unit, j * call.get(4) * unit};
      list.push_back({call.get(0) * unit + d.x * sc.cos - d.y * sc.sin,
                      call.get(1) * unit + d.x * sc.sin + d.y * sc.cos});
    }
  return at_points(list);
}

// CYCLE802: up to nine points, behind the two masks.
bool SinumerikCycles::points(const Call& call) {
  std::vector<Vec2> list;
  for (std::size_t i = 2; i + 1 < 20; i += 2)
    if (call.given(i) && call.given(i + 1))
      list.push_back({call.get(i) * scale(), call.get(i + 1) * scale()});
  return at_points(list);
}

// Without MCALL the pattern is a row of rapids.
bool SinumerikCycles::at_points(const std::vector<Vec2>& points) {
  const Basis b = basis();
  unsigned named = 0;
  for (int i = 0; i < 3; ++i)
    if (component(b.u, i) != 0 || component(b.v, i) != 0) named |= 1U << i;
  for (const Vec2 p : points) {
    const Vec3 at = from_plane(b, p, holes_.level());
    holes_.approach(at, named, where());
    if (modal_call_ && !drill(*modal_call_)) return false;
  }
  return true;
}

}  // namespace mrsim
