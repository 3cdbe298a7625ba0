#include "interp/text/codes.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace mrsim {
namespace {

struct Row {
  int number;  // G number * 10
  Code code;
  Group group;
};

using C = Code;
using G = Group;

constexpr Row kShared[] = {{0, C::rapid, G::motion},          {10, C::line, G::motion},
                           {20, C::arc_cw, G::motion},        {30, C::arc_ccw, G::motion},
                           {40, C::dwell, G::oneshot},        {170, C::plane_xy, G::plane},
                           {180, C::plane_zx, G::plane},      {190, C::plane_yz, G::plane},
                           {400, C::comp_off, G::comp},       {410, C::comp_left, G::comp},
                           {420, C::comp_right, G::comp},     {900, C::absolute, G::distance},
                           {910, C::incremental, G::distance}};

constexpr Row kSinumerik[] = {
    {90, C::ignored, G::other},
    {250, C::speed_limit, G::frame},
    {260, C::speed_limit, G::frame},
    {330, C::thread, G::motion},
    {340, C::thread_growing, G::motion},
    {350, C::thread_shrinking, G::motion},
    {530, C::suppress_frames, G::suppress},
    {580, C::trans_coarse, G::frame},
    {590, C::trans_fine, G::frame},
    {600, C::ignored, G::path},
    {630, C::tap_floating, G::oneshot},
    {640, C::ignored, G::path},
    {700, C::inch, G::units},
    {710, C::metric, G::units},
    {740, C::reference_approach, G::oneshot},
    {750, C::fixed_point, G::oneshot},
    {930, C::inverse_time, G::feed},
    {940, C::per_minute, G::feed},
    {950, C::per_revolution, G::feed},
    {960, C::surface_speed, G::feed},
    {970, C::surface_speed_off, G::feed},
    {1100, C::pole_position, G::frame},
    {1110, C::pole_zero, G::frame},
    {1120, C::pole_pole, G::frame},
    {1400, C::ignored, G::approach_side},
    {1410, C::ignored, G::approach_side},
    {1420, C::ignored, G::approach_side},
    {1430, C::ignored, G::approach_side},
    {1470, C::unsupported, G::oneshot},
    {1480, C::unsupported, G::oneshot},
    {1530, C::suppress_frames, G::suppress},
    {2470, C::unsupported, G::oneshot},
    {2480, C::unsupported, G::oneshot},
    {2900, C::ignored, G::other},
    {2910, C::unsupported, G::other},
    {3310, C::tap_in, G::motion},
    {3320, C::tap_out, G::motion},
    {3400, C::ignored, G::approach_path},
    {3410, C::ignored, G::approach_path},
    {3470, C::unsupported, G::oneshot},
    {3480, C::unsupported, G::oneshot},
    {4500, C::corner_arc, G::corner},
    {4510, C::corner_intersection, G::corner},
    {4600, C::ignored, G::retract},
    {4610, C::ignored, G::retract},
    {4620, C::ignored, G::retract},
    {5000, C::work_off, G::work},
    {6010, C::ignored, G::exact},
    {6020, C::ignored, G::exact},
    {6030, C::ignored, G::exact},
    {6410, C::ignored, G::path},
    {6420, C::ignored, G::path},
    {6430, C::ignored, G::path},
    {6440, C::ignored, G::path},
    {6450, C::ignored, G::path},
    {7000, C::inch_feed, G::units},
    {7100, C::metric_feed, G::units},
    {9610, C::surface_speed, G::feed},
    {9620, C::surface_speed, G::feed},
    {9710, C::surface_speed_off, G::feed},
};

// FANUC words that mean the same on mills and lathes.
constexpr Row kFanuc[] = {
    {50, C::high_speed, G::path},
    {51, C::high_speed, G::path},
    {70, C::unsupported, G::other},
    {71, C::unsupported, G::other},
    {80, C::high_speed, G::path},
    {90, C::ignored, G::exact},
    {100, C::data_setting, G::oneshot},
    {101, C::ignored_words, G::oneshot},
    {110, C::ignored, G::oneshot},
    {121, C::unsupported, G::other},
    {131, C::ignored, G::other},
    {200, C::inch_feed, G::units},
    {210, C::metric_feed, G::units},
    {220, C::ignored_words, G::oneshot},
    {230, C::ignored, G::other},
    {250, C::ignored, G::other},
    {260, C::ignored, G::other},
    {270, C::reference_check, G::oneshot},
    {280, C::reference, G::oneshot},
    {281, C::ignored, G::oneshot},
    {290, C::unsupported, G::oneshot},
    {300, C::reference_second, G::oneshot},
    {301, C::ignored, G::oneshot},
    {310, C::probe, G::oneshot},
    {411, C::comp_left, G::comp},
    {421, C::comp_right, G::comp},
    {434, C::unsupported, G::length},
    {435, C::unsupported, G::length},
    {520, C::local_shift, G::oneshot},
    {530, C::suppress_frames, G::oneshot},
    {531, C::unsupported, G::oneshot},
    {541, C::work_extended, G::work},
    {542, C::unsupported, G::work},
    {591, C::work_offset, G::work},
    {592, C::work_offset, G::work},
    {593, C::work_offset, G::work},
    {610, C::ignored, G::path},
    {611, C::ignored, G::path},
    {640, C::ignored, G::path},
    {650, C::unsupported, G::oneshot},
    {660, C::unsupported, G::other},
    {670, C::ignored, G::other},
    {682, C::unsupported, G::rotation},
    {683, C::unsupported, G::rotation},
    {684, C::unsupported, G::rotation},
    {691, C::ignored, G::rotation},
    {800, C::cycle_off, G::other},
    {901, C::center_absolute, G::other},
    {911, C::center_relative, G::other},
    {960, C::surface_speed, G::speed},
    {970, C::surface_speed_off, G::speed},
    {1001, C::unsupported, G::oneshot},
    {1030, C::ignored_words, G::oneshot},
    {1070, C::unsupported, G::other},
    {1120, C::unsupported, G::other},
    {1130, C::ignored, G::other},
    {1430, C::unsupported, G::length},
    {1540, C::work_extended, G::work},
    {1870, C::ignored_words, G::oneshot},
    {2340, C::unsupported, G::length},
    {2540, C::unsupported, G::oneshot},
    {2550, C::ignored, G::other},
};

constexpr Row kFanucMill[] = {
    {120, C::circle_pocket, G::oneshot},
    {130, C::circle_pocket, G::oneshot},
    {150, C::polar_off, G::polar},
    {160, C::polar_on, G::polar},
    {330, C::thread, G::motion},
    {390, C::unsupported, G::oneshot},
    {430, C::length_plus, G::length},
    {431, C::unsupported, G::length},
    {440, C::length_minus, G::length},
    {450, C::unsupported, G::oneshot},
    {460, C::unsupported, G::oneshot},
    {470, C::unsupported, G::oneshot},
    {480, C::unsupported, G::oneshot},
    {490, C::length_off, G::length},
    {500, C::scaling_off, G::scaling},
    {501, C::mirror_off, G::mirror},
    {510, C::scaling_on, G::scaling},
    {511, C::mirror_on, G::mirror},
    {600, C::one_way, G::oneshot},
    {620, C::ignored, G::path},
    {630, C::ignored, G::path},
    {680, C::rotation_on, G::rotation},
    {690, C::rotation_off, G::rotation},
    {700, C::hole_pattern, G::oneshot},
    {710, C::hole_pattern, G::oneshot},
    {720, C::hole_pattern, G::oneshot},
    {730, C::drill_cycle, G::other},
    {740, C::drill_cycle, G::other},
    {760, C::drill_cycle, G::other},
    {920, C::set_position, G::oneshot},
    {921, C::position_reset, G::oneshot},
    {922, C::position_suspend, G::oneshot},
    {923, C::position_resume, G::oneshot},
    {930, C::inverse_time, G::feed},
    {940, C::per_minute, G::feed},
    {950, C::per_revolution, G::feed},
    {980, C::return_initial, G::center},
    {990, C::return_r, G::center},
    {1500, C::unsupported, G::oneshot},
};

constexpr Row kFanucLathe[] = {
    {320, C::thread, G::motion},         {330, C::thread, G::motion},
    {340, C::thread_growing, G::motion}, {430, C::length_plus, G::length},
    {490, C::length_off, G::length},     {500, C::set_position, G::oneshot},
    {680, C::unsupported, G::other},     {690, C::ignored, G::other},
    {700, C::turn_cycle, G::oneshot},    {710, C::turn_cycle, G::oneshot},
    {720, C::turn_cycle, G::oneshot},    {730, C::turn_cycle, G::oneshot},
    {740, C::turn_cycle, G::oneshot},    {750, C::turn_cycle, G::oneshot},
    {760, C::turn_cycle, G::oneshot},    {920, C::turn_pass, G::motion},
    {940, C::turn_pass, G::motion},      {950, C::per_revolution, G::feed},
    {980, C::per_minute, G::feed},       {990, C::per_revolution, G::feed},
};

constexpr Row kIso[] = {
    {50, C::high_speed, G::path},
    {51, C::high_speed, G::path},
    {70, C::unsupported, G::path},
    {80, C::unsupported, G::path},
    {90, C::ignored, G::exact},
    {100, C::data_setting, G::oneshot},
    {200, C::inch_feed, G::units},
    {210, C::metric_feed, G::units},
    {280, C::reference, G::oneshot},
    {300, C::reference_second, G::oneshot},
    {330, C::thread, G::motion},
    {430, C::length_plus, G::length},
    {440, C::length_minus, G::length},
    {490, C::length_off, G::length},
    {500, C::ignored, G::path},
    {520, C::local_shift, G::oneshot},
    {530, C::suppress_frames, G::oneshot},
    {600, C::ignored, G::path},
    {610, C::ignored, G::path},
    {611, C::ignored, G::path},
    {640, C::ignored, G::path},
    {700, C::hole_pattern, G::oneshot},
    {710, C::hole_pattern, G::oneshot},
    {800, C::cycle_off, G::other},
    {901, C::center_absolute, G::other},
    {911, C::center_relative, G::other},
    {920, C::set_position, G::oneshot},
    {930, C::inverse_time, G::feed},
    {940, C::per_minute, G::feed},
    {950, C::per_revolution, G::feed},
    {960, C::surface_speed, G::speed},
    {970, C::surface_speed_off, G::speed},
};

constexpr Row kCodesys[] = {
    {50, C::unsupported, G::motion},      {60, C::unsupported, G::motion},
    {80, C::unsupported, G::motion},      {90, C::unsupported, G::motion},
    {100, C::unsupported, G::motion},     {120, C::unsupported, G::motion},
    {150, C::plane_2d, G::plane},         {160, C::plane_normal, G::plane},
    {200, C::unsupported, G::oneshot},    {360, C::unsupported, G::oneshot},
    {370, C::unsupported, G::oneshot},    {380, C::unsupported, G::oneshot},
    {430, C::decoder_length, G::length},  {500, C::path_smoothing, G::path},
    {510, C::path_smoothing, G::path},    {520, C::path_smoothing, G::path},
    {530, C::decoder_reset, G::oneshot},  {540, C::decoder_set, G::oneshot},
    {550, C::decoder_add, G::oneshot},    {560, C::decoder_here, G::oneshot},
    {600, C::ignored, G::exact},          {610, C::ignored, G::exact},
    {700, C::ignored, G::other},          {710, C::ignored, G::other},
    {750, C::ignored, G::oneshot},        {920, C::position_jump, G::oneshot},
    {980, C::center_absolute, G::center}, {990, C::center_relative, G::center},
};

constexpr Row kNgc[] = {
    {50, C::spline_cubic, G::motion},
    {51, C::spline_quadratic, G::motion},
    {52, C::nurbs, G::motion},
    {53, C::nurbs_end, G::motion},
    {70, C::diameter_on, G::diameter},
    {80, C::diameter_off, G::diameter},
    {100, C::data_setting, G::oneshot},
    {171, C::unsupported, G::plane},
    {181, C::unsupported, G::plane},
    {191, C::unsupported, G::plane},
    {200, C::inch_feed, G::units},
    {210, C::metric_feed, G::units},
    {280, C::reference, G::oneshot},
    {281, C::ignored, G::oneshot},
    {300, C::reference_second, G::oneshot},
    {301, C::ignored, G::oneshot},
    {330, C::thread, G::motion},
    {331, C::tap_return, G::motion},
    {382, C::probe, G::motion},
    {383, C::probe, G::motion},
    {384, C::probe, G::motion},
    {385, C::probe, G::motion},
    {411, C::comp_left, G::comp},
    {421, C::comp_right, G::comp},
    {430, C::length_plus, G::length},
    {431, C::length_dynamic, G::length},
    {432, C::length_add, G::length},
    {490, C::length_off, G::length},
    {520, C::local_shift, G::oneshot},
    {530, C::suppress_frames, G::suppress},
    {591, C::work_offset, G::work},
    {592, C::work_offset, G::work},
    {593, C::work_offset, G::work},
    {610, C::ignored, G::path},
    {611, C::ignored, G::path},
    {640, C::ignored_words, G::path},
    {700, C::unsupported, G::other},
    {710, C::unsupported, G::other},
    {711, C::unsupported, G::other},
    {712, C::unsupported, G::other},
    {720, C::unsupported, G::other},
    {721, C::unsupported, G::other},
    {722, C::unsupported, G::other},
    {730, C::drill_cycle, G::motion},
    {740, C::drill_cycle, G::motion},
    {760, C::turn_cycle, G::oneshot},
    {800, C::cycle_off, G::motion},
    {901, C::center_absolute, G::center},
    {911, C::center_relative, G::center},
    {920, C::set_position, G::oneshot},
    {921, C::position_reset, G::oneshot},
    {922, C::position_suspend, G::oneshot},
    {923, C::position_resume, G::oneshot},
    {930, C::inverse_time, G::feed},
    {940, C::per_minute, G::feed},
    {950, C::per_revolution, G::feed},
    {960, C::surface_speed, G::speed},
    {970, C::surface_speed_off, G::speed},
    {980, C::return_initial, G::retract},
    {990, C::return_r, G::retract},
};

constexpr std::pair<int, std::string_view> kUnsupportedNames[] = {
    {50, "a spline"},
    {51, "a spline"},
    {70, "a hypothetical axis"},
    {71, "cylindrical interpolation"},
    {80, "an arc tangent to the path before"},
    {121, "polar interpolation"},
    {290, "a return from the reference point"},
    {330, "a thread"},
    {390, "a corner arc"},
    {434, "tool centre point control"},
    {435, "tool centre point control"},
    {450, "an offset of the tool's position"},
    {460, "an offset of the tool's position"},
    {470, "an offset of the tool's position"},
    {480, "an offset of the tool's position"},
    {531, "a move of the tilted axes"},
    {542, "a dynamic work offset"},
    {650, "a macro call"},
    {660, "a modal macro call"},
    {680, "a rotation"},
    {682, "a tilted working plane"},
    {683, "a tilted working plane"},
    {684, "a tilted working plane"},
    {1070, "cylindrical interpolation"},
    {1120, "polar interpolation"},
    {1430, "tool centre point control"},
    {1500, "a pocket"},
    {2340, "tool centre point control"},
    {2540, "a dynamic work offset"},
};

const Row* find_row(std::span<const Row> rows, int number) {
  const auto at =
      std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.number == number; });
  return at == rows.end() ? nullptr : &*at;
}

