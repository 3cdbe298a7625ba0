// All cuts of a run in one list: those that the stock remembers, then the program's.
#pragma once

#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mrsim {

struct CutList {
  CutHistory all;             ///< motions index its files and tools
  std::size_t inherited = 0;  ///< motions that come from the stock's history
};

/// Joins a stock's history and a program. A motion's index in the list is its owner number.
CutList join_cuts(const CutHistory& history, const Program& program);

/// What these owners of faces, ascending, stand for.
OwnerTable owner_table(const std::vector<std::int32_t>& owners, const CutHistory& cuts);

}  // namespace mrsim
