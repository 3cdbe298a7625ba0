// Searches for points of the exact surface, on an edge of the grid and in a cell along one face. A
// search only says where it wants d next, so that searches with the same list of sweeps are sampled
// together.
#pragma once

#include "mesh/solid/vertex_lattice.h"
#include "removal/field/field.h"

#include <span>
#include <vector>

namespace mrsim::detail {

inline constexpr double kOnSurface = 5e-7;  ///< mm: |d| at which a point counts as exact
inline constexpr int kNewtonSteps = 24;
/// Share of a cell's size: how far beyond a cell its points of the surface are searched for, and so
/// how far beyond it its list of candidates holds.
inline constexpr double kCellReach = 1.0 / 16;

/// Whether both lie on one face of the part: one patch of one sweep, or of the stock.
inline bool same_face(const FieldSample& a, const FieldSample& b) {
  return a.owner == b.owner && a.patch == b.patch;
}

/// A number that no other face has: equal where same_face() holds.
inline std::uint64_t face_key(const FieldSample& face) {
  return static_cast<std::uint64_t>(face.owner - kStockOwner) << 32 |
         static_cast<std::uint32_t>(face.patch);
}

/// The field with the sweeps that matter here.
struct Probe {
  const ExactField& field;
  std::span<const std::uint32_t> candidates;
  double shallow = 0;  ///< mm: creases that need not be found if cutting them off moves less

  FieldSample sample(const Vec3& p) const { return field.sample(p, candidates); }
  bool is_on_surface(const Vec3& p) const { return field.is_on_surface(p, candidates, kOnSurface); }
  double offset(const Vec3& p) const { return sample(p).distance + kInsideTolerance; }
};

/// A point of the surface and the faces of the part that meet in it.
struct SurfacePoint {
  Vec3 position;
  FieldSample faces[3];
  int count = 0;  ///< 1 smooth, 2 crease, 3 corner; 0 = none found
};

inline bool has_face(const SurfacePoint& p, const FieldSample& face) {
  for (int k = 0; k < p.count; ++k)
    if (same_face(p.faces[k], face)) return true;
  return false;
}

/// One end of a segment that the surface crosses, with d + kInsideTolerance there, which may be
/// rounded.
struct SegmentEnd {
  Vec3 position;
  double offset = 0;
};

/// Where the surface crosses the segment from `inside` to `outside`, to 1e-10 mm. Requires d to
/// differ in side. Follows the face that decides d: two samples in most cases.
class CrossingSearch {
 public:
  CrossingSearch(const SegmentEnd& inside, const SegmentEnd& outside);

  const Vec3& point() const { return point_; }  ///< where d is wanted; when done, the crossing
  const FieldSample& at() const { return at_; }
  const Vec3& normal() const { return normal_; }  ///< of the surface, nearly there
  /// The point beside the crossing at which d = 0. For edges that cross one plane all these points
  /// lie on that plane.
  Vec3 position() const;
  /// Takes the sample at point(); true when that is the crossing.
  bool take(const ExactField& field, const FieldSample& sample);

 private:
  Vec3 from_, along_, point_, normal_;
  FieldSample at_;
  double size_, a_ = 0, b_ = 1, fa_, fb_, t_;
  int side_ = 0, steps_ = 0;
};
/// The crossing on the segment; costs two samples in most cases.
Vec3 find_crossing(const Probe& probe, const Vec3& inside, const Vec3& outside);
/// Its position() instead of its point().
Vec3 find_place(const Probe& probe, const Vec3& inside, const Vec3& outside);

/// A point of the surface strictly inside `room`, from `start` on, along whatever face decides d:
/// creases are met only by chance.
class SmoothSearch {
 public:
  /// `face`: what decides d at the start, null where that is not known.
  SmoothSearch(const ExactField& field, const Box3& room, const Vec3& start,
               const FieldSample* face = nullptr);

  const Vec3& point() const { return point_; }  ///< where d is wanted
  /// Takes the sample at point(); true when the search has ended.
  bool take(const ExactField& field, const FieldSample& sample);
  /// The point that was found; count = 0: none.
  SurfacePoint result() const;

 private:
  void follow(const ExactField& field, const FieldSample& face, FacePlane plane);

  Box3 room_;
  Vec3 point_;
  FieldSample at_;
  int steps_ = 0;
  bool found_ = false;
};

/// Where the owner changes between two points of one plane face, to 1/256 of their distance.
class BorderSearch {
 public:
  /// `owner`: of the face at `from`.
  BorderSearch(const Vec3& from, const Vec3& to, std::int32_t owner)
      : from_(from), to_(to), owner_(owner) {}

  Vec3 point() const {
    return 0.5 * (from_ + to_);
  }  ///< where the owner is wanted; then the border
  /// Takes the sample at point(); true when the search has ended.
  bool take(const ExactField&, const FieldSample& sample) {
    (sample.owner == owner_ ? from_ : to_) = point();
    return ++steps_ == 7;
  }

 private:
  Vec3 from_, to_;
  std::int32_t owner_;
  int steps_ = 0;
};

/// Runs searches that share their candidates to their ends, sampling for all of them at once where
/// there is anything but the stock.
template <class Search>
void run_together(const Probe& probe, std::span<Search> searches) {
  if (probe.candidates.empty()) {
    for (Search& search : searches)
      while (!search.take(probe.field, probe.sample(search.point()))) {
      }
    return;
  }
  struct Memory {
    std::vector<std::size_t> unfinished;
    std::vector<Vec3> points;
    std::vector<FieldSample> samples;
  };
  static thread_local Memory memory;
  auto& [unfinished, points, samples] = memory;
  unfinished.clear();
  for (std::size_t k = 0; k < searches.size(); ++k) unfinished.push_back(k);
  while (!unfinished.empty()) {
    points.clear();
    for (const std::size_t k : unfinished) points.push_back(searches[k].point());
    samples.resize(points.size());
    probe.field.samples(points, probe.candidates, samples.data());
    std::size_t left = 0;
    for (std::size_t i = 0; i < unfinished.size(); ++i)
      if (!searches[unfinished[i]].take(probe.field, samples[i]))
        unfinished[left++] = unfinished[i];
    unfinished.resize(left);
  }
}

/// Whether p lies in the room at a distance from its sides of at least 1e-6 of its size. `flat`:
/// the axis on which the room has no extent, or -1.
bool strictly_inside(const Vec3& p, const Box3& room, int flat);

/// Whether p is so near to the room (a cell, or a face of one) that the probe's candidates are
/// complete there.
bool in_reach(const Vec3& p, const Box3& room);

}  // namespace mrsim::detail
