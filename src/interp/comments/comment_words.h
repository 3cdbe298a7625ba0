// What the words of a tool's comment say of the numbers beside them: "DIA", "LOC", "FLUTE".
#pragma once

#include <cstdint>
#include <string_view>

namespace mrsim {

enum class WordRole : std::uint8_t {
  none,
  adjective,  ///< may stand between a size and the kind of tool: "10 MM CARBIDE LONG ENDMILL"
  flutes,
  diameter,
  register_of,  ///< "OFF" in "DIA. OFF. - 41": the number is a register, not a diameter
  radius,
  radius_letter,  ///< "R": its number is glued to it
  corner,         ///< "CORNER": names a radius only together with "RADIUS"
  nose,
  width,
  length,  ///< of the flutes; "LENGTH" alone is that of the tool
  angle,
  taper,
  tip,
  count,  ///< "4 HOLES"
  other,  ///< depth, speed, shank, register: the number does not describe the cutter
  work    ///< a number about the work: "STOCK .5", "50MM PCD"
};

/// Where the number of a word stands.
enum class NumberSide : std::uint8_t { either, before, behind };

struct CommentWord {
  WordRole role = WordRole::none;
  NumberSide side = NumberSide::either;
};

/// What an upper-case word says of the number beside it.
CommentWord comment_word(std::string_view word);

}  // namespace mrsim
