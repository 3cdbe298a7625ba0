// Words whose values stay in force: F S D H RNDM and their kin. Private to src/interp.
#pragma once

#include "interp/tools/tool_changer.h"

namespace mrsim {

class ValueWords : public ControlPart {
 public:
  ValueWords(Control& control, ToolChanger& tools) : ControlPart(control), tools_(tools) {}
  /// False: an error was reported.
  bool apply();

 private:
  bool turned_line(char c);
  std::string unread_axis(char c) const;
  bool switches_channel();
  bool turns_in_mode(char c, const Word& word);
  bool rotary_axes();
  bool feed();
  bool feed_per_tooth(const Word& word);
  bool speed();
  bool beeps() const;
  bool d_limits_speed() const;
  bool limits_speed(const Word* s);
  bool edge();
  bool tip_of_diameter();
  bool take_lengths(const Word* h);
  void meet_table(const Word* h);
  bool length_register();
  void auxiliary_axes();
  void dynamics();
  bool codesys();
  bool sinumerik();

  ToolChanger& tools_;
  bool axis_c_ = false;  ///< C was given as an axis: it is no chamfer
};

}  // namespace mrsim
