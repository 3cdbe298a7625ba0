// SINUMERIK's drilling cycles CYCLE81 to CYCLE89 and CYCLE840, the patterns HOLES1, HOLES2,
// CYCLE801 and CYCLE802, and MCALL, which runs a cycle behind every move in the plane. Private to
// src/interp.
#pragma once

#include "interp/control/cycle_call.h"
#include "interp/control/statements.h"

#include <optional>
#include <vector>

namespace mrsim {

class SinumerikCycles : public ControlPart {
 public:
  SinumerikCycles(Control& control, HoleMaker& holes, Statements* statements)
      : ControlPart(control), holes_(holes), statements_(statements) {}

  /// A name that run() knows.
  static bool knows(std::string_view name);
  /// The call of the block. False: an error was reported.
  bool run();
  /// MCALL, with a cycle or without. False: an error was reported.
  bool modal_call();
  /// The cycle of MCALL at the end of a move in the plane.
  bool run_modal(const Vec3& from);

 private:
  using Call = CycleCall;

  bool read_call(Call& call);
  bool hole(const Call& call, Hole& out);
  bool depth(const Call& call, std::size_t mode, double reference, double down, double& bottom);
  bool strokes(const Call& call, double reference, Hole& hole);
  void tapping(const Call& call, Hole& hole);
  bool pattern(const Call& call);
  bool swivel(const Call& call);
  bool row(const Call& call);
  bool circle(const Call& call);
  bool grid(const Call& call);
  bool points(const Call& call);
  bool at_points(const std::vector<Vec2>& points);
  bool drill(const Call& call);
  Word where() const;

  HoleMaker& holes_;
  Statements* statements_;
  std::optional<Call> modal_call_;
};

}  // namespace mrsim
