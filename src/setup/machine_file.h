// The machine of a job: the table [machine] of a TOML file (docs/job.md).
#pragma once

#include <mrsim/cycle_time.h>

#include <string>
#include <string_view>

namespace mrsim {

/// Reads the table [machine]; other tables and keys of the file belong to others. `name` stands in
/// errors. Keys that are not there keep their defaults. Throws PlacedError "machine-syntax",
/// "machine-key", "machine-value"; "machine-missing" where there is no such table.
MachineData parse_machine(std::string_view text, const std::string& name);

/// parse_machine() of a file. Throws what read_file throws, too.
MachineData load_machine_file(const std::string& path);

}  // namespace mrsim
