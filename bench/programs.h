// Deterministic programs for benchmarks and stress tests, as motions and as NC text.
#pragma once

#include <mrsim/types.h>

#include <string>
#include <vector>

namespace mrsim::bench {

struct BenchProgram {
  std::string name;
  StockShape stock;
  Tool tool;
  std::vector<Motion> motions;
};

/// Ball Ø6 over z = 10 + 3 sin(x/8) cos(y/7) in a 100 x 100 x 20 mm block: sqrt(n) rows of short
/// lines, n in all.
BenchProgram raster(std::size_t n);

/// Flat Ø10 clearing a 200 x 200 x 40 mm block in trochoids of 20 short lines (loop radius 4 mm),
/// 25 rows on each of 5 levels, n lines.
BenchProgram adaptive(std::size_t n);

/// `holes` bores Ø3.2, 10 mm deep, each one helix (pitch 0.5 mm, end mill Ø2), in a 200 x 200 x 20
/// mm block.
BenchProgram helix_drill(std::size_t holes);

/// A contour of n short lines, r = 35 + 3 sin(z/10), on a bar Ø80 x 200 mm, 35 degree insert with
/// 0.4 mm nose.
BenchProgram turn(std::size_t n);

/// A pocket of n arcs at one level, flat Ø6, in a 200 x 200 x 40 mm block: rings of semicircles
/// with drifting centres.
BenchProgram arcs(std::size_t n);

/// The program by name: "raster-1000", "adaptive-10000", "helix-drill-2000", "turn-100",
/// "arcs-5000". Throws Error for other names.
BenchProgram program_named(const std::string& name);

/// The same program as SINUMERIK text, coordinates to 1e-6 mm.
std::string nc_text(const BenchProgram& program);

}  // namespace mrsim::bench
