#include "interp/language/variables.h"

#include "core/text/text_io.h"
#include "interp/language/operations.h"
#include "interp/text/characters.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kMostR = 32536;
constexpr int kLinuxcncLast = 5602, kLinuxcncSystem = 5001, kLinuxcncLocals = 30;
constexpr int kFanucLast = 1000, kFanucLocals = 33;
// More common variables of FANUC's 30i. Their cells follow that of #999.
constexpr int kFanucMore[][2] = {{98000, 98499}, {900000, 907399}};
constexpr int kFagorLast = 2256, kFagorLocals = 25;

int locals_of(VariableForm form) {
  return form == VariableForm::linuxcnc ? kLinuxcncLocals
         : form == VariableForm::fanuc  ? kFanucLocals
         : form == VariableForm::fagor  ? kFagorLocals
                                        : -1;
}

// How many cells a control has: one more than the highest number.
int count_of(VariableForm form) {
  switch (form) {
    case VariableForm::linuxcnc:
      return kLinuxcncLast;
    case VariableForm::fanuc:
      return kFanucLast;
    case VariableForm::sinumerik:
      return kMostR;
    case VariableForm::fagor:
      return kFagorLast;
    default:
      return 0;
  }
}

std::string shown(VariableForm form, double number) {
  const char* letter = form == VariableForm::sinumerik ? "R"
                       : form == VariableForm::fagor   ? "P"
                                                       : "#";
  return fmt::format("{}{:.0f}", letter, number);
}

// The number of the cell of a variable, where the control has more common ones than #100 to #999.
double folded(VariableForm form, double number) {
  if (form != VariableForm::fanuc) return number;
  double behind = kFanucLast;
  for (const auto& [first, last] : kFanucMore) {
    if (number >= first && number <= last) return behind + number - first;
    behind += last - first + 1;
  }
  return number;
}

// The numbers between those of the control, in a sentence; empty: there are none, or `n` is not
// among them.
const char* gap(VariableForm form, std::size_t n) {
  if (form == VariableForm::fanuc && ((n > 33 && n < 100) || (n > 199 && n < 400)))
    return "#1-#33, #100-#199, #400-#999 and system variables from #1000";
  if (form == VariableForm::fagor &&
      ((n > 25 && n < 100) || (n > 299 && n < 1000) || (n > 1255 && n < 2000)))
    return "P0-P25, P100-P299, P1000-P1255, P2000-P2255";
  return "";
}

constexpr std::size_t kMostElements = 1'000'000;

}  // namespace

Variables::Variables(VariableForm form) : form_(form) {
  common_.resize(form == VariableForm::sinumerik ? 300U : static_cast<std::size_t>(count_of(form)));
  levels_.push_back(std::make_unique<Level>());
}

bool Variables::is_system(double number) const {
  if (form_ == VariableForm::linuxcnc) return number >= kLinuxcncSystem && number < kLinuxcncLast;
  return form_ == VariableForm::fanuc && number >= kFanucLast && folded(form_, number) == number;
}

double Variables::folded_number(double number) const { return folded(form_, number); }

std::string Variables::name_of(double number) const { return shown(form_, number); }

bool Variables::is_local(double number) const { return number <= locals_of(form_); }

bool Variables::is_local_of_call(double number) const {
  return levels_.size() > 1 && is_local(number);
}

void Variables::enter_level() {
  levels_.push_back(std::make_unique<Level>());
  if (form_ == VariableForm::fanuc)  // a variable that the call does not give is vacant
    for (Cell& cell : levels_.back()->cells) cell.state = State::vacant;
}

void Variables::leave_level() {
  for (const auto& [name, variable] : levels_.back()->names) elements_ -= variable.elements.size();
  levels_.pop_back();
}

// The cell of a number that is no system variable. Null: `why` may say why not.
Variables::Cell* Variables::cell(double number, std::string& why) {
  const double last = count_of(form_) - 1;
  const bool linuxcnc_zero = form_ == VariableForm::linuxcnc && number == 0;
  const double index = folded(form_, number);
  if (!(number >= 0 && (number <= last || index != number)) || linuxcnc_zero) {
    why = fmt::format("{} is no variable of this control: the numbers go from {} to {:.0f}",
                      shown(form_, number),
                      linuxcnc_zero || form_ == VariableForm::linuxcnc ? 1 : 0, last);
    return nullptr;
  }
  const auto n = static_cast<std::size_t>(index);
  if (is_local(index)) return &levels_.back()->cells[n];
  if (const std::string_view there = gap(form_, n); !there.empty()) {
    why =
        fmt::format("{} is no variable of this control: there are {}", shown(form_, number), there);
    return nullptr;
  }
  if (n >= common_.size()) common_.resize(n + 1);
  return &common_[n];
}

