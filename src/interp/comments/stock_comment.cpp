#include "interp/comments/stock_comment.h"

#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/text/text_io.h"
#include "interp/comments/comment_tokens.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <utility>

namespace mrsim {
namespace {

constexpr auto kAbsent = std::string_view::npos;

// The text behind `name`, which ends with its sign ("STOCKMIN:"). Nothing: the text does not begin
// with it.
std::optional<std::string_view> behind(std::string_view text, std::string_view name) {
  if (!text.starts_with(name)) return std::nullopt;
  return text.substr(name.size());
}

}  // namespace

// Reads up to `most` numbers, whatever stands between them: "X= 300.000, Y= 200.000", "0.00MM,
// 0.00MM". Gives how many there are.
std::size_t StockComments::read_lengths(std::string_view text, Length* out, std::size_t most) {
  std::size_t count = 0, i = 0;
  while (count < most) {
    i = text.find_first_of("0123456789.-", i);
    if (i == kAbsent) break;
    const std::size_t end = std::min(text.find_first_not_of("0123456789.", i + 1), text.size());
    const std::optional<double> value = parse_number(text.substr(i, end - i));
    if (!value) break;
    const std::string_view rest = text.substr(end);
    const double unit = rest.starts_with("MM")                            ? 1
                        : rest.starts_with("IN") || rest.starts_with('"') ? kMmPerInch
                                                                          : 0;
    out[count++] = {*value, unit};
    i = end;
  }
  return count;
}

bool StockComments::read_limits(std::string_view text) {
  for (const bool is_low : {true, false}) {
    const auto values = behind(text, is_low ? "STOCKMIN:" : "STOCKMAX:");
    Lengths corner;
    if (!values || read_lengths(*values, corner.data(), 3) != 3) continue;
    (is_low ? low_ : high_) = corner;
    return true;
  }
  return false;
}

bool StockComments::read_block(std::string_view text) {
  const auto values = behind(text, "STOCK/BLOCK,");
  std::array<Length, 6> v;
  if (!values || read_lengths(*values, v.data(), 6) != 6) return false;
  size_ = {v[0], v[1], v[2]};
  inside_ = {v[3], v[4], v[5]};
  return true;
}

// Reads the size in the comment "Material Size", or in the one behind it.
void StockComments::read_size(std::string_view text) {
  const std::size_t x = text.find("X="), y = text.find("Y="), z = text.find("Z=");
  Lengths size;
  if (x != kAbsent && x < y && y < z && z != kAbsent &&
      read_lengths(text.substr(x), size.data(), 3) == 3)
    size_ = size;
}

void StockComments::read_origin(std::string_view text) {
  const auto says = [&](std::string_view word) { return text.find(word) != kAbsent; };
  if (says("XY ORIGIN POSITION")) {
    Lengths place;
    const std::size_t count = read_lengths(text, place.data(), 2);
    is_moved_ = std::any_of(place.begin(), place.begin() + static_cast<std::ptrdiff_t>(count),
                            [](const Length& l) { return l.value != 0; });
  } else if (says("XY ORIGIN")) {
    const bool center = says("CENTER") || says("CENTRE");
    if (!center && !says("CORNER")) return;
    share_.x = center ? 0.5 : says("RIGHT") ? 1 : 0;
    share_.y = center ? 0.5 : says("TOP") ? 1 : 0;
    has_share_xy_ = true;
  } else if (says("Z ORIGIN")) {
    if (!says("SURFACE") && !says("BED")) return;
    share_.z = says("MATERIAL SURFACE") ? 1 : 0;  // else the surface of the table
    has_share_z_ = true;
  }
}

void StockComments::read(std::string_view bytes, int line) {
  const std::string folded = fold_comment(bytes);
  std::string_view text = folded;
  while (text.starts_with(' ')) text.remove_prefix(1);
  const bool had_size = size_.has_value();
  const bool sized = std::exchange(size_follows_, false);
  const bool limits = read_limits(text);
  if (!limits && !read_block(text)) {
    if (text.starts_with("MATERIAL SIZE") || sized) read_size(text);
    size_follows_ = text.starts_with("MATERIAL SIZE") && !size_;
    if (text.find("ORIGIN") != kAbsent) read_origin(text);
  }
  if (limits || (size_ && !had_size && !low_)) line_ = line;
}

std::optional<Box3> StockComments::box(double unit) const {
  const auto in_mm = [&](const Lengths& lengths) {
    const auto mm = [&](const Length& l) { return l.value * (l.unit > 0 ? l.unit : unit); };
    return Vec3{mm(lengths[0]), mm(lengths[1]), mm(lengths[2])};
  };
  Box3 box;
  if (low_ && high_) {
    box.lo = in_mm(*low_);
    box.hi = in_mm(*high_);
  } else if (size_ && (inside_ || (has_share_xy_ && has_share_z_ && !is_moved_))) {
    const Vec3 size = in_mm(*size_);
    const Vec3 shared{share_.x * size.x, share_.y * size.y, share_.z * size.z};
    box.lo = Vec3{} - (inside_ ? in_mm(*inside_) : shared);
    box.hi = box.lo + size;
  }
  const bool solid = box.lo.x < box.hi.x && box.lo.y < box.hi.y && box.lo.z < box.hi.z;
  return solid ? std::optional(box) : std::nullopt;
}

}  // namespace mrsim
