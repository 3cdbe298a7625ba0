#include "interp/comments/tool_hint.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/words/tool_types.h"
#include "interp/comments/form_outline.h"
#include "interp/comments/insert_code.h"
#include "interp/comments/turning_hint.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kSameSize = 0.02;           // mm: two readings of one size differ by rounding only
constexpr double kRounded = 0.05;            // mm: a radius in inches with three decimals
constexpr double kLeastVee = 1;              // mm: of a V-bit; a smaller size is rather its tip's
constexpr double kLargestWithoutUnit = 150;  // mm: a larger one is rather a size in another unit
constexpr double kLargestMetric = 500;       // mm: a larger one is rather a name, "endmill1000"

// Whether the number is a size of the trade in inches, given in mm: 3.175 is 1/8 inch.
bool is_inch_size_in_mm(const ToolLength& length) {
  const double sizes = length.value / kMmPerInch * 32;
  const double whole = std::round(sizes);
  return whole >= 2 && whole <= 32 && std::abs(sizes - whole) * kMmPerInch / 32 < 6e-4;
}

// Whether the name has lost the slash of a fraction, because posts leave out signs of a tool's
// name: "18 FLAT ENDMILL" beside 3.175 mm is 1/8, "112 FACE MILL" beside 1.5 inches is 1 1/2.
bool lost_its_slash(const ToolLength& name, double diameter) {
  constexpr double kMost = 9999;
  if (name.unit > 0 || name.fraction || name.value > kMost || name.value != std::floor(name.value))
    return false;
  const auto digits = static_cast<int>(name.value);
  for (int power = 10; power < digits; power *= 10) {
    const int lower = digits % power;
    if (lower < 2 || lower > 64 || (lower & (lower - 1)) != 0) continue;
    for (const int whole_at : {10000, 10, 100}) {  // no whole number, or one before 1 or 2 digits
      const int upper = digits / power, fraction = upper % whole_at;
      if (fraction % 2 == 0 || fraction >= lower) continue;
      const int whole = upper / whole_at;
      const double inches = whole + static_cast<double>(fraction) / lower;
      if (std::abs(inches * kMmPerInch - diameter) < kSameSize) return true;
    }
  }
  return false;
}

// The most explicit reading of the diameter.
const ToolLength& main_reading(const ToolHint& hint, double unit) {
  for (const ToolLength& reading : hint.diameters)
    if (std::none_of(hint.diameters.begin(), hint.diameters.end(), [&](const ToolLength& other) {
          return lost_its_slash(reading, other.mm(unit));
        }))
      return reading;
  return hint.diameters.front();
}

// The diameter in mm; 0 and a reason where the readings differ or the unit is in doubt.
double agreed_diameter(const ToolHint& hint, double unit, std::string& why) {
  const ToolLength& first = main_reading(hint, unit);
  const double diameter = first.mm(unit);
  bool confirmed = false;
  for (const ToolLength& other : hint.diameters) {
    if (&other == &first || lost_its_slash(other, diameter)) continue;
    if (std::abs(other.mm(unit) - diameter) > kSameSize) {
      why = fmt::format("can be read as diameter {} or {}", as_written(first), as_written(other));
      return 0;
    }
    if (!other.fraction || other.unit > 0) confirmed = true;
  }
  if (first.unit == 0 && !confirmed) {
    const bool metric_fraction = first.fraction && unit == 1 && !hint.type;
    const bool converted = unit > 1 && !first.fraction && is_inch_size_in_mm(first);
    const bool wide = hint.trade == ToolTrade::face_mill || hint.trade == ToolTrade::disc;
    const bool name = hint.type && hint.bare_size && !wide;  // "365_endmill001"
    const bool huge =
        converted || diameter > (unit > 1 || name ? kLargestWithoutUnit : kLargestMetric);
    if (first.letter_point && unit == 1) {
      why = fmt::format("can be read as diameter {0} or as D. and a number without a point",
                        as_written(first));
      return 0;
    }
    if (metric_fraction || huge || (first.inch_style && unit == 1)) {
      why = fmt::format("gives the diameter {} without a unit, in a program in {}",
                        as_written(first), unit > 1 ? "inches" : "mm");
      return 0;
    }
  }
  if (hint.beside_inches && first.unit == 0 && unit == 1 && hint.diameters.size() == 1) {
    why = fmt::format("gives the diameter {} without a unit, beside a size in inches",
                      as_written(first));
    return 0;
  }
  if (hint.disputed_gauge && unit == 1) {
    why = fmt::format("can be read as size {} of ANSI or of BS 328, which differ", hint.gauge);
    return 0;
  }
  if (!hint.gauge.empty() && !hint.pilot && unit == 1 && !confirmed) {
    why = fmt::format("can be read as the drill {} of {}, in a program in mm", hint.gauge,
                      as_written(first));
    return 0;
  }
  return diameter;
}

