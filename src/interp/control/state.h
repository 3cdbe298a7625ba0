// The state of a control as plain values, so that a rejected block can be undone by a copy.
#pragma once

#include "core/numbers/axis_set.h"
#include "interp/path/frames.h"
#include "interp/text/codes.h"

#include <cstdint>
#include <optional>
#include <string>

namespace mrsim {

/// A value of a drilling cycle as it was written.
struct CycleLevel {
  double value = 0;  ///< mm
  bool incremental = false;
  bool given = false;
};

/// A drilling cycle in force (G73 ... G89): what its blocks have said so far.
struct DrillCycle {
  int number = 0;                         ///< of the G word, 0 = none
  CycleLevel safe, bottom;                ///< R and Z
  double peck = 0;                        ///< Q, mm
  double first = 0, less = 0, least = 0;  ///< Haas: strokes by I J K, mm
  double out_every = 0;                   ///< Haas: depth between the ways out of G73, mm
  double initial = 0;                     ///< level along the plane's normal before the first cycle
  bool begun = false;                     ///< `initial` counts
  bool dwells = false;                    ///< P was given
  double dwell = 0;                       ///< the value of P, s
  bool fagor = false;                     ///< the cycle is Fagor's, with the depth in I
  bool pitched = false;                   ///< Brother's taps: I is the lead, J threads per inch
  double lead = 0;                        ///< mm; 0: the lead of a tap is its feed / speed
  int plane = -1;  ///< lathes: kPlaneXY along Z, kPlaneYZ along X; -1 = that in force
  int file = 0, line = 0, call = -1;  ///< where the block stands that chose the cycle
};

/// A pocket of Fagor, mm: G87 a rectangle, G88 a circle.
struct FagorPocket {
  int number = 0;                          ///< 0 = none
  CycleLevel reference, depth;             ///< Z and I
  double half_length = 0, half_width = 0;  ///< J and K; of a circle J is the radius
  bool clockwise = false;                  ///< J above 0
  double infeed = 0, width = 0;            ///< B and C
  double above = 0;                        ///< D: height of the level of Z over the part
  double initial = 0;                      ///< level before the cycle
  bool begun = false;                      ///< `initial` counts
};

/// A turning cycle in force: G90, G92 or G94 of a FANUC lathe.
struct TurnCycle {
  int number = 0;       ///< 0 = none
  double x = 0, z = 0;  ///< the end, in the frame in force, X as radius
  AxisSet named;        ///< axes of the end that were given
  double taper = 0;     ///< mm
  double lead = 0;      ///< mm per revolution
};

/// What the first lines of G71 to G76 have set.
struct TurnSettings {
  double depth = 0, escape = 0;        ///< G71 G72: of a pass, and back at its end, mm
  double shift_x = 0, shift_z = 0;     ///< G73: from the first pass to the last, mm
  int repeats = 1;                     ///< G73: passes
  bool thousandths = false;            ///< G71 to G73: words without a point are thousandths
  bool pockets = false;                ///< G71 G72: the contour may have some (H of Mitsubishi)
  double peck_return = 0;              ///< G74 G75, mm
  int finishes = 1;                    ///< G76: passes at the full depth
  double chamfer = 0;                  ///< G76: in leads
  double angle = 0;                    ///< G76: of the tip, degrees
  double least_depth = 0, finish = 0;  ///< G76, mm
};

/// The height at which a drilling cycle ends: G98, G99, and M53 of Okuma.
enum class HoleReturn { initial, safe, level };

/// The axes of each plane by Modal::plane: its first, its second, and the one across it.
inline constexpr int kFirstOfPlane[] = {0, 2, 1, 0}, kSecondOfPlane[] = {1, 0, 2, 1},
                     kNormalOfPlane[] = {2, 1, 0, 2};

/// What modal G words and values have set.
struct Modal {
  Code motion = Code::line;
  int plane = kPlaneXY;  ///< or kPlaneZX, kPlaneYZ, kPlaneOfNormal
  Vec3 normal{0, 0, 1};  ///< CODESYS G16
  bool incremental = false;
  bool has_increments = false;  ///< the program has said G91, or other words of systems B and C
  bool inch = false;            ///< lengths
  /// The unit of a number without a point, in the program's unit of length.
  double least_increment() const { return inch ? 1e-4 : 1e-3; }
  bool inch_feed = false;        ///< feeds
  bool units_given = false;      ///< by a G word of the program
  bool center_absolute = false;  ///< CODESYS G98
  bool center_told = false;      ///< the program has said whether it is
  bool polar = false;            ///< FANUC G16
  Code diameter = Code::diameter_off;
  bool diameter_told = false;  ///< by a word of the program
  FeedUnit feed_unit = FeedUnit::mm_per_min;
  bool feed_of_turn = false;  ///< the feed in force was told in mm per revolution
  bool surface_speed = false;
  double feed = 0, speed = 0, cutting_speed = 0;  ///< mm, rev/min, m/min
  double speed_limit = 0;                         ///< rev/min of the spindle; 0: none
  double lead = 0;                                ///< mm per revolution, of the thread in force
  bool lead_apart = false;                        ///< the last lead stood in E or K, not in F
  Code comp = Code::comp_off;
  bool comp_suspended = false;
  bool comp_diameter = false;  ///< G41.1 G42.1: D is the diameter of the tool, see edge_radius
  int comp_tip = 0;            ///< tip orientation by L of G41.1 G42.1, as Tool::tip; 0: centre
  Code corner = Code::corner_arc;
  Code approach = Code::approach_normal;
  double disc = 0;
  double offn = 0;  ///< allowance on the contour under G41 and G42, mm
  double rndm = 0, frcm = 0;
  int edge = 1;  ///< D number; CODESYS: see edge_radius
  bool edge_given = false;
  double edge_radius = 0;  ///< CODESYS: D, mm
  bool system_c =
      false;           ///< code system C of FANUC lathes: G72 to G78 are the cycles G70 to G76 of A
  bool okuma = false;  ///< words of OSP: G53 and G56 H are lengths of tools, G71 is a thread
  Code length = Code::length_off;
  double length_offset = 0;  ///< mm along the tool axis
  double length_number = 0;  ///< the last H
  bool length_told = false;  ///< the tool table has the length of the last H
  DrillCycle drill;
  FagorPocket pocket;  ///< in force where `drill` has its number
  HoleReturn hole_return = HoleReturn::initial;
  bool return_told = false;            ///< by a word of the program
  std::optional<double> return_level;  ///< G71 Z of Okuma, mm
  TurnCycle turn;
  TurnSettings turn_settings;
};

/// Where the tool is, and how it came there.
struct Position {
  Vec3 programmed;      ///< in the frame in force, mm, X as radius
  Vec3 physical;        ///< in the stock's coordinates
  AxisSet known;        ///< the axes whose place is given by the program or the user
  Vec3 retained;        ///< programmed values before the frame changed (G91 travels from them)
  AxisSet moved_frame;  ///< axes for which `retained` still holds
  Vec3 tangent;         ///< direction of the last element at its end, in the stock's coordinates
  bool has_tangent = false;
  Vec2 spline_end;            ///< the last control point of a G5, from its end
  bool after_spline = false;  ///< the last element was a G5
  Vec3 before;                ///< in the frame in force: where the last feed in the plane began
  bool has_before = false;
  Vec3 pole;                                 ///< in the frame in force
  double polar_angle = 0, polar_radius = 0;  ///< last programmed, degrees and mm
  bool has_polar_angle = false, has_polar_radius = false;
  bool new_tool = false;    ///< no motion since another tool came
  AxisSet told_axes;        ///< axes that G50 of a lathe has set since the last motion
  Vec3 told, shift_before;  ///< the values of that G50, and Frames::position_shift before it
};

/// The frames that together make the frame in force.
struct Frames {
  Vec3 work;                        ///< settable offset (G54 ...)
  double work_turn = 0;             ///< of the settable offset about Z, degrees (G10 L2 R)
  std::string work_name;            ///< "G54", empty = off
  bool work_given = false;          ///< the tool table or the program gives this work offset
  Vec3 position_shift;              ///< G92
  Vec3 position_memory;             ///< the shift of G92 that G92.2 set aside
  Vec3 local;                       ///< G52
  Vec3 fine;                        ///< the part of program.shift that ATRANS and G59 added
  Frame swivel;                     ///< CYCLE800 without a tilt
  Frame program;                    ///< TRANS ROT SCALE MIRROR; CODESYS: the decoder frame
  Frame rotation, scaling, mirror;  ///< FANUC G68, G51, G51.1
  double rotation_angle = 0;        ///< of G68 or G73, degrees
  Vec3 rotation_at;                 ///< centre of G73 (Fagor)
  Vec3 mirror_at;
  AxisSet mirrored;          ///< axes under G51.1
  AxisSet local_axes;        ///< axes with a word in Okuma's G11 in force
  bool local_angle = false;  ///< Okuma's G11 in force has the angle P
  Frame total;

  /// Whether Okuma's G11 is in force.
  bool turned_locally() const { return !local_axes.empty() || local_angle; }
};

}  // namespace mrsim
