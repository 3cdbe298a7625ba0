#include "interp/tool_comment.h"

#include "core/text_io.h"
#include "core/units.h"
#include "interp/characters.h"

#include <algorithm>
#include <utility>

namespace mrsim {
namespace {

struct Keyword {
  std::string_view text;
  ToolType type;
};

// Slovenian, English, German, Spanish; '~' stands for any character outside of ASCII. The first hit
// counts, so the particular stands before the general.
constexpr Keyword kKeywords[] = {
    {"BORING BAR", ToolType::boring},     {"GROOV", ToolType::grooving},
    {"PARTING", ToolType::grooving},      {"CUTOFF", ToolType::grooving},
    {"CUT OFF", ToolType::grooving},      {"STECHSTAHL", ToolType::grooving},
    {"RANURAR", ToolType::grooving},      {"THREADING", ToolType::threading},
    {"GEWINDEDREH", ToolType::threading}, {"TURNING", ToolType::turning},
    {"TURN TOOL", ToolType::turning},     {"LATHE TOOL", ToolType::turning},
    {"DREHMEI", ToolType::turning},       {"DREHSTAHL", ToolType::turning},
    {"SCHLICHTSTAHL", ToolType::turning}, {"STRU~", ToolType::turning},
    {"STRUZ", ToolType::turning},         {"CUCHILLA", ToolType::turning},
    {"CNMG", ToolType::turning},          {"DNMG", ToolType::turning},
    {"VNMG", ToolType::turning},          {"WNMG", ToolType::turning},
    {"TNMG", ToolType::turning},          {"CCMT", ToolType::turning},
    {"DCMT", ToolType::turning},          {"VCMT", ToolType::turning},
    {"VBMT", ToolType::turning},          {"SLOT DRILL", ToolType::endmill},
    {"LOLLIPOP", ToolType::lollipop},     {"BARREL", ToolType::barrel},
    {"T-SLOT", ToolType::tslot},          {"T SLOT", ToolType::tslot},
    {"TSLOT", ToolType::tslot},           {"BALL", ToolType::ballmill},
    {"KUGEL", ToolType::ballmill},        {"KROGL", ToolType::ballmill},
    {"ESFERIC", ToolType::ballmill},      {"BULL", ToolType::bullmill},
    {"TORUS", ToolType::bullmill},        {"CHAMFER", ToolType::chamfer},
    {"FASENFR", ToolType::chamfer},       {"TAPERED MILL", ToolType::taper},
    {"DRILL", ToolType::drill},           {"BOHRER", ToolType::drill},
    {"SVEDER", ToolType::drill},          {"BROCA", ToolType::drill},
    {"END MILL", ToolType::endmill},      {"ENDMILL", ToolType::endmill},
    {"FLAT END", ToolType::endmill},      {"FLAT MILL", ToolType::endmill},
    {"FACE MILL", ToolType::endmill},     {"SQUARE MILL", ToolType::endmill},
    {"FREZALO", ToolType::endmill},       {"STEBLAST", ToolType::endmill},
    {"SCHAFTFR", ToolType::endmill},      {"FRAESER", ToolType::endmill},
    {"FR~SER", ToolType::endmill},        {"FRESA", ToolType::endmill}};

// The Slovenian word for a cutter of a lathe is short, so it must stand alone.
constexpr std::string_view kTurningWords[] = {"NO~", "NOZ"};

// Upper case, one '~' for each character outside of ASCII.
std::string folded(std::string_view utf8) {
  std::string out;
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) out += upper(c);
    if (byte >= 0xC0) out += '~';
  }
  return out;
}

struct Scanner {
  std::string_view text;
  std::size_t at = 0;
  void blanks() {
    while (at < text.size() && (text[at] == ' ' || text[at] == '=' || text[at] == ':')) ++at;
  }
};

// The number at `at`, after blanks and "="; nothing when there is none.
std::optional<double> number_at(std::string_view text, std::size_t at, std::size_t* end = nullptr) {
  Scanner s{text, at};
  s.blanks();
  std::size_t stop = s.at;
  while (stop < text.size() && (is_digit(text[stop]) || text[stop] == '.' || text[stop] == ','))
    ++stop;
  std::string digits(text.substr(s.at, std::min<std::size_t>(stop - s.at, 20)));
  if (!digits.empty() && (digits.back() == ',')) digits.pop_back();
  std::replace(digits.begin(), digits.end(), ',', '.');
  if (end) *end = stop;
  const std::optional<double> value = parse_number(digits);
  return value && *value > 0 && *value < 1e6 ? value : std::nullopt;
}

bool word_starts(std::string_view text, std::size_t at) {
  return at == 0 || !(is_name(text[at - 1]) || text[at - 1] == '~');
}

// The number after the stand-alone word `name`.
std::optional<double> value_after(std::string_view text, std::string_view name) {
  for (std::size_t i = text.find(name); i != std::string_view::npos; i = text.find(name, i + 1)) {
    if (!word_starts(text, i)) continue;
    std::size_t next = i + name.size();
    if (next < text.size() && is_letter(text[next])) continue;
    if (next < text.size() && text[next] == '.' && next + 1 < text.size() &&
        !is_digit(text[next + 1]))
      ++next;  // "DIA. 5"
    if (const auto value = number_at(text, next)) return value;
  }
  return std::nullopt;
}

