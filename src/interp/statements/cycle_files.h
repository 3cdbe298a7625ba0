// Programs that have the name of one of SINUMERIK's own cycles: which of them are run in place of
// the cycle. Private to src/interp.
#pragma once

#include "interp/calls/block_reader.h"

#include <map>
#include <string>
#include <string_view>

namespace mrsim {

/// The program that a call names. For a call that the control has built in, or whose name is
/// reserved, the main program itself is not meant. `name`: upper case.
SubprogramName called_program(std::string name);

class CycleFiles : public ControlPart {
 public:
  CycleFiles(Control& control, BlockReader& reader) : ControlPart(control), reader_(reader) {}

  /// Whether the call of `name`, upper case, at column `p` of the line calls a program. The machine
  /// builder's program, which begins with PROC and the name, replaces a built-in cycle; any other
  /// program does not. A note names the file either way.
  bool calls_program(const std::string& name, std::string_view line, std::size_t p);

 private:
  BlockReader& reader_;
  std::map<std::string, bool> replaced_;  ///< built-in cycles: whether a program replaces them
};

}  // namespace mrsim
