// `mrsim compare`, and the comparison at the end of a run (--nominal).
#pragma once

#include "cli/options/compare_request.h"
#include <mrsim/mrsim.h>
#include <mrsim/solid_files.h>

#include <string>
#include <vector>

namespace mrsim::cli {

struct NamedNominal {
  TriMesh mesh;
  std::string note;  ///< how a STEP file was tessellated
};
/// The nominal, read and checked: before a long run.
NamedNominal prepare_comparison(const CompareRequest& request);

/// The comparison, with the lines of the programs that are found.
Comparison compare_named(const CompareRequest& request, const TriMesh& part,
                         const TriMesh& nominal);
/// The part coloured by its deviation, as the bytes of request.deviation.
void write_deviation(const CompareRequest& request, const TriMesh& part, const TriMesh& nominal,
                     const Comparison& comparison, const ByteSink& sink);
/// Prints the comparison; kDone or, for a rejected part, kRejected.
int show_comparison(const CompareRequest& request, const NamedNominal& nominal,
                    const Comparison& comparison);

/// `part`, moved and coloured by its deviation from the nominal of the request, for a picture.
TriMesh color_by_deviation(const CompareRequest& request, const TriMesh& part);

/// The command: argv[0] is "compare".
int run_compare(int argc, const char* const* argv);

}  // namespace mrsim::cli
