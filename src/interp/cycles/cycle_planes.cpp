#include "interp/cycles/cycle_planes.h"

namespace mrsim {

std::optional<CyclePlanes> cycle_planes(const CycleCall& call, int mode, double unit) {
  const double below = call.get("DPR");
  if (!call.given("RTP") || !call.given("RFP") || (!call.given("DP") && below == 0))
    return std::nullopt;
  CyclePlanes out;
  out.top = call.get("RTP") * unit;
  out.reference = call.get("RFP") * unit;
  out.up = out.top < out.reference ? -1 : 1;
  out.safe = out.reference + out.up * std::abs(call.get("SDIS")) * unit;
  out.bottom = call.get("DP") * unit;
  const double relative =
      call.given("DP") ? call.get("DP") : below;  // with a mode, DP or DPR holds it
  if (mode == 1) out.bottom = out.reference - out.up * std::abs(relative) * unit;
  if (mode == 0 && below != 0) out.bottom = out.reference - out.up * std::abs(below) * unit;
  return out;
}

}  // namespace mrsim
