// What programs do, as text that tests compare.
#pragma once

#include "interp/support.h"

#include <string>

#include <fmt/format.h>

namespace mrsim::testing {

/// End points of the motions, and the codes of errors and warnings.
inline std::string path_of(const Program& program) {
  std::string out;
  for (const Motion& m : program.motions)
    out += fmt::format("{:.9g},{:.9g},{:.9g} ", m.end.x + 0.0, m.end.y + 0.0, m.end.z + 0.0);
  return out + codes(program);
}

inline std::string run(Dialect dialect, const std::string& text) {
  return path_of(read_text(text, at_origin(dialect)));
}

}  // namespace mrsim::testing
