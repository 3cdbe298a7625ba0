#include "interp/cycles/cycle_planes.h"

namespace mrsim {

std::optional<CyclePlanes> cycle_planes(const CycleCall& call, std::size_t first, int dpr, int mode,
                                        double unit) {
  const std::size_t dp = first + 3;
  const double below = dpr < 0 ? 0 : call.get(static_cast<std::size_t>(dpr));
  if (!call.given(first) || !call.given(first + 1) || (!call.given(dp) && below == 0))
    return std::nullopt;
  CyclePlanes out;
  out.top = call.get(first) * unit;
  out.reference = call.get(first + 1) * unit;
  out.up = out.top < out.reference ? -1 : 1;
  out.safe = out.reference + out.up * std::abs(call.get(first + 2)) * unit;
  out.bottom = call.get(dp) * unit;
  const double relative = call.given(dp) ? call.get(dp) : below;  // with a mode, in DP or DPR
  if (mode == 1) out.bottom = out.reference - out.up * std::abs(relative) * unit;
  if (mode == 0 && below != 0) out.bottom = out.reference - out.up * std::abs(below) * unit;
  return out;
}

}  // namespace mrsim
