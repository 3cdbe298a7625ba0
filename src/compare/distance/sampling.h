// Points spread evenly over a surface, and their deviations.
#pragma once

#include "compare/distance/nominal.h"
#include "core/numbers/vec.h"
#include <mrsim/compare.h>

#include <vector>

namespace mrsim {

/// First `spread` points that each stand for `weight` mm^2, then every vertex (weight 0).
struct SurfaceSamples {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> faces;  ///< the triangle each lies on
  std::size_t spread = 0;
  double weight = 0;  ///< mm^2
  double area = 0;    ///< mm^2
};

/// Point k of the R2 sequence (Roberts 2018), which fills the unit square evenly.
Vec2 spread_point(std::size_t k);

/// `count` samples at equal steps of the summed area, in each triangle at the points of
/// spread_point(): every triangle gets its share of the area to within one sample, and
/// tiny ones share samples. A function of the mesh alone.
SurfaceSamples sample_surface(const TriMesh& mesh, std::size_t count);

/// Number of samples that the options ask for on a surface of this area, at most 5 million: a
/// density that gives more is an Error "density-too-large".
std::size_t sample_count(const CompareOptions& options, double area);

/// Samples of one surface with their signed deviation, positive = material left.
struct DeviationField {
  SurfaceSamples samples;
  std::vector<SurfaceHit> hits;  ///< distance = deviation, triangle of the other surface
};

/// `sign` +1 for the part's samples on the nominal, -1 for the nominal's on the part.
DeviationField measure(SurfaceSamples samples, const NominalSurface& other, double sign,
                       int threads);

/// Largest, mean and percentiles, and the share beyond the band.
DeviationFigures figures_of(const DeviationField& field, const Acceptance& band);

/// 60 bins over twice the band, so that the ends of `band` are borders between bins.
Histogram histogram_of(const DeviationField& field, const Acceptance& band);

}  // namespace mrsim
