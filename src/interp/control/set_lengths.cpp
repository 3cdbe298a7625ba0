#include "interp/control/set_lengths.h"

#include "core/numbers/rounding.h"

#include <cmath>

namespace mrsim {
namespace {

bool differs(const SetLengths::Setting& a, const SetLengths::Setting& b) {
  return a.relative != b.relative || std::abs(a.mm - b.mm) > kRounding;
}

}  // namespace

void SetLengths::set(const Register& which, int kind, std::optional<double> before,
                     Setting setting) {
  const auto [at, fresh] = set_[which].try_emplace(kind);
  if (fresh) at->second.before = before;
  at->second.now = std::move(setting);
  fresh_ = true;
}

void SetLengths::set_another(const Register& which, int kind, Setting setting) {
  const Setting* before = find(which, kind);
  setting.mm = before ? before->mm + 1 : 0;
  setting.relative = true;
  set(which, kind, std::nullopt, std::move(setting));
}

const SetLengths::Setting* SetLengths::find(const Register& which, int kind) const {
  const auto at = set_.find(which);
  if (at == set_.end()) return nullptr;
  const auto length = at->second.find(kind);
  return length == at->second.end() ? nullptr : &length->second.now;
}

std::vector<SetLengths::Setting> SetLengths::cut(int tool, double number, const std::string& id,
                                                 const Register& which) {
  last_ = {tool, number};
  fresh_ = false;
  std::vector<Setting> changed;
  const auto at = set_.find(which);
  const Lengths now = at == set_.end() ? Lengths{} : at->second;
  Cutter& cutter = cutters_[id];
  const auto same = cutter.cuts.find(which);
  if (same != cutter.cuts.end()) {
    for (const auto& [kind, length] : now) {
      const auto met = same->second.find(kind);
      const bool first = met == same->second.end();
      if (first ? !length.before || std::abs(length.now.mm - *length.before) > kRounding
                : differs(length.now, met->second.now))
        changed.push_back(length.now);
    }
  } else if (!cutter.cuts.empty() && !now.empty()) {
    changed = between(cutter.cuts[cutter.last], now);
  }
  cutter.cuts[which] = now;
  cutter.last = which;
  return changed;
}

// The lengths of two registers that differ. A length that is unknown in one of them is left out.
std::vector<SetLengths::Setting> SetLengths::between(const Lengths& then, const Lengths& now) {
  std::vector<Setting> changed;
  if (then.empty()) return changed;
  const auto compare = [&](const Lengths& from, const Lengths& to, bool both) {
    for (const auto& [kind, length] : from) {
      const auto other = to.find(kind);
      if (other != to.end() ? !both : !length.before) continue;
      const double value = other != to.end() ? other->second.now.mm : *length.before;
      const bool known = !length.now.relative && (other == to.end() || !other->second.now.relative);
      if (known && std::abs(length.now.mm - value) > kRounding) changed.push_back(length.now);
    }
  };
  compare(now, then, true);
  compare(then, now, false);
  return changed;
}

}  // namespace mrsim
