// What the variables tell a LoopWatch.
#include "core/text/text_io.h"
#include "interp/language/variables.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kMostElementsCompared = 64;

std::optional<std::string> text_of(const std::vector<Value>& elements) {
  if (elements.size() > kMostElementsCompared) return std::nullopt;
  std::string out;
  for (const Value& value : elements) {
    if (value.kind == Value::Kind::frame) return std::nullopt;
    out += fmt::format("{}:{}:{} ", static_cast<int>(value.kind), value.number, value.text);
  }
  return out;
}

}  // namespace

VariableKey Variables::watch_key(double number) const {
  VariableKey key;
  key.level = is_local(number) ? levels_.size() : 0;
  key.number = number;
  return key;
}

VariableKey Variables::watch_key(std::string_view name) const {
  VariableKey key;
  key.name = this->key(name);
  const bool global = form_ == VariableForm::linuxcnc && name[0] == '_';
  key.level = !global && levels_.back()->names.contains(key.name) ? levels_.size() : 0;
  return key;
}

void Variables::watch_read(double number) const {
  if (is_system(number)) return watch_->read_state();
  watch_->read(watch_key(number));
}

// A name that is not there may be one of the control, or be set later.
void Variables::watch_read(std::string_view name) const {
  const VariableKey key = watch_key(name);
  if (key.level == 0 && !globals_.contains(key.name)) return watch_->read_state();
  watch_->read(key);
}

void Variables::watch_write(double number) const { watch_write(watch_key(number)); }

void Variables::watch_write(std::string_view name) const { watch_write(watch_key(name)); }

void Variables::watch_write(const VariableKey& key) const {
  watch_->write(key, watch_->knows_change_of(key) ? "" : state_of(key));
}

std::optional<std::string> Variables::state_of(const VariableKey& key) const {
  const Level* const level = key.level > 0 ? levels_[key.level - 1].get() : nullptr;
  if (!key.name.empty()) {
    const Names& names = level ? level->names : globals_;
    const auto at = names.find(key.name);
    return at == names.end() ? std::nullopt : text_of(at->second.elements);
  }
  const auto n = static_cast<std::size_t>(folded_number(key.number));
  if (!level && n >= common_.size()) return std::nullopt;
  const Cell& cell = level ? level->cells[n] : common_[n];
  return fmt::format("{}:{}", static_cast<int>(cell.state), cell.number);
}

std::string Variables::names_of(const std::set<VariableKey>& keys) const {
  constexpr std::size_t kMost = 4;
  std::string out;
  std::size_t n = 0;
  for (const VariableKey& key : keys) {
    if (n++ == kMost) return out + ", ...";
    const std::string name = key.name.empty() ? name_of(key.number)
                             : form_ == VariableForm::linuxcnc
                                 ? fmt::format("#<{}>", to_utf8(key.name))
                                 : to_utf8(key.name);
    out += fmt::format("{}{}", out.empty() ? "" : ", ", name);
  }
  return out;
}

}  // namespace mrsim
