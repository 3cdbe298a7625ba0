// G10: the program sets work offsets and registers, which take precedence over the tool table.
// Private to src/interp.
#pragma once

#include "interp/frames/frame_words.h"

namespace mrsim {

class OffsetWords : public ControlPart {
 public:
  OffsetWords(Control& control, FrameWords& frames) : ControlPart(control), frame_words_(frames) {}
  /// G10 L P of the block. False: an error was reported.
  bool run();

 private:
  bool work(int l, int p);
  void tell_of_machine(const WorkOffset& offset);
  bool work_shift(const Word& where);
  bool turned_offset(const Word& where);
  Vec3 shift_to_here(const Vec3& old, const std::string& name);
  void meet_unknown(const Frame& frame);
  bool tool_life(const Word& where);
  bool parameters(const Word& where);
  struct Length {
    double mm = 0;
    bool incremental = false;
    std::string name;
    char axis = 'Z';
  };
  void table_lengths(int l, int tool);
  void keep_length(int number, int kind, bool wear, const Length& length);
  bool tool_register(int l, int p, const Word& where);
  std::string work_name(int l, int p) const;

  FrameWords& frame_words_;
};

}  // namespace mrsim
