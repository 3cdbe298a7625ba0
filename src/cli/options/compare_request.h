// What a comparison is to do, read from the options of `mrsim compare` and of a run (--nominal).
#pragma once

#include <mrsim/compare.h>

#include <string>
#include <vector>

namespace mrsim::cli {

class TypedOptions;

struct CompareRequest {
  std::string part, nominal;
  CompareOptions options;
  double deflection = 0;  ///< mm, 0 = by the tolerance
  std::string report, json, junit, deviation;
  DeviationScheme scheme = DeviationScheme::standard;
  std::vector<std::string> folders;  ///< where programs are looked for
  bool quiet = false;
};

/// The files alone, whatever else was typed.
CompareRequest named_request(const TypedOptions& typed);
/// Throws Error of kind usage.
CompareRequest compare_request(const TypedOptions& typed);

}  // namespace mrsim::cli
