// How often a test repeats itself on random or shifted cases.
#pragma once

namespace mrsim::testing {

/// `count`, or a third of it under sanitizers: there each case takes ten times as long, and what
/// they look for, faults of memory and of arithmetic, lies in code that every case runs through.
/// All cases are run by the build without.
constexpr unsigned rounds(unsigned count) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return (count + 2) / 3;
#else
  return count;
#endif
}

}  // namespace mrsim::testing
