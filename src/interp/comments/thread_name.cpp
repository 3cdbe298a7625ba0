#include "interp/comments/thread_name.h"

#include "core/numbers/units.h"

namespace mrsim {
namespace {

constexpr double kCoarsestPitch = 6;  // mm, of M64

// Reads "M8", "M8X1.25", "M8 X 1.25", "M8-1.25", "MF10X1", "M5*0.8".
std::optional<ThreadName> read_metric(const CommentView& view, std::size_t i, bool threads) {
  if (!view.is_one(i, {"M", "MF"}) || !view.number(i + 1)) return std::nullopt;
  if (!view.glued(i + 1) && !threads) return std::nullopt;
  const CommentToken& size = view[i + 1];
  if (size.fraction || size.angle || !(size.value > 0)) return std::nullopt;
  ThreadName name{{size.value, 1, false}, false, i, i + 2};
  const bool pitch = view.is_one(i + 2, {"X", "-", "*"}) && view.number(i + 3) &&
                     view[i + 3].value <= kCoarsestPitch && view[i + 3].value < size.value &&
                     !view[i + 3].fraction;
  if (pitch && (!view.is(i + 2, "-") || view[i + 3].decimals)) name.end = i + 4;
  return name;
}

// Reads "8.-1.25", "10.0-1.5". The second number is a pitch if it has a point, else threads per
// inch.
std::optional<ThreadName> read_plain_metric(const CommentView& view, std::size_t i) {
  if (!view.number(i) || !view.is(i + 1, "-") || !view.number(i + 2) || !view[i + 2].decimals)
    return std::nullopt;
  if (view[i].fraction || view[i + 2].value > kCoarsestPitch || view[i + 2].value >= view[i].value)
    return std::nullopt;
  return ThreadName{view.length(i), false, i, i + 3};
}

// The diameter of machine screws #0 to #12: 0.060 inch, and 0.013 more for each number.
ToolLength screw_size(double number) { return {0.060 + 0.013 * number, kMmPerInch, false}; }

// Reads "1/4-20", ".250-20", "10-32", "#10-24", "NO. 8-32". The first number is that of a machine
// screw or inches: "1-8" is 1 inch with eight threads per inch.
std::optional<ThreadName> read_unified(const CommentView& view, std::size_t i, bool threads) {
  const bool series = view.is_one(
      i + 3, {"UN", "UNC", "UNF", "UNEF", "UNJ", "UNJF", "UNS", "NC", "NF", "BSW", "STI"});
  if (!(threads || series) || !view.number(i) || !view.is(i + 1, "-") || !view.whole(i + 2))
    return std::nullopt;
  const CommentToken& size = view[i];
  const double per_inch = view[i + 2].value;
  if (size.unit == 1 || size.angle || per_inch < 4 || per_inch > 80 || size.value > 12)
    return std::nullopt;
  ThreadName name{{}, false, i, i + 3};
  const bool screw = i > 0 && view.is_one(i - 1, {"#", "NO", "NR", "NUMBER"});
  if (screw) --name.first;
  if (screw || (view.whole(i) && per_inch >= 24))  // no whole inch has so fine a thread
    name.diameter = screw_size(size.value);
  else
    name.diameter = {size.value, kMmPerInch, false};
  return name;
}

// Reads "1/8 NPT", "1/4-18 NPTF", "G1/4", "RC 1/8", whose size is that of the pipe: no diameter.
std::optional<ThreadName> read_pipe_thread(const CommentView& view, std::size_t i) {
  const bool glued_size = view.glued(i + 1) && view.number(i + 1) && view[i + 1].fraction;
  if (view.is_one(i, {"G", "RP", "RC", "R"}) && glued_size) return ThreadName{{}, false, i, i + 2};
  if (!view.is_one(i, {"NPT", "NPTF", "NPS", "NPSF", "BSP", "BSPP", "BSPT", "PIPE"}))
    return std::nullopt;
  ThreadName name{{}, false, i, i + 1};
  if (view.number(i + 1) && view[i + 1].fraction) name.end = i + 2;
  while (name.first > 0 && (view[name.first - 1].is_number() || view.is(name.first - 1, "-")))
    --name.first;
  return name;
}

}  // namespace

std::optional<ThreadName> find_thread_name(const CommentView& view, bool threads) {
  bool enlarged = false;
  for (std::size_t i = 0; i < view.size(); ++i)
    enlarged |= view.is_one(i, {"STI", "HELICOIL", "HELI", "EG"});
  for (std::size_t i = 0; i < view.size() && threads; ++i)
    if (auto pipe = read_pipe_thread(view, i)) return pipe;
  for (std::size_t i = 0; i < view.size(); ++i) {
    auto name = read_metric(view, i, threads);
    if (!name) name = read_unified(view, i, threads);
    if (!name && threads) name = read_plain_metric(view, i);
    if (!name) continue;
    name->enlarged = enlarged;
    return name;
  }
  return std::nullopt;
}

}  // namespace mrsim
