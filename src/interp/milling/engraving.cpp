#include "interp/milling/engraving.h"

#include "core/numbers/trig.h"
#include "interp/path/stroke_font.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kSerialVariable = 599;
constexpr double kMostSerial = 1e9;
/// The manual of Haas prints widths of the space and the exclamation mark, 0.864 and 0.538 of the
/// height. They are the widths of our font times this factor.
constexpr double kHaasWidth = 1.133;

}  // namespace

bool Engraving::holds_text(const BlockWords& block) {
  return !block.comments.empty() && block.find(letter('P')) && block.has_code('G', 47);
}

// The control turns and scales the letters by its own G68 and G51.
bool Engraving::allowed() {
  const Word& where = *block_.oneshot;
  if (modal_.plane != kPlaneXY) return error("value-range", "G47 needs the plane G17", where);
  if (modal_.comp != Code::comp_off)
    return error("cycle-compensation", "G47 engraves under radius compensation", where);
  if (modal_.incremental)
    return error("not-supported", "G47 under G91 is not supported: write G90 before it", where);
  if (!frames_.total.plain)
    return error("not-supported",
                 "G47 in a turned, scaled or mirrored frame is not supported; I turns the text",
                 where);
  return true;
}

// With P0 and P1 the text is the comment of the block. Any other P is the code of a character.
bool Engraving::read_letters(Text& out) {
  const Word& p = *take('P');
  if (p.value >= ' ' && p.value <= '~' && p.value == std::floor(p.value)) {
    out.letters = static_cast<char>(p.value);
    return true;
  }
  if (p.value != 0 && p.value != 1)
    return error("value-range", "P of G47 is 0, 1, or the code of a character, 32 to 126", p);
  if (block_.comments.empty())
    return error("value-missing", "G47 needs its text, (TEXT), in the same block", p);
  const std::string_view text = block_.comments.front();
  if (p.value == 1) return serial_number(text, out.letters);
  out.letters = text;
  return true;
}

// "####" is that many digits of #599; digits instead set it first. Then #599 counts on.
bool Engraving::serial_number(std::string_view form, std::string& out) {
  const Word& p = *peek('P');
  const bool digits = form.find_first_not_of("0123456789") == std::string_view::npos;
  if (form.empty() || form.size() > 9 ||
      (!digits && form.find_first_not_of('#') != std::string_view::npos))
    return error("value-range",
                 "G47 P1 has up to nine # in brackets, or the number to begin with: (####), (0001)",
                 p);
  double number = 0;
  if (digits)
    number = std::stod(std::string(form));
  else if (!statements_ || !statements_->variable(kSerialVariable, number))
    warning("serial-number", "#599 has no value: 0 is engraved; --set '#599=1' gives it one", p);
  if (!(number >= 0 && number < kMostSerial) || number != std::floor(number))
    return error("value-range", "#599, the serial number, is a whole number from 0", p);
  out = fmt::format("{:0{}}", static_cast<long>(number), form.size());
  out = out.substr(out.size() - form.size());
  if (statements_) statements_->set_variable(kSerialVariable, number + 1);
  return true;
}

bool Engraving::read(Text& out) {
  const Word& where = *block_.oneshot;
  const Word* z = take('Z');
  const Word* j = take('J');
  if (!z) return error("value-missing", "G47 needs Z, the depth", where);
  if (!j && !modal_.inch)
    return error("value-missing", "G47 needs J, the height of the letters", where);
  if (!read_letters(out)) return false;
  out.height = j ? j->value * length_unit(*j) : 25.4;
  out.depth = z->value * length_unit(*z);
  const Word* r = take('R');
  out.retract = r ? r->value * length_unit(*r) : position_.programmed.z;
  if (const Word* i = take('I')) out.turn = i->value;
  if (const Word* e = take('E')) out.plunge = e->value * feed_scale();
  if (!(out.height > 0)) return error("value-range", "J of G47 is a height above 0", *j);
  if (!(out.retract > out.depth))
    return error("value-range", "R of G47, or where Z is, must lie above Z", *z);
  return out.plunge >= 0 || error("feed-range", "E of G47 is a feed above 0", *peek('E'));
}

void Engraving::cut(const Text& text) {
  TextStrokes set = text_strokes(text.letters);
  const Vec2 start = cutter_.mover().position();
  const SinCos turn = sincos_deg(text.turn);
  const auto in_text = [&](Vec2 p) {
    const Vec2 at{p.x * kHaasWidth * text.height, p.y * text.height};
    return start + Vec2{turn.cos * at.x - turn.sin * at.y, turn.sin * at.x + turn.cos * at.y};
  };
  LetterCutter::Levels levels;
  levels.safe = text.retract;
  levels.depth = text.depth;
  levels.plunge = text.plunge;
  for (std::vector<Vec2>& stroke : set.strokes)
    for (Vec2& point : stroke) point = in_text(point);
  cutter_.cut(set.strokes, levels);
  cutter_.mover().rapid(in_text({set.width, 0}));
}

bool Engraving::run() {
  Text text;
  Target start;
  if (!allowed() || !read(text) || !axes_.target(start, position_.programmed)) return false;
  cutter_.begin(*block_.oneshot);
  cutter_.mover().rapid({start.programmed.x, start.programmed.y});
  cut(text);
  return true;
}

}  // namespace mrsim
