#include "interp/words/workpiece.h"

#include "core/text/text_io.h"
#include "interp/text/characters.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Whether the comment says inches: "MATERIAL - STEEL INCH - 1030" of Mastercam, "UNITS: INCHES".
bool says_inches(std::string_view comment) {
  const std::string text = upper_case(comment.substr(0, 200));
  bool inches = false, units = false;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && is_letter(text[end])) ++end;
    const std::string_view word = std::string_view(text).substr(i, end - i);
    if (word == "MM") return false;
    inches |= word == "INCH" || word == "INCHES";
    units |= word == "MATERIAL" || word == "UNIT" || word == "UNITS" || word == "DIMENSIONS" ||
             word == "PROGRAM";
    i = end > i ? end : i + 1;
  }
  return inches && units;
}

// The numbers of WORKPIECE behind its type, for a box; and what two of them mean for other types.
enum : std::size_t { kMask, kTop, kBottom, kFinished, kX0, kY0, kX1, kY1 };
enum : std::size_t { kLength = kX0, kWidth = kY0, kOuter = kX0, kInner = kY0 };
// Bits of the mask. If one is set, the value is a coordinate, else a distance from the one before.
enum : unsigned { kX1Absolute = 16, kY1Absolute = 32, kBottomAbsolute = 64 };

}  // namespace

// WORKPIECE(,"",,"BOX",mask,za,zi,zb,x0,y0,x1,y1) states the stock, and so do the types of round
// stock.
bool WorkpieceWords::run() {
  Word where;
  const std::size_t at = block_.line.find('(');
  where.column = at == std::string_view::npos ? 0 : static_cast<int>(at) - 9;
  where.length = 9;
  std::array<double, 12> v{};
  std::string type;
  std::size_t count = 0, field = 0;
  std::string_view rest = block_.argument;
  for (bool more = true; more; ++field) {
    const std::size_t comma = rest.find(',');
    more = comma != std::string_view::npos;
    std::string text;
    for (const char c : rest.substr(0, comma))
      if (c != ' ' && c != '"') text += c;
    if (more) rest.remove_prefix(comma + 1);
    if (field == 3) type = upper_case(text);
    if (type == "N_CORNER" || type == "FILE") {
      note_once("simulator-line",
                fmt::format("WORKPIECE of type {} draws the blank on the control's screen and is "
                            "not taken over: --stock gives it",
                            type),
                where, "WORKPIECE");
      return true;
    }
    if (field < 4 || count >= v.size()) continue;
    const std::optional<double> value = text.empty() ? 0.0 : parse_number(text);
    if (!value)
      return error("not-supported", "an expression in WORKPIECE is not supported yet", where);
    v[count] = *value * (count == kMask ? 1 : scale());
    ++count;
  }
  return set(type, v, where);
}

bool WorkpieceWords::set(const std::string& type, const std::array<double, 12>& v,
                         const Word& where) {
  const auto mask = static_cast<unsigned>(v[kMask] < 0 ? 0 : v[kMask]);
  const double top = v[kTop], bottom = (mask & kBottomAbsolute) ? v[kBottom] : v[kTop] + v[kBottom];
  StockShape stock;
  if (type.empty()) return true;
  stock.box.lo.z = std::min(top, bottom);
  stock.box.hi.z = std::max(top, bottom);
  if (type == "BOX") {
    const double x1 = (mask & kX1Absolute) ? v[kX1] : v[kX0] + v[kX1],
                 y1 = (mask & kY1Absolute) ? v[kY1] : v[kY0] + v[kY1];
    stock.box.lo.x = std::min(v[kX0], x1);
    stock.box.hi.x = std::max(v[kX0], x1);
    stock.box.lo.y = std::min(v[kY0], y1);
    stock.box.hi.y = std::max(v[kY0], y1);
  } else if (type == "RECTANGLE") {
    stock.box.lo = {-v[kLength] / 2, -v[kWidth] / 2, stock.box.lo.z};
    stock.box.hi = {v[kLength] / 2, v[kWidth] / 2, stock.box.hi.z};
  } else if (type == "CYLINDER" || type == "PIPE") {
    stock.kind = type == "PIPE" ? StockShape::Kind::tube : StockShape::Kind::cylinder;
    stock.outer_radius = v[kOuter] / 2;
    if (type == "PIPE") stock.inner_radius = v[kInner] / 2;
    stock.box.lo = {-v[kOuter] / 2, -v[kOuter] / 2, stock.box.lo.z};
    stock.box.hi = {v[kOuter] / 2, v[kOuter] / 2, stock.box.hi.z};
  } else {
    return error("not-supported", fmt::format("WORKPIECE of type {} is not supported yet", type),
                 where);
  }
  const Vec3 shift = frames_.total.shift;
  stock.box.lo += shift;
  stock.box.hi += shift;
  stock.axis_point = {shift.x, shift.y, 0};
  if (!(stock.box.lo.x < stock.box.hi.x && stock.box.lo.y < stock.box.hi.y &&
        stock.box.lo.z < stock.box.hi.z))
    return error("value-range", "the WORKPIECE has no volume", where);
  stock.description = fmt::format("WORKPIECE {} in line {}", type, block_.line_number);
  program_.workpiece = stock;
  return true;
}

