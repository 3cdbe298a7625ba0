#include "removal/vdb/reach.h"

#include "core/vec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include <openvdb/tools/Interpolation.h>

namespace mrsim {
namespace {

constexpr int kMostSteps = 96;  // of the lattice along its longest side
constexpr int kStages = 6;
// Lattice steps that a place may be beside a tool: centres on the lattice miss the best one by as
// much.
constexpr double kSlack = 0.4;
constexpr double kError = 3;  // steps of the lattice, of a diameter
constexpr double kFar = 1e12;

// Points about some places, with whether each lies in the solid.
struct Lattice {
  Vec3 origin;
  double step = 0;
  std::array<int, 3> size{};
  std::vector<char> solid;  // x fastest, then y

  std::size_t index(int x, int y, int z) const {
    const auto wide = static_cast<std::size_t>(size[0]), deep = static_cast<std::size_t>(size[1]);
    return (static_cast<std::size_t>(z) * deep + static_cast<std::size_t>(y)) * wide +
           static_cast<std::size_t>(x);
  }
  Vec3 point(int x, int y, int z) const {
    return origin + step * Vec3{double(x), double(y), double(z)};
  }
};

Box3 bounds_of(std::span<const Vec3> places) {
  Box3 box;
  for (const Vec3& p : places) extend(box, p);
  return box;
}

// Holds all tools up to `radius` that touch one of the places.
Lattice make_lattice(const openvdb::FloatGrid& solid, const Box3& places, double radius) {
  const double voxel = solid.voxelSize().x();
  const Vec3 margin = (2 * radius + 3 * voxel) * Vec3{1, 1, 1};
  const Box3 box{places.lo - margin, places.hi + margin};
  const Vec3 length = box.hi - box.lo;
  Lattice out;
  out.step = std::max(voxel, std::max({length.x, length.y, length.z}) / kMostSteps);
  out.origin = box.lo;
  out.size = {int(length.x / out.step) + 2, int(length.y / out.step) + 2,
              int(length.z / out.step) + 2};
  out.solid.resize(out.index(0, 0, out.size[2]));
  const openvdb::FloatGrid::ConstAccessor accessor = solid.getConstAccessor();
  const openvdb::tools::GridSampler<openvdb::FloatGrid::ConstAccessor, openvdb::tools::BoxSampler>
      at(accessor, solid.transform());
  for (int z = 0; z < out.size[2]; ++z)
    for (int y = 0; y < out.size[1]; ++y)
      for (int x = 0; x < out.size[0]; ++x) {
        const Vec3 p = out.point(x, y, z);
        out.solid[out.index(x, y, z)] = at.wsSample({p.x, p.y, p.z}) < 0;
      }
  return out;
}

// Squared distances along one line from the parabolas that stand on it (Felzenszwalb and
// Huttenlocher 2012). `line` is read and written.
void transform(std::vector<double>& line, std::vector<int>& at, std::vector<double>& from,
               std::vector<double>& out) {
  const int n = static_cast<int>(line.size());
  at.resize(line.size());
  from.resize(line.size() + 1);
  out.resize(line.size());
  const auto value = [&](int i) { return line[static_cast<std::size_t>(i)] + double(i) * i; };
  int k = 0;
  at[0] = 0;
  from[0] = -kFar;
  from[1] = kFar;
  for (int q = 1; q < n; ++q) {
    double s = 0;
    while (true) {
      const int v = at[static_cast<std::size_t>(k)];
      s = (value(q) - value(v)) / (2.0 * (q - v));
      if (k == 0 || s > from[static_cast<std::size_t>(k)]) break;
      --k;
    }
    if (s > from[static_cast<std::size_t>(k)]) ++k;
    at[static_cast<std::size_t>(k)] = q;
    from[static_cast<std::size_t>(k)] = k == 0 ? -kFar : s;
    from[static_cast<std::size_t>(k) + 1] = kFar;
  }
  k = 0;
  for (int q = 0; q < n; ++q) {
    while (from[static_cast<std::size_t>(k) + 1] < q) ++k;
    const int v = at[static_cast<std::size_t>(k)];
    out[static_cast<std::size_t>(q)] = double(q - v) * (q - v) + line[static_cast<std::size_t>(v)];
  }
  line.swap(out);
}

// Squared distances, in steps, from the marked points of a slice or a lattice; kFar without any.
std::vector<double> distances2(const std::vector<char>& marked, const std::array<int, 3>& size) {
  std::vector<double> out(marked.size());
  for (std::size_t i = 0; i < marked.size(); ++i) out[i] = marked[i] != 0 ? 0 : kFar;
  std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(size[0]), 0};
  stride[2] = stride[1] * static_cast<std::size_t>(size[1]);
  std::vector<double> line, spare, from;
  std::vector<int> at;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto count = static_cast<std::size_t>(size[axis]);
    if (count < 2) continue;
    for (std::size_t i = 0; i < out.size(); ++i) {
      if (i / stride[axis] % count != 0) continue;
      line.resize(count);
      for (std::size_t k = 0; k < count; ++k) line[k] = out[i + k * stride[axis]];
      transform(line, at, from, spare);
      for (std::size_t k = 0; k < count; ++k) out[i + k * stride[axis]] = line[k];
    }
  }
  return out;
}