// A radius in mm. A radius without a unit has the unit of the diameter beside it.
double beside(const ToolLength& radius, const ToolHint& hint, double unit) {
  if (hint.diameters.empty() || radius.unit > 0 || radius.fraction) return radius.mm(unit);
  const ToolLength& first = hint.diameters.front();
  return radius.value * (first.unit > 0 ? first.unit : first.fraction ? kMmPerInch : unit);
}

// Whether comments agree in the sizes that each of them gives; a rounded radius in inches does.
bool sizes_agree(const ToolHint& hint, double unit, std::string& why) {
  const bool turns = hint.type && is_turning(*hint.type);
  const auto mm = [&](ToolLength size) {
    if (turns && size.unit == 0 && hint.insert != "R" && !hint.width)
      size.unit = usual_nose_unit(size.value);
    return turns ? size.mm(unit) : beside(size, hint, unit);
  };
  for (const SizePair& pair : hint.pairs) {
    if (std::abs(mm(pair.first) - mm(pair.second)) <= (turns ? kRounded : kSameSize)) continue;
    why = fmt::format("can be read as {} {} or {}", pair.what, as_written(pair.first),
                      as_written(pair.second));
    return false;
  }
  return true;
}

// Sets the corner radius; false if the tool cannot have it. A bull-nose mill whose corner is half
// its diameter becomes a ball mill.
bool fill_corner(const ToolHint& hint, double unit, Tool& out, std::string& why) {
  const ToolLength& corner = hint.corner ? hint.corner : hint.nose;  // "DC=12 RE=1"
  out.corner_radius = corner && hint.trade != ToolTrade::tap ? beside(corner, hint, unit) : 0;
  if (out.type == ToolType::endmill && out.corner_radius > 0) out.type = ToolType::bullmill;
  const double radius = out.diameter / 2;
  // The diameter of a tapered mill is where its flank meets the plane of the tip, which is smaller
  // than a ball's equator: the corner may be larger than half of it.
  const SinCos lean = sincos(out.type == ToolType::taper ? out.taper_angle : 0);
  if (out.corner_radius > radius * lean.cos / (1 - lean.sin) + kSameSize) {
    why = fmt::format("gives a corner radius of {:.6g} mm, more than half the diameter",
                      out.corner_radius);
    return false;
  }
  if (out.type == ToolType::bullmill && !(out.corner_radius > 0)) {
    why = "gives no corner radius";
    return false;
  }
  const bool ball = out.type == ToolType::ballmill || out.type == ToolType::lollipop;
  if (ball && out.corner_radius > 0 && out.corner_radius < radius - kRounded) {
    why =
        fmt::format("names a ball mill, but its radius of {:.6g} mm is less than half the diameter",
                    out.corner_radius);
    return false;
  }
  const bool whole = out.corner_radius > radius - 1e-3;
  if (out.type == ToolType::bullmill && whole) out.type = ToolType::ballmill;
  if (out.type == ToolType::ballmill || ball || out.type == ToolType::drill) out.corner_radius = 0;
  return true;
}

// A cone's flank ends at the flute length; without one at the diameter, if the tip has its own,
// else where the program's cuts end.
void fill_cone(const ToolHint& hint, double unit, Tool& out, std::string& why) {
  if (hint.flute_length) out.flute_length = beside(hint.flute_length, hint, unit);
  const bool ball = hint.trade == ToolTrade::cone_ball;
  const double tip = ball ? 2 * out.corner_radius : hint.tip ? beside(hint.tip, hint, unit) : 0;
  if (tip > 0 && tip < out.diameter - kSameSize) out.tip_diameter = tip;
  if (!(out.taper_angle > 0))
    why = "gives no taper angle";
  else if (ball && !(out.corner_radius > 0))
    why = "gives no radius of the tip";
}

