#include "interp/control/set_lengths.h"

#include "core/numbers/rounding.h"

#include <cmath>

namespace mrsim {

void SetLengths::set(const Register& which, int kind, std::optional<double> before,
                     Setting setting) {
  const auto [at, fresh] = set_[which].try_emplace(kind);
  if (fresh) at->second.at_cut = before;
  at->second.now = std::move(setting);
  fresh_ = true;
}

const SetLengths::Setting* SetLengths::find(const Register& which, int kind) const {
  const auto at = set_.find(which);
  if (at == set_.end()) return nullptr;
  const auto length = at->second.find(kind);
  return length == at->second.end() ? nullptr : &length->second.now;
}

std::vector<SetLengths::Setting> SetLengths::cut(int tool, double number, const Register& which) {
  last_ = {tool, number};
  fresh_ = false;
  std::vector<Setting> changed;
  const bool again = !cutters_.insert(which).second;
  const auto at = set_.find(which);
  if (at == set_.end()) return changed;
  for (auto& [kind, length] : at->second) {
    const bool differs = !length.at_cut || std::abs(length.now.mm - *length.at_cut) > kRounding;
    if (again && differs) changed.push_back(length.now);
    length.at_cut = length.now.mm;
  }
  return changed;
}

}  // namespace mrsim
