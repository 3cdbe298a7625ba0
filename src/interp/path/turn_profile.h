// The contour of LinuxCNC's turning cycles G70, G71, G72: fillets and chamfers at its corners,
// allowances, and the moves that rough or finish it. Lengths are in the program's unit, because
// LinuxCNC's tolerances are. Guarantees: the moves of its interpreter, in its order; what it can
// not cut is a fault with a reason. Does not know words, blocks or tools.
#pragma once

#include "core/numbers/vec.h"

#include <cstddef>
#include <string>
#include <vector>

namespace mrsim {

/// A piece of a contour. The first piece is the way to it.
struct ProfilePiece {
  enum class Corner { none, fillet, chamfer };
  bool arc = false, ccw = false;
  Vec2 start, end, center;
  Corner corner = Corner::none;  ///< the corner at `start`, of the size `size`
  double size = 0;
  int source = -1;  ///< where the piece comes from, a number of the caller's, for faults
};

struct ProfileMove {
  enum class Kind { rapid, line, arc };
  Kind kind = Kind::rapid;
  Vec2 end, center;
  bool ccw = false;
  bool approach = false;  ///< a rapid without radius compensation
};

struct ProfileFault {
  std::string text;  ///< why it cannot be cut; empty: it can
  int source = -1;
};

/// Which pockets a roughing cycle cuts: G71, G71.1, G71.2.
enum class Pockets { all, none, rest };

/// The values of G71 and G72.
struct Roughing {
  bool across = false;  ///< G72: levels in z
  Pockets pockets = Pockets::all;
  double step = 1, retract = 0.5;  ///< I, R
  double allowance = 0;            ///< D
};

/// The values of G70: passes at distances from `first` to `last`.
struct Finishing {
  int passes = 1;
  double first = 0, last = 0;
};

/// Places are (z, x). Requires: two pieces or more, each from the end of the one before; the first
/// is straight and begins where the cycle does.
ProfileFault rough_profile(std::vector<ProfilePiece> pieces, const Roughing& how,
                           std::vector<ProfileMove>& out);
ProfileFault finish_profile(std::vector<ProfilePiece> pieces, const Finishing& how,
                            std::vector<ProfileMove>& out);

}  // namespace mrsim
