#include "interp/language/unread_presets.h"

namespace mrsim {
namespace {

// A number that is local to a call is another variable than that of the main program.
bool is_meant(const UnreadPresets::Preset& one, double number, const VariableArray* named,
              bool local) {
  if (named != nullptr || one.named != nullptr) return one.named == named;
  return one.number == number && !local;
}

}  // namespace

void UnreadPresets::note_read(double number, const VariableArray* named, bool local) {
  std::erase_if(list_, [&](const Preset& one) {
    return !one.is_replaced && is_meant(one, number, named, local);
  });
}

void UnreadPresets::note_replaced(double number, const VariableArray* named, bool local) {
  for (Preset& one : list_)
    if (is_meant(one, number, named, local)) one.is_replaced = true;
}

}  // namespace mrsim
