/// mrsim: one options struct per stage, each field with its default and range. Standard library
/// types only.
#pragma once

#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {

/// Called now and then with the stage and the share done in [0, 1], from any thread but never from
/// two at once. Returning false stops the run with Error "cancelled".
using Progress = std::function<bool(const char* stage, double fraction)>;

/// What G41 and G42 offset by when the program's D register is not in the tool table.
enum class CompRadius : std::uint8_t {
  automatic,  ///< the tool's own radius, with a warning
  radius,     ///< the tool's own radius
  wear,       ///< nothing: the program holds the path of the tool's centre, D is wear alone
  off,        ///< nothing, whatever the table says
};

struct InterpOptions {
  /// The control whose words the program uses. Default: recognised from the text, with the reason
  /// in Program.
  Dialect dialect = Dialect::automatic;
  /// Mill or lathe. Default: by the rule in docs/interp.md; no or mixed evidence is an Error of
  /// kind usage.
  MachineKind machine = MachineKind::automatic;
  /// Position before the first move, mm. Default: unknown; such moves carry Motion::assumed_start.
  std::optional<Vec3> start;
  /// Skip levels in force: bit n skips blocks that begin with "/n" ("/" is "/0"). Default: none.
  unsigned block_skip = 0;
  /// Folders searched for subprograms after the program's own; SINUMERIK: also files of DEF lines.
  std::vector<std::string> search_path;
  /// Known tools, registers and work offsets; an empty id is the tool of a program that names none.
  ToolTable table;
  /// Where the machine's own coordinates and reference points lie. Default: unknown.
  MachinePlaces places;
  /// Print the contour instead of the compensated tool reference point.
  bool programmed_contour = false;
  /// FANUC: numbers without a decimal point count least increments (0.001 mm, 0.0001 inch) instead
  /// of millimetres.
  bool least_increments = false;
  /// Radius compensation without a register.
  CompRadius comp = CompRadius::automatic;
  /// A program that cuts and names no tool at all is an error; false (trace, check): a warning.
  bool require_tools = true;
  /// Blocks run in all, repeated subprograms included; more is the error "program-endless".
  std::uint64_t max_blocks = 4'000'000'000;
  /// Jumps, passes of loops, calls and repeats in all; more is the error "program-endless".
  std::uint64_t max_steps = 10'000'000;
  /// Variables that have a value before the program starts: "R1", "#100", "#<_name>", and a number
  /// or, for SINUMERIK, a text.
  std::vector<std::pair<std::string, std::string>> variables;
  /// Hand every assignment to the sink as it happens.
  bool trace_variables = false;
};

/// A mesh that bounds no solid is wrapped (docs/formats.md).
struct StockWrap {
  double distance = 0;  ///< mm: the wrap keeps to this where the surface has no gaps; 0 = no wrap
  double gap = 0;       ///< mm: narrower gaps and grooves are closed; 0 = ten distances
};

struct StockOptions {
  /// Replace a mesh that is a box, a cylinder or a tube by that exact solid.
  bool exact_primitives = true;
  StockWrap wrap;
  Progress progress;
};

struct CarveOptions {
  /// Voxel edge in mm. Requires: > 0, or 0 for the default (docs/removal.md).
  double voxel = 0;
  /// Threads, 0 = all cores. The result does not depend on it.
  int threads = 0;
  /// Bytes of memory the run may take, 0 = what the machine has free. A run whose estimate is above
  /// it is done in slabs, or refused where it can not be.
  std::size_t max_memory = 0;
  Progress progress;
};

struct CollisionOptions {
  /// Deeper than this, in mm, is a collision; less is a touch. Requires: >= 0.001.
  double depth = 0.01;
  /// Lines of the program that are measured and reported; those beyond are counted.
  std::size_t lines = 20;
  /// Threads, 0 = all cores. The result does not depend on it.
  int threads = 0;
  Progress progress;
};

struct MeshOptions {
  /// Largest distance in mm between the mesh and the exact part, both ways. 0 = as the voxel gives;
  /// simulate() then takes 0.017 % of the longest side unless the voxel is given.
  double tolerance = 0;
  int threads = 0;
  Progress progress;
};

/// Which of the pieces that no material joins stay in the part.
enum class KeepPieces : std::uint8_t { all, largest };

/// What the colour of a face shows.
enum class ColorBy : std::uint8_t { none, line, tool };

/// How a mesh is written to a file.
struct MeshFileOptions {
  /// Colours of the faces where the format has colours. The owners themselves (file, line, tool)
  /// are written where the format has room for them, whatever this says.
  ColorBy color = ColorBy::none;
  /// Text instead of binary where a format has both (STL).
  bool ascii = false;
  /// Threads, 0 = all cores. The bytes do not depend on it.
  int threads = 0;
};

/// The machine's axis that points up in a picture. Automatic: X, so that the axis Z lies, for parts
/// whose walls are turned about Z; else Z.
enum class UpAxis { automatic, x, z };

struct RenderOptions {
  /// Picture size in pixels. Requires: 16 .. 8192.
  int width = 1600, height = 1200;
  /// Viewing direction: angle about the vertical from the front, and above the ground; degrees.
  double azimuth = 30, elevation = 35;
  UpAxis up = UpAxis::automatic;
  /// Draw edges where faces meet at more than this many degrees; 0 = none.
  double edge_angle = 25;
  /// Colour the faces by what cut them, with a legend. TriMesh::colors, where given, come first.
  ColorBy color = ColorBy::none;
  /// Darken corners and pockets by how little sky they see.
  bool ambient_occlusion = true;
  /// Let the part throw a shadow on the ground.
  bool ground = true;
  /// A line of text below the part. Default: its size.
  std::string caption;
  int threads = 0;
};

}  // namespace mrsim