void Variables::answer(const Cell& cell, double number, Value& out) const {
  if (cell.state == State::number || form_ == VariableForm::linuxcnc) {
    out = Value::of(cell.number);  // 0 on LinuxCNC when it was never set
    if (cell.state == State::faulty) out.kind = Value::Kind::faulty;
    return;
  }
  out = Value::nothing(cell.state == State::unset);
  if (cell.state == State::faulty) out.kind = Value::Kind::faulty;
  if (!out.never_set) return;
  const std::string name = shown(form_, number);
  out.text = form_ == VariableForm::fanuc
                 ? fmt::format("{} was never set: assign it first, or say --set '{}=1'", name, name)
                 : fmt::format("{} was never set: assign it first, or say --set {}=1", name, name);
}

bool Variables::numbered(double number, Value& out, std::string& why) {
  if (is_watched()) watch_read(number);
  if (is_system(number)) {
    if (system_) return system_->read(number, out, why);
    why = fmt::format("the system variable {} is not answered here", shown(form_, number));
    return false;
  }
  if (form_ == VariableForm::fanuc && number == 0) {
    out = Value::nothing(false);
    return true;
  }
  const Cell* const at = cell(number, why);
  if (!at) return false;
  if (!unread_.empty()) unread_.note_read(number, nullptr, is_local_of_call(number));
  answer(*at, number, out);
  return true;
}

bool Variables::assign(double number, const Value& value, std::string& why) {
  if (is_system(number)) {
    if (system_) return system_->write(number, value, why);
    why = fmt::format("the system variable {} cannot be set here", shown(form_, number));
    return false;
  }
  if (form_ == VariableForm::fanuc && number == 0) {
    why = "#0 is always vacant: nothing can be assigned to it";
    return false;
  }
  Cell* const at = cell(number, why);
  if (!at) return false;
  if (is_watched()) watch_write(number);
  if (!unread_.empty()) unread_.note_replaced(number, nullptr, is_local_of_call(number));
  switch (value.kind) {
    case Value::Kind::number:
      *at = {value.number, State::number};
      return true;
    case Value::Kind::vacant:
      *at = {0, State::vacant};
      return true;
    case Value::Kind::faulty:
      *at = {0, State::faulty};
      return true;
    default:
      why = fmt::format("{} holds numbers only", shown(form_, number));
      return false;
  }
}

bool Variables::exists(double number) {
  if (form_ != VariableForm::linuxcnc) return false;
  return number >= 1 && number < kLinuxcncLast;
}

// Names are the same in upper and in lower case. They have no blanks.
std::string Variables::key(std::string_view name) const { return upper_case(name); }

Variables::Array* Variables::find(std::string_view name) {
  const std::string wanted = key(name);
  const bool global = form_ == VariableForm::linuxcnc && name[0] == '_';
  if (!global)
    if (const auto at = levels_.back()->names.find(wanted); at != levels_.back()->names.end())
      return &at->second;
  if (form_ == VariableForm::linuxcnc && !global) return nullptr;
  const auto at = globals_.find(wanted);
  return at == globals_.end() ? nullptr : &at->second;
}

bool Variables::exists(std::string_view name) {
  if (name.empty()) return false;
  if (is_watched()) watch_read(name);
  const Array* const variable = find(name);
  if (variable) unread_.note_read(-1, variable, false);
  return variable || (system_ && system_->knows(name));
}

bool Variables::named(std::string_view name, std::span<const Value> indices, Value& out,
                      std::string& why) {
  if (is_watched()) watch_read(name);
  if (Array* const variable = find(name)) {
    unread_.note_read(-1, variable, false);
    return variable->read(name, indices, out, why);
  }
  const bool plc = form_ == VariableForm::codesys;
  const bool dollar = name[0] == '$' && !plc;
  if (system_ && !plc && (dollar || system_->knows(name)))
    return system_->read(name, indices, out, why);
  const std::string text = to_utf8(name.substr(0, 60));
  const bool of_machine = name[0] == 'V' && !is_common(name);
  if (form_ == VariableForm::fanuc &&
      !of_machine) {  // a variable of Okuma that is not set is EMPTY
    out = Value::nothing(name != "EMPTY");
    if (out.never_set)
      out.text = fmt::format("{} was never set: assign it first{}", text,
                             is_common(name) ? fmt::format(", or say --set {}=1", text) : "");
    return true;
  }
  if (dollar)
    why = fmt::format("the system variable {} is not answered here", text);
  else if (plc && name[0] == '$')
    why = fmt::format("{} is a variable of the controller: G36 sets it, or say --set '{}=1'", text,
                      text);
  else if (plc)
    why = fmt::format("{} is not defined: LET it, or make it a formal of the subprogram", text);
  else if (form_ == VariableForm::fanuc)
    why = fmt::format("{} was never set: assign it first", text);
  else if (form_ == VariableForm::linuxcnc)
    why = fmt::format("#<{}> was never set: assign it first{}", text,
                      name[0] == '_' ? fmt::format(", or say --set '#<{}>=1'", text) : "");
  else
    why = fmt::format("{} is not defined (alarm 12550): DEF it, or say --set {}=1", text, text);
  return false;
}

