#include "interp/words/fagor_places.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMostPlaces = 10'000;
constexpr double kApart = 1e-3;  // steps: how far a row may miss its length

}  // namespace

bool FagorPlaces::read(Word& word) {
  where_ = &word;
  const int g = static_cast<int>(word.value);
  for (const Word& other : block_.words)
    if (other.address >= letter('P') && other.address <= letter('V') &&
        other.address != letter('S') && other.address != letter('T'))
      return error("not-supported",
                   fmt::format("{} beside {} (places that are left out) is not supported yet",
                               text_of(other), text_of(word)),
                   other);
  if (!(g < 63 ? line(g == 62) : circle(g == 64))) return false;
  word.address = Address::data;
  return true;
}

// Takes the value of a word, so that no other part reads it.
bool FagorPlaces::take_number(char name, bool is_length, double& out) {
  for (Word& word : block_.words) {
    if (word.address != letter(name)) continue;
    out = word.value * (is_length ? length_unit(word) : 1);
    word.address = Address::data;
    return true;
  }
  return false;
}

// A row has two of three values: the whole length or angle, the step, the number of places.
bool FagorPlaces::row(char whole, char step, char number, bool lengths, Row& out) {
  double all = 0, each = 0, count = 0;
  const bool has_all = take_number(whole, lengths, all),
             has_step = take_number(step, lengths, each);
  const bool counted = take_number(number, false, count);
  if (has_all + has_step + counted != 2)
    return error(
        "value-missing",
        fmt::format("{} needs two of {}, {} and {}", text_of(*where_), whole, step, number),
        *where_);
  if (!counted) count = each == 0 ? 0 : std::round(all / each) + 1;
  if (!has_step) each = count > 1 ? all / (count - 1) : 0;
  const bool misses = !counted && std::abs((count - 1) * each - all) > kApart * std::abs(each);
  if (count < 1 || count > kMostPlaces || count != std::floor(count) || misses)
    return error("value-range",
                 fmt::format("{}: the places are from 1 to {:g}, whole steps from the first to the "
                             "last",
                             text_of(*where_), kMostPlaces),
                 *where_);
  out = {static_cast<long>(count), each};
  return true;
}

// Adds a place at this distance from the current one, in the plane, mm.
void FagorPlaces::add(double along, double across) {
  const Basis b = basis();
  block_.places.push_back(position_.programmed + along * b.u + across * b.v);
}

// G60 A X I K is a line. G62 is a grid: Y J D are the rows, at B degrees to the lines; the tool
// goes to and fro.
bool FagorPlaces::line(bool grid) {
  double turn = 0, between = 90;
  Row columns, rows{1, 0};
  take_number('A', false, turn);
  if (!row('X', 'I', 'K', true, columns)) return false;
  if (grid) take_number('B', false, between);
  if (grid && !row('Y', 'J', 'D', true, rows)) return false;
  if (double(columns.number) * double(rows.number) > kMostPlaces)
    return error("value-range", "too many places in the grid", *where_);
  const SinCos first = sincos_deg(turn), second = sincos_deg(turn + between);
  for (long j = 0; j < rows.number; ++j)
    for (long i = 0; i < columns.number; ++i) {
      const long k = j % 2 == 0 ? i : columns.number - 1 - i;
      const double x = double(k) * columns.step, y = double(j) * rows.step;
      if (i + j > 0) add(x * first.cos + y * second.cos, x * first.sin + y * second.sin);
    }
  return true;
}

// G63 X Y I K is a circle: X Y are the centre from the current place, I the step in degrees. G64 is
// an arc with the whole angle B. C is the direction from place to place: 2 clockwise, 3
// counter-clockwise.
bool FagorPlaces::circle(bool arc) {
  double x = 0, y = 0, way = 0, step = 0, number = 0;
  take_number('X', true, x);
  take_number('Y', true, y);
  take_number('C', false, way);
  take_number('F', false, number);
  Row places;
  if (arc) {
    if (!row('B', 'I', 'K', false, places)) return false;
  } else {
    const bool has_step = take_number('I', false, step), counted = take_number('K', false, number);
    if (has_step == counted || (has_step && step == 0))
      return error("value-missing", fmt::format("{} needs I or K", text_of(*where_)), *where_);
    if (has_step) number = std::round(360 / std::abs(step));
    if (counted && number >= 1) step = 360 / number;
    if (number < 1 || number > kMostPlaces || number != std::floor(number))
      return error("value-range", "the number of places is 1 to 10000", *where_);
    places = {static_cast<long>(number), step};
  }
  if (way == 2 || way == 3) places.step = (way == 2 ? -1 : 1) * std::abs(places.step);
  const double radius = std::sqrt(x * x + y * y), start = degrees(atan2(-y, -x));
  for (long i = 1; i < places.number; ++i) {
    const SinCos sc = sincos_deg(start + double(i) * places.step);
    add(x + radius * sc.cos, y + radius * sc.sin);
  }
  return true;
}

}  // namespace mrsim
