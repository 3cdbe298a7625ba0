// What the operator does while the program waits. A part that is turned over: the cuts behind are
// of another side, which this simulation cuts from the first one. A tool that is changed by hand:
// the program does not say by a T word which it is. Private to src/interp.
#pragma once

#include "interp/control/control.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

class OperatorStops : public ControlPart {
 public:
  explicit OperatorStops(Control& control) : ControlPart(control) {}
  /// The texts of a block for the operator, before it runs.
  void read_texts();
  /// The block has run; `cuts`: of the program so far. Reports at the first cut behind the stop.
  void end_block(std::size_t cuts);

 private:
  struct Text {
    std::string bytes;
    int line = 0;
    bool stops = false;  ///< it stands in the block of the stop
  };
  void keep(std::string_view text, bool stops);
  bool stops() const;
  bool names_another_tool(std::string_view text) const;
  void tell() const;
  void tell_turn(const Text& text) const;
  void tell_change(const Text& text) const;

  std::vector<Text> texts_;  ///< since the last cut; read where a stop makes them count
  bool stopped_ = false;     ///< M0 or M1 since the last cut
  bool called_ = false;      ///< a T word, or another tool, since the last cut
  std::string tool_;         ///< of the last cut
  std::size_t cuts_ = 0;
};

}  // namespace mrsim
