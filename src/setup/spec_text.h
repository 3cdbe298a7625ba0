// Text of --tool and --stock, and of files that may be no text.
#pragma once

#include <optional>
#include <string_view>

namespace mrsim {

/// The text without blanks at both ends.
inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// By the mark at the beginning of the file.
inline bool is_utf16(std::string_view text) {
  return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
}

/// mm. "5", "6.35mm", "0.25in", "1/4in", "1/4\""; nothing: that is no length.
std::optional<double> parse_length(std::string_view text);

}  // namespace mrsim
