/// mrsim: tools as their user describes them, and what a control knows of them and of the machine.
#pragma once

#include <mrsim/geometry.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mrsim {

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

}  // namespace mrsim
