/// mrsim: plain values shared by all stages of the simulation.
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

#include <mrsim/events.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(__GNUC__)
#define MRSIM_API __attribute__((visibility("default")))
#else
#define MRSIM_API
#endif

namespace mrsim {

/// A point or a vector, in mm unless said otherwise.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// An axis-aligned box; empty when lo > hi on any axis.
struct Box3 {
  Vec3 lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
          std::numeric_limits<double>::infinity()};
  Vec3 hi{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()};
  friend bool operator==(const Box3&, const Box3&) = default;
};

/// A fault of a file, an option or the machine that ends the run. `code` is a short stable word
/// ("stl-truncated"), what() a sentence for a person. `usage` faults exit with 2, the others
/// with 1.
class MRSIM_API Error : public std::runtime_error {
 public:
  enum class Kind { input, usage };
  Error(std::string code, const std::string& text, Kind kind = Kind::input);
  ~Error() override;
  const std::string& code() const { return code_; }
  Kind kind() const { return kind_; }

 private:
  std::string code_;
  Kind kind_;
};

enum class Severity : std::uint8_t { note, warning, error };

/// A place in a file: 1-based line and column (in bytes), 0 = unknown.
struct SourcePlace {
  std::string file;
  int line = 0;
  int column = 0;
};

/// One finding about a text file, data rather than an exception: a run collects all of them.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string code;  ///< stable word, "arc-radius-too-small"
  std::string text;  ///< what is wrong and what to do, one sentence or two
  SourcePlace place;
  int length = 1;  ///< bytes to underline from place.column
  std::string
      source_line;  ///< the text of the line, UTF-8, without its end (shortened when very long)
  std::vector<SourcePlace> called_from;  ///< call chain, innermost first
};

/// An Error about one place in a text file (a tool table, a job): a Diagnostic that ends the run.
class MRSIM_API PlacedError : public Error {
 public:
  explicit PlacedError(Diagnostic diagnostic, Kind kind = Kind::input);
  ~PlacedError() override;
  const Diagnostic& diagnostic() const { return diagnostic_; }

 private:
  Diagnostic diagnostic_;
};

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

/// A vertex of an outline; the piece that leaves it is straight (bulge 0) or an arc, bulge =
/// tan(angle / 4), counter-clockwise positive. Milling: r from the axis, z from the tip. Turning: r
/// = X, z = Z from the programmed point.
struct ProfilePoint {
  double r = 0, z = 0, bulge = 0;
  friend bool operator==(const ProfilePoint&, const ProfilePoint&) = default;
};

enum class ToolType : std::uint8_t {
  endmill,
  ballmill,
  bullmill,
  chamfer,
  taper,
  drill,
  tslot,
  lollipop,
  barrel,
  form,
  turning,
  grooving,
  boring,
  threading
};

/// A piece of shank or holder: a cone frustum of the given diameters and length, stacked upwards.
struct ToolSegment {
  double diameter_low = 0, diameter_high = 0, length = 0;
};

/// A tool as its user describes it: numbers, not shapes. 0 (or empty) = not given, the documented
/// default holds.
struct Tool {
  std::string id;  ///< "4", "ENDMILL_5"; empty for the tool of a program that names none
  ToolType type = ToolType::endmill;
  double diameter = 0;  ///< milling; turning: of a round insert
  double corner_radius = 0;
  double taper_angle = 0;  ///< radians, from the axis, per side
  double tip_angle = 0;    ///< radians, included
  double tip_diameter = 0;
  double neck_diameter = 0;           ///< tslot, lollipop
  double profile_radius = 0;          ///< barrel: radius of the flank
  double flute_length = 0;            ///< 0 = the cutter reaches above the stock
  std::vector<ProfilePoint> profile;  ///< form tools, from the axis at the tip upwards
  std::vector<ToolSegment> shank, holder;
  std::string insert;       ///< turning: ISO shape, "VNMG" or "V"
  double insert_angle = 0;  ///< radians, 0 = by `insert`
  double nose_radius = 0;
  double lead_angle = 0;  ///< radians, between feed (-Z) and cutting edge
  double edge_length = 0;
  double width = 0;  ///< grooving, threading: width of blade or tooth; tslot: height of the head
  bool left_hand = false;
  int tip = 0;                      ///< tip orientation 1..9 as on the control, 0 = by lead angle
  bool tip_is_nose_centre = false;  ///< the programmed point is the nose centre (orientation 9)
  std::string origin;               ///< where the data came from, for the report
};

