// Suspicions: what kind of mistake would make deviations such as these.
#pragma once

#include "compare/blame/blame.h"
#include <mrsim/compare.h>

namespace mrsim {

/// Throws Error "compare-units" when one is 25.4 or 1000 times as large as the other, and
/// "compare-apart" when they are farther apart than three times their size and will not be aligned.
void require_same_place(const Box3& part, const Box3& nominal, Alignment align);

/// "part-shifted": the surface that was cut fits after a small move. "tool-size": most of what one
/// tool cut, on several lines, is off by the same amount.
std::vector<ComparisonHint> find_hints(const TriMesh& part, const DeviationField& field,
                                       const NominalSurface& nominal, const FaceLines& lines,
                                       const Acceptance& band, int threads);

}  // namespace mrsim
