// Where the variables of a program live: by number and by name, local to a call or common to all.
// Guarantees: reading what was never set says how to set it; counts and sizes are bounded.
// Does not: know the state of the control, which SystemVariables answers for.
#pragma once

#include "interp/language/expression.h"
#include "interp/language/value.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// How a control's variables are named and how long they live.
enum class VariableForm : unsigned char {
  linuxcnc,   ///< #1-#30 by call, #31-#5000, #<local>, #<_global>
  fanuc,      ///< #1-#33 by level, #100-#199, #400-#999, #98000-#98499, #900000-#907399
  sinumerik,  ///< R parameters, DEF by program, GUD
  fagor,      ///< P0-P25 by level, P100-P299, P1000-P1255, P2000-P2255
  codesys,    ///< #NAME by subprogram, $NAME$
};

/// Variables that are the control's state: positions, offsets, tool data, modal codes.
class SystemVariables {
 public:
  virtual ~SystemVariables() = default;
  /// False: `why` says that this variable is not answered, by name.
  virtual bool read(double number, Value& out, std::string& why) = 0;
  virtual bool read(std::string_view name, std::span<const Value> indices, Value& out,
                    std::string& why) = 0;
  virtual bool write(double number, const Value& value, std::string& why) = 0;
  virtual bool write(std::string_view name, std::span<const Value> indices, const Value& value,
                     std::string& why) = 0;
  virtual bool knows(std::string_view name) = 0;
};

/// Types of SINUMERIK's DEF.
enum class VariableType : unsigned char { real, integer, boolean, character, text, axis, frame };

class Variables : public VariableReader {
 public:
  static constexpr int kLocals = 34;

  /// A defined variable; dimensions of 0 stand for none.
  struct Array {
    VariableType type = VariableType::real;
    std::array<int, 3> dimensions{};
    std::vector<Value> elements;
    std::size_t longest = std::string::npos;  ///< of a text: STRING[20]
  };

  explicit Variables(VariableForm form);
  void set_system(SystemVariables* system) { system_ = system; }

  bool numbered(double number, Value& out, std::string& why) override;
  bool named(std::string_view name, std::span<const Value> indices, Value& out,
             std::string& why) override;
  bool exists(double number) override;
  bool exists(std::string_view name) override;

  bool assign(double number, const Value& value, std::string& why);
  bool assign(std::string_view name, std::span<const Value> indices, const Value& value,
              std::string& why);
  /// DEF: dimensions of 0 stand for none. Elements hold 0, "" or the identity.
  bool define(std::string_view name, VariableType type, std::array<int, 3> dimensions, bool global,
              std::string& why);
  void limit_texts(std::string_view name, std::size_t longest) { find(name)->longest = longest; }
  /// Elements of a defined variable in order, from the element at `indices`: SET, a value that is
  /// left out leaves its element; or with `repeats` REP, so often the first value.
  bool fill(std::string_view name, std::span<const Value> indices,
            std::span<const std::optional<Value>> values, std::size_t repeats, std::string& why);
  /// The whole array of a name, nullptr: there is none.
  const Array* array(std::string_view name);
  /// Gives a defined variable the type, size and elements of an array.
  void set_array(std::string_view name, const Array& values);
  bool is_defined(std::string_view name) { return find(name) != nullptr; }
  /// VC1 and V1 of Okuma, common to all programs.
  static bool is_common(std::string_view name);
  /// A variable from outside: "R1", "#100", "#<_name>", "NAME". False: not a variable of this
  /// control.
  bool preset(std::string_view name, const Value& value, std::string& why);
  /// One from outside that the program has not read. Those of the control's state are not watched.
  struct Unread {
    std::string given;  ///< its name as it came
    double number = -1;
    const Array* named = nullptr;  ///< instead of a number
    bool is_replaced = false;      ///< the program has set it
  };
  const std::vector<Unread>& unread() const { return unread_; }

  /// A call begins or ends: its locals. `arguments`: bit n = local n is given, else it is vacant.
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
  /// Of FANUC's macros, to be put back into another run of the same command.
  using Locals = std::array<Cell, kLocals>;
  const Locals& locals() const { return levels_.back()->cells; }
  void set_locals(const Locals& locals) { levels_.back()->cells = locals; }

 private:
  using Names = std::map<std::string, Array, std::less<>>;
  struct Level {
    Locals cells;
    Names names;
  };

  Cell* cell(double number, std::string& why);
  void answer(const Cell& cell, double number, Value& out) const;
  Array* find(std::string_view name);
  static bool names_part(const Array& variable, std::span<const Value> indices);
  static bool names_character(const Array& variable, std::span<const Value> indices);
  bool read_element(std::string_view name, const Array& variable, std::span<const Value> indices,
                    Value& out, std::string& why) const;
  static bool write_character(Array& variable, const Value& index, const Value& value,
                              std::string& why);
  bool write_element(std::string_view name, Array& variable, std::span<const Value> indices,
                     const Value& value, std::string& why) const;
  bool element(std::string_view name, const Array& variable, std::span<const Value> indices,
               std::size_t& at, std::string& why) const;
  bool store(Array& variable, std::size_t at, const Value& value, std::string& why) const;
  std::string key(std::string_view name) const;
  bool is_system(double number) const;
  bool is_local(double number) const;
  bool preset_number(std::string_view given, double number, const Value& value, std::string& why);
  bool preset_name(std::string_view given, std::string_view name, const Value& value,
                   std::string& why);
  bool is_meant(const Unread& one, double number, const Array* named) const;
  void note_read(double number, const Array* named = nullptr);
  void note_replaced(double number, const Array* named = nullptr);

  VariableForm form_;
  SystemVariables* system_ = nullptr;
  std::vector<std::unique_ptr<Level>> levels_;
  std::vector<Cell> common_;
  Names globals_;
  std::size_t elements_ = 0;
  std::vector<Unread> unread_;
};

}  // namespace mrsim
