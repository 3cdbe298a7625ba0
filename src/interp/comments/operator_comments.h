// Comments that tell the operator what to do at a stop: turn the part over ("FLIP PART", "BAUTEIL
// WENDEN"), or change the tool by hand ("CHANGE TO 1/8 BALL ENDMILL").
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace mrsim {

enum class PartTurned : std::uint8_t {
  no,
  perhaps,  ///< "OTHER SIDE", "MOVE PART", perhaps about the work: counts beside M0 alone
  yes
};

/// `bytes` in whatever encoding they came; `lathe`: "TURN PART" is what the machine does.
PartTurned says_part_is_turned(std::string_view bytes, bool lathe);

/// Whether the comment asks for a change of the tool by hand.
bool says_tool_is_changed(std::string_view bytes);

/// The number of the tool, of a comment that is nothing but a tool change, "M6 T2": posts for
/// controls without M6 leave it there.
std::optional<int> tool_change_in_comment(std::string_view bytes);

}  // namespace mrsim