// Work offsets and drilling cycles are ranges, not rows.
CodeEntry find_range(Dialect dialect, int number) {
  if (number % 10 != 0 || dialect == Dialect::codesys) return {};
  const int g = number / 10;
  const bool sinumerik = dialect == Dialect::sinumerik;
  if (g >= 54 && g <= (sinumerik ? 57 : 59)) return {C::work_offset, G::work, g};
  if (sinumerik && g >= 505 && g <= 599) return {C::work_offset, G::work, g};
  if (!sinumerik && g >= 81 && g <= 89)
    return {C::drill_cycle, dialect == Dialect::ngc ? G::motion : G::other, g};
  if (dialect == Dialect::fanuc && g >= 110 && g <= 129 && g != 112 && g != 113)
    return {C::work_offset, G::work, g};
  return {};
}

std::span<const Row> own_rows(Dialect dialect) {
  switch (dialect) {
    case Dialect::sinumerik:
      return kSinumerik;
    case Dialect::fanuc:
      return kFanuc;
    case Dialect::codesys:
      return kCodesys;
    case Dialect::ngc:
      return kNgc;
    default:
      return kIso;
  }
}

}  // namespace

CodeEntry find_g_code(Dialect dialect, MachineKind machine, int number_by_10) {
  const Row* row = nullptr;
  if (dialect == Dialect::fanuc)
    row = machine == MachineKind::lathe ? find_row(kFanucLathe, number_by_10)
                                        : find_row(kFanucMill, number_by_10);
  if (!row) row = find_row(own_rows(dialect), number_by_10);
  // What the common subset leaves open means what FANUC's words mean.
  if (!row && dialect == Dialect::iso && machine != MachineKind::lathe)
    row = find_row(kFanucMill, number_by_10);
  if (!row && dialect == Dialect::iso) row = find_row(kFanuc, number_by_10);
  if (!row) row = find_row(kShared, number_by_10);
  if (row) return {row->code, row->group, number_by_10 / 10};
  return find_range(dialect, number_by_10);
}

std::string_view unsupported_code(Dialect dialect, int number_by_10) {
  if (dialect == Dialect::ngc && number_by_10 >= 700 && number_by_10 <= 722)
    return "a turning cycle";
  if (dialect != Dialect::fanuc && dialect != Dialect::iso) return {};
  for (const auto& [number, name] : kUnsupportedNames)
    if (number == number_by_10) return name;
  return {};
}

const CodeTable& code_table(Dialect dialect, MachineKind machine) {
  static const auto kTables = [] {
    std::array<CodeTable, 12> tables;
    for (std::size_t t = 0; t < tables.size(); ++t)
      for (int g = 0; g < 1000; ++g)
        tables[t][static_cast<std::size_t>(g)] = find_g_code(
            static_cast<Dialect>(t / 2), t % 2 ? MachineKind::lathe : MachineKind::mill, 10 * g);
    return tables;
  }();
  return kTables[2 * static_cast<std::size_t>(dialect) + (machine == MachineKind::lathe ? 1 : 0)];
}

}  // namespace mrsim
