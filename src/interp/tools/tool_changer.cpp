#include "interp/tools/tool_changer.h"

#include "core/text_io.h"
#include "core/units.h"
#include "interp/comments/form_outline.h"
#include "interp/comments/turret_name.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

std::size_t digits_of(std::string_view text) {
  return std::size_t(std::count_if(text.begin(), text.end(), is_digit));
}

// "LAMA 3MM": one number, of a few mm.
bool tells_blade_width(std::string_view comment) {
  constexpr double kThinnest = 1, kWidest = 6;  // mm
  const std::size_t first = comment.find_first_of("0123456789");
  if (first == comment.npos) return false;
  const std::size_t end = std::min(comment.find_first_not_of("0123456789.", first), comment.size());
  const std::optional<double> width = parse_number(comment.substr(first, end - first));
  std::string_view unit = comment.substr(end);
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  const bool mm = unit.starts_with("MM") || unit.starts_with("mm");
  return mm && width && *width >= kThinnest && *width <= kWidest && digits_of(unit) == 0;
}

// Words for --tool with what is known of the tool already.
std::string example_of(const Tool& read, bool lathe) {
  if (read.type == ToolType::grooving && lathe)
    return "grooving:w=3 (with tip=7 the blade stands along Z, its middle the point)";
  if (read.type == ToolType::tslot && read.diameter > 0)
    return fmt::format("tslot:d={:.6g},w=4 (w: the height of its head)", read.diameter);
  if (read.type == ToolType::taper && read.diameter > 0 && read.taper_angle > 0)
    return fmt::format("taper:d={:.6g},r={:.6g},a={:.6g},l=20 (l: its flutes)", read.diameter,
                       read.corner_radius, degrees(read.taper_angle));
  const auto known = [](double value, double otherwise) { return value > 0 ? value : otherwise; };
  if (read.type == ToolType::chamfer)
    return fmt::format("chamfer:d={:.6g},tip_angle={:.6g},t={:.6g} (t: its tip)",
                       known(read.diameter, 6),
                       degrees(known(read.tip_angle, known(2 * read.taper_angle, radians(60)))),
                       known(read.tip_diameter, 0.2));
  if (read.type == ToolType::drill) return fmt::format("drill:d={:.6g}", known(read.diameter, 10));
  if (read.type == ToolType::ballmill)
    return fmt::format("ballmill:d={:.6g}", known(read.diameter, 10));
  if (read.type == ToolType::bullmill)
    return fmt::format("bullmill:d={:.6g},r={:.6g} (r: its corner)", known(read.diameter, 10),
                       known(read.corner_radius, 1));
  return lathe ? "turning:insert=CNMG,r=0.8"
               : fmt::format("endmill:d={:.6g}", known(read.diameter, 10));
}

}  // namespace

ToolChanger::ToolChanger(Control& control)
    : ControlPart(control), tool_(control.tool), notes_(lathe(), turret_digits()) {
  const std::vector<Tool>& tools = options_.table.tools;
  for (std::size_t i = 0; i < tools.size(); ++i) given_.emplace(tools[i].id, i);
}

const Tool* ToolChanger::given(const std::string& id) const {
  const auto at = given_.find(id);
  return at == given_.end() ? nullptr : &options_.table.tools[at->second];
}

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
  const std::string whole = fmt::format("{}", number);
  if (digits >= turret_digits() && given(whole) != nullptr) return whole;
  const bool thrice = digits == 6 && number == station * 10101;
  if ((digits == 6 || digits == 8) && offset != 0 && offset != station && !thrice)
    note_once("tool-station",
              fmt::format("{} is read as tool {} with offset {}: half of the digits for each", text,
                          station, offset),
              word, text);
  return fmt::format("{}", station);
}

// Digits from which on a T word names a station and an offset; 0: it never does.
std::size_t ToolChanger::turret_digits() const {
  if (!lathe()) return 0;
  return is(Dialect::fanuc) ? 3 : is(Dialect::ngc) ? 4 : 0;
}

