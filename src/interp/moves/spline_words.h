// LinuxCNC's splines in the plane: G5 (cubic), G5.1 (quadratic), and NURBS (G5.2 to G5.3), as arcs
// within a micrometre.
// Private to src/interp.
#pragma once

#include "interp/moves/point_arcs.h"
#include "interp/path/spline.h"

namespace mrsim {

class SplineWords : public ControlPart {
 public:
  SplineWords(Control& control, AxisWords& axes) : ControlPart(control), axes_(axes) {}
  /// The lines and arcs of the block's spline. False: an error was reported.
  bool solve(const Vec3& from, std::vector<SolvedArc>& out);

  /// Takes a control point of a NURBS from G5.2 or a block behind it. False: an error was reported.
  bool control_point(const Vec3& from);
  /// G5.3: the lines and arcs of the NURBS. False: an error was reported.
  bool close(const Vec3& from, std::vector<SolvedArc>& out);
  /// Whether a NURBS has been opened and not closed.
  bool under_way() const { return !nurbs_.empty(); }
  /// The block that has opened it.
  const Motion& opening() const { return opening_; }
  void forget() { nurbs_.clear(); }

 private:
  void pieces(const std::vector<CurvePiece>& curve, const Target& to, const Vec3& from,
              const Word& where, std::vector<SolvedArc>& out);
  bool offset(char first, char second, const Word& where, Vec2& out);

  AxisWords& axes_;
  std::vector<NurbsPoint> nurbs_;
  Motion opening_;  ///< tells only its place
  int order_ = 3;
};

}  // namespace mrsim
