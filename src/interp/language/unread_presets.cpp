// Variables that have a value before the program starts, and whether it reads them.

#include "core/text_io.h"
#include "interp/language/variables.h"
#include "interp/text/characters.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {

bool Variables::preset_number(std::string_view given, double number, const Value& value,
                              std::string& why) {
  if (!assign(number, value, why)) return false;
  if (!is_system(number)) unread_.push_back({std::string(given), number, nullptr, false});
  return true;
}

bool Variables::preset_name(std::string_view given, std::string_view name, const Value& value,
                            std::string& why) {
  if (!assign(name, {}, value, why)) return false;
  if (const Array* const variable = find(name))
    unread_.push_back({std::string(given), -1, variable, false});
  return true;
}

bool Variables::preset(std::string_view name, const Value& value, std::string& why) {
  if (name.empty()) return false;
  if (form_ == VariableForm::fanuc && is_common(name))
    return define(name, VariableType::real, {}, true, why) && preset_name(name, name, value, why);
  const bool hash = name.starts_with('#');
  const bool numbers = form_ == VariableForm::linuxcnc || form_ == VariableForm::fanuc;
  const std::string_view rest = name.substr(hash ? 1 : 0);
  const bool r = !hash && form_ == VariableForm::sinumerik && name.size() > 1 &&
                 upper(name[0]) == 'R' &&
                 name.find_first_not_of("0123456789", 1) == std::string_view::npos;
  const auto number = parse_number(r ? name.substr(1) : rest);
  why = fmt::format("{} is not a variable of this control", to_utf8(name.substr(0, 60)));
  if (r || (hash && number && numbers)) return preset_number(name, *number, value, why);
  if (form_ == VariableForm::fagor && upper(name[0]) == 'P')
    if (const auto parameter = parse_number(name.substr(1)); parameter)
      return preset_number(name, *parameter, value, why);
  if (form_ == VariableForm::codesys)
    return name.size() > 2 && name.front() == '$' && name.find('$', 1) == name.size() - 1 &&
           preset_name(name, name, value, why);
  if (hash && form_ == VariableForm::linuxcnc && rest.size() > 2 && rest.front() == '<' &&
      rest.back() == '>')
    return preset_name(name, rest.substr(1, rest.size() - 2), value, why);
  if (hash || form_ != VariableForm::sinumerik || number) return false;
  for (const char c : name)
    if (!is_name(c)) return false;
  const auto type = value.kind == Value::Kind::text ? VariableType::text : VariableType::real;
  return define(name, type, {}, true, why) && preset_name(name, name, value, why);
}

// A local number of a call is another one than that of the main program.
bool Variables::is_meant(const Unread& one, double number, const Array* named) const {
  if (named != nullptr || one.named != nullptr) return one.named == named;
  return one.number == number && (levels_.size() == 1 || !is_local(number));
}

void Variables::note_read(double number, const Array* named) {
  std::erase_if(
      unread_, [&](const Unread& one) { return !one.is_replaced && is_meant(one, number, named); });
}

void Variables::note_replaced(double number, const Array* named) {
  for (Unread& one : unread_)
    if (is_meant(one, number, named)) one.is_replaced = true;
}

}  // namespace mrsim
