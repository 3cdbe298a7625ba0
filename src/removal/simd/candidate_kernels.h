// The loops of pruning over columns of sweeps, for the best instruction set of this machine.
//
// Columns by form, lengths in mm about the list's origin: StripColumn, LineColumn, ArcColumn; of a
// straight segment of a slanted path, BallSlot (removal/field/record_slots.h).
// A height number is equal for two sweeps just when their tips are equally high in double; NaN
// equals nothing. The last column holds the bits of the sweep's index, which compare as they do;
// for a pack that of its first sweep, and the column before it the pack's number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace mrsim {

enum class InstructionSet;

inline constexpr std::size_t kCandidateColumns = 10, kIdColumn = 9, kPackColumn = 8;
inline constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
/// mm^2, and a share of squared distances: exact distances, in doubles, are rounded by less, so of
/// sweeps that are equally near none is dropped.
inline constexpr float kTieMargin = 1e-9f;

struct CandidateColumns {
  const float* base = nullptr;
  std::size_t stride = 0;
  const float* operator[](std::size_t i) const { return base + i * stride; }
};

/// A tool as the kernels see it, mm.
struct ToolColumns {
  float core = 0, round = 0;  ///< rounded_slab of sweep_lanes.inl; a ball: round
  float height = 0;           ///< of the top above the tip
  float flat = 0;             ///< radius of the flat end, 0 = none, rounded down
  bool rising = false;        ///< a lower tip removes more
};

/// A tool as the bounds of heights see it, mm: a disc, a fillet, a cone, and a wall.
struct HeightTool {
  float core = 0, round = 0;  ///< radius of the disc at the tip, and of the fillet about it
  float per_round = 0;        ///< 1 / round; 0 without a fillet
  float reach = 0;            ///< of the fillet in plan, beyond the disc
  float slope = 0;            ///< of the cone that follows; 0 = none
  float steepest = 0;         ///< slope of a tangent that lies below the tool
  float sine = 0;             ///< of its angle
  float radius = 0;           ///< of the wall
  float lift = 0;             ///< how far the tool may be above this outline
  float top = 0;              ///< height up to which it does not narrow
};

/// A square in plan for the bounds of heights.
struct HeightArgs {
  float x = 0, y = 0;  ///< centre about the list's origin
  float wide = 0;      ///< radius in plan of what the bounds are for
  float top = 0;       ///< height above which a bound need not hold
  float error = 0;     ///< of a bound
  float stray = 1;     ///< share of a path's deviation from its segment that may lie in plan
  HeightTool tool;
};

/// The region and the slack of one step.
struct RegionArgs {
  float x = 0, y = 0, z = 0;             ///< centre about the list's origin
  float half = 0, tall = 0, radius = 0;  ///< of the region
  bool box = false;
  float delta = 0;     ///< error of a distance or a nearest point
  float fixed = 0;     ///< margin of dominance, mm^2 ...
  float per_root = 0;  ///< ... and per mm of distance
  ToolColumns tool;
};

/// What is found of each sweep.
struct CandidateRows {
  float *distance, *squared;  ///< to the sweep; to its skeleton
  float *x, *y, *z;           ///< nearest point of the skeleton less the centre; plan: z of the tip
  float *rest,
      *height_number;  ///< what dominance has to exceed besides the linear term, with margin
};
struct LeastDistance {
  float distance, squared, z;
};

/// A sweep that may beat others, and the limits of one call.
struct Beater {
  float squared, x, y, z, height_number, id;
};
struct KeepArgs {
  RegionArgs at;
  float limit = 0;   ///< largest distance that is kept
  float beyond = 0;  ///< plan: squared distance from which two equal tips differ strictly
  float within = 0;  ///< the threshold of keep: of strips a distance from the skeleton, of
                     ///< horizontal moves the height of a tip
  bool plan = false, rising = false, has_cover = false;
  int beaters = 0;
  Beater beater[2], cover;
};
struct PlanBeaters {
  std::size_t nearest, lowest, cover;  ///< slots; cover: n when there is none
};

/// Parts of a region for which strip_quarters finds the nearest strip.
inline constexpr std::size_t kStripQuarters = 4;
/// The nearest of several strips, of equally near ones the first. `squared`: its squared distance,
/// less a number that is the same for all strips.
struct StripAt {
  float squared;
  std::size_t slot;
};

struct CandidateKernels {
  /// Fill the rows of n sweeps, padded with infinite distances to a whole register; the least of
  /// each.
  LeastDistance (*strip)(const CandidateColumns& c, std::size_t n, const RegionArgs& a,
                         const CandidateRows& out);
  LeastDistance (*line)(const CandidateColumns& c, std::size_t n, const RegionArgs& a,
                        const CandidateRows& out);
  LeastDistance (*arc)(const CandidateColumns& c, std::size_t n, const RegionArgs& a,
                       const CandidateRows& out);
  /// First slot with the value; n when there is none.
  std::size_t (*find)(const float* column, std::size_t n, float value);
  /// The nearest, the lowest (then nearest), and the lowest whose squared distance is below
  /// `inside`.
  PlanBeaters (*plan)(const CandidateRows& rows, std::size_t n, const LeastDistance& least,
                      float inside);
  /// Copies what is not beaten to `out` (same stride rules); how many. Writes up to a register
  /// more. `reaches` is set where the region comes within a.within of a skeleton that is kept,
  /// which must be convex; of horizontal moves, where the tip of one that is kept is no higher.
  std::size_t (*keep)(const KeepArgs& a, const CandidateRows& rows, const CandidateColumns& in,
                      std::size_t n, std::size_t columns, float* out, std::size_t out_stride,
                      bool& reaches);

  /// Heights over a square: writes what each is at least to `lower`, infinite where the tool does
  /// not come, and returns what the least one is at most (height_lanes.inl). For segments of paths:
  float (*segment_heights)(const CandidateColumns& c, std::size_t n, const HeightArgs& a,
                           float* lower);
  /// For horizontal moves, by rows that line() or arc() has filled:
  float (*horizontal_heights)(const CandidateRows& rows, std::size_t n, const HeightArgs& a,
                              float* lower);

  /// Copies the first `columns` and the number of those entries whose `lower` is at most `limit`.
  std::size_t (*keep_low)(const float* lower, std::size_t n, float limit,
                          const CandidateColumns& in, std::size_t columns, float* out,
                          std::size_t out_stride);

  // Strips of one tool for a region without parts, where nothing but their numbers is wanted.
  /// For each of four parts, about (-b, -b), (-b, b), (b, -b) and (b, b) of the centre in plan, the
  /// strip whose point nearest to the region's centre is the nearest to the part's.
  void (*strip_quarters)(const CandidateColumns& c, std::size_t n, const RegionArgs& a, float b,
                         StripAt* out);
  /// Strip k as what others have to be compared with.
  Beater (*strip_beater)(const CandidateColumns& c, std::size_t k, const RegionArgs& a);
  /// Writes the indices (as bits) of those with a squared distance up to `limit` that are not
  /// beaten to `ids`, and up to a register more; how many. `reaches` as in keep.
  std::size_t (*strip_ids)(const CandidateColumns& c, std::size_t n, const RegionArgs& a,
                           const Beater& j, float limit, float within, float* ids, bool& reaches);
};

/// The kernels of an instruction set, null where the machine or the compiler has none.
const CandidateKernels* candidate_kernels(InstructionSet isa);
/// The best ones; chosen once.
const CandidateKernels& candidate_kernels();

}  // namespace mrsim
