// Which variables that had a value before the program started it has not read. Private to
// src/interp.
#pragma once

#include <string>
#include <vector>

namespace mrsim {

struct VariableArray;

class UnreadPresets {
 public:
  struct Preset {
    std::string given;  ///< its name as the user wrote it
    double number = -1;
    const VariableArray* named = nullptr;  ///< the variable, where it has no number
    bool is_replaced = false;              ///< the program has set it
  };

  void add(Preset preset) { list_.push_back(std::move(preset)); }
  bool empty() const { return list_.empty(); }
  const std::vector<Preset>& list() const { return list_; }

  /// The program reads or sets a variable. `local`: its number is local to a call.
  void note_read(double number, const VariableArray* named, bool local);
  void note_replaced(double number, const VariableArray* named, bool local);

 private:
  std::vector<Preset> list_;
};

}  // namespace mrsim
