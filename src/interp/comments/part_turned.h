// Comments that tell the operator to turn the part over: "FLIP PART", "BAUTEIL WENDEN".
#pragma once

#include <cstdint>
#include <string_view>

namespace mrsim {

enum class PartTurned : std::uint8_t {
  no,
  perhaps,  ///< "OTHER SIDE", which may be a place of the work: counts beside M0 alone
  yes
};

/// `bytes` in whatever encoding they came; `lathe`: "TURN PART" is what the machine does.
PartTurned says_part_is_turned(std::string_view bytes, bool lathe);

}  // namespace mrsim
