/// mrsim: plain values shared by all stages of the simulation: motions, stocks and programs here;
/// what they are made of in the headers below, which need not be included by themselves.
///
/// Units everywhere: millimetres, radians, seconds. Positions are in the stock's coordinate system.
/// A lathe's positions are (x = radius, y = 0, z), its spindle is the Z axis. Standard library
/// types only; every type here is a value that can be copied, compared member by member and sent to
/// another thread.
///
/// Example:
///     mrsim::Motion m;
///     m.kind = mrsim::MotionKind::line;
///     m.end = {10, 0, 0};  // 10 mm along X from the origin
#pragma once

#include <mrsim/diagnostics.h>
#include <mrsim/events.h>
#include <mrsim/geometry.h>
#include <mrsim/tool.h>
#include <mrsim/tri_mesh.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {

/// `ngc` is LinuxCNC and what follows it: Grbl, Mach, Carbide.
enum class Dialect : std::uint8_t { automatic, sinumerik, iso, fanuc, codesys, ngc };
enum class MachineKind : std::uint8_t { automatic, mill, lathe };

enum class MotionKind : std::uint8_t { rapid, line, arc };
enum class FeedUnit : std::uint8_t { mm_per_min, mm_per_rev, inverse_time };

/// One canonical move: frames, offsets and compensations applied. An arc is never chopped, however
/// many turns.
struct Motion {
  MotionKind kind = MotionKind::rapid;
  FeedUnit feed_unit = FeedUnit::mm_per_min;
  bool constant_surface_speed = false;  ///< `speed` is m/min (G96), else rev/min
  bool assumed_start = false;  ///< starts at a position never programmed: neither swept nor checked
  Vec3 start, end;             ///< mm
  Vec3 center;                 ///< arc: centre at the height of the start
  /// arc: unit axis, normalised so that its first non-zero component in the order z, y, x is
  /// positive
  Vec3 axis{0, 0, 1};
  double radius = 0;  ///< arc: mm
  double sweep = 0;  ///< arc: signed angle in radians about `axis`, counter-clockwise positive, any
                     ///< number of turns
  double rise = 0;   ///< arc: signed travel along `axis` over the whole sweep (helix), mm
  Vec3 tool_axis{0, 0, 1};  ///< milling: unit vector from the tool's tip to its shank
  int tool = -1;            ///< index into Program::tools, -1 = none chosen yet
  double feed = 0;          ///< in `feed_unit`; 0 = none given
  double speed = 0;         ///< rev/min or m/min; 0 = none given
  double speed_limit = 0;   ///< rev/min: the spindle turns no faster (G50 S, LIMS); 0 = none given
  double lead = 0;  ///< thread lead in mm per revolution (G33, G331 and relatives), negative =
                    ///< left-hand, 0 = not a thread
  int file = 0;     ///< index into Program::files
  int line = 0;     ///< 1-based
  int column = 0;   ///< 1-based, bytes: the word that made it a motion
  int call = -1;    ///< index into Program::calls, -1 = in the main program
};

/// Where a subprogram was called from; `outer` leads to the caller's own call, -1 ends the chain.
struct CallSite {
  int file = 0;
  int line = 0;
  int outer = -1;
};

/// What was cut in earlier setups, in the order of the cuts: the part of a stock that a .vdb
/// remembers.
struct CutHistory {
  std::vector<std::string> files;
  std::vector<Tool> tools;
  std::vector<Motion> motions;  ///< `file` and `tool` index the lists above; `call` is -1
};

/// The stock before the first cut. Exact primitives keep their closed form; a mesh is taken as it
/// is.
struct StockShape {
  enum class Kind : std::uint8_t { box, cylinder, tube, mesh };
  Kind kind = Kind::box;
  Box3 box;                 ///< box: the solid; others: its bounds
  double outer_radius = 0;  ///< cylinder and tube, about the Z axis direction through `axis_point`
  double inner_radius = 0;  ///< tube
  Vec3 axis_point;          ///< x, y of the axis (z unused)
  TriMesh mesh;             ///< mesh
  CutHistory history;       ///< cuts made before this program (a .vdb saved by mrsim)
  std::string description;  ///< for the report: "box 100 x 60 x 10 mm, exact (from block.stl)"
  std::string repairs;  ///< what had to be done to its file's mesh ("12 triangles turned"), or ""
};

/// Everything that the interpreter understood of a program.
struct Program {
  Dialect dialect = Dialect::automatic;
  std::string dialect_reason;
  MachineKind machine = MachineKind::automatic;
  std::string machine_reason;
  std::vector<std::string> files;  ///< main program first
  std::vector<CallSite> calls;
  std::vector<Tool> tools;  ///< those the program uses, with inferred data filled in
  std::vector<Motion> motions;
  std::vector<Event> events;  ///< ascending by `before`
  double zero_height = 0;     ///< Z of the highest work zero (G54 .., G92) that cuts count from
  std::vector<Diagnostic> diagnostics;
  std::optional<StockShape> workpiece;  ///< stock stated by the program itself (WORKPIECE)
  std::vector<std::pair<std::string, std::string>>
      start_modes;  ///< "plane" -> "G17", printed by check --verbose
};

}  // namespace mrsim
