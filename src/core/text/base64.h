// Base64 (RFC 4648, with padding): bytes as text for pages and metadata.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mrsim {

/// The bytes as text of base 64, with "=" at the end.
std::string base64(std::string_view bytes);
/// The bytes again; nothing for text that base64() can not have made.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace mrsim
