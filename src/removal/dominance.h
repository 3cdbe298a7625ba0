// Which sweeps lose to another one everywhere in a ball: what keeps the lists of a million short
// moves short.
//
// Two sweeps of one tool whose shapes are offsets of skeletons (a ball's path, an insert's polygon,
// a level path seen in plan): with s the distance from the centre to a skeleton and q the nearest
// point on it, sweep i never decides within r of the centre when
//     s_i^2 - s_j^2 > 2 r |q_i - q_j| + r^2,
// because |p - s|^2 - |p - q_j|^2 is linear in p for every s on the convex skeleton i
// (docs/removal.md). Strict by a margin for rounding, so that two sweeps never drop each other and
// dropping never changes a bit.
#pragma once

#include "core/vec.h"
#include "removal/sweep.h"

#include <span>
#include <vector>

namespace mrsim {

class Dominance {
 public:
  /// The nearest points of a list of sweeps, as SweepTable::nearest gives them.
  struct Nearest {
    std::vector<double> distance, squared, x, y, z;
    void resize(std::size_t size);
    NearestColumns columns() {
      return {distance.data(), squared.data(), x.data(), y.data(), z.data()};
    }
  };

  explicit Dominance(const SweepTable& sweeps);

  /// Clears keep[k] of every sweep ids[k] that another one of the list beats within `radius` of
  /// `center`. Results stay the same to the last bit in the whole ball; with `band` > 0 only where
  /// |d| < band, and more sweeps go.
  void drop(const Vec3& center, double radius, double band, std::span<const std::uint32_t> ids,
            const Nearest& nearest, std::vector<char>& keep) const;

 private:
  struct Row {
    double low;    ///< strip: lowest point of the skeleton, mm
    float length;  ///< of the path, mm, rounded up
    float flat;    ///< plan: radius of the flat end, 0 = none, rounded down
    std::int32_t group;
    SweepSkeleton::Kind kind;
    bool rising, convex;
  };
  struct Ball {
    double z, radius, band;
  };

  void drop_solid(const Ball& ball, std::span<const std::uint32_t> ids, const Nearest& n,
                  std::int32_t group, std::vector<char>& keep) const;
  void drop_plan(const Ball& ball, std::span<const std::uint32_t> ids, const Nearest& n,
                 std::int32_t group, std::vector<char>& keep) const;

  std::vector<Row> rows_;
};

}  // namespace mrsim
