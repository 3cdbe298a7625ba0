// Whether AddressSanitizer or ThreadSanitizer watches this program. Asked as it runs: test programs
// may be linked again, from the same objects, with a library that they watch.
#pragma once

extern "C" {
__attribute__((weak)) void __asan_init();
__attribute__((weak)) void __tsan_init();
}

namespace mrsim::testing {

inline bool is_sanitized() { return __asan_init != nullptr || __tsan_init != nullptr; }

}  // namespace mrsim::testing
