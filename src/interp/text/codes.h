// The meanings of function words, the same for all controls, and their modal groups.
#pragma once

#include <cstdint>

namespace mrsim {

/// The meaning of a function word, the same for all dialects.
enum class Code : std::uint8_t {
  unknown,
  ignored,          ///< known, without effect on geometry
  path_continuous,  ///< the mode at corners becomes an event of the program
  path_exact,       ///< G61 of LinuxCNC: another such mode
  path_stops,       ///< G60 G61: the tool stops at corners
  path_stops_once,  ///< G9: it stops once
  ignored_words,    ///< ignored, and so are the other words of its block
  high_speed,       ///< FANUC G5 P, G5.1 Q, G8 P: ignored; G5 with axes is a spline
  unsupported,      ///< known, not read yet: an error
  statement,        ///< read before the other words, by the language or IsoWords
  turn_pass,        ///< G90 G92 G94 of a lathe: modal, one pass a block
  turn_cycle,       ///< G70 to G76 of a lathe
  drill_cycle,      ///< G73 G74 G76 G81 ... G89: CodeEntry::number says which
  cycle_off,        ///< G80
  circle_pocket,    ///< G12 G13 of Haas
  contour_pocket,   ///< G150 of Haas
  figure_copy,      ///< G72.1 G72.2 of FANUC mills
  engrave,          ///< G47 P of Haas
  hole_pattern,     ///< G70 G71 G72 of Haas; G70 and G71 alone are the units; G34 to G37.1
  return_initial,   ///< G98: cycles return to the level before them
  return_r,         ///< G99: ... to R
  rapid,
  line,
  arc_cw,
  arc_ccw,
  arc_point,
  arc_tangent,
  thread,
  thread_growing,
  thread_shrinking,
  tap_in,
  tap_out,
  tap_floating,
  tap_return,  ///< LinuxCNC G33.1: in and out again
  spline_cubic,
  spline_quadratic,
  nurbs,
  nurbs_end,
  motion_off,  ///< G80 of LinuxCNC: no motion is in force
  dwell,
  reference,
  reference_second,
  reference_store,  ///< LinuxCNC G28.1 G30.1: G28 and G30 lead to this position from now on
  reference_check,
  reference_leave,  ///< G29
  one_way,          ///< G60: a rapid that arrives from one side
  probe,
  data_setting,      ///< G10
  position_reset,    ///< G92.1: the shift of G92 and its memory become 0
  position_suspend,  ///< G92.2
  position_resume,   ///< G92.3
  reference_approach,
  fixed_point,
  plane_xy,
  plane_zx,
  plane_yz,
  plane_normal,
  plane_2d,
  absolute,
  incremental,
  inch,
  metric,
  inch_feed,
  metric_feed,
  inverse_time,
  per_minute,
  per_revolution,
  surface_speed,
  surface_speed_off,
  comp_off,
  comp_left,
  comp_right,
  corner_arc,
  corner_intersection,
  approach_normal,
  approach_contour,
  comp_suspend,
  comp_resume,
  length_plus,
  length_minus,
  length_off,
  length_dynamic,  ///< G43.1
  length_add,      ///< G43.2
  work_offset,
  work_extended,
  work_off,
  suppress_frames,
  center_absolute,
  center_relative,
  polar_on,
  polar_off,
  pole_position,
  pole_zero,
  pole_pole,
  trans,
  atrans,
  rot,
  arot,
  scale,
  ascale,
  mirror,
  amirror,
  trans_coarse,
  trans_fine,
  speed_limit,
  set_position,
  local_shift,
  rotation_on,
  rotation_off,
  scaling_on,
  scaling_off,
  mirror_on,
  mirror_off,
  diameter_on,
  diameter_off,
  diameter_absolute,
  diameter_cycles_off,
  decoder_reset,
  decoder_set,
  decoder_add,
  decoder_here,
  position_jump,
  decoder_length,
  path_smoothing,
  local_turned,      ///< G11 of Okuma: a shift of the zero and a turn about it
  local_turned_off,  ///< G10 of Okuma
  fagor_mirror,      ///< G10 to G13
  fagor_scale,       ///< G72 S
  fagor_turn,        ///< G73 Q
  fagor_pocket,      ///< G87 G88 with J and B
  program_return,
  header,
};

/// Modal group: two words of one group in a block contradict each other.
enum class Group : std::uint8_t {
  none,
  motion,
  oneshot,
  plane,
  distance,
  units,
  feed,
  speed,
  comp,
  corner,
  approach,
  suspend,
  length,
  work,
  suppress,
  center,
  polar,
  frame,
  scaling,
  rotation,
  mirror,
  diameter,
  path,
  exact,
  acceleration,
  feed_forward,
  feed_reference,
  bottleneck,
  compressor,
  comp_kind,
  approach_side,
  approach_path,
  retract,
  path_reference,
  feed_profile,
  other,
};

}  // namespace mrsim