// Ø in whatever encoding: a character outside of ASCII, not inside a word, before a number.
std::optional<double> after_diameter_sign(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '~' || !word_starts(text, i)) continue;
    if (const auto value = number_at(text, i + 1)) return value;
  }
  return std::nullopt;
}

// "5 MM", "5MM".
std::optional<double> before_mm(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_digit(text[i]) || !word_starts(text, i) || (i > 0 && text[i - 1] == '.')) continue;
    std::size_t end = i;
    const auto value = number_at(text, i, &end);
    while (end < text.size() && text[end] == ' ') ++end;
    if (value && text.substr(end, 2) == "MM") return value;
    i = end;
  }
  return std::nullopt;
}

std::optional<ToolType> find_type(std::string_view text) {
  for (const Keyword& keyword : kKeywords)
    if (text.find(keyword.text) != std::string_view::npos) return keyword.type;
  for (const std::string_view word : kTurningWords) {
    const std::size_t i = text.find(word);
    if (i == std::string_view::npos || !word_starts(text, i)) continue;
    const std::size_t end = i + word.size();
    if (end == text.size() || !is_name(text[end])) return ToolType::turning;
  }
  return std::nullopt;
}

// "T12 ..." or "TOOL 12 ..." at the head.
void find_id(std::string_view text, ToolHint& hint) {
  std::size_t i = text.find_first_not_of(' ');
  if (i == std::string_view::npos) return;
  text.remove_prefix(i);
  const bool tool = text.starts_with("TOOL ");
  if (!tool && !text.starts_with("T")) return;
  i = tool ? 5 : 1;
  if (i < text.size() && tool && text[i] == 'T') ++i;
  std::size_t end = i;
  while (end < text.size() && is_digit(text[end])) ++end;
  if (end == i || end - i > 8 || (end < text.size() && (text[end] == '.' || is_letter(text[end]))))
    return;
  while (i + 1 < end && text[i] == '0') ++i;
  hint.id = std::string(text.substr(i, end - i));
}

// Makera: "@MKR|TOOL|number=1|type=Flat End|diameter=3.175".
bool read_key_values(std::string_view text, ToolHint& hint) {
  if (text.find("@MKR|TOOL|") == std::string_view::npos) return false;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t bar = std::min(text.find('|', from), text.size());
    const std::string_view field = text.substr(from, bar - from);
    from = bar + 1;
    const std::size_t equal = field.find('=');
    if (equal == std::string_view::npos) continue;
    const std::string_view key = field.substr(0, equal), value = field.substr(equal + 1);
    const std::optional<double> number = number_at(value, 0);
    if (key == "NUMBER" || key == "ID") hint.id = std::string(value);
    if (key == "TYPE") hint.type = find_type(value);
    if (number && (key == "DIAMETER" || key == "DIA" || key == "D")) hint.diameter = *number;
    if (number && key.find("CORNER") != std::string_view::npos) hint.corner_radius = *number;
  }
  return true;
}

}  // namespace

ToolHint read_tool_comment(std::string_view bytes) {
  ToolHint hint;
  if (bytes.size() > 400) bytes = bytes.substr(0, 400);
  hint.text = to_utf8(bytes);
  while (!hint.text.empty() && hint.text.front() == ' ') hint.text.erase(0, 1);
  while (!hint.text.empty() && hint.text.back() == ' ') hint.text.pop_back();
  const std::string text = folded(hint.text);
  if (read_key_values(text, hint)) return hint;
  find_id(text, hint);
  hint.type = find_type(text);
  auto diameter = after_diameter_sign(text);
  if (!diameter) diameter = value_after(text, "DIA");
  if (!diameter) diameter = value_after(text, "DIAMETER");
  const bool assigned = text.find("D=") != std::string::npos;
  if (!diameter && (hint.type || assigned)) diameter = value_after(text, "D");
  if (!diameter && hint.type && !is_turning(*hint.type)) diameter = before_mm(text);
  if (diameter) hint.diameter = *diameter;
  if (const auto corner = value_after(text, "CR")) hint.corner_radius = *corner;
  if (const auto taper = value_after(text, "TAPER")) hint.taper_angle = radians(*taper);
  if (hint.type && is_turning(*hint.type))
    if (const auto nose = value_after(text, "R")) hint.nose_radius = *nose;
  if (hint.type == ToolType::endmill && hint.corner_radius > 0) hint.type = ToolType::bullmill;
  return hint;
}

void complete_turning_tool(Tool& tool) {
  if (tool.insert.empty() && tool.insert_angle == 0) tool.insert_angle = radians(35);
  if (tool.lead_angle == 0) tool.lead_angle = radians(93);
  if (tool.edge_length == 0) tool.edge_length = 16;
}

}  // namespace mrsim
