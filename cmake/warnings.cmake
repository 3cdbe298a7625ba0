# Flags of our own code: warnings, and the two that keep results equal on every machine (no contraction, no fast-math).
add_library(mrsim_flags INTERFACE)
target_compile_options(mrsim_flags INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor
  -Wno-missing-field-initializers -Wold-style-cast -ffp-contract=off
  # GCC 12 warns of overlap inside of its own std::string (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<BOOL:${MRSIM_WERROR}>:-Werror>)
