// Places vertices on the exact surface: on edges of the grid, in its faces, in its cells; on
// creases and corners where faces of the part meet (docs/mesh.md, Vertices).
#pragma once

#include "mesh/contour_lattice.h"
#include "removal/field.h"

#include <span>
#include <vector>

namespace mrsim::detail {

inline bool same_face(const FieldSample& a, const FieldSample& b) {
  return a.owner == b.owner && a.patch == b.patch;
}

/// The field with the sweeps that matter here.
struct Probe {
  const ExactField& field;
  std::span<const std::uint32_t> candidates;
  double shallow = 0;  ///< mm: creases that need not be found if cutting them off moves less

  FieldSample sample(const Vec3& p) const { return field.sample(p, candidates); }
  double offset(const Vec3& p) const { return sample(p).distance + kInsideTolerance; }
};

/// A point of the surface and the faces of the part that meet in it.
struct SurfacePoint {
  Vec3 position;
  FieldSample faces[3];
  int count = 0;  ///< 1 smooth, 2 crease, 3 corner; 0 = none found
};

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
  /// Takes the sample at point(); true when that is the crossing.
  bool take(const ExactField& field, const FieldSample& sample);

 private:
  Vec3 from_, along_, point_, normal_;
  FieldSample at_;
  double size_, a_ = 0, b_ = 1, fa_, fb_, t_;
  int side_ = 0, steps_ = 0;
};
Vec3 find_crossing(const Probe& probe, const Vec3& inside, const Vec3& outside);

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
  /// What was found; count = 0: nothing.
  SurfacePoint result() const;

 private:
  void follow(const ExactField& field, const FieldSample& face, double d);

  Box3 room_;
  Vec3 point_;
  FieldSample at_;
  int steps_ = 0;
  bool found_ = false;
};

/// Runs searches that share their candidates to their ends, sampling for all of them at once.
template <class Search>
void run_together(const Probe& probe, std::span<Search> searches) {
  static thread_local std::vector<std::size_t> open;
  static thread_local std::vector<Vec3> points;
  static thread_local std::vector<FieldSample> samples;
  open.clear();
  for (std::size_t k = 0; k < searches.size(); ++k) open.push_back(k);
  while (!open.empty()) {
    points.clear();
    for (const std::size_t k : open) points.push_back(searches[k].point());
    samples.resize(points.size());
    probe.field.samples(points, probe.candidates, samples.data());
    std::size_t left = 0;
    for (std::size_t i = 0; i < open.size(); ++i)
      if (!searches[open[i]].take(probe.field, samples[i])) open[left++] = open[i];
    open.resize(left);
  }
}

/// A point of the surface and the unit normal of the part's face there.
struct SurfaceElement {
  Vec3 position, normal;
};
/// True where the surface between the two points leaves their chord so little that a cell of `size`
/// mm may cut off a crease between them. A sufficient test, for any faces.
bool is_nearly_flat(const Probe& probe, const SurfaceElement& a, const SurfaceElement& b,
                    double size);

/// True where the two faces join smoothly about p, or so nearly that a cell of `size` mm may cut
/// off their crease: none is looked for.
bool join_smoothly(const Probe& probe, const Vec3& p, const FieldSample& a, const FieldSample& b,
                   double size);

/// Newton's iteration from p to the common zero of up to three faces of the part, within the plane
/// where coordinate `plane_axis` is kept (-1: none). False where it does not settle near `room`.
bool solve_faces(const ExactField& field, std::span<const FieldSample> faces, int plane_axis,
                 const Box3& room, Vec3& p);

/// A point on the surface strictly inside the rectangle `room`, flat on `axis`: on the crease of a
/// and b, or smooth where b is null. count = 0 where there is none.
SurfacePoint point_in_face(const Probe& probe, const Box3& room, int axis, const Vec3& start,
                           const FieldSample& a, const FieldSample* b);

/// Where a crease passes the rectangle between two points of the surface on its border, which lie
/// on faces a and b of the part.
SurfacePoint crease_in_face(const Probe& probe, const Box3& room, int axis, const Vec3& from,
                            const FieldSample& a, const Vec3& to, const FieldSample& b);

/// A point of the surface between the middle of `room` and one of the points, of which the two
/// nearest in order lie on different sides. Requires: points on the border of the room.
SurfacePoint point_towards_middle(const Probe& probe, const Box3& room,
                                  std::span<const Vec3> points);

/// What a cell's vertex is placed by: crossings of the grid's edges, and points where creases enter
/// the cell through its faces.
struct CellHints {
  std::span<const Vec3> crossings;
  std::span<const FieldSample> faces;  ///< of the crossings
  std::span<const Vec3> creases;       ///< may be empty
};

/// A point on the surface strictly inside `room`, as sharp as the part is there. count = 0: none.
SurfacePoint point_in_cell(const Probe& probe, const Box3& room, const CellHints& hints);

/// The crease of two of the faces nearest to `start`, in or near the room but not necessarily
/// inside: the tip of a ridge that passes between the edges of the grid. `axis` as in
/// point_in_face, -1: free.
SurfacePoint crease_near(const Probe& probe, const Box3& room, int axis, const Vec3& start,
                         std::span<const FieldSample> faces);

/// p rounded, in the interior of the rectangle, which is flat on `axis`.
Vec3 snap_inside(const Vec3& p, const Box3& room, int axis);

}  // namespace mrsim::detail
