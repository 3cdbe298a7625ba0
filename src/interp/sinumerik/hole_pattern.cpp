#include "interp/sinumerik/hole_pattern.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::array<std::string_view, 4> kPatterns = {"HOLES1", "HOLES2", "CYCLE801", "CYCLE802"};
constexpr double kMostHolesOfPattern = 10'000;

}  // namespace

bool HolePattern::knows(std::string_view name) {
  return std::find(kPatterns.begin(), kPatterns.end(), name) != kPatterns.end();
}

bool HolePattern::places(std::vector<Vec2>& out) {
  if (call_.name == "HOLES1") return row(out);
  if (call_.name == "HOLES2") return circle(out);
  return call_.name == "CYCLE801" ? grid(out) : points(out);
}

// It is not confirmed which places HIDE leaves out, and how ANG1 and ANG2 shear a grid. XA and YA
// of CYCLE802 say for each place whether it counts from the one before (2).
bool HolePattern::reads_all_of() {
  const auto refuse = [&](const char* what) {
    return error("not-supported", fmt::format("{} with {} is not supported", call_.name, what),
                 where_);
  };
  const bool grid = call_.name == "CYCLE801";
  if (!call_.text("HIDE").empty()) return refuse("hidden positions (HIDE)");
  if (grid && (call_.get("ANG1") != 0 || call_.get("ANG2") != 0))
    return refuse("sheared rows (ANG1, ANG2)");
  if (call_.name != "CYCLE802") return true;
  for (int place = 0; place < 9; ++place)
    if (call_.digit("XA", place) == 2 || call_.digit("YA", place) == 2)
      return refuse("incremental positions (a 2 in XA or YA)");
  return true;
}

// Holes on a line: SPCA SPCO STA1 FDIS DBH NUM.
bool HolePattern::row(std::vector<Vec2>& list) {
  const double count = call_.get("NUM"), unit = scale();
  if (count < 0 || count > kMostHolesOfPattern)
    return error("value-range", "HOLES1: the number of holes is 1 to 10000", where_);
  const SinCos sc = sincos_deg(call_.get("STA1"));
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double along = (call_.get("FDIS") + i * call_.get("DBH")) * unit;
    list.push_back(
        {call_.get("SPCA") * unit + along * sc.cos, call_.get("SPCO") * unit + along * sc.sin});
  }
  const Vec2 from = in_plane(basis(), position_.programmed);  // the row begins at the nearer end
  if (!list.empty() && length(list.back() - from) < length(list.front() - from) - kRounding)
    std::reverse(list.begin(), list.end());
  return true;
}

// Holes on a circle: CPA CPO RAD STA1 INDA NUM. INDA 0 means all round, and so does 1 in the
// thousands of VARI, whatever INDA still holds from the mask.
bool HolePattern::circle(std::vector<Vec2>& list) {
  const double count = call_.get("NUM"), unit = scale();
  if (count < 1 || count > kMostHolesOfPattern)
    return error("value-range", "HOLES2: the number of holes is 1 to 10000", where_);
  if (call_.get("RAD") < 0)
    return error("value-range", "the radius RAD of HOLES2 has no sign", where_);
  const double even = 360 / std::floor(count), between = call_.get("INDA");
  const bool full = call_.digit("VARI", 3) == 1;
  if (full && between != 0 && std::abs(between - even) > kRounding)
    reporter_.add(Severity::warning, "pattern-full-circle",
                  fmt::format("HOLES2: by VARI the holes lie all round, {:g} degrees apart: INDA, "
                              "{:g} degrees, does not count",
                              even, between),
                  where_);
  const double step = between == 0 || full ? even : between;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const SinCos sc = sincos_deg(call_.get("STA1") + i * step);
    list.push_back({(call_.get("CPA") + call_.get("RAD") * sc.cos) * unit,
                    (call_.get("CPO") + call_.get("RAD") * sc.sin) * unit});
  }
  return true;
}

// Holes on a grid, or only on its frame (VARI 1): SPCA SPCO STA DIS1 DIS2 NUM1 NUM2.
bool HolePattern::grid(std::vector<Vec2>& list) {
  const double columns = call_.get("NUM1"), rows = call_.get("NUM2"), unit = scale();
  if (columns < 1 || rows < 1 || columns * rows > kMostHolesOfPattern)
    return error("value-range", "CYCLE801: the number of holes is 1 to 10000", where_);
  const bool frame = static_cast<int>(call_.get("VARI")) % 10 == 1;
  const int nu = static_cast<int>(columns), nv = static_cast<int>(rows);
  const SinCos sc = sincos_deg(call_.get("STA"));
  for (int j = 0; j < nv; ++j)
    for (int k = 0; k < nu; ++k) {
      const int i = j % 2 ? nu - 1 - k : k;  // the tool goes to and fro
      if (frame && i > 0 && i < nu - 1 && j > 0 && j < nv - 1) continue;
      const Vec2 d{i * call_.get("DIS1") * unit, j * call_.get("DIS2") * unit};
      list.push_back({call_.get("SPCA") * unit + d.x * sc.cos - d.y * sc.sin,
                      call_.get("SPCO") * unit + d.x * sc.sin + d.y * sc.cos});
    }
  return true;
}

// CYCLE802 has up to nine points behind its two masks.
bool HolePattern::points(std::vector<Vec2>& list) {
  static constexpr ValueName kPoints[][2] = {{"X0", "Y0"}, {"X1", "Y1"}, {"X2", "Y2"},
                                             {"X3", "Y3"}, {"X4", "Y4"}, {"X5", "Y5"},
                                             {"X6", "Y6"}, {"X7", "Y7"}, {"X8", "Y8"}};
  for (const auto& [x, y] : kPoints)
    if (call_.given({x, y})) list.push_back({call_.get(x) * scale(), call_.get(y) * scale()});
  return true;
}

}  // namespace mrsim
