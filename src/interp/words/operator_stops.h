// Finds what the operator does while the program waits. If the part is turned over, the cuts that
// follow are on another side, but this simulation cuts them from the first one. If a tool is
// changed by hand, no T word says which one it is. Private to src/interp.
#pragma once

#include "interp/control/control.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

class OperatorStops : public ControlPart {
 public:
  explicit OperatorStops(Control& control) : ControlPart(control) {}
  /// Reads the texts of a block for the operator, before it runs.
  void read_texts();
  /// The block has run; `cuts`: how many cuts the program has made. Reports at the first cut behind
  /// the stop.
  void end_block(std::size_t cuts);

 private:
  struct Text {
    std::string bytes;
    int line = 0;
    bool stops = false;  ///< the text stands in the block of the stop
  };
  void keep(std::string_view text, bool stops);
  bool stops() const;
  bool names_another_tool(std::string_view text) const;
  void tell() const;
  void tell_turn(const Text& text) const;
  void tell_change(const Text& text) const;
  void tell_changes_in_comments();

  std::vector<Text> texts_;       ///< since the last cut; they count behind a stop
  bool stopped_ = false;          ///< an M0 or M1 came since the last cut
  bool called_ = false;           ///< a T word, or another tool, came since the last cut
  std::string tool_;              ///< the tool of the last cut
  std::optional<int> commented_;  ///< the tool that a comment has changed to last
  std::size_t cuts_ = 0;
};

}  // namespace mrsim
