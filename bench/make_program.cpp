// Writes a benchmark program as NC text to standard output: make_program raster-100000 > raster.MPF
#include "programs.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
  try {
    const std::string text =
        mrsim::bench::nc_text(mrsim::bench::program_named(argc == 2 ? argv[1] : ""));
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
