#include "interp/control/block_words.h"

#include "interp/text/characters.h"

namespace mrsim {

void BlockWords::begin() {
  ++epoch_;
  groups_ = 0;
  places.clear();
  motion_code = oneshot = frame_code = ends_cycle = lap_begins = call_word = m98 = home = set_tool =
      comp_word = pause = nullptr;
  motion = Code::unknown;
  turn_cycle = 0;
  path_mode.reset();
  suppress_frames = comp_selected = comp_moved = length_changed = false;
  ends_rotation = ends_scaling = false;
  tool_change = stop_after = return_after = loops = home_guessed = false;
}

void BlockWords::forget_words() {
  words.clear();
  ++epoch_;
}

void BlockWords::put_back(const BlockPlace& place) {
  forget_words();
  begin();
  file = place.file;
  line_number = place.line;
  call = place.call;
}

Motion BlockWords::motion_at(int column) const {
  Motion place;
  place.file = file;
  place.line = line_number;
  place.column = column + 1;
  place.call = call;
  return place;
}

std::optional<long> BlockWords::number_after(const Word& word) const {
  const std::string_view code = line.substr(0, line.find(';'));
  int depth = 0;  // of brackets, which hold comments and expressions
  for (auto i = static_cast<std::size_t>(word.column) + 1; i + 1 < code.size(); ++i) {
    depth += code[i] == '(' ? 1 : code[i] == ')' && depth > 0 ? -1 : 0;
    if (depth != 0 || upper(code[i]) != 'N' || !is_digit(code[i + 1])) continue;
    long value = 0;
    for (++i; i < code.size() && is_digit(code[i]) && value < 100'000; ++i)
      value = 10 * value + (code[i] - '0');
    return value;
  }
  return std::nullopt;
}

}  // namespace mrsim
