#include "interp/turning/turn_call.h"

#include "core/numbers/rounding.h"

#include <fmt/format.h>

namespace mrsim {

bool TurnCall::refuse(const char* what) {
  return fail("not-supported", fmt::format("{}: {} is not supported yet", call_.name, what));
}

void TurnCall::to(double x, double z, MotionKind kind, double lead) {
  Target target;
  target.programmed = {x, position_.programmed.y, z};
  target.named = kAxisX | kAxisZ;
  if (length(target.programmed - position_.programmed) > kRounding)
    moves_.step(target, where_, kind, lead, 0);
}

}  // namespace mrsim
