# Flags of our own code: warnings, and the two that keep results equal on every machine (no contraction, no fast-math).
add_library(mrsim_flags INTERFACE)
target_compile_options(mrsim_flags INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor
  -Wno-missing-field-initializers -Wold-style-cast -ffp-contract=off $<$<BOOL:${MRSIM_WERROR}>:-Werror>)
