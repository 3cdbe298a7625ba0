#include "interp/cycles/cycle_call.h"

#include <algorithm>
#include <cmath>

namespace mrsim {

const Value* CycleCall::find(ValueName value) const {
  const std::optional<std::size_t> at = place_in_list(list_of_cycle(name), value.text());
  return at && *at < values.size() && values[*at] ? &*values[*at] : nullptr;
}

bool CycleCall::given(ValueName value) const {
  const Value* const found = find(value);
  return found && found->kind == Value::Kind::number;
}

bool CycleCall::given(std::initializer_list<ValueName> all) const {
  return std::all_of(all.begin(), all.end(), [&](ValueName value) { return given(value); });
}

double CycleCall::get(ValueName value, double otherwise) const {
  return given(value) ? find(value)->number : otherwise;
}

std::string CycleCall::text(ValueName value) const {
  const Value* const found = find(value);
  return found ? found->text : std::string();
}

int CycleCall::digit(ValueName value, int n) const {
  double v = std::floor(std::abs(get(value)));
  for (; n > 0; --n) v = std::floor(v / 10);
  return static_cast<int>(std::fmod(v, 10));
}

void CycleCall::set(ValueName value, double number) {
  const std::size_t at = place_in_list(list_of_cycle(name), value.text()).value();
  if (values.size() <= at) values.resize(at + 1);
  values[at] = Value::of(number);
}

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
