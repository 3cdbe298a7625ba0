#include "cli/console/figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace mrsim::cli {

std::string grouped(double value, int decimals) {
  std::string digits = fmt::format("{:.{}f}", std::fabs(value), decimals);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  for (std::size_t i = point; i > 3; i -= 3) digits.insert(i - 3, " ");
  return (value < 0 && digits.find_first_not_of("0. ") != digits.npos ? "-" : "") + digits;
}

std::string small_volume(double volume) { return grouped(volume, volume < 100 ? 2 : 0); }

std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  if (seconds < 59.95) return fmt::format("{:.1f} s", seconds);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace mrsim::cli