inline bool is_turning(ToolType t) { return t >= ToolType::turning; }

/// Radius and length registers (D, H) and work offsets of a control, keyed by "D3", "H1", "T4.D1" /
/// "G54".
struct OffsetRegister {
  std::string name;
  double radius = 0, wear = 0, length = 0;
};
struct WorkOffset {
  std::string name;
  Vec3 shift;  ///< mm; X on a lathe is a radius
};
/// Places of the machine in its own coordinates, mm; X of a lathe is a radius.
struct MachinePlaces {
  std::vector<WorkOffset> zero;  ///< work zeros; empty: where the machine's zero lies is unknown
  Vec3 reference;                ///< where G28 and G74 lead
  std::optional<Vec3> second;    ///< where G30 and G75 lead
  std::optional<Box3> limits;    ///< of travel; infinite where an axis has none
};
struct ToolTable {
  std::vector<Tool> tools;
  std::vector<OffsetRegister> offsets;
  std::vector<WorkOffset> work;
};

/// Where the faces of one owner come from. A mesh carries the owners that its faces name, so that a
/// file can say which line of which program, with which tool, cut a face.
struct FaceOrigin {
  std::int32_t owner = -1;  ///< as in TriMesh::owners; -1 is the stock and needs no entry
  std::int32_t file = -1;   ///< index into OwnerTable::files, -1 = unknown
  std::int32_t line = 0;    ///< 1-based, 0 = unknown
  std::int32_t tool = -1;   ///< index into OwnerTable::tools, -1 = unknown
  friend bool operator==(const FaceOrigin&, const FaceOrigin&) = default;
};
struct OwnerTable {
  std::vector<std::string> files;   ///< programs, main program first
  std::vector<std::string> tools;   ///< ids of the tools, "4"
  std::vector<FaceOrigin> origins;  ///< ascending by owner, each owner once
  friend bool operator==(const OwnerTable&, const OwnerTable&) = default;
};

/// A colour (sRGB) with what a legend says of it.
struct ColorLabel {
  std::array<std::uint8_t, 3> color{};
  std::string text;
  friend bool operator==(const ColorLabel&, const ColorLabel&) = default;
};

/// An indexed triangle mesh. Vertices are float because files are: what was checked is what is
/// written.
struct TriMesh {
  std::vector<std::array<float, 3>> vertices;  ///< #V by 3, mm
  std::vector<std::array<std::uint32_t, 3>>
      triangles;  ///< #F by 3, counter-clockwise seen from outside
  std::vector<std::int32_t>
      owners;  ///< #F or empty: index of the motion that cut the face, -1 = stock
  std::vector<std::array<std::uint8_t, 3>>
      colors;  ///< #V or empty: sRGB of each vertex, for pictures and files (deviation)
  std::vector<ColorLabel> legend;  ///< what `colors` stand for, from high to low; may be empty
  OwnerTable origin;               ///< what `owners` stand for; may be empty
};

/// What a mesh is, and whether it keeps mrsim's promises.
struct MeshSummary {
  bool closed = false;    ///< every edge has two triangles
  bool oriented = false;  ///< ... that run through it in opposite directions, and the volume is
                          ///< positive
  bool manifold = false;  ///< ... and every vertex has one fan
  bool inverted = false;  ///< closed, but inside out: the volume is negative
  std::size_t degenerate = 0;  ///< triangles without area
  double volume = 0;           ///< mm^3, signed
  double area = 0;             ///< mm^2
  long euler = 0;              ///< V - E + F
  std::size_t components = 0;  ///< pieces of surface (a cavity is one of its own)
  Box3 bounds;                 ///< mm
  std::string first_fault;     ///< empty, or a sentence with the place
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
