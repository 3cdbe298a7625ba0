#include "interp/text/m_codes.h"

namespace mrsim {
namespace {

struct MCodeRow {
  int number;
  MCode code;
};

// The M words of DIN 66025 and ISO 6983.
constexpr MCodeRow kCommon[] = {
    {0, MCode::stop},
    {1, MCode::optional_stop},
    {2, MCode::end},
    {3, MCode::clockwise},
    {4, MCode::counter_clockwise},
    {5, MCode::spindle_off},
    {6, MCode::tool_change},
    {7, MCode::mist},
    {8, MCode::flood},
    {9, MCode::coolant_off},
    {17, MCode::flow},
    {19, MCode::spindle_off},
    {30, MCode::end},
    {97, MCode::flow},
    {98, MCode::flow},
    {99, MCode::flow},
};

constexpr int kNoEffect[] = {10, 11, 13, 14, 29, 36, 37, 38, 40,
                             41, 42, 43, 44, 45, 46, 48, 49, 70};

// On lathes 13 and 14 belong to the live tool (Okuma) or the chuck (Haas).
constexpr MCodeRow kMills[] = {
    {13, MCode::clockwise_flood},
    {14, MCode::counter_clockwise_flood},
};

// M words of Haas, and of posts for FANUC's controls.
constexpr MCodeRow kFanucMills[] = {
    {88, MCode::through},
    {89, MCode::coolant_off},
};

constexpr MCodeRow kLinuxCnc[] = {
    {60, MCode::stop},  // M60 also changes the pallet
};

template <std::size_t n>
MCode find(const MCodeRow (&rows)[n], int number) {
  for (const MCodeRow& row : rows)
    if (row.number == number) return row.code;
  return MCode::unknown;
}

MCode find_own(Dialect dialect, MachineKind machine, int number) {
  if (dialect == Dialect::ngc) return find(kLinuxCnc, number);
  if (dialect == Dialect::codesys || machine == MachineKind::lathe) return MCode::unknown;
  const MCode code = find(kMills, number);
  return code != MCode::unknown || dialect == Dialect::sinumerik ? code : find(kFanucMills, number);
}

}  // namespace

MCode find_m_code(Dialect dialect, MachineKind machine, int number) {
  if (const MCode own = find_own(dialect, machine, number); own != MCode::unknown) return own;
  if (const MCode common = find(kCommon, number); common != MCode::unknown) return common;
  for (const int quiet : kNoEffect)
    if (quiet == number) return MCode::no_effect;
  return MCode::unknown;
}

std::string_view m_code_text(MCode code) {
  switch (code) {
    case MCode::stop:
      return "stop";
    case MCode::optional_stop:
      return "optional stop";
    case MCode::end:
      return "end";
    case MCode::clockwise:
      return "spindle clockwise";
    case MCode::counter_clockwise:
      return "spindle counter-clockwise";
    case MCode::spindle_off:
      return "spindle off";
    case MCode::clockwise_flood:
      return "spindle clockwise, flood";
    case MCode::counter_clockwise_flood:
      return "spindle counter-clockwise, flood";
    case MCode::tool_change:
      return "tool change";
    case MCode::mist:
      return "mist";
    case MCode::flood:
      return "flood";
    case MCode::through:
      return "coolant through the tool";
    case MCode::coolant_off:
      return "coolant off";
    default:
      return {};
  }
}

}  // namespace mrsim
