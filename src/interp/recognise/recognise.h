// Which control and which kind of machine a program is for, from its text, with the reason.
#pragma once

#include <mrsim/options.h>
#include <mrsim/types.h>

#include <string>

namespace mrsim {

struct Recognition {
  Dialect dialect = Dialect::automatic;
  std::string dialect_reason;
  MachineKind machine = MachineKind::automatic;  ///< automatic: not known
  std::string machine_reason;
  bool okuma = false;    ///< FANUC's words as Okuma's OSP has them
  int leader_lines = 0;  ///< text before the first % of a FANUC or ISO tape
  bool empty = true;     ///< no word of NC at all
};

/// Reads as much of the file as it takes, in one pass, memory flat. What `options` fix stays fixed.
Recognition recognise(const std::string& path, const InterpOptions& options);

}  // namespace mrsim
