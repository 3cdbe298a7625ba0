#include "interp/turning/turn_cycles.h"

#include "interp/turning/corner_cycle.h"
#include "interp/turning/groove_cycles.h"
#include "interp/turning/thread_cycles.h"

#include <algorithm>
#include <array>

namespace mrsim {
namespace {

constexpr std::array<std::string_view, 6> kTurnCycles = {"CYCLE92", "CYCLE93", "CYCLE951",
                                                         "CYCLE97", "CYCLE98", "CYCLE99"};

}  // namespace

bool TurnCycles::knows(std::string_view name) {
  return std::find(kTurnCycles.begin(), kTurnCycles.end(), name) != kTurnCycles.end();
}

bool TurnCycles::run(const CycleCall& call, const Word& where) {
  if (modal_.comp != Code::comp_off)
    return error("cycle-compensation", "a cycle under radius compensation: G40 before it", where);
  if (call.name == "CYCLE92" || call.name == "CYCLE93")
    return GrooveCycles(control_, tools_, moves_, call, where).run();
  if (call.name == "CYCLE951") return CornerCycle(control_, moves_, call, where).run();
  return ThreadCycles(control_, moves_, call, where).run();
}

}  // namespace mrsim
