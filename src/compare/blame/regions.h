// Surface out of tolerance, put together into regions, and the lines that are to blame.
#pragma once

#include "compare/blame/blame.h"
#include <mrsim/compare.h>

namespace mrsim {

struct RegionInput {
  const TriMesh& part_mesh;
  const TriMesh& nominal_mesh;
  const DeviationField& part;
  const DeviationField& nominal;
  const FaceLines& lines;
  const std::vector<std::vector<std::string>>& texts;
};

/// Samples of both surfaces that are out of tolerance to the same side and within about two
/// spacings of each other are one region. Worst first. `count` gets the number of all regions; the
/// first `most` of them are described.
std::vector<DeviationRegion> find_regions(const RegionInput& input, const Acceptance& band,
                                          std::size_t most, std::size_t& count);

}  // namespace mrsim
