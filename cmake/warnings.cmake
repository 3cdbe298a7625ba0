# Flags of our own code: warnings; no contraction, so that results are equal on every machine (and no fast-math); and two that change no
# value but let sqrt and comparisons be plain instructions: nobody reads errno or floating-point flags. Nobody replaces our functions at
# load time either, so that they may be inlined into each other.
add_library(mrsim_flags INTERFACE)
target_compile_options(mrsim_flags INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor
  -Wno-missing-field-initializers -Wold-style-cast -Wcast-align=strict -ffp-contract=off -fno-math-errno -fno-trapping-math
  -fno-semantic-interposition
  # GCC 12 warns of overlap inside of its own std::string (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<BOOL:${MRSIM_WERROR}>:-Werror>)
