#include "interp/statements/figure_copy.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr long kMostCopies = 99'999'999;
constexpr double kTurned = 72.1;  // the G word; the other one is 72.2

}  // namespace

bool FigureCopy::wants_block() const {
  return block_.oneshot && block_.oneshot_code == Code::figure_copy;
}

bool FigureCopy::whole(const Word* word, long least, long& out) {
  if (!word) return true;
  const double most = static_cast<double>(kMostCopies);
  if (word->value < static_cast<double>(least) || word->value > most ||
      word->value != std::floor(word->value))
    return error(
        "value-range",
        fmt::format("{} is a whole number from {} to {}", text_of(*word), least, kMostCopies),
        *word);
  out = static_cast<long>(word->value);
  return true;
}

bool FigureCopy::run() {
  where_ = *block_.oneshot;
  step_ = {};
  runs_ = 1;
  const Word* p = take('P');
  if (!p)
    return error("call-without-program",
                 fmt::format("{} needs P with the number of a program", text_of(where_)), where_);
  program_ = *p;
  if (!whole(p, 1, number_) || !whole(take('L'), 0, runs_)) return false;
  waits_ = where_.value == kTurned ? read_turn() : read_shift();
  return waits_;
}

// The centre is absolute, in G91 too.
bool FigureCopy::read_turn() {
  const Word* angle = take('R');
  AxisSet named;
  for (int i = 0; i < 3; ++i)
    if (const Word* w = take("XYZ"[i])) {
      component(step_.center, i) = w->value * length_unit(*w);
      named |= AxisSet(i);
    }
  const Basis b = basis();
  if (!angle || !named.has(axes_along(b.u) | axes_along(b.v)))
    return error(
        "value-missing",
        fmt::format("{} needs R, the angle, and both coordinates of its centre", text_of(where_)),
        where_);
  step_.angle = angle_value(*angle);
  return true;
}

bool FigureCopy::read_shift() {
  for (int i = 0; i < 3; ++i)
    if (const Word* w = take("IJK"[i])) component(step_.shift, i) = w->value * length_unit(*w);
  return !(step_.shift == Vec3{}) ||
         error("value-missing", fmt::format("{} needs I, J or K, the shift", text_of(where_)),
               where_);
}

// The first run lies where the subprogram says. Copies inside one another add up.
void FigureCopy::end_block() {
  if (!std::exchange(waits_, false)) return;
  const std::optional<SubprogramPlace> place = reader_.locate({number_, {}}, program_);
  if (!place) return;
  CallRequest request;
  request.file = place->file;
  request.begin = {place->offset, place->line, 0};
  request.repeats = runs_;
  const Frame base = frames_.rotation;
  request.on_start = [this, base, step = step_, i = 0.0]() mutable {
    transforms_.place_figure(base, i * step.angle, step.center, i * step.shift);
    ++i;
  };
  request.on_left = [this, base] { transforms_.place_figure(base, 0, {}, {}); };
  reader_.enter(std::move(request), program_);
}

}  // namespace mrsim
