// NAME[index]=value of SINUMERIK where NAME is no variable: an axis by AX[ ], a code by G[ ], or
// data without effect on geometry. Private to src/interp.
#pragma once

#include "interp/text/sinumerik_values.h"

#include <cstddef>
#include <string>

namespace mrsim {

class SinumerikArrays : public SinumerikValues {
 public:
  explicit SinumerikArrays(ParsedLine& line) : SinumerikValues(line) {}

  /// The word that begins at `from` with `name`, in upper case; the place is at its bracket. What
  /// is not read is a fault of the block.
  void read(Block& block, std::size_t from, const std::string& name);

 private:
  std::string axis_of(std::size_t close) const;
};

}  // namespace mrsim
