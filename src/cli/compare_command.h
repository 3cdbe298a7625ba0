// `mrsim compare`, and the comparison at the end of a run (--nominal).
#pragma once

#include <mrsim/compare.h>
#include <mrsim/mrsim.h>
#include <mrsim/solid_files.h>

#include <string>
#include <vector>

namespace mrsim::cli {

class TypedOptions;

/// What a comparison is asked for.
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

/// The lines of a run that collide, the deepest first.
std::vector<ReportCollision> collisions_of(const JobResult& result);
/// What a run tells the report.
ReportFacts facts_of(const JobResult& result, const std::string& program);

}  // namespace mrsim::cli
