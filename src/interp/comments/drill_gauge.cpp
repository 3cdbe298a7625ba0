#include "interp/comments/drill_gauge.h"

#include "interp/comments/comment_words.h"

#include <iterator>

namespace mrsim {
namespace {

constexpr double kNumbers[] = {
    .2280, .2210, .2130, .2090, .2055, .2040, .2010, .1990, .1960, .1935, .1910, .1890,
    .1850, .1820, .1800, .1770, .1730, .1695, .1660, .1610, .1590, .1570, .1540, .1520,
    .1495, .1470, .1440, .1405, .1360, .1285, .1200, .1160, .1130, .1110, .1100, .1065,
    .1040, .1015, .0995, .0980, .0960, .0935, .0890, .0860, .0820, .0810, .0785, .0760,
    .0730, .0700, .0670, .0635, .0595, .0550, .0520, .0465, .0430, .0420, .0410, .0400,
    .0390, .0380, .0370, .0360, .0350, .0330, .0320, .0310, .0292, .0280, .0260, .0250,
    .0240, .0225, .0210, .0200, .0180, .0160, .0145, .0135};
constexpr double kLetters[] = {.234, .238, .242, .246, .250, .257, .261, .266, .272,
                               .277, .281, .290, .295, .302, .316, .323, .332, .339,
                               .348, .358, .368, .377, .386, .397, .404, .413};

struct CentreSizes {
  double pilot, body;  // inches
};
constexpr CentreSizes kCentreDrills[] = {{3. / 64, 1. / 8}, {5. / 64, 3. / 16}, {7. / 64, 1. / 4},
                                         {1. / 8, 5. / 16}, {3. / 16, 7. / 16}, {7. / 32, 1. / 2},
                                         {1. / 4, 5. / 8},  {5. / 16, 3. / 4}};
constexpr CentreSizes kBritishCentreDrills[] = {
    {3. / 64, 1. / 8},  {1. / 16, 3. / 16}, {3. / 32, 1. / 4}, {1. / 8, 5. / 16},
    {3. / 16, 7. / 16}, {1. / 4, 5. / 8},   {5. / 16, 3. / 4}, {0, 0}};

bool is_letter_word(const CommentView& view, std::size_t i) {
  return view.word(i) && view[i].text.size() == 1 && view[i].text[0] >= 'A' &&
         view[i].text[0] <= 'Z';
}

DrillGauge letter_gauge(const CommentView& view, std::size_t i) {
  return {std::string(view[i].text), kLetters[view[i].text[0] - 'A'], i, i + 1};
}

// Reads "#7", "NO. 7", "NUMBER 7" from token i on.
std::optional<DrillGauge> read_number(const CommentView& view, std::size_t i) {
  if (!view.is_one(i, {"#", "NO", "NUMBER", "NUM", "WIRE"}) || !view.number(i + 1) ||
      !view.whole(i + 1))
    return std::nullopt;
  if (view.numbers_work(i)) return std::nullopt;  // "HOLE #1 - DRILL"
  const double number = view[i + 1].value;
  const bool goes_on = view.glued(i + 2) && (view.word(i + 2) || view.is(i + 2, "-"));
  if (number < 1 || number > double(std::size(kNumbers)) || goes_on) return std::nullopt;
  return DrillGauge{std::string(view[i + 1].text), kNumbers[std::size_t(number) - 1], i, i + 2};
}

// Reads "LETTER Q", "LTR F", "\"F\"" from token i on.
std::optional<DrillGauge> read_letter(const CommentView& view, std::size_t i) {
  const bool quoted = view.is(i, "\"") && view.is(i + 2, "\"");
  if (!(quoted || view.is_one(i, {"LETTER", "LTR", "LET"})) || !is_letter_word(view, i + 1))
    return std::nullopt;
  DrillGauge gauge = letter_gauge(view, i + 1);
  gauge.first = i;
  gauge.end = i + (quoted ? 3 : 2);
  return gauge;
}

// Whether no word of its own meaning stands between the gauge and the kind, as in "#29 (.136)
// DRILL". "#8 SCREW CLEARANCE DRILL" has such words: that drill is as large as a screw.
bool joined_by_signs(const CommentView& view, std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i)
    if (view.word(i) && !view.taken(i) && comment_word(view[i].text).role == WordRole::none)
      return false;
  return true;
}

// Whether the number before token i may be that of a screw: "DRILL #10 HOLE", "#6 SCREW DRILL".
bool is_of_screw(const CommentView& view, std::size_t i) {
  if (view.is(i, "SCREW") && view.is(i + 1, "MACHINE")) return false;  // a short drill
  return view.is_one(i, {"SCREW", "SCREWS", "BOLT", "HOLE", "HOLES", "CLEARANCE", "CLR"});
}

// Whether the number of the sign at i may be that of a thread, a hole or another drill: "CENTER
// DRILL FOR #4-40", "#7 HOLES", "HOLES #1 TO #6", "CENTER DRILL #3 OR #4".
bool numbers_other(const CommentView& view, std::size_t i) {
  const std::size_t end = i + 2;
  const bool sign = view.is_one(end, {"-", "/"});
  const bool joint = sign || view.is_one(end, {"&", "TO", "OR", "AND"});
  const bool number = view.number(end + 1) && (!sign || view.glued(end));
  const bool goes_on = joint && (number || view.is(end + 1, "#"));
  const bool drill = view.is_one(end, {"DRILL", "DRL", "DR", "TAP", "REAM"}) && !view.taken(end);
  const bool led = i > 0 && view.is_one(i - 1, {"FOR", "TO", "OR", "AND", "&"});
  const bool ends_range = i > 1 && view.is_one(i - 1, {"-", "/"}) && view.number(i - 2);
  return goes_on || drill || led || ends_range || is_of_screw(view, end);
}

// Reads "F DRILL". Five letters are left out: A is an article, C DRILL is a centre drill, U DRILL
// has inserts, I and S look like 1 and 5. A number before the letter counts flutes: "2 F DRILL".
std::optional<DrillGauge> read_bare_letter(const CommentView& view, std::size_t kind_first) {
  if (kind_first == 0) return std::nullopt;
  std::size_t i = kind_first - 1;
  if (i > 0 && view.is(i, "-") && view.glued(i)) --i;
  if (!is_letter_word(view, i) || view.taken(i)) return std::nullopt;
  if (std::string_view("ACISU").find(view[i].text) != std::string_view::npos) return std::nullopt;
  if (i > 0 && (view.number(i - 1) || view.glued(i))) return std::nullopt;
  return letter_gauge(view, i);
}

}  // namespace