// A centre drill by its number, or by its pilot and body: "#3", "3.15 X 8". Its pilot is as long as
// the standards say: ANSI B94.11M for numbers and inches, ISO 866 for sizes in mm.
bool fill_centre_drill(const ToolHint& hint, double unit, Tool& out) {
  constexpr double kMetric = 1.25, kInches = 1;  // lengths, in widths of the pilot
  const double pilot = beside(hint.pilot, hint, unit), told = hint.pilot.unit;
  const bool inches = told > 1 || hint.pilot.fraction || (told == 0 && unit > 1);
  const double length = pilot * (inches ? kInches : kMetric);
  out.type = ToolType::form;
  out.profile = centre_drill_outline(pilot, out.diameter, length, hint.tip_angle);
  out.origin += fmt::format(", its pilot {:.4g} mm wide and {:.4g} mm long", pilot, length);
  return true;
}

void fill_dovetail(const ToolHint& hint, double unit, Tool& out, std::string& why) {
  if (!(hint.taper_angle > 0)) {
    why = "gives no angle of its flanks";
  } else if (!hint.flute_length) {
    why = "gives no height of its head";
  } else if (hint.corner) {
    why = "gives a corner radius, which its outline must have";
  } else {
    out.taper_angle = 0;
    out.profile =
        dovetail_outline(out.diameter, hint.taper_angle, beside(hint.flute_length, hint, unit));
    if (out.profile.empty()) why = "gives flanks that meet below the height of its head";
  }
}

// Sets what only some kinds of mill have: the flank of a tapered mill, the head of a T-slot mill.
bool fill_shape(const ToolHint& hint, double unit, Tool& out, std::string& why) {
  if (out.type == ToolType::taper) {
    fill_cone(hint, unit, out, why);
  } else if (out.type == ToolType::tslot) {
    if (hint.width) out.width = beside(hint.width, hint, unit);
    if (!(out.width > 0)) why = "gives no width of the head";
    const bool thousandths = unit == 1 && hint.width.unit == 0 && hint.width.inch_style;
    if (thousandths)
      why = fmt::format("gives the width {} without a unit, in a program in mm",
                        as_written(hint.width));
  } else if (out.type == ToolType::chamfer) {
    if (hint.tip) out.tip_diameter = beside(hint.tip, hint, unit);
    if (hint.trade == ToolTrade::chamfer_mill && !hint.tip && !hint.corner)
      out.origin += ", its tip taken to be sharp";
    if (hint.trade == ToolTrade::vee && !hint.tip && out.diameter > 0 && out.diameter < kLeastVee)
      why =
          fmt::format("can be read as diameter {0:.4g} mm or as a tip of {0:.4g} mm", out.diameter);
    if (out.diameter > 0 && out.tip_diameter >= out.diameter)
      why = "gives a tip that is not smaller than the diameter";
    if (hint.trade == ToolTrade::countersink && hint.assumed_angle && unit > 1)
      why = "gives no angle, and countersinks of inch sizes have 82 or 90 degrees";
  } else if (out.type == ToolType::barrel) {
    why = "gives no radius of the flank";
  } else if (hint.trade == ToolTrade::dovetail) {
    fill_dovetail(hint, unit, out, why);
  }
  return why.empty();
}

// Fills in the first reading of a comment in doubt, so that the error can show an example.
void sketch(const ToolHint& hint, double unit, Tool& out) {
  if (!hint.diameters.empty()) out.diameter = hint.diameters.front().mm(unit);
  if (hint.corner) out.corner_radius = beside(hint.corner, hint, unit);
  if (hint.tip) out.tip_diameter = beside(hint.tip, hint, unit);
  out.tip_angle = hint.tip_angle;
  out.taper_angle = hint.taper_angle;
  out.insert = hint.insert;
}

