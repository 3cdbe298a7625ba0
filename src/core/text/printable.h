// Text from files and their names, as people may be shown it.
#pragma once

#include <string>
#include <string_view>

namespace mrsim {

/// A line of text with control characters, line ends among them, shown as '?': what comes from a
/// file or its name never reaches a terminal as an escape sequence or as a message of its own, nor
/// turns the direction of the text round. Tabs stay.
std::string printable(std::string_view text);

/// Whether `text` begins with one of the marks behind which text may be shown backwards, U+202A to
/// U+202E and U+2066 to U+2069; each is three bytes long.
bool turns_text(std::string_view text);

}  // namespace mrsim
