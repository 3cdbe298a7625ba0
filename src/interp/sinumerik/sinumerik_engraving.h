// CYCLE60 of SINUMERIK: a text on a line or on an arc, cut in letters of a plain font. Private to
// src/interp.
#pragma once

#include "interp/cycles/cycle_call.h"
#include "interp/milling/letter_cutter.h"

#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

class SinumerikEngraving : public ControlPart {
 public:
  SinumerikEngraving(Control& control, Moves& moves)
      : ControlPart(control), cutter_(control, moves) {}

  static bool knows(std::string_view name) { return name == "CYCLE60"; }
  /// Carries out the cycle. False: an error was reported.
  bool run(const CycleCall& call, const Word& where);

 private:
  /// Lengths in mm. `up`, `across`: 0 the reference point is the text's bottom or left, 1 its
  /// middle, 2 its top or right.
  struct Layout {
    std::string letters;
    Vec2 place;
    double height = 0, turn = 0;
    int across = 0, up = 0;
    bool mirrored = false;
    int arc = 0;         ///< 0 a line, 1 over the centre, tops outwards, 2 below it, tops inwards
    Vec2 center;         ///< centre of the arc
    int spacing_by = 0;  ///< 0 the gap, 1 the whole width, 2 the angle of the arc
    double spacing = 0;  ///< the value of that: mm, or degrees
  };
  using Strokes = std::vector<std::vector<Vec2>>;

  bool fail(const char* code, const std::string& text) { return error(code, text, where_); }
  bool read(Layout& out);
  bool read_letters(std::string& out);
  bool read_form(Layout& out);
  bool reads_all();
  Vec2 point(ValueName u, ValueName v, bool polar) const;
  bool strokes(const Layout& l, Strokes& out);
  bool on_line(const Layout& l, double gap, double width, Strokes& out);
  bool on_arc(const Layout& l, double gap, double width, double radius, Strokes& out);

  LetterCutter cutter_;
  const CycleCall* call_ = nullptr;
  Word where_;
};

}  // namespace mrsim
