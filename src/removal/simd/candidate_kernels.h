// The loops of pruning over columns of sweeps, for the best instruction set of this machine.
//
// Columns by form, lengths in mm about the list's origin:
//   strip  ax ay az ux uy L s 1/(1+s^2)          ball centre at the start, direction and length in
//                                                plan, slope
//   line   ax ay dx dy 1/(dx^2+dy^2) - tip level path in plan, height of the tip and its number
//   arc    cx cy R mx my cos sin tip level       as in sweep_lanes.inl
// A level number is equal for two sweeps just when their tips are equally high in double; NaN
// equals nothing. The last column holds the bits of the sweep's index, which compare as they do;
// for a pack that of its first sweep, and the column before it the pack's number.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mrsim {

enum class SimdLevel;

inline constexpr std::size_t kNearColumns = 10, kIdColumn = 9, kPackColumn = 8;

struct NearColumns {
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

/// The region and the slack of one step.
struct NearArgs {
  float x = 0, y = 0, z = 0;             ///< centre about the list's origin
  float half = 0, tall = 0, radius = 0;  ///< of the region
  bool box = false;
  float delta = 0;     ///< error of a distance or a nearest point
  float fixed = 0;     ///< margin of dominance, mm^2 ...
  float per_root = 0;  ///< ... and per mm of distance
  ToolColumns tool;
};

/// What is found of each sweep.
struct NearRows {
  float *distance, *squared;  ///< to the sweep; to its skeleton
  float *x, *y, *z;           ///< nearest point of the skeleton less the centre; plan: z of the tip
  float *rest, *level;        ///< what dominance has to exceed besides the linear term, with margin
};
struct NearLeast {
  float distance, squared, z;
};

/// A sweep that may beat others, and the limits of one run.
struct Beater {
  float squared, x, y, z, level, id;
};
struct KeepArgs {
  NearArgs at;
  float limit = 0;   ///< largest distance that is kept
  float beyond = 0;  ///< plan: squared distance from which two equal tips differ strictly
  float within = 0;  ///< what is asked, see keep: of strips the distance from a skeleton, of level
                     ///< moves the height of a tip
  bool plan = false, rising = false, has_cover = false;
  int beaters = 0;
  Beater beater[2], cover;
};
struct PlanBeaters {
  std::size_t nearest, lowest, cover;  ///< slots; cover: n when there is none
};

/// Of several strips the first of the nearest ones, by the squared distance less one for all.
struct NearStrip {
  float squared;
  std::size_t slot;
};

struct NearKernels {
  /// Fill the rows of n sweeps, padded with infinite distances to a whole register; the least of
  /// each.
  NearLeast (*strip)(const NearColumns& c, std::size_t n, const NearArgs& a, const NearRows& out);
  NearLeast (*line)(const NearColumns& c, std::size_t n, const NearArgs& a, const NearRows& out);
  NearLeast (*arc)(const NearColumns& c, std::size_t n, const NearArgs& a, const NearRows& out);
  /// First slot with the value; n when there is none.
  std::size_t (*find)(const float* column, std::size_t n, float value);
  /// The nearest, the lowest (then nearest), and the lowest whose squared distance is below
  /// `inside`.
  PlanBeaters (*plan)(const NearRows& rows, std::size_t n, const NearLeast& least, float inside);
  /// Copies what is not beaten to `out` (same stride rules); how many. Writes up to a register
  /// more. `reaches` is set where the region comes within a.within of a skeleton that is kept,
  /// which must be convex; of level moves, where the tip of one that is kept is no higher.
  std::size_t (*keep)(const KeepArgs& a, const NearRows& rows, const NearColumns& in, std::size_t n,
                      std::size_t columns, float* out, std::size_t out_stride, bool& reaches);

  // Strips of one tool for a region without parts, where nothing but their numbers is wanted.
  /// For each of four parts, about (-b, -b), (-b, b), (b, -b) and (b, b) of the centre in plan, the
  /// strip whose point nearest to the region's centre is the nearest to the part's.
  void (*strip_quarters)(const NearColumns& c, std::size_t n, const NearArgs& a, float b,
                         NearStrip* out);
  /// Strip k as what others have to be compared with.
  Beater (*strip_beater)(const NearColumns& c, std::size_t k, const NearArgs& a);
  /// Writes the indices (as bits) of those with a squared distance up to `limit` that are not
  /// beaten to `ids`, and up to a register more; how many. `reaches` as in keep.
  std::size_t (*strip_ids)(const NearColumns& c, std::size_t n, const NearArgs& a, const Beater& j,
                           float limit, float within, float* ids, bool& reaches);
};

/// The kernels of a level, null where the machine or the compiler has none.
const NearKernels* near_kernels(SimdLevel level);
/// The best ones; chosen once.
const NearKernels& near_kernels();

}  // namespace mrsim