// Whether the size is too small for a diameter and may be what the work loses: "FACE MILL 1MM",
// "CHAMFER MILL 0.5MM".
bool may_be_depth(const ToolHint& hint, double diameter, std::string& why) {
  constexpr double kLeastFaceMill = 6, kLeastChamferMill = 2;  // mm
  const double least = hint.trade == ToolTrade::face_mill      ? kLeastFaceMill
                       : hint.trade == ToolTrade::chamfer_mill ? kLeastChamferMill
                                                               : 0;
  if (!hint.bare_size || diameter >= least) return false;
  why = fmt::format("can be read as diameter {:.4g} mm or as what the work loses", diameter);
  return true;
}

// Whether the tool may be the cutter for the work of another line: it has a size that an end mill
// lacks and that cutter has.
bool may_have_form(const ToolHint& hint) {
  return !hint.work.empty() && (hint.width || (hint.corner && hint.rounds_edges));
}

bool fill_mill(const ToolHint& hint, double unit, Tool& out, std::string& why) {
  if (may_have_form(hint)) {
    why = fmt::format("can be read as an end mill or as a cutter for \"{}\"", hint.work);
    return false;
  }
  const bool open_cone = hint.trade == ToolTrade::vee && hint.diameters.empty();
  if (hint.diameters.empty() && !open_cone) {
    why = "gives no diameter";
    return false;
  }
  if (!open_cone) out.diameter = agreed_diameter(hint, unit, why);
  if (!open_cone && !(out.diameter > 0)) return false;
  if (may_be_depth(hint, out.diameter, why)) return false;
  if (hint.pilot) return fill_centre_drill(hint, unit, out);
  out.taper_angle = hint.taper_angle;
  out.tip_angle = hint.tip_angle;
  if (hint.assumed_angle)
    out.origin += fmt::format(", taken to have {:.4g} degrees", degrees(out.tip_angle));
  return fill_corner(hint, unit, out, why) && fill_shape(hint, unit, out, why);
}

}  // namespace

std::string as_written(const ToolLength& length) {
  return fmt::format("{:.6g}{}", length.value,
                     length.unit == 1  ? " mm"
                     : length.unit > 1 ? " inch"
                                       : "");
}

bool fill_tool(const ToolHint& hint, double unit, bool lathe, Tool& out, std::string& why) {
  out.type = hint.type.value_or(ToolType::endmill);
  why = hint.doubt;
  if (!why.empty()) {
    sketch(hint, unit, out);
    return false;
  }
  if (!hint.type && (lathe || !hint.names_tool)) {
    why = "names no kind of tool";
    return false;
  }
  if (!sizes_agree(hint, unit, why)) {
    sketch(hint, unit, out);
    return false;
  }
  out.origin = fmt::format("comment \"{}\"", hint.text);
  if (!hint.work.empty()) out.origin += fmt::format(", \"{}\" taken to be the work", hint.work);
  if (out.type == ToolType::boring && !lathe) out.type = ToolType::endmill;  // it turns in a bore
  if (hint.plain_teeth() || hint.trade == ToolTrade::tap)
    out.origin += ", its thread as a plain cylinder";
  if (!hint.type || hint.unknown_shape)
    out.origin += hint.corner ? ", taken to be a mill" : ", taken to be an end mill";
  if (is_turning(out.type) && !lathe) {
    why = fmt::format("names a {} tool of a lathe", out.type == ToolType::threading  ? "threading"
                                                    : out.type == ToolType::grooving ? "grooving"
                                                                                     : "turning");
    return false;
  }
  if (!is_turning(out.type)) {
    if (!fill_mill(hint, unit, out, why)) return false;
    if (!hint.type && hint.other_work) why = "names no kind of tool that is known";
    return why.empty();
  }
  fill_turning(hint, unit, out);
  why = doubt_of_turning(hint, unit, out);
  return why.empty();
}

bool contradict(const ToolHint& first, const ToolHint& second, double unit, bool lathe) {
  Tool tool;
  std::string why;
  if (!fill_tool(first, unit, lathe, tool, why)) return false;
  ToolHint both = first;
  merge_hint(both, second);
  return !fill_tool(both, unit, lathe, tool, why);
}

}  // namespace mrsim
