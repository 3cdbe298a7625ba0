#include "interp/statements/sinumerik_text.h"

#include "interp/text/characters.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace mrsim {

std::optional<VariableType> type_named(const std::string& name) {
  static constexpr std::pair<std::string_view, VariableType> kTypes[] = {
      {"REAL", VariableType::real},    {"INT", VariableType::integer},
      {"BOOL", VariableType::boolean}, {"CHAR", VariableType::character},
      {"STRING", VariableType::text},  {"AXIS", VariableType::axis},
      {"FRAME", VariableType::frame}};
  for (const auto& [known, type] : kTypes)
    if (known == name) return type;
  return std::nullopt;
}

bool is_structure(std::string_view word) {
  static constexpr std::string_view kStructures[] = {"IF",       "ELSE",   "ENDIF",  "WHILE",
                                                     "ENDWHILE", "FOR",    "ENDFOR", "LOOP",
                                                     "ENDLOOP",  "REPEAT", "UNTIL"};
  return std::find(std::begin(kStructures), std::end(kStructures), word) != std::end(kStructures);
}

std::string word_at(std::string_view line, std::size_t& p) {
  p = behind_blanks(line, p);
  const std::size_t from = p;
  while (p < line.size() && is_name(line[p])) ++p;
  return upper_case(line.substr(from, std::min<std::size_t>(p - from, 64)));
}

std::string program_of_path(std::string_view path) {
  std::string name = upper_case(path.substr(path.find_last_of("/\\") + 1));
  if (name.starts_with("_N_")) name.erase(0, 3);
  for (const std::string_view kind : {"_SPF", "_MPF", ".SPF", ".MPF"})
    if (name.size() > kind.size() && name.ends_with(kind)) name.resize(name.size() - kind.size());
  return name;
}

}  // namespace mrsim