// Radii, mm, of the largest tools centred at each point, 0 in the solid.
std::vector<float> free_radii(const std::vector<char>& marked, const std::array<int, 3>& size,
                              double step, double most) {
  const std::vector<double> squares = distances2(marked, size);
  std::vector<float> out(squares.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = float(std::clamp((std::sqrt(squares[i]) - 0.5) * step, 0.0, most));
  return out;
}

// Of the tools that come to `place`, the largest; `place` in steps from the first point.
double largest_at(const std::vector<float>& radii, const std::array<int, 3>& size,
                  const Vec3& place, double step, double most) {
  const double far = most / step + 1;
  const auto first = [&](double at) { return std::max(0, int(at - far)); };
  const auto end = [&](double at, int count) { return std::min(count, int(at + far) + 2); };
  const auto wide = static_cast<std::size_t>(size[0]), deep = static_cast<std::size_t>(size[1]);
  double best = 0;
  for (int z = first(place.z); z < end(place.z, size[2]); ++z)
    for (int y = first(place.y); y < end(place.y, size[1]); ++y)
      for (int x = first(place.x); x < end(place.x, size[0]); ++x) {
        const std::size_t i =
            (static_cast<std::size_t>(z) * deep + static_cast<std::size_t>(y)) * wide +
            static_cast<std::size_t>(x);
        if (!(radii[i] > best)) continue;
        const Vec3 way = step * (Vec3{double(x), double(y), double(z)} - place);
        const double reach = radii[i] + kSlack * step;
        if (dot(way, way) <= reach * reach) best = radii[i];
      }
  return best;
}

double ball_radius(const Lattice& lattice, std::span<const Vec3> places, double most) {
  const std::vector<float> radii = free_radii(lattice.solid, lattice.size, lattice.step, most);
  double least = most;
  for (const Vec3& p : places)
    least =
        std::min(least, largest_at(radii, lattice.size, (1 / lattice.step) * (p - lattice.origin),
                                   lattice.step, most));
  return least;
}

// In each slice the solid's shadow: what lies in it or anywhere above.
double cylinder_radius(Lattice lattice, std::span<const Vec3> places, double most) {
  const auto slice = lattice.index(0, 0, 1);
  for (int z = lattice.size[2] - 2; z >= 0; --z)
    for (std::size_t i = lattice.index(0, 0, z); i < lattice.index(0, 0, z + 1); ++i)
      lattice.solid[i] = lattice.solid[i] != 0 || lattice.solid[i + slice] != 0;
  const std::array<int, 3> size{lattice.size[0], lattice.size[1], 1};
  std::vector<std::vector<float>> radii(static_cast<std::size_t>(lattice.size[2]));
  double least = most;
  for (const Vec3& p : places) {
    const Vec3 at = (1 / lattice.step) * (p - lattice.origin);
    const int z = static_cast<int>(std::ceil(at.z));  // a bottom above the place leaves less
    std::vector<float>& of_slice = radii[static_cast<std::size_t>(z)];
    if (of_slice.empty()) {
      const auto first =
          lattice.solid.begin() + static_cast<std::ptrdiff_t>(lattice.index(0, 0, z));
      of_slice =
          free_radii({first, first + static_cast<std::ptrdiff_t>(slice)}, size, lattice.step, most);
    }
    least = std::min(least, largest_at(of_slice, size, {at.x, at.y, 0}, lattice.step, most));
  }
  return least;
}

using RadiusOn = std::function<double(const Lattice&, std::span<const Vec3>, double)>;

Reach search(const openvdb::FloatGrid& solid, std::span<const Vec3> places, double most,
             const RadiusOn& radius_on) {
  if (places.empty()) return {};
  const Box3 box = bounds_of(places);
  const double voxel = solid.voxelSize().x();
  double tried = most / 2;
  Reach found;
  for (int stage = 0; stage < kStages; ++stage) {
    const Lattice lattice = make_lattice(solid, box, tried);
    const double radius = radius_on(lattice, places, tried);
    found = {2 * radius, kError * lattice.step, stage == 0 && radius >= tried - lattice.step};
    const double next = std::min(1.25 * radius + 2 * lattice.step, tried);
    if (lattice.step <= voxel || next > 0.9 * tried || found.is_least) break;
    tried = next;
  }
  return found;
}

}  // namespace

Reach largest_ball(const openvdb::FloatGrid& solid, std::span<const Vec3> places, double most) {
  return search(solid, places, most, ball_radius);
}

Reach largest_cylinder(const openvdb::FloatGrid& solid, std::span<const Vec3> places, double most) {
  return search(solid, places, most, cylinder_radius);
}

}  // namespace mrsim