std::optional<DrillGauge> find_drill_gauge(const CommentView& view, std::size_t kind_first,
                                           std::size_t kind_end) {
  for (std::size_t i = 0; i < view.size(); ++i) {
    auto gauge = read_number(view, i);
    if (!gauge) gauge = read_letter(view, i);
    if (!gauge || is_of_screw(view, gauge->end)) continue;
    const bool before = gauge->end <= kind_first && joined_by_signs(view, gauge->end, kind_first);
    const bool behind = gauge->first >= kind_end && joined_by_signs(view, kind_end, gauge->first);
    if (before || behind) return gauge;
  }
  return read_bare_letter(view, kind_first);
}

std::optional<CentreGauge> find_centre_gauge(const CommentView& view, std::size_t kind_first,
                                             std::size_t kind_end) {
  for (std::size_t i = 0; i + 1 < view.size(); ++i) {
    const bool british = view.is(i, "BS");
    if (!(british || view.is_one(i, {"#", "NO", "NUMBER", "NUM", "SIZE"})) || !view.whole(i + 1))
      continue;
    if (view.numbers_work(i) || numbers_other(view, i)) continue;
    const double number = view[i + 1].value;
    const auto at = static_cast<std::size_t>(number) - 1;
    const bool known = number >= 1 && number <= double(std::size(kCentreDrills));
    if (!known || (british && kBritishCentreDrills[at].body == 0)) continue;
    const bool before = i + 2 <= kind_first && joined_by_signs(view, i + 2, kind_first);
    const bool behind = i >= kind_end && joined_by_signs(view, kind_end, i);
    if (!before && !behind) continue;
    const CentreSizes &ansi = kCentreDrills[at], &bs = kBritishCentreDrills[at];
    const CentreSizes& sizes = british ? bs : ansi;
    const bool disputed = !british && (ansi.pilot != bs.pilot || ansi.body != bs.body);
    return CentreGauge{std::string(view[i + 1].text), sizes.pilot, sizes.body, disputed, i, i + 2};
  }
  return std::nullopt;
}

std::optional<KeyNumber> find_key_number(const CommentView& view, std::size_t kind_first,
                                         std::size_t kind_end) {
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (!view.number(i) || !view.whole(i) || view.glued(i + 1)) continue;
    const std::size_t digits = view[i].text.size();
    if (digits < 3 || digits > 4) continue;
    const bool signed_off = i > 0 && view.is_one(i - 1, {"#", "NO", "NUMBER"});
    const std::size_t first = signed_off ? i - 1 : i;
    const bool before = i + 1 <= kind_first && joined_by_signs(view, i + 1, kind_first);
    const bool behind = first >= kind_end && joined_by_signs(view, kind_end, first);
    const int number = static_cast<int>(view[i].value);
    const int eighths = number % 100, thirty_seconds = number / 100;
    const bool fits = eighths >= 2 && eighths <= 28 && thirty_seconds >= 2 && thirty_seconds <= 24;
    if (fits && (before || behind))
      return KeyNumber{eighths / 8.0, thirty_seconds / 32.0, first, i + 1};
  }
  return std::nullopt;
}

}  // namespace mrsim
