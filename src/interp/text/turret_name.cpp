#include "interp/text/turret_name.h"

#include "core/text_io.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace mrsim {
namespace {

constexpr std::string_view kTurning[] = {
    "ROUGHING",   "FINISHING",    "ROUGHER",       "FINISHER",    "SCHRUPPER",
    "SCHLICHTER", "SCHRUPPSTAHL", "SCHLICHTSTAHL", "DREHMEISSEL", "DREHSTAHL"};

// "80", "T80": the corner of the insert.
std::string_view corner_of(std::string_view word) {
  if (word.starts_with('T')) word.remove_prefix(1);
  const bool usual = word == "35" || word == "55" || word == "80";
  return usual ? word : std::string_view();
}

// The last word, taken off.
std::string take_last(std::string& text) {
  const std::size_t blank = text.find_last_of(' ');
  if (blank == std::string::npos) return {};
  std::string last = text.substr(blank + 1);
  text.erase(blank);
  return last;
}

}  // namespace

std::string spelled_turret_name(std::string_view name) {
  std::string text = upper_case(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  std::string side;
  for (const auto& [letter, word] : {std::pair{" A", "OD "}, std::pair{" I", "ID "}}) {
    if (!text.ends_with(letter)) continue;
    side = word;
    take_last(text);
    break;
  }
  std::string head = text;
  const std::string last = take_last(head);
  const std::string_view corner = corner_of(last);
  const bool turning =
      std::find(std::begin(kTurning), std::end(kTurning), head) != std::end(kTurning);
  if (turning && !corner.empty()) text = "TURNING TOOL " + std::string(corner) + " DEG";
  return "TOOL " + side + text;
}

}  // namespace mrsim