// T0101 is tool 1 with offset 1 in Mach; LinuxCNC would look for tool 101.
std::string ToolChanger::mach_station(long number, std::size_t digits, const std::string& text,
                                      const Word& word) {
  const std::string whole = fmt::format("{}", number);
  if (digits != turret_digits() || number < 100 || given(whole) != nullptr) return whole;
  note_once("tool-station",
            fmt::format("{} is read as tool {} with offset {}, as Mach does; if it is tool {}, "
                        "give that with --tool {}=..",
                        text, number / 100, number % 100, number, number),
            word, text);
  return fmt::format("{}", number / 100);
}

void ToolChanger::use(Tool tool) {
  tool_.index = static_cast<int>(program_.tools.size());
  used_.emplace(tool.id, tool_.index);
  program_.tools.push_back(std::move(tool));
}

void ToolChanger::read_comments() {
  const Word* t = peek('T');
  std::string called;
  if (t != nullptr)
    called = id_of(*t);
  else if (!block_.words.empty() && tool_.pending.active)
    called = tool_.pending.id;
  for (const std::string_view comment : block_.comments)
    notes_.comment(comment, called, block_.words.empty(), block_.name.starts_with("NAT"));
  if (const std::string other = notes_.other_nameless(); !other.empty())
    reporter_.add(Severity::error, "tool-unknown",
                  fmt::format("the comment \"{}\" names another tool than the first, and no T word "
                              "says that it comes: write one, with M6, or split the program",
                              other),
                  0, 1);
}

// T0 and T0000 of FANUC's lathes end the offset in force; the turret stays where it is.
bool ToolChanger::cancels_offset(const Word& word) {
  return lathe() && is(Dialect::fanuc) && !word.string && word.value == 0;
}

bool ToolChanger::apply() {
  if (is(Dialect::codesys) && is_circular(current_motion()) &&
      (peek('I') || peek('J') || peek('K') || block_.motion_code))
    return true;  // the opening angle
  const Word* word = block_.set_tool ? block_.set_tool : take('T');
  if (word && cancels_offset(*word)) return true;
  if (word || block_.tool_change) control_.saved_tool = tool_;
  if (word) {
    if (!select(*word)) return false;
    if (block_.tool_change) tool_.direct_change = false;  // M6
    if (lathe() || is(Dialect::codesys) || tool_.direct_change) block_.tool_change = true;
  }
  if (block_.tool_change && tool_.pending.active) {
    change();
    if (word) compare_offset(*word);
    if (is(Dialect::sinumerik) && !peek('D')) modal_.edge = 1;
  }
  if (!word) return true;
  // A second T beside M6 makes the next tool ready.
  for (const Word& next : block_.words)
    if (next.address == letter('T') && &next != word && !select(next)) return false;
  return true;
}

// T0101.1 of Mazak's lathes: the digits behind the point tell tools of one station apart. False: an
// error was reported.
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

bool ToolChanger::select(const Word& word) {
  if (!word.string && (word.value < 0 || word.value > 1e8))
    return error("value-range", "T is a whole number or a name", word);
  if (!word.string && word.value != std::floor(word.value) && !suffix(word)) return false;
  tool_.written = word.string ? -1 : word.value;
  tool_.pending.active = true;
  tool_.pending.id = id_of(word);
  tool_.pending.at.file = block_.file;
  tool_.pending.at.line = block_.line_number;
  tool_.pending.at.column = word.column + 1;
  tool_.pending.at.call = block_.call;
  notes_.call(tool_.pending.id);
  return true;
}

void ToolChanger::change() {
  if (tool_.chosen && tool_.current != tool_.pending.id) position_.new_tool = true;
  if (tool_.current != tool_.pending.id) tool_.below = false;
  tool_.current = tool_.pending.id;
  tool_.place = tool_.pending.at;
  tool_.pending.active = false;
  tool_.chosen = true;
  tool_.index = -1;
  tool_.failed = false;
  notes_.change(tool_.current);
}

// ".250 BALL EM" where no G word says inches: of a shop whose control wakes up in them?
bool ToolChanger::of_unknown_unit(const ToolHint& hint) const {
  constexpr double kSmall = 1;  // in mm rare, in inches usual
  if (modal_.units_given || is(Dialect::sinumerik) || is(Dialect::codesys)) return false;
  if (hint.diameters.empty() || hint.diameter >= kSmall) return false;
  return hint.diameters.front().unit == 0 && !hint.diameters.front().fraction;
}