void CommentedStock::read_comments() {
  if (settled_) return;
  for (const std::string_view comment : block_.comments)
    says_inches_ = says_inches_ || says_inches(comment);
  if (lathe()) return;
  for (const std::string_view comment : block_.comments)
    comments_.read(comment, block_.line_number);
}

bool CommentedStock::may_mean_inches() const {
  return !modal_.units_given && !is(Dialect::sinumerik) && !is(Dialect::codesys);
}

// Warns of --tool endmill:d=0.25 for a tool of 1/4 inch.
void CommentedStock::compare_typed_tools() {
  constexpr double kLeastInInches = 1;  // mm: mills of programs in inches are larger
  if (!modal_.inch) return;
  for (const Tool& tool : program_.tools) {
    if (!tool.origin.starts_with("--tool") || !(tool.diameter > 0) ||
        tool.diameter > kLeastInInches)
      continue;
    return reporter_.add_general(
        Severity::warning, "tool-unit",
        fmt::format("the program is in inches, and --tool gives a diameter of {:g} mm: write "
                    "d={:g}in if inches are meant",
                    tool.diameter, tool.diameter));
  }
}

// Warns where lengths are probably inches: G96 S1000 at X2 is a speed in feet a minute and a
// diameter in inches.
void CommentedStock::compare_units(bool tools_in_inches, double farthest, double slowest) {
  compare_typed_tools();
  constexpr double kSmall = 40;       // mm; as inches it is a metre
  constexpr double kFastest = 30000;  // rev/min: lathes for watches reach it
  if (says_inches_ || !may_mean_inches() || farthest >= kSmall) return;
  if (tools_in_inches)
    reporter_.add_general(
        Severity::warning, "units-unset",
        "the tools are in inches and the places small, but the program has no G20: "
        "it is read in mm; write G20, or G21, at its top");
  else if (std::isfinite(slowest) && slowest > kFastest)
    reporter_.add_general(
        Severity::warning, "units-unset",
        fmt::format("the speeds of G96 and the diameters are {:.0f} rev/min and more in mm, as if "
                    "meant in feet and inches, but the program has no G20: it is read in mm; write "
                    "G20, or G21, at its top",
                    slowest));
}

void CommentedStock::settle() {
  settled_ = true;
  if (says_inches_ && may_mean_inches())
    reporter_.add(Severity::warning, "units-unset",
                  "a comment says inches, but the program has no G20: it is read in mm; write G20 "
                  "at its top",
                  0, 1);
  const std::optional<Box3> box = comments_.box(scale());
  if (!box || program_.workpiece) return;
  StockShape stock;
  const Vec3 zero = frames_.work + frames_.position_shift;
  stock.box = {box->lo + zero, box->hi + zero};
  const Vec3 &lo = stock.box.lo, &hi = stock.box.hi;
  stock.description =
      fmt::format("of the comment in line {}: box:{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}",
                  comments_.line(), lo.x, lo.y, lo.z, hi.x, hi.y, hi.z);
  program_.workpiece = stock;
}

}  // namespace mrsim
