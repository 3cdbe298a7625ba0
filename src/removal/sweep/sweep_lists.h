// Lists of sweeps: a list is sorted by the form of its sweeps, and each part goes to the kernels of
// its form. Each function means what its namesake in SweepTable says.
#pragma once

#include "removal/columns/sweep_columns.h"
#include "removal/sweep/sweep_table.h"

#include <cstdint>
#include <optional>
#include <span>

namespace mrsim {

/// SweepTable::nearest().
SweepTable::Nearest nearest_sweep(const SweepColumns& c, std::span<const std::uint32_t> list,
                                  const Vec3& p, double enough);
/// Distances from p of the sweeps in `ids`, into `out`. With `least`, a distance above it, or above
/// another one of the list, need not be exact.
void sweep_distances(const SweepColumns& c, std::span<const std::uint32_t> ids, const Vec3& p,
                     double* out, std::optional<double> least = {});
/// SweepTable::near_distances().
void near_distances(const SweepColumns& c, std::span<const std::uint32_t> ids, const Vec3& p,
                    double margin, double* out);
/// SweepTable::least().
void least_distances(const SweepColumns& c, std::span<const std::uint32_t> ids,
                     PointColumns& points);

}  // namespace mrsim
