// The columns of SweepTable, which sweep/ and prune/ read. Sweeps with a closed form are
// records of 8 or 16 doubles, aligned to cache lines: a list of sweeps costs one or two lines each,
// and a register full of them is read by loads and a transposition, which beats gathering.
#pragma once

#include "core/numbers/rounding.h"
#include "removal/columns/height_segments.h"
#include "removal/columns/path_column.h"
#include "removal/columns/run_chords.h"
#include "removal/columns/sweep_class.h"
#include "removal/columns/sweep_packs.h"
#include "removal/columns/turn_tree.h"
#include "removal/forms/chain_sweep.h"
#include "removal/forms/curtain_sweep.h"
#include "removal/forms/slant_sweep.h"
#include "removal/forms/sweep_motion.h"
#include "removal/forms/turn_sweep.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/tool/tool.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace mrsim {

inline constexpr std::size_t kSweepsOfThread = 1 << 16;  ///< sweeps that are worth a thread

/// Patch numbers: the profile's patch, or kCornerPatch + corner where a corner of the profile draws
/// the surface, plus kBranchPatch * branch (half of an arc, quarter turn of a helix), plus
/// kFlankPatch for the second flank of the groove that a sharp tip leaves.
inline constexpr std::int32_t kCornerPatch = 1 << 12;
inline constexpr std::int32_t kFlankPatch = 1 << 15;
inline constexpr std::int32_t kBranchPatch = 1 << 16;

enum class SweepKind : std::uint8_t {
  ball_line,   ///< ball reaching up, any line: ball_line of sweep_lanes.inl
  plane_line,  ///< flat or bull-nose reaching up, or a closed ball, horizontal line: plane_line
  plane_arc,   ///< the same on a horizontal arc: plane_arc
  ball_arc,    ///< ball reaching up, arc in an upright plane
  profile,     ///< any profile on a horizontal line or arc, or up and down
  path,        ///< any profile on any other path
  turn         ///< insert
};
inline constexpr std::size_t kSweepKinds = 7;

/// The number of a tip's height as a column holds it: exact, or NaN, which equals nothing.
inline double height_number(std::uint32_t number) {
  return number < (1u << 24) ? number : std::numeric_limits<double>::quiet_NaN();
}

struct SweepRef {
  SweepKind kind = SweepKind::profile;
  bool split : 1 = false;  ///< arc whose wall can meet itself: its halves are patches of their own
  bool grooves : 1 = false;  ///< by a sharp tip: so are the flanks on both sides of the path
  std::uint16_t frame = 0;   ///< index into frames + 1, 0 = the stock's own
  std::uint32_t row = 0;     ///< index into the column of its kind
  std::int32_t shape = 0;    ///< index into shapes
};

/// Tags: the form (0 ball_line, 1 plane_line, 2 plane_arc, in the stock's frame) above the row.
inline constexpr std::uint32_t kTagShift = 30, kOtherForm = 3, kTagRow = (1u << kTagShift) - 1;
/// For sweeps of the other form, stored in the tag above the row: what bounds the distance of a
/// sweep that is evaluated on its own, or the lists that it is evaluated in.
enum class SingleForm : std::uint32_t { box, slant, chain, outline, bore, turned, upright };
inline constexpr std::uint32_t kSingleShift = 27, kSingleRow = (1u << kSingleShift) - 1;
inline bool is_other(std::uint32_t tag) { return tag >> kTagShift == kOtherForm; }
/// Requires: is_other(tag).
inline SingleForm single_form(std::uint32_t tag) {
  return static_cast<SingleForm>(tag >> kSingleShift & 7);
}

struct SweepColumns {
  std::uint64_t serial = 0;  ///< differs from that of any other table of the process
  std::vector<SweepRef> refs;
  std::vector<std::int32_t> motions;  ///< by sweep: the motion that makes it
  std::vector<std::uint32_t> tags;    ///< form and row of each sweep, all that lists have to read
  std::vector<Box3> bounds[kSweepKinds];  ///< by kind and row; lines have none: bounds_of
  std::vector<LineRecord> ball_lines, plane_lines;
  std::vector<ArcRecord> plane_arcs;
  std::vector<BallArc> ball_arcs;
  std::vector<ProfileRow> profiles;
  std::vector<OutlineEdge> outline_edges;
  std::vector<OutlineTool> outlines;  ///< by shape; empty when no profile has one
  PathColumn paths;
  std::vector<ChainLine> chain_lines;    ///< by row of paths; empty when there are none
  std::vector<ChainTool> chain_tools;    ///< by shape, likewise
  std::vector<SlantRecord> slant_lines;  ///< by row of paths; empty when there are none
  std::vector<LineRecord> bores;  ///< turns of helices (BoreSlot) by row of paths; empty when none
  std::vector<UprightRecord> upright_quarters;
  std::vector<std::uint32_t> first_quarter;  ///< by row of paths: its first quarter, and the end;
                                             ///< empty when there are none
  std::vector<TurnSweep> turns;
  std::vector<ToolShape> shapes;
  std::vector<ToolFrame> frames;
  std::vector<SweepClass> classes;  ///< in the order of their groups
  TurnTree turn_tree;
  SweepPacks packs;
  RunChords run_chords;
  std::vector<LineRecord> segments;           ///< of paths and profiles (height_segments.h)
  std::vector<std::uint32_t> first_segment;   ///< by sweep, and the end; empty when there are none
  std::vector<std::uint32_t> class_of;        ///< by sweep; empty when all are of the first class
  std::vector<std::uint32_t> height_numbers;  ///< by sweep: number of the tip's height; empty when
                                              ///< none is compared by it
  bool uniform = false;     ///< all of one kind, in the stock's frame: row i is sweep i
  bool all_turned = false;  ///< all are the same at every angle about the Z axis
  double max_error = 0;
  double smallest_radius = 0;

