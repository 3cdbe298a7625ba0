// Bytes as choices in a grammar of NC programs: loops, calls, cycles and frames that are well
// formed, so that the control's language is reached and not only its parser. Budgets are low.
#include "grammar_codesys.h"
#include "grammar_fanuc.h"
#include "grammar_iso.h"
#include "grammar_linuxcnc.h"
#include "grammar_sinumerik.h"
#include "interp_checks.h"

#include <cstdint>
#include <string>

namespace {

using namespace mrsim;
using namespace mrsim::fuzz;

std::string program_of(Dialect dialect, const std::uint8_t* data, std::size_t size) {
  switch (dialect) {
    case Dialect::ngc:
      return LinuxCnc(data, size).program();
    case Dialect::sinumerik:
      return Sinumerik(data, size).program();
    case Dialect::iso:
      return Fagor(data, size).program();
    case Dialect::codesys:
      return Codesys(data, size).program();
    default:
      return Fanuc(data, size).program();
  }
}

// The first byte chooses the control; the highest values are those of the languages added last.
Dialect dialect_of(std::uint8_t choice) {
  if (choice >= 240) return Dialect::codesys;
  if (choice >= 224) return Dialect::iso;
  if (choice >= 200) return Dialect::sinumerik;
  return choice % 3 == 0 ? Dialect::ngc : Dialect::fanuc;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2 || size > 4096) return 0;
  const Dialect dialect = dialect_of(data[0]);
  write_program(program_of(dialect, data + 1, size - 1));
  const int machine = data[0] % 2 == 0 ? 0 : 5;
  InterpOptions options = options_of(static_cast<int>(dialect) - 1 + machine);
  options.require_tools = false;
  options.max_steps = 100'000;
  read_program(options);
  return 0;
}
