#include "interp/control/start_modes.h"

namespace mrsim {
namespace {

struct StartRow {
  Dialect dialect;
  MachineKind machine;
  Code motion;
  int plane;
  FeedUnit feed_unit;
  Code diameter;
  Code corner;
  const char *motion_name, *plane_name, *feed_name, *diameter_name, *units_name, *corner_name;
};

using C = Code;
constexpr auto kMin = FeedUnit::mm_per_min;
constexpr auto kRev = FeedUnit::mm_per_rev;

// SINUMERIK mills start in the reset state of the maker (docs/interp.md), lathes as PRIMER_2S
// needs.
constexpr StartRow kRows[] = {
    {Dialect::sinumerik, MachineKind::mill, C::line, kPlaneXY, kMin, C::diameter_off, C::corner_arc,
     "G1", "G17", "G94", "DIAMOF", "G71", "G450"},
    {Dialect::sinumerik, MachineKind::lathe, C::line, kPlaneZX, kRev, C::diameter_on, C::corner_arc,
     "G1", "G18", "G95", "DIAMON", "G71", "G450"},
    {Dialect::iso, MachineKind::mill, C::rapid, kPlaneXY, kMin, C::diameter_off,
     C::corner_intersection, "G0", "G17", "G94", "X is a length", "G71", "intersection"},
    {Dialect::iso, MachineKind::lathe, C::rapid, kPlaneZX, kRev, C::diameter_on,
     C::corner_intersection, "G0", "G18", "G95", "X is a diameter", "G71", "intersection"},
    {Dialect::fanuc, MachineKind::mill, C::rapid, kPlaneXY, kMin, C::diameter_off,
     C::corner_intersection, "G0", "G17", "G94", "X is a length", "G21", "intersection"},
    {Dialect::fanuc, MachineKind::lathe, C::rapid, kPlaneZX, kRev, C::diameter_on,
     C::corner_intersection, "G0", "G18", "G99 (per revolution)", "X and U are diameters", "G21",
     "intersection"},
    {Dialect::ngc, MachineKind::mill, C::rapid, kPlaneXY, kMin, C::diameter_off, C::corner_arc,
     "G0", "G17", "G94", "G8 (radius)", "G21", "arc"},
    {Dialect::ngc, MachineKind::lathe, C::rapid, kPlaneZX, kMin, C::diameter_off, C::corner_arc,
     "G0", "G18", "G94", "G8 (radius)", "G21", "arc"},
    {Dialect::codesys, MachineKind::mill, C::line, kPlaneXY, kMin, C::diameter_off, C::corner_arc,
     "G1", "G15 (X/Y)", "per minute", "none", "mm", "arc"},
    {Dialect::codesys, MachineKind::lathe, C::line, kPlaneXY, kMin, C::diameter_off, C::corner_arc,
     "G1", "G15 (X/Y)", "per minute", "none", "mm", "arc"},
};

const StartRow& row_of(Dialect dialect, MachineKind machine) {
  for (const StartRow& row : kRows)
    if (row.dialect == dialect && row.machine == machine) return row;
  return kRows[0];
}

}  // namespace

Modal start_modal(Dialect dialect, MachineKind machine) {
  const StartRow& row = row_of(dialect, machine);
  Modal m;
  m.motion = row.motion;
  m.plane = row.plane;
  m.feed_unit = row.feed_unit;
  m.diameter = row.diameter;
  m.corner = row.corner;
  if (dialect == Dialect::ngc) {
    m.edge = 0;  // the radius of the tool in the spindle
    m.hole_return = HoleReturn::safe;
  }
  return m;
}

std::vector<std::pair<std::string, std::string>> start_mode_names(Dialect dialect,
                                                                  MachineKind machine) {
  const StartRow& row = row_of(dialect, machine);
  std::vector<std::pair<std::string, std::string>> names = {
      {"motion", row.motion_name},  {"plane", row.plane_name},      {"distance", "G90"},
      {"units", row.units_name},    {"feed", row.feed_name},        {"compensation", "G40"},
      {"corners", row.corner_name}, {"diameter", row.diameter_name}};
  const char* work = dialect == Dialect::sinumerik ? "G500"
                     : dialect == Dialect::codesys ? "G53"
                                                   : "G54";
  names.emplace_back("work offset", work);
  if (dialect == Dialect::codesys) names.emplace_back("centre", "G99 (relative)");
  if (dialect == Dialect::sinumerik) names.emplace_back("approach", "NORM");
  return names;
}

const char* dialect_name(Dialect dialect) {
  switch (dialect) {
    case Dialect::sinumerik:
      return "sinumerik";
    case Dialect::iso:
      return "iso";
    case Dialect::fanuc:
      return "fanuc";
    case Dialect::codesys:
      return "codesys";
    case Dialect::ngc:
      return "ngc";
    default:
      return "automatic";
  }
}

}  // namespace mrsim
