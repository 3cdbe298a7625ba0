// How often a test repeats itself on random or shifted cases.
#pragma once

#include "support/sanitized.h"

namespace mrsim::testing {

/// `count`, or a third of it under sanitizers: there each case takes ten times as long, and what
/// they look for, faults of memory and of arithmetic, lies in code that every case runs through.
/// All cases are run by the build without.
inline unsigned rounds(unsigned count) { return is_sanitized() ? (count + 2) / 3 : count; }

}  // namespace mrsim::testing