  /// Distance from a sweep of p in the frame of its tool. Where that is above `limit` mm, it may be
  /// any distance above it.
  double distance(const SweepRef& ref, const Vec3& p, double limit = kInfinity) const;
  double distance(std::size_t i, const Vec3& p, double limit = kInfinity) const {
    const SweepRef& ref = refs[i];
    return distance(ref, ref.frame > 0 ? frames[ref.frame - 1].in(p) : p, limit);
  }
  /// Whether a sweep is a straight move of a convex tool with chain_minimum().
  bool is_chain(const SweepRef& ref) const {
    return ref.kind == SweepKind::path && !chain_lines.empty() && chain_lines[ref.row].plan >= 0;
  }
  /// Whether it is one of a tool with slant_minimum().
  bool is_slant_line(const SweepRef& ref) const {
    return ref.kind == SweepKind::path && !slant_lines.empty() && slant_lines[ref.row].length > 0;
  }
  /// Whether it is the lowest turn of a helix by an end mill.
  bool is_bore(const SweepRef& ref) const {
    return ref.kind == SweepKind::path && !bores.empty() && bores[ref.row].c[BoreSlot::radius] > 0;
  }
  /// Whether it is one on a horizontal path whose tool has an outline.
  bool has_outline(const SweepRef& ref) const {
    return ref.kind == SweepKind::profile && !outlines.empty() &&
           !outlines[static_cast<std::size_t>(ref.shape)].edges.empty();
  }
  /// The path of a mill on an arc in an upright plane, in the frame of its tool; else null.
  const ToolPath* upright_arc(const SweepRef& ref) const {
    if (ref.kind != SweepKind::path || paths.is_line(ref.row)) return nullptr;
    const ToolPath& path = paths.arc(ref.row);
    return path.upright ? &path : nullptr;
  }
  /// The quarters of an upright arc by the row of its path. Requires: SingleForm::upright.
  std::span<const UprightRecord> quarters_of(std::uint32_t row) const {
    return std::span(upright_quarters)
        .subspan(first_quarter[row], first_quarter[row + 1] - first_quarter[row]);
  }
  /// The least distance over the positions of a path, in the frame of its tool, and where it is.
  PathSample path_sample(const SweepRef& ref, const Vec3& p) const;
  /// A box that holds a sweep.
  Box3 bounds_of(const SweepRef& ref) const;
  /// A box that holds what a number of a list means: a sweep, or a pack of sweeps.
  Box3 bounds_of_number(std::size_t number) const;
  /// A box that holds the sweep of a line with the form and tool of `ref`.
  Box3 bounds_of_line(const SweepRef& ref, const LineRecord& record) const;
  std::uint32_t segment_count(std::size_t sweep) const {
    return first_segment.empty() ? 0 : first_segment[sweep + 1] - first_segment[sweep];
  }
  /// How lists hold a sweep.
  SweepClass::Form form_of(std::size_t sweep) const {
    if (segment_count(sweep) > 0) return SweepClass::Form::segment;
    return static_cast<SweepClass::Form>(tags[sweep] >> kTagShift);
  }
  /// Nearest point of the skeleton of a sweep of other form, less p; infinitely far where there is
  /// nothing to compare. Plan: z is that of the tip.
  struct Foot {
    double squared = std::numeric_limits<double>::infinity();
    Vec3 offset;
    bool convex = false;
  };
  Foot foot(const SweepRef& ref, const Vec3& p) const;
  const Curtain& ball_arc_face(const SweepRef& ref, std::int32_t patch) const {
    const BallArc& s = ball_arcs[ref.row];
    return ref.split ? s.halves[patch >= kBranchPatch ? 1 : 0] : s.whole;
  }
  /// The row of a sweep whose form is known. Reads no memory where all sweeps are of one form.
  std::uint32_t row_of(std::uint32_t sweep) const {
    return uniform ? sweep : tags[sweep] & kTagRow;
  }
  std::uint32_t class_index(std::uint32_t sweep) const {
    return class_of.empty() ? 0 : class_of[sweep];
  }
  /// A list by what its numbers stand for.
  struct Numbers {
    std::span<const std::uint32_t> sweeps, turned, packs;  ///< turned: those of turn_tree
  };
  Numbers numbers_of(std::span<const std::uint32_t> list) const;
  /// Appends what a number of a list stands for: a pack's sweeps, or the number itself.
  void append_sweeps(std::uint32_t number, std::vector<std::uint32_t>& out) const {
    if (number < kFirstPack) return out.push_back(number);
    for (std::uint32_t i = packs[number].first; i <= packs[number].last; ++i) out.push_back(i);
  }
  /// The sweeps of a list, those of its packs as well; valid until the thread's next call.
  std::span<const std::uint32_t> sweeps_of(const Numbers& list) const;
  const Profile& cutter(const SweepRef& ref) const { return shapes[ref.shape].cutter; }
};

}  // namespace mrsim
