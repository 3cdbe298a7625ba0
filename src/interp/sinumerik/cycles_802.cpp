#include "interp/sinumerik/cycles_802.h"

#include <algorithm>

namespace mrsim {
namespace {

struct CycleOf802 {
  std::string_view name, cycle;
  std::string_view values;  ///< of the later cycle's list; behind that of CYCLE83 its feed
};

constexpr CycleOf802 kCycles802[] = {
    {"LCYC60", "HOLES1", "R116,R117,R120,R118,R121,R119"},
    {"LCYC61", "HOLES2", "R116,R117,R118,R120,R121,R119"},
    {"LCYC75", "POCKET3",
     "R101,R103,R102,R104,R118,R119,R120,R116,R117,0,R121,R124,R125,R123,R122,R126,R127+10"},
    {"LCYC82", "CYCLE82", "R101,R103,R102,R104,,R105"},
    {"LCYC83", "CYCLE83", "R101,R103,R102,R104,,R110,,R111,R105,R109,1,R127,,,,,,,,,R107"},
    {"LCYC84", "CYCLE84", "R101,R103,R102,R104,,R105,5,,R106,0,R112,R113"},
    {"LCYC840", "CYCLE840", "R101,R103,R102,R104,,0,0,R126,0,,R106"},
    {"LCYC85", "CYCLE85", "R101,R103,R102,R104,,R105,R107,R108"},
    {"LCYC95", "CYCLE95", "_CNAME,R108,0,0,R106,R111,R111,R112,R105,,,R110"},
    {"LCYC97", "CYCLE97",
     "R104,,R101,R103,R100,R102,R109,R110,R111,R106,0,R112,R113,0,R105+2,R114"}};

const CycleOf802* find_cycle_of_802(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kCycles802), std::end(kCycles802),
                                         [&](const CycleOf802& c) { return c.name == name; });
  return found == std::end(kCycles802) ? nullptr : found;
}

}  // namespace

bool is_cycle_of_802(std::string_view name) { return find_cycle_of_802(name) != nullptr; }

bool read_cycle_of_802(std::string_view name, Statements* statements, const Word& where,
                       CycleCall& call) {
  const CycleOf802& row = *find_cycle_of_802(name);
  call.name = std::string(row.cycle);
  call.written = std::string(name);
  for (std::string_view rest = row.values;;) {
    const std::string_view value = rest.substr(0, rest.find(','));
    call.values.emplace_back();
    if (!value.empty()) {
      call.values.back().emplace();
      if (!statements || !statements->value_of(value, *call.values.back(), where)) return false;
    }
    if (value.size() == rest.size()) return true;
    rest.remove_prefix(value.size() + 1);
  }
}

}  // namespace mrsim
