// Turning cycles without a contour: G90, G92, G94 of FANUC lathes (code system A), G74, G75 and G76
// in both forms, G76 of LinuxCNC. Each becomes the motions that its manual shows.
// Private to src/interp.
#pragma once

#include "interp/moves/moves.h"

#include <vector>

namespace mrsim {

class TurnWords : public ControlPart {
 public:
  TurnWords(Control& control, AxisWords& axes, Moves& moves)
      : ControlPart(control), axes_(axes), moves_(moves) {}

  /// Whether G90, G92 or G94 is in force and the block has words for it.
  bool wants_block() const;
  /// Runs one pass of the cycle in force. False: an error was reported.
  bool pass();
  /// Carries out G74, G75 or G76 of the block. False: an error was reported.
  bool run();
  /// Whether the block gives an axis. If not, it is the first line of a cycle in two lines.
  bool has_axes() const;

 private:
  /// A thread of G76. Lengths are in mm, depths in radius.
  struct Thread {
    double lead = 0;
    double height = 0, first = 0, least = 0, finish = 0;
    double taper = 0;  ///< radius at the start minus radius at the end
    double slope = 0;  ///< tangent of half the angle of the tip
    double chamfer = 0;
    int finishes = 1;
    bool constant_depth = false;
    bool both_flanks = false;  ///< passes follow the two flanks in turn
  };

  /// A thread of LinuxCNC's G76. Lengths are in mm, depths count from the crest.
  struct DriveLine {
    double pitch = 0, crest = 0, first = 0, full = 0;
    double degression = 1, slide = 0;  ///< tangent of the slide's angle
    double taper = 0;
    bool taper_in = false, taper_out = false;
    double end = 0;  ///< Z
  };

  bool mills_flats();
  bool pecks();
  void grooves(const Vec3& from, const Vec3& to, double shift, double stroke, double relief);
  bool thread();
  bool thread_settings();
  bool one_line_thread(Thread& thread);
  bool thread_depths(const Thread& thread, std::vector<double>& depths);
  void thread_passes(const Thread& thread, const Vec3& from, const Vec3& end,
                     const std::vector<double>& depths);
  bool linuxcnc_thread();
  bool drive_line(DriveLine& out, double& springs);
  void drive_line_pass(const DriveLine& t, const Vec3& from, double depth);
  bool axis_end(Target& to);
  double long_or_least(const Word& word);
  double least(const Word& word) const;
  double count(const Word& word);
  void go(double x, double z, MotionKind kind, double lead = 0);
  const Word& where() const;

  AxisWords& axes_;
  Moves& moves_;
};

}  // namespace mrsim
