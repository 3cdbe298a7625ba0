#include "setup/spec_text.h"

#include "core/numbers/units.h"
#include "core/text/text_io.h"

namespace mrsim {
namespace {

bool drop_end(std::string_view& text, std::string_view end) {
  if (!text.ends_with(end)) return false;
  text = trimmed(text.substr(0, text.size() - end.size()));
  return true;
}

}  // namespace

std::optional<double> parse_length(std::string_view text) {
  const bool inches = drop_end(text, "inch") || drop_end(text, "in") || drop_end(text, "\"");
  if (!inches) drop_end(text, "mm");
  double unit = inches ? kMmPerInch : 1;
  const std::size_t slash = inches ? text.find('/') : text.npos;
  if (slash != text.npos) {
    const std::optional<double> below = parse_number(trimmed(text.substr(slash + 1)));
    if (!below || !(*below > 0)) return std::nullopt;
    unit /= *below;
    text = trimmed(text.substr(0, slash));
  }
  const std::optional<double> number = parse_number(text, true);
  if (!number) return std::nullopt;
  return *number * unit;
}

}  // namespace mrsim
