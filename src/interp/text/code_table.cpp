#include "interp/text/code_table.h"

#include "interp/text/code_rows.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace mrsim {
namespace {

using Row = CodeRow;
using C = Code;
using G = Group;

constexpr std::pair<int, std::string_view> kUnsupportedNames[] = {
    {50, "a spline"},
    {51, "a spline"},
    {70, "a hypothetical axis"},
    {71, "cylindrical interpolation"},
    {80, "an arc tangent to the path before"},
    {121, "polar interpolation"},
    {140, "the second turret of Okuma, the second spindle of Haas"},
    {330, "a thread"},
    {390, "a corner arc"},
    {434, "tool centre point control"},
    {435, "tool centre point control"},
    {450, "an offset of the tool's position"},
    {460, "an offset of the tool's position"},
    {470, "an offset of the tool's position; with P and (TEXT) it engraves on Haas"},
    {480, "an offset of the tool's position"},
    {531, "a move of the tilted axes"},
    {542, "a dynamic work offset"},
    {544, "the setting error of a workpiece"},
    {650, "a macro call"},
    {660, "a modal macro call"},
    {680, "a rotation; on lathes the mirror image of double turrets"},
    {682, "a tilted working plane"},
    {683, "a tilted working plane"},
    {684, "a tilted working plane"},
    {770, "Brother's synchronised tapping"},
    {780, "Brother's synchronised tapping"},
    {1000, "without T of Brother, or X0 Y0 of Haas on mills"},
    {1010, "a mirror image of Haas', but for X0 Y0 on mills"},
    {1070, "cylindrical interpolation"},
    {1120, "polar interpolation"},
    {1410, "the second spindle of Okuma"},
    {1430, "tool centre point control"},
    {1470, "a straight approach of SINUMERIK: write a line"},
    {1480, "a straight way off of SINUMERIK: write a line"},
    {2340, "tool centre point control"},
    {2470, "an approach of SINUMERIK in a quadrant: write lines and arcs"},
    {2480, "a way off of SINUMERIK in a quadrant: write lines and arcs"},
    {2540, "a dynamic work offset"},
    {2700, "Mazak's finishing cycle: write G70"},
    {2710, "Mazak's roughing along Z: write G71"},
    {2720, "Mazak's roughing along X: write G72"},
    {2730, "Mazak's pattern repeating: write G73"},
    {2740, "Mazak's grooving of a face: write G74"},
    {2750, "Mazak's grooving: write G75"},
    {2760, "Mazak's threading in passes: write G76"},
    {2900, "Mazak's turning cycle: write G90; or the end of SINUMERIK's ISO mode"},
    {2920, "Mazak's threading cycle: write G92"},
    {2940, "Mazak's facing cycle: write G94"},
    {2910, "ISO dialect mode: run what follows with --dialect fanuc"},
    {3470, "an approach of SINUMERIK in a semicircle: write lines and arcs"},
    {3480, "a way off of SINUMERIK in a semicircle: write lines and arcs"},
};

const Row* find_row(std::span<const Row> rows, int number) {
  const auto at =
      std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.number == number; });
  return at == rows.end() ? nullptr : &*at;
}

// Work offsets and drilling cycles are ranges, not rows.
CodeEntry find_range(Dialect dialect, int number) {
  if (number % 10 != 0 || dialect == Dialect::codesys) return {};
  const int g = number / 10;
  const bool sinumerik = dialect == Dialect::sinumerik;
  if (g >= 54 && g <= (sinumerik ? 57 : 59)) return {C::work_offset, G::work, g};
  if (sinumerik && g >= 505 && g <= 599) return {C::work_offset, G::work, g};
  if (!sinumerik && g >= 81 && g <= 89)
    return {C::drill_cycle, dialect == Dialect::ngc ? G::motion : G::other, g};
  if (dialect == Dialect::fanuc && g >= 110 && g <= 129 && g != 112 && g != 113)
    return {C::work_offset, G::work, g};
  return {};
}

// The cycle that a word means. Rigid taps are the cycles of G84 and G74: so are G84.2 and G84.3,
// G77 and G78 of Brother, G284 and G274 of Okuma, and G184 of Haas.
int cycle_of(int number_by_10) {
  if (number_by_10 == 770 || number_by_10 == 842 || number_by_10 == 2840) return 84;
  if (number_by_10 == 780 || number_by_10 == 843 || number_by_10 == 2740 || number_by_10 == 1840)
    return 74;
  return number_by_10 / 10;
}

std::span<const Row> own_rows(Dialect dialect) {
  switch (dialect) {
    case Dialect::sinumerik:
      return sinumerik_codes();
    case Dialect::fanuc:
      return fanuc_codes();
    case Dialect::codesys:
      return codesys_codes();
    case Dialect::ngc:
      return linuxcnc_codes();
    default:
      return iso_codes();
  }
}

}  // namespace

CodeEntry find_g_code(Dialect dialect, MachineKind machine, int number_by_10) {
  const Row* row = nullptr;
  if (dialect == Dialect::fanuc)
    row = machine == MachineKind::lathe ? find_row(fanuc_lathe_codes(), number_by_10)
                                        : find_row(fanuc_mill_codes(), number_by_10);
  if (!row) row = find_row(own_rows(dialect), number_by_10);
  // A word that the common subset of ISO does not define means what it means on FANUC.
  if (!row && dialect == Dialect::iso && machine != MachineKind::lathe)
    row = find_row(fanuc_mill_codes(), number_by_10);
  if (!row && dialect == Dialect::iso) row = find_row(fanuc_codes(), number_by_10);
  if (!row) row = find_row(shared_codes(), number_by_10);
  if (row && row->code == C::drill_cycle) return {row->code, row->group, cycle_of(number_by_10)};
  if (row) return {row->code, row->group, number_by_10 / 10};
  return find_range(dialect, number_by_10);
}

std::string_view unsupported_code(Dialect dialect, int number_by_10) {
  if (dialect == Dialect::ngc || dialect == Dialect::codesys) return {};
  for (const auto& [number, name] : kUnsupportedNames)
    if (number == number_by_10) return name;
  return {};
}

const CodeTable& code_table(Dialect dialect, MachineKind machine) {
  static const auto kTables = [] {
    std::array<CodeTable, 12> tables;
    for (std::size_t t = 0; t < tables.size(); ++t)
      for (int g = 0; g < 1000; ++g)
        tables[t][static_cast<std::size_t>(g)] = find_g_code(
            static_cast<Dialect>(t / 2), t % 2 ? MachineKind::lathe : MachineKind::mill, 10 * g);
    return tables;
  }();
  return kTables[2 * static_cast<std::size_t>(dialect) + (machine == MachineKind::lathe ? 1 : 0)];
}

}  // namespace mrsim
