// The report of a run for other programs: --json and --junit.
#pragma once

#include "cli/options/arguments.h"
#include <mrsim/compare.h>
#include <mrsim/mrsim.h>

#include <string>

namespace mrsim::cli {

/// A run that has ended, well or with an error.
struct RunRecord {
  const Arguments* arguments = nullptr;
  const JobResult* result = nullptr;       ///< none: nothing is known
  const Comparison* comparison = nullptr;  ///< none: not compared
  int exit_code = 0;
  std::string error_code, error_text;  ///< of the Error that ended the run, else empty
  std::string rest;                    ///< JSON of --rest; empty: not asked for
};

/// One JSON object, docs/schema/run.json: the same keys whatever happened, null where nothing is
/// known.
std::string run_json(const RunRecord& record);

/// JUnit XML: cases for the program, the run, the collisions and the comparison.
std::string run_junit(const RunRecord& record);

}  // namespace mrsim::cli