// '; T="ROUGHER_80" D1' says no more than the name.
bool ToolChanger::repeats_name(const std::string& comment, const std::string& id) const {
  const std::size_t at = comment.find(id);
  if (!lathe() || at == comment.npos || id.find_first_not_of("0123456789") == id.npos) return false;
  const std::string rest = comment.substr(0, at) + comment.substr(at + id.size());
  return std::count_if(rest.begin(), rest.end(), is_digit) <= 1;
}

// From what comments say of it, else from its name. False and a reason where they do not suffice;
// no reason: nothing is said. `said`: a warning where the tool's shape is not all there.
bool ToolChanger::infer(const std::string& id, Tool& out, std::string& why, Severity& said) const {
  if (const ToolHint* hint = notes_.find(id)) {
    if (hint->plain_teeth()) said = Severity::warning;
    if (fill_tool(*hint, scale(), lathe(), out, why)) {
      const bool number = !id.empty() && hint->gauge == id;  // "#7 DRILL" beside T7
      if (!number && !of_unknown_unit(*hint)) return true;
      why = number ? fmt::format("names drill {0}, or tool {0}", id)
                   : fmt::format(
                         "gives the diameter {:g} without a unit, in a program without G20 "
                         "and G21",
                         hint->diameter);
    }
    why = fmt::format("the comment \"{}\" {}", hint->text, why);
    if (!repeats_name(hint->text, id)) return false;
  }
  std::string name = id;  // "ENDMILL_D10"; "PLUNGE_CUTTER_3" of a lathe is a tool, not its work
  std::replace(name.begin(), name.end(), '_', ' ');
  if (lathe()) name = spelled_turret_name(id);
  if (!lathe() && name.starts_with("CUTTER")) name.replace(0, 6, "END MILL");  // of ShopMill
  ToolHint hint = read_tool_comment(name);
  if (lathe() && !hint.type && hint.inside) hint.type = ToolType::boring;  // "ID_ROUGH"
  hint.text = id;
  std::string ignored;
  if (!hint.type || !fill_tool(hint, scale(), lathe(), out, ignored)) {
    if (why.empty() && lathe() && hint.type == ToolType::grooving)  // no insert that turns
      why = fmt::format("its name \"{}\" {}", id, ignored);
    return false;
  }
  why.clear();
  if (hint.plain_teeth()) said = Severity::warning;
  out.origin.replace(0, out.origin.find(' '), "its name");
  return true;
}

// The data of a tool, and where they came from. False when there are none.
bool ToolChanger::resolve(const std::string& id, Tool& out, std::string& why,
                          Severity& said) const {
  if (const Tool* known = given(id)) {
    out = *known;
    return true;
  }
  if (infer(id, out, why, said)) return true;
  if (const Tool* any = given("")) {
    out = *any;
    out.origin = fmt::format("{}, given for the program as a whole", any->origin);
    return true;
  }
  if (!lathe() || !why.empty()) return false;
  out = {};
  if (const std::string comment = notes_.not_understood(id); tells_blade_width(comment)) {
    out.type = ToolType::grooving;
    why = fmt::format("the comment \"{}\" tells a width as blades have, and no kind of tool",
                      comment);
    return false;
  }
  out.type = ToolType::turning;
  out.origin = fmt::format(
      "{} a sharp 35 degree finishing insert, lead angle 93 degrees, edge 16 mm", kNoToolData);
  complete_turning_tool(out);
  return true;
}

// Posts for machines without a tool changer (Grbl) name the tool in a comment alone.
void ToolChanger::take_commented(const Word& where) {
  const std::string id = notes_.only();
  if (id.empty()) {
    notes_.adopt_nameless();
    return;
  }
  tool_.pending.id = id;
  tool_.pending.at.file = block_.file;
  tool_.pending.at.line = block_.line_number;
  tool_.pending.at.column = where.column + 1;
  tool_.pending.at.call = block_.call;
  change();
}

