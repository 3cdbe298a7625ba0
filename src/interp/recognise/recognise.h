// Recognises by its text for which control and which kind of machine a program is, with the reason.
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
  bool okuma = false;    ///< the words are FANUC's as Okuma's OSP means them
  int leader_lines = 0;  ///< lines of text before the first % of a FANUC or ISO tape
  bool empty = true;     ///< there is no word of NC
};

/// Reads as much of the file as needed, in one pass; memory does not grow with the file. What
/// `options` give is not changed.
Recognition recognise(const std::string& path, const InterpOptions& options);

}  // namespace mrsim
