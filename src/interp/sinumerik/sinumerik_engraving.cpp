#include "interp/sinumerik/sinumerik_engraving.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "interp/path/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kValues = 21;

// The digits of VARI.
enum : int { kPolar, kAlong, kReserved, kAcross, kUp, kSpacingBy, kPolarCenter, kMirror };

// A letter of height 1 on the line y = 0, and where it stands in the text.
using Layout = std::function<Vec2(Vec2 inside, double begin, double width)>;

std::vector<std::vector<Vec2>> set_letters(std::string_view letters, double height, double gap,
                                           const Layout& layout) {
  std::vector<std::vector<Vec2>> out;
  double begin = 0;
  for (const char c : letters) {
    TextStrokes letter = letter_strokes(c);
    const double width = letter.width * height;
    for (std::vector<Vec2>& stroke : letter.strokes) {
      for (Vec2& p : stroke) p = layout(height * p, begin, width);
      out.push_back(std::move(stroke));
    }
    begin += width + gap;
  }
  return out;
}

}  // namespace

bool SinumerikEngraving::read_letters(std::string& out) {
  out = call_->text("TEXT");
  if (out.empty())
    return fail("value-missing", "CYCLE60 needs its text, in quotes, as its first value");
  if (out.find('<') != std::string::npos)
    return fail("not-supported",
                "CYCLE60: a text with < > (numbers, dates and variables that the control fills in) "
                "is not supported: join the text by << before the cycle");
  for (const char c : out)
    if (!font_has(c))
      return fail("not-supported",
                  "CYCLE60: the text has a character that is not ASCII, which the font here lacks");
  return true;
}

// The meaning of the values behind CODEP is not confirmed, except for the plane and the kind of
// depth.
bool SinumerikEngraving::reads_all() {
  const auto refuse = [&](const char* what) {
    return fail("not-supported", fmt::format("CYCLE60: {} is not supported", what));
  };
  if (call_->values.size() > kValues) return refuse("a list of more than 21 values");
  if (call_->given("CODEP") && call_->get("CODEP") != 0 && call_->get("CODEP") != 1252)
    return refuse("a code page (CODEP) other than 1252");
  if (call_->get("UMODE") != 0) return refuse("a UMODE other than 0");
  if (call_->get("GMODE") != 0) return refuse("a GMODE other than 0");
  if (call_->get("DMODE") < 0 || call_->get("DMODE") > 3) return refuse("a DMODE above 3");
  if (call_->get("AMODE") < 0 || call_->get("AMODE") > 2) return refuse("an AMODE above 2");
  const int plane = call_->digit("DMODE", 0);
  return plane == 0 || plane == modal_.plane + 1 ||
         fail("cycle-plane", "CYCLE60: DMODE names another plane than the one in force");
}

Vec2 SinumerikEngraving::point(ValueName u, ValueName v, bool polar) const {
  const double a = call_->get(u), b = call_->get(v);
  if (!polar) return {a * scale(), b * scale()};
  const SinCos turn = sincos_deg(b);
  return {a * scale() * turn.cos, a * scale() * turn.sin};
}

bool SinumerikEngraving::read_form(Layout& out) {
  const double form = call_->get("VARI");
  out.arc = call_->digit("VARI", kAlong);
  out.across = call_->digit("VARI", kAcross);
  out.up = call_->digit("VARI", kUp);
  out.spacing_by = call_->digit("VARI", kSpacingBy);
  const int mirror = call_->digit("VARI", kMirror);
  out.mirrored = mirror == 1;
  if (form < 0 || form >= 1e8 || form != std::floor(form) || call_->digit("VARI", kPolar) > 1 ||
      out.arc > 2 || call_->digit("VARI", kReserved) != 0 || out.across > 2 || out.up > 2 ||
      out.spacing_by > 2 || call_->digit("VARI", kPolarCenter) > 1 || mirror > 2)
    return fail("value-range", fmt::format("CYCLE60: VARI {} has a digit that is not known: "
                                           "units 0-1, tens 0-2, thousands 0-2, ten thousands "
                                           "0-2, hundred thousands 0-2, millions 0-1, ten "
                                           "millions 0-2",
                                           form));
  if (out.spacing_by == (out.arc == 0 ? 2 : 1))
    return fail("value-range",
                "CYCLE60: VARI gives a whole width (1) to a text on a line only, an angle (2) to "
                "one on an arc only (hundred thousands)");
  // It is not confirmed about which line the control mirrors. A centred text is the same for all.
  if (out.mirrored && (out.across != 1 || (out.arc == 0 && call_->get("STA") != 0)))
    return fail("not-supported",
                "CYCLE60: mirror writing is supported only about a centred reference point "
                "(thousands of VARI 1) and without an angle (STA)");
  return true;
}

