/// mrsim: the report of a run or a comparison, one HTML page: the part in three dimensions with its
/// deviations, the program's text, and the run to play.
#pragma once

#include <mrsim/compare.h>
#include <mrsim/cycle_time.h>
#include <mrsim/play.h>
#include <mrsim/types.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {

/// A line of the program that runs a part of its tool into material.
struct ReportCollision {
  std::string part;        ///< "cutter", "shank" or "holder"
  std::string tool, file;  ///< its id; the program's file
  int line = 0;            ///< from 1
  std::string text;        ///< of the line
  bool rapid = false;
  double depth = 0;         ///< mm, of the deepest motion of the line
  double volume = 0;        ///< mm^3 of the material that the part meets on that motion
  Vec3 place;               ///< mm, where that is, in the part's coordinates
  double seconds = 0;       ///< s, the machine's time of all motions before that motion
  std::size_t motion = 0;   ///< its number from 1, as --until counts
  std::size_t motions = 1;  ///< of the line that collide with this part
};

/// The run that the report plays. Null: it plays none; no stock: the path alone. All of them
/// outlive the report's call.
struct ReportRun {
  const Program* program = nullptr;
  const CycleTime* cycle = nullptr;
  const StockShape* stock = nullptr;
  const Play* play = nullptr;
};

/// What the report shows beside the deviations; all may stay empty.
struct ReportFacts {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;  ///< "Stock" -> "box 100 x 60 x 10 mm"
  std::vector<std::pair<std::string, double>> times;       ///< stage -> seconds
  std::vector<Tool> tools;
  std::vector<Diagnostic> diagnostics;
  std::vector<ReportCollision> collisions;  ///< worst first
  std::size_t more_collisions = 0;          ///< lines beyond these
  ReportRun run;
};
/// A self-contained HTML page: the part with its deviations, regions, program text. Works from
/// disk without a network. `nominal` may have no triangles, `comparison` no figures (a plain
/// viewer of the part). Requires: what ReportRun points to stays alive during the call. Cost:
/// linear in triangles and motions.
MRSIM_API std::string report_html(const TriMesh& part, const TriMesh& nominal,
                                  const Comparison& comparison, const ReportFacts& facts = {},
                                  int threads = 0);

}  // namespace mrsim
