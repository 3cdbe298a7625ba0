// Which tool a T word names: stations of turrets, their offsets and suffixes.
#include "core/text/text_io.h"
#include "interp/text/characters.h"
#include "interp/tools/tool_changer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

std::size_t digits_of(std::string_view text) {
  return std::size_t(std::count_if(text.begin(), text.end(), is_digit));
}

}  // namespace

std::string ToolChanger::id_of(const Word& word) {
  if (word.string) return to_utf8(word.text.substr(0, 80));
  const long number = static_cast<long>(word.value);
  if (turret_digits() == 0) return fmt::format("{}", number);
  const std::string written = text_of(word), text = written.substr(0, written.find('.'));
  const bool plain = text.find_first_of("#[") == text.npos;
  const std::size_t digits = plain ? digits_of(text) : 0;
  if (is(Dialect::ngc)) return mach_station(number, digits, text, word);
  const long station = turret_station(number, digits);
  const long offset = number - station * (digits == 8 ? 10000 : 1000);
  std::string whole = fmt::format("{}", number);
  if (digits >= turret_digits() && given(whole) != nullptr) return whole;
  const bool thrice = digits == 6 && number == station * 10101;
  if ((digits == 6 || digits == 8) && offset != 0 && offset != station && !thrice)
    note_once("tool-station",
              fmt::format("{} is read as tool {} with offset {}: half of the digits for each", text,
                          station, offset),
              word, text);
  return fmt::format("{}", station);
}

// How many digits a T word needs to name a station and an offset; 0: it never does.
std::size_t ToolChanger::turret_digits() const {
  if (!lathe()) return 0;
  return is(Dialect::fanuc) ? 3 : is(Dialect::ngc) ? 4 : 0;
}

// T0101 is tool 1 with offset 1 in Mach; LinuxCNC would look for tool 101.
std::string ToolChanger::mach_station(long number, std::size_t digits, const std::string& text,
                                      const Word& word) {
  std::string whole = fmt::format("{}", number);
  if (digits != turret_digits() || number < 100 || given(whole) != nullptr) return whole;
  note_once("tool-station",
            fmt::format("{} is read as tool {} with offset {}, as Mach does; if it is tool {}, "
                        "give that with --tool {}=..",
                        text, number / 100, number % 100, number, number),
            word, text);
  return fmt::format("{}", number / 100);
}

// T0 and T0000 of FANUC's lathes end the offset in force; the turret stays where it is.
bool ToolChanger::cancels_offset(const Word& word) {
  return lathe() && is(Dialect::fanuc) && !word.string && word.value == 0;
}

// T0100 of FANUC's lathes behind the cuts of tool 1 ends its offset: what follows is about the next
// tool.
bool ToolChanger::leaves_tool(const Word& word) {
  return lathe() && is(Dialect::fanuc) && !word.string && word.value >= 100 &&
         std::fmod(word.value, 100) == 0 && tool_.chosen && id_of(word) == tool_.current &&
         notes_.cuts_since_change();
}

// The tool of the table or of the comments that is in the spindle: "1", or "1 (line 11)".
std::string ToolChanger::data_id() {
  std::string id = edges_.id_at_edge(), called = notes_.tool_of(tool_.current);
  if (id != tool_.current) return id;
  if (called != id && given(called) == nullptr && given(id) != nullptr) {
    reporter_.once_at(
        Severity::warning, "tool-contradicts",
        fmt::format(
            "the comment \"{}\" at this call names another tool than at an earlier one, and "
            "the one that is given for {} cuts here, too: give \"{}\" as well, or another "
            "number to one of them",
            notes_.find(id)->text, id, called),
        tool_.place, called);
    return id;
  }
  tool_.shown = called;
  return called;
}

// Tells what comments at later calls of one number say.
void ToolChanger::hear_news(const Word& where) {
  if (notes_.take_brought()) {
    tool_.index = -1;
    tool_.failed = false;
  }
  if (const std::string other = notes_.other_numbered(); !other.empty())
    reporter_.add(Severity::error, "tool-unknown",
                  fmt::format("the comment \"{}\" names another tool than the one that cuts here, "
                              "and no T word says that it comes: write one, with M6, in front of "
                              "its first cut, or give it a number of its own",
                              other),
                  where.column, where.length);
  if (const std::string kind = notes_.other_kind(); !kind.empty())
    reporter_.add_at(Severity::warning, "tool-contradicts",
                     fmt::format("{}, and does not describe one: the same tool {} cuts here as "
                                 "before; where it is another, write its kind and size at its call",
                                 kind, tool_.current),
                     tool_.place);
}

// T0101.1 of Mazak's lathes: the digits behind the point tell the tools of one station apart.
// False: an error was reported.
bool ToolChanger::suffix(const Word& word) {
  if (!lathe() || !is(Dialect::fanuc))
    return error("value-range",
                 fmt::format("T is a whole number or a name; on Mazak the digits behind the point "
                             "are a tool's suffix: write T{:g}",
                             std::floor(word.value)),
                 word);
  const std::string text = text_of(word), id = id_of(word);
  const auto [at, first] = suffixes_.emplace(id, word.value);
  if (!first && at->second != word.value)
    return error("value-range",
                 fmt::format("{} is a second tool {}, told apart by the digits behind the point, "
                             "which are not read: give it a number of its own",
                             text, id),
                 word);
  note_once("tool-station",
            fmt::format("{} is read as tool {}: on Mazak the digits behind the point are a suffix",
                        text, id),
            word, text);
  return true;
}

}  // namespace mrsim
