// Where the variables of a program live: by number and by name, local to a call or common to all.
// Guarantees: the fault of a variable that was never set says how to set it; counts and sizes are
// bounded. Does not know the state of the control: SystemVariables gives the variables of that.
#pragma once

#include "interp/language/evaluator.h"
#include "interp/language/loop_watch.h"
#include "interp/language/unread_presets.h"
#include "interp/language/value.h"
#include "interp/language/variable_array.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// Variables that are the control's state: positions, offsets, tool data, modal codes.
class SystemVariables {
 public:
  virtual ~SystemVariables() = default;
  /// False: `why` names the variable and says that it is not read here.
  virtual bool read(double number, Value& out, std::string& why) = 0;
  virtual bool read(std::string_view name, std::span<const Value> indices, Value& out,
                    std::string& why) = 0;
  virtual bool write(double number, const Value& value, std::string& why) = 0;
  virtual bool write(std::string_view name, std::span<const Value> indices, const Value& value,
                     std::string& why) = 0;
  virtual bool knows(std::string_view name) = 0;
};

class Variables : public VariableReader {
 public:
  static constexpr int kLocals = 34;

  using Array = VariableArray;

  explicit Variables(VariableForm form);
  void set_system(SystemVariables* system) { system_ = system; }
  /// Tells `watch` of each variable that is read or set.
  void set_watch(LoopWatch* watch) { watch_ = watch; }
  /// What a variable holds, as text. Nothing: it is a large array, or a frame.
  std::optional<std::string> state_of(const VariableKey& key) const;
  /// The names of variables, the first ones: "#1, #<depth>".
  std::string names_of(const std::set<VariableKey>& keys) const;

  bool numbered(double number, Value& out, std::string& why) override;
  bool named(std::string_view name, std::span<const Value> indices, Value& out,
             std::string& why) override;
  bool exists(double number) override;
  bool exists(std::string_view name) override;

  /// Sets a variable. False: `why` says why it cannot have the value.
  bool assign(double number, const Value& value, std::string& why);
  bool assign(std::string_view name, std::span<const Value> indices, const Value& value,
              std::string& why);
  /// DEF defines a variable. A dimension that it does not have is 0. Its elements begin as 0, "" or
  /// the identity.
  bool define(std::string_view name, VariableType type, std::array<int, 3> dimensions, bool global,
              std::string& why);
  void limit_texts(std::string_view name, std::size_t longest) { find(name)->longest = longest; }
  /// Sets elements of a defined variable in order, from the element at `indices` on. For SET, a
  /// value that is left out leaves its element as it is. For REP, `repeats` elements get the first
  /// value.
  bool fill(std::string_view name, std::span<const Value> indices,
            std::span<const std::optional<Value>> values, std::size_t repeats, std::string& why);
  /// The array of a name; null: there is none.
  const Array* array(std::string_view name);
  /// Gives a defined variable type, size and elements of an array.
  void set_array(std::string_view name, const Array& values);
  bool is_defined(std::string_view name) { return find(name) != nullptr; }
  /// Whether the name is that of a variable of Okuma that all programs share, VC1 or V1.
  static bool is_common(std::string_view name);
  /// Sets a variable before the program starts: "R1", "#100", "#<_name>", "NAME". False: the
  /// control has no such variable.
  bool preset(std::string_view name, const Value& value, std::string& why);
  /// The variables of preset() that the program has not read, without those that are the control's
  /// state.
  const std::vector<UnreadPresets::Preset>& unread() const { return unread_.list(); }

  /// A call begins or ends, and with it its local variables. `arguments`: bit n says that local n
  /// is given; else it is vacant.
  void enter_level();
  void leave_level();
  std::size_t levels() const { return levels_.size(); }
  VariableForm form() const { return form_; }

 private:
  enum class State : unsigned char { unset, vacant, number, faulty };
  struct Cell {
    double number = 0;
    State state = State::unset;
  };

 public:
  /// Local variables of FANUC's macros, which another run of the same command gets back.
  using Locals = std::array<Cell, kLocals>;
  const Locals& locals() const { return levels_.back()->cells; }
  void set_locals(const Locals& locals) {
    if (watch_) watch_->forget();
    levels_.back()->cells = locals;
  }

 private:
  using Names = std::map<std::string, Array, std::less<>>;
  struct Level {
    Locals cells;
    Names names;
  };

  Cell* cell(double number, std::string& why);
  void answer(const Cell& cell, double number, Value& out) const;
  Array* find(std::string_view name);
  std::string key(std::string_view name) const;
  bool is_system(double number) const;
  bool is_local(double number) const;
  bool is_local_of_call(double number) const;
  bool is_watched() const { return watch_ && watch_->is_on(); }
  void watch_read(double number) const;
  void watch_read(std::string_view name) const;
  void watch_write(double number) const;
  void watch_write(std::string_view name) const;
  void watch_write(const VariableKey& key) const;
  VariableKey watch_key(double number) const;
  VariableKey watch_key(std::string_view name) const;
  double folded_number(double number) const;
  std::string name_of(double number) const;
  bool preset_number(std::string_view given, double number, const Value& value, std::string& why);
  bool preset_name(std::string_view given, std::string_view name, const Value& value,
                   std::string& why);

  VariableForm form_;
  SystemVariables* system_ = nullptr;
  LoopWatch* watch_ = nullptr;
  std::vector<std::unique_ptr<Level>> levels_;
  std::vector<Cell> common_;
  Names globals_;
  std::size_t elements_ = 0;
  UnreadPresets unread_;
};

}  // namespace mrsim
