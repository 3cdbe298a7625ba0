// The closed forms of sweep_lanes.inl over lists of sweeps and lists of points, for the best
// instruction set of this machine. All of them give the same bits.
#pragma once

#include "core/numbers/rounding.h"
#include "removal/simd/form_records.h"
#include "removal/tool/polygon.h"
#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>

namespace mrsim {

/// Points by columns, with the nearest sweep so far and its distance.
struct PointColumns {
  static constexpr std::size_t kMost = 64, kPad = 8;
  std::size_t count = 0;  ///< columns are filled up to a multiple of kPad
  alignas(64) double x[kMost], y[kMost], z[kMost];
  alignas(64) double least[kMost];
  alignas(64) double nearest[kMost];  ///< index of the sweep; of equally near ones the lower
};

/// Points in plan by columns, with the lowest height so far.
struct PlanPoints {
  static constexpr std::size_t kCount = 16;
  alignas(64) double x[kCount], y[kCount];
  alignas(64) double low[kCount];
};

/// One side of each of eight convex polygons: where it begins, its direction and its length.
struct alignas(64) PolygonSides {
  static constexpr std::size_t kLanes = 8;
  double ax[kLanes] = {}, ay[kLanes] = {}, dx[kLanes] = {}, dy[kLanes] = {}, length[kLanes] = {};
};

/// The kernels of one form. List kernels: out[k] for records[rows[k]] and one point.
template <class Record>
struct FormKernels {
  void (*list)(const Record* records, const std::uint32_t* rows, std::size_t n, const Vec3& p,
               double* out);
  /// Brings `points` up to date with the sweeps ids[k] of records[rows[k]].
  void (*least)(const Record* records, const std::uint32_t* rows, const std::uint32_t* ids,
                std::size_t n, PointColumns& points);
};
struct SweepKernels {
  const char* name;
  FormKernels<LineRecord> ball_line, plane_line;
  FormKernels<ArcRecord> plane_arc;
  /// Brings the points beside the wall of a bore up to date with sweep `id`; a bit for each of the
  /// others to which the sweep may be nearer than the nearest so far.
  std::uint64_t (*bore)(const LineRecord& record, std::uint32_t id, PointColumns& points);
  /// Lower bounds (up to 1e-8 mm) of the distances of p from turns of helices. A byte of `decided`
  /// is not 0 where the bound is the distance. Both have room for a multiple of PointColumns::kPad.
  void (*bore_bounds)(const LineRecord* records, const std::uint32_t* rows, std::size_t n,
                      const Vec3& p, double* out, std::uint8_t* decided);
  /// Brings the points `active`, a bit each, up to date with sweep `id`, a lowest turn.
  void (*helix)(const HelixRecord& record, std::uint32_t id, std::uint64_t active,
                PointColumns& points);
  /// Lower bounds (up to 1e-8 mm) of the distances of p from slanted lines. `out` has room for a
  /// multiple of PointColumns::kPad.
  void (*slant_bounds)(const SlantRecord* records, const std::uint32_t* rows, std::size_t n,
                       const Vec3& p, double* out);
  /// Brings `points` up to date with sweep `id`, a slanted line.
  void (*slant)(const SlantRecord& record, std::uint32_t id, PointColumns& points);
  /// Distances of p from quarters of upright arcs. A result above `limit` only means *above limit*.
  /// With `nearest` each distance lowers the limit for those after it. `out` has room for a
  /// multiple of PointColumns::kPad.
  void (*upright_list)(const UprightRecord* records, const std::uint32_t* rows, std::size_t n,
                       const Vec3& p, double limit, bool nearest, double* out);
  /// Brings `points` up to date with sweep `id`, an upright arc of `count` quarters.
  void (*upright)(const UprightRecord* quarters, std::size_t count, std::uint32_t id,
                  PointColumns& points);
  /// Lower bounds (up to 1e-9 mm) of the distances of p from straight moves of one convex tool. A
  /// result above `limit` only means *above limit*. `out` has room as for slant_bounds.
  void (*chain_bounds)(const ChainTool& tool, const ChainLine* lines, const std::uint32_t* rows,
                       std::size_t n, const Vec3& p, double limit, double* out);
  /// Does what chain_bounds does, for moves in columns, with room for a register behind the last
  /// one.
  void (*chain_bounds_beside)(const ChainTool& tool, const ChainColumns& lines, std::size_t n,
                              const Vec3& p, double limit, double* out);
  /// Brings `points` up to date with sweep `id`, a straight move of a convex tool.
  void (*chain)(const ChainTool& tool, const ChainLine& line, std::uint32_t id,
                PointColumns& points);
  /// Distances of p from horizontal paths, all arcs or all lines, of one tool. A result above
  /// `limit` only means *above limit*. `out` has room for a multiple of PointColumns::kPad.
  void (*outline_list)(const OutlineTool& tool, const ProfileRow* paths, const std::uint32_t* rows,
                       std::size_t n, const Vec3& p, double limit, double* out);
  /// Brings `points` up to date with sweep `id`, a tool of that outline on a horizontal path.
  void (*outline)(const OutlineTool& tool, const ProfileRow& row, std::uint32_t id,
                  PointColumns& points);
  /// Signed distances of (x, y) from eight polygons with `count` sides less `round`, the bits of
  /// polygon_distance. Lanes may repeat a side. `out` is a whole cache line.
  void (*polygons)(const PolygonSides* sides, std::size_t count, const double* round, double x,
                   double y, double* out);
  /// Brings `points`, seen as (x, z) or (-x, z), up to date with a polygon less `round`.
  void (*polygon_least)(const ConvexPolygon::Side* sides, std::size_t count, double round,
                        bool mirrored, std::uint32_t id, PointColumns& points);
  /// out[k]: the lowest height of a ball's straight move (ball_height_lanes.inl) above point k in
  /// plan. Returns a bit for each point where that is below its lowest so far, which is not
  /// changed.
  std::uint32_t (*ball_heights)(const LineRecord& move, const PlanPoints& points, double* out);
  /// Bounds of these heights within r of each point: lowers `least` to the lower bound and `low` to
  /// the upper one. Returns a bit for each point where the lower bound is below its `low` before.
  std::uint32_t (*ball_bounds)(const LineRecord& move, double r, PlanPoints& points, double* least);
};

enum class InstructionSet { scalar, avx2, avx512 };

/// The machine has the instructions.
bool has_simd(InstructionSet isa);

/// The kernels of an instruction set, null where the machine or the compiler has none.
const SweepKernels* sweep_kernels(InstructionSet isa);
/// The best ones; chosen once.
const SweepKernels& sweep_kernels();
/// The best one of this machine; with MRSIM_SIMD=scalar, avx2 or avx512 in the environment none
/// above that (tests and benchmarks compare them). Throws Error "simd-unknown" for any other value.
InstructionSet best_instruction_set();
/// The entry for the one that this build and this machine have, else null: tables are scalar, AVX2,
/// AVX-512, null where the build has none.
template <class Kernels>
const Kernels* kernels_at(InstructionSet isa, const Kernels* const (&tables)[3]) {
  return has_simd(isa) ? tables[static_cast<int>(isa)] : nullptr;
}

}  // namespace mrsim