bool SinumerikEngraving::read(Layout& out) {
  if (!reads_all() || !read_letters(out.letters) || !read_form(out)) return false;
  if (!call_->given("WID") || !call_->given("DF"))
    return fail("value-missing", "CYCLE60 needs WID, the letters' height, and DF, their spacing");
  out.height = call_->get("WID") * scale();
  out.spacing = call_->get("DF") * (out.spacing_by == 2 ? 1 : scale());
  if (!(out.height > 0) || out.spacing < 0)
    return fail("value-range", "CYCLE60: WID is a height above 0, DF a spacing from 0");
  out.place = point("PA", "PO", call_->digit("VARI", kPolar) == 1);
  out.turn = call_->get("STA");
  if (out.arc != 0) out.center = point("CP1", "CP2", call_->digit("VARI", kPolarCenter) == 1);
  return true;
}

// The reference point is at `across` halves of the width and `up` halves of the height.
bool SinumerikEngraving::on_line(const Layout& l, double gap, double width, Strokes& out) {
  const SinCos turn = sincos_deg(l.turn);
  const Vec2 origin{l.across * width / 2, l.up * l.height / 2};
  out = set_letters(l.letters, l.height, gap, [&](Vec2 inside, double begin, double) {
    Vec2 at = Vec2{begin + inside.x, inside.y} - origin;
    if (l.mirrored) at.x = -at.x;
    return l.place + Vec2{turn.cos * at.x - turn.sin * at.y, turn.sin * at.x + turn.cos * at.y};
  });
  return true;
}

// Each letter stands upright on the arc of the base line, its middle on the radius.
bool SinumerikEngraving::on_arc(const Layout& l, double gap, double width, double radius,
                                Strokes& out) {
  const Vec2 from = l.place - l.center;
  const SinCos first{from.y / length(from), from.x / length(from)};
  const double outwards = l.arc == 1 ? 1 : -1;
  out = set_letters(l.letters, l.height, gap, [&](Vec2 inside, double begin, double wide) {
    double along = begin + wide / 2 - l.across * width / 2, x = inside.x - wide / 2;
    if (l.mirrored) along = -along, x = -x;
    const SinCos turn = sincos(along / radius);  // the text runs clockwise over the centre
    const Vec2 up{first.cos * turn.cos + outwards * first.sin * turn.sin,
                  first.sin * turn.cos - outwards * first.cos * turn.sin};
    const Vec2 right{outwards * up.y, -outwards * up.x};
    return l.center + (radius + outwards * inside.y) * up + x * right;
  });
  return true;
}

bool SinumerikEngraving::strokes(const Layout& l, Strokes& out) {
  double letters = 0;
  for (const char c : l.letters) letters += letter_strokes(c).width * l.height;
  const auto gaps = static_cast<double>(l.letters.size() - 1);
  double radius = 0;
  if (l.arc != 0) {
    const double reference = length(l.place - l.center);
    radius = reference - (l.arc == 1 ? 1 : -1) * l.up * l.height / 2;
    if (reference <= kRounding || radius <= kRounding)
      return fail("value-range",
                  "CYCLE60: the radius of the text's arc, from its centre CP1 CP2 to the reference "
                  "point, is too small");
  }
  double gap = l.spacing;
  if (l.spacing_by != 0) {
    const double whole = l.spacing_by == 1 ? l.spacing : radians(l.spacing) * radius;
    if (gaps == 0 || whole < letters)
      return fail("value-range",
                  fmt::format("CYCLE60: the letters of this font are {:.3f} mm wide together, "
                              "which DF, the width or the angle of the whole text, leaves no room "
                              "for",
                              letters));
    gap = (whole - letters) / gaps;
  }
  const double width = letters + gaps * gap;
  if (l.arc == 0) return on_line(l, gap, width, out);
  if (width > 2 * kPi * radius + kRounding)
    return fail("value-range", "CYCLE60: the text is longer than its circle");
  return on_arc(l, gap, width, radius, out);
}

bool SinumerikEngraving::run(const CycleCall& call, const Word& where) {
  call_ = &call;
  where_ = where;
  if (modal_.comp != Code::comp_off)
    return fail("cycle-compensation", "CYCLE60 under radius compensation: G40 before it");
  Layout layout;
  Strokes lines;
  if (!read(layout) || !strokes(layout, lines)) return false;
  const auto planes = cycle_planes(call, call.digit("AMODE", 0), scale());
  if (!planes)
    return fail("value-missing", "CYCLE60 needs RTP, RFP and DP, its planes and its depth");
  if (!planes->cuts())
    return fail("value-range",
                "CYCLE60: the depth does not lie below the reference plane (alarm 61101)");
  LetterCutter::Levels levels;
  levels.safe = planes->safe;
  levels.depth = planes->bottom;
  levels.feed = call.get("FFP1") * feed_scale();
  levels.plunge = call.given("FFD") ? call.get("FFD") * feed_scale() : levels.feed;
  if (levels.feed < 0 || levels.plunge < 0) return fail("feed-range", "the feeds must be above 0");
  cutter_.begin(where);
  cutter_.mover().rapid_height(planes->top);
  if (!lines.empty()) cutter_.mover().rapid(lines.front().front());
  cutter_.cut(lines, levels);
  cutter_.mover().rapid_height(planes->top);
  return true;
}

}  // namespace mrsim