bool Variables::assign(std::string_view name, std::span<const Value> indices, const Value& value,
                       std::string& why) {
  Array* variable = find(name);
  const bool plc = form_ == VariableForm::codesys;
  if (!variable && system_ && !plc && (name[0] == '$' || system_->knows(name)))
    return system_->write(name, indices, value, why);
  if (!variable && form_ == VariableForm::linuxcnc) {
    if (!define(name, VariableType::real, {}, name[0] == '_', why)) return false;
    variable = find(name);
  }
  if (!variable && plc && name[0] == '$') {
    const bool text = value.kind == Value::Kind::text;
    if (!define(name, text ? VariableType::text : VariableType::real, {}, true, why)) return false;
    variable = find(name);
  }
  if (!variable) {
    why = fmt::format("{} is not defined{}", to_utf8(name.substr(0, 60)),
                      plc ? ": LET it first" : " (alarm 12550): DEF it first");
    return false;
  }
  if (is_watched()) watch_write(name);
  unread_.note_replaced(-1, variable, false);
  return variable->write(name, indices, value, form_, why);
}

bool Variables::is_common(std::string_view name) {
  const std::size_t digits = name.size() > 1 && upper(name[1]) == 'C' ? 2 : 1;
  return name.size() > digits && upper(name[0]) == 'V' &&
         name.find_first_not_of("0123456789", digits) == name.npos;
}

bool Variables::define(std::string_view name, VariableType type, std::array<int, 3> dimensions,
                       bool global, std::string& why) {
  Names& names = global ? globals_ : levels_.back()->names;
  if (watch_) watch_->define(global ? 0 : levels_.size());
  std::size_t count = 1;
  for (const int size : dimensions) {
    if (size < 0 || static_cast<std::size_t>(size) > kMostElements) count = kMostElements + 1;
    if (size > 0 && count <= kMostElements) count *= static_cast<std::size_t>(size);
  }
  if (elements_ + count > kMostElements) {
    why = fmt::format("more than {} variables and elements of arrays", kMostElements);
    return false;
  }
  const auto [at, fresh] = names.try_emplace(key(name));
  if (!fresh && !global) {
    why = fmt::format("{} is defined twice (alarm 12170)", to_utf8(name.substr(0, 60)));
    return false;
  }
  elements_ += count - at->second.elements.size();
  at->second.type = type;
  at->second.dimensions = dimensions;
  const Value first = type == VariableType::frame ? Value::of_frame({})
                      : type == VariableType::text || type == VariableType::axis
                          ? Value::of_text({})
                          : Value::of(0);
  at->second.elements.assign(count, first);
  return true;
}

const Variables::Array* Variables::array(std::string_view name) {
  const Array* const found = find(name);
  if (found && is_watched()) watch_read(name);
  return found && found->dimensions[0] > 0 ? found : nullptr;
}

void Variables::set_array(std::string_view name, const Array& values) {
  if (Array* const found = find(name)) {
    if (is_watched()) watch_write(name);
    elements_ += values.elements.size() - found->elements.size();
    *found = values;
  }
}

bool Variables::fill(std::string_view name, std::span<const Value> indices,
                     std::span<const std::optional<Value>> values, std::size_t repeats,
                     std::string& why) {
  Array* const variable = find(name);
  std::size_t at = 0;
  if (!variable) {
    why = fmt::format("{} is not defined (alarm 12550)", to_utf8(name.substr(0, 60)));
    return false;
  }
  if (is_watched()) watch_write(name);
  if (!indices.empty() && !variable->place_of(name, indices, at, why)) return false;
  const std::size_t left = variable->elements.size() - at;
  const std::size_t count = repeats > 0 ? std::min(repeats, left) : values.size();
  if (count > left) {
    why = fmt::format("{} values for {} elements", count, left);
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<Value>& value = values[repeats > 0 ? 0 : i];
    if (value && !variable->store(at + i, *value, form_, why)) return false;
  }
  return true;
}

bool Variables::preset_number(std::string_view given, double number, const Value& value,
                              std::string& why) {
  if (!assign(number, value, why)) return false;
  if (!is_system(number)) unread_.add({std::string(given), number, nullptr, false});
  return true;
}

bool Variables::preset_name(std::string_view given, std::string_view name, const Value& value,
                            std::string& why) {
  if (!assign(name, {}, value, why)) return false;
  if (const Array* const variable = find(name))
    unread_.add({std::string(given), -1, variable, false});
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

}  // namespace mrsim