void ToolChanger::require(const Word& where, bool cuts) {
  if (cuts) notes_.cut();
  if (tool_.index >= 0 || tool_.failed) return;
  if (!tool_.chosen && tool_.pending.active && cuts) {
    reporter_.once_at(
        Severity::note, "tool-not-changed",
        fmt::format("T{} is used without M6: it is taken to be in the spindle", tool_.pending.id),
        tool_.pending.at, "m6");
    change();
    tool_.direct_change = true;  // and so are those after it, until an M6 comes
  }
  if (!tool_.chosen && cuts && !given("")) take_commented(where);
  const std::string id = id_at_edge();
  if (const auto known = used_.find(id); known != used_.end()) {
    tool_.index = known->second;
    return compare_edge(where);
  }
  Tool tool;
  std::string why;
  if (!tool_.chosen && !cuts) return;
  Severity said = Severity::note;
  if (!resolve(id, tool, why, said)) {
    if (cuts) missing(where, why, tool);
    return;
  }
  tool.id = id;
  use(tool);
  compare_edge(where);
  compare_nose(tool, where);
  if (given(id)) return;
  const std::string text =
      fmt::format("tool {}: {} ({})", tool_.current.empty() ? "(none named)" : tool_.current,
                  tool_summary(tool), tool.origin);
  if (tool_.chosen)
    reporter_.add_at(said, "tool-inferred", text, tool_.place);
  else
    reporter_.add(said, "tool-inferred", text, where);
}

// `read`: what the comments do say of it.
void ToolChanger::missing(const Word& where, const std::string& why, const Tool& read) {
  tool_.failed = true;
  if (!tool_.chosen) {
    const Severity severity = options_.require_tools ? Severity::error : Severity::warning;
    reporter_.add(severity, "tool-unknown",
                  fmt::format("the program names no tool{}: give one with --tool endmill:d=10, or "
                              "--tools",
                              why.empty() ? "" : ", and " + why),
                  where.column, where.length);
    return;
  }
  Tool unknown;  // so that traces can name it; the error stops everything else
  unknown.id = tool_.current;
  unknown.origin = "no data";
  use(std::move(unknown));
  const std::string comment = notes_.not_understood(tool_.current);
  const std::string none = comment.empty()
                               ? "there are no data for it"
                               : fmt::format("no tool is known in its comment \"{}\"", comment);
  std::string spec = fmt::format("{}={}", tool_.current, example_of(read, lathe()));
  if (tool_.current.find(' ') != std::string::npos) spec = '"' + spec + '"';  // for the shell
  const ToolHint* hint = notes_.find(tool_.current);
  const std::string outline = hint ? outline_example(*hint, scale()) : std::string();
  const std::string remedy =
      read.type == ToolType::form
          ? fmt::format("give its profile (type = \"form\") with --tools tools.toml{}{}",
                        outline.empty() ? "" : ": ", outline)
          : fmt::format("give --tool {} or --tools tools.toml", spec);
  reporter_.add_at(
      Severity::error, "tool-unknown",
      fmt::format("tool {} cuts, but {}: {}", tool_.current, why.empty() ? none : why, remedy),
      tool_.place);
}

std::string tool_summary(const Tool& tool) {
  static constexpr const char* kNames[] = {
      "end mill",     "ball mill",     "bull-nose mill", "chamfer mill",  "tapered mill",
      "drill",        "T-slot mill",   "lollipop mill",  "barrel mill",   "form mill",
      "turning tool", "grooving tool", "boring bar",     "threading tool"};
  std::string text = kNames[static_cast<std::size_t>(tool.type)];
  if (tool.diameter > 0) text += fmt::format(" {:g} mm", tool.diameter);
  if (tool.corner_radius > 0) text += fmt::format(", corner radius {:g} mm", tool.corner_radius);
  if (tool.tip_angle > 0) text += fmt::format(", point {:.4g} degrees", degrees(tool.tip_angle));
  if (tool.taper_angle > 0)
    text += fmt::format(", {:.4g} degrees a side", degrees(tool.taper_angle));
  if (tool.tip_diameter > 0) text += fmt::format(", tip {:.4g} mm", tool.tip_diameter);
  if (tool.type == ToolType::tslot) text += fmt::format(", head {:.4g} mm", tool.width);
  return text;
}

}  // namespace mrsim
