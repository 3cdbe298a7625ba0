#define EIGEN_DONT_VECTORIZE  // the same bits on every machine
#include "compare/distance/align.h"

#include "core/numbers/trig.h"
#include "core/numbers/vec.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace mrsim {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kSettled = 1e-9;  // of the part's reach: a step that moves no digit of the result
constexpr int kMostSteps = 60;
constexpr double kTukeyWidth = 4.685;           // standard deviations (Holland and Welsch 1977)
constexpr double kDeviationsOfMedian = 1.4826;  // a standard deviation by the median of |residuals|
constexpr double kNarrowest = 1e-5;             // of the part's reach: no width is less
constexpr double kSlides = 1e-6;  // of the largest eigenvalue: directions of less are left out

// Rodrigues' formula about the axis w / |w| by |w| radians.
RigidTransform rotation_by(const Vec3& w) {
  const double angle = length(w);
  RigidTransform t;
  if (angle == 0) return t;
  const Vec3 k = (1 / angle) * w;
  const SinCos a = sincos(angle);
  for (int i = 0; i < 3; ++i) {
    Vec3 unit;
    component(unit, i) = 1;
    const Vec3 column = a.cos * unit + a.sin * cross(k, unit) + ((1 - a.cos) * dot(k, unit)) * k;
    for (int j = 0; j < 3; ++j) component(t.rotation[std::size_t(j)], i) = component(column, j);
  }
  return t;
}

struct Residual {
  Vec3 point, normal;
  double value = 0;
};

std::vector<Residual> residuals(const std::vector<Vec3>& points, const NominalSurface& nominal,
                                const RigidTransform& t, int threads) {
  std::vector<Vec3> moved(points.size());
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = apply(t, points[i]);
  std::vector<SurfaceHit> hits(points.size());
  nominal.query(moved, hits, threads);
  std::vector<Residual> out(points.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const TriangleTree::Corners k = nominal.tree().corners(hits[i].triangle);
    const Vec3 foot = nearest_on_triangle(moved[i], k.a, k.b, k.c).point;
    const Vec3 n = nominal.tree().normal(hits[i].triangle);
    out[i] = {moved[i], n, dot(moved[i] - foot, n)};
  }
  return out;
}

// The side of a box that a normal belongs to, 0 .. 5.
std::size_t side_of(const Vec3& n) {
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  if (z >= x && z >= y) return n.z < 0 ? 5 : 4;
  if (y >= x) return n.y < 0 ? 3 : 2;
  return n.x < 0 ? 1 : 0;
}

// Width beyond which a residual counts nothing, by the median, never so narrow that rounding
// decides. One for each side: on a plate the large faces fit at once, and
// their median would call its edges outliers.
std::array<double, 6> tukey_widths(const std::vector<Residual>& all, double floor) {
  std::array<std::vector<double>, 6> sizes;
  for (const Residual& r : all) sizes[side_of(r.normal)].push_back(std::abs(r.value));
  std::array<double, 6> out;
  for (std::size_t i = 0; i < 6; ++i) {
    out[i] = floor;
    if (sizes[i].empty()) continue;
    const auto middle = sizes[i].begin() + long(sizes[i].size() / 2);
    std::nth_element(sizes[i].begin(), middle, sizes[i].end());
    out[i] = std::max(kTukeyWidth * kDeviationsOfMedian * *middle, floor);
  }
  return out;
}

struct Step {
  RigidTransform move;
  double size = 0;
};

// One weighted least-squares step about `pivot`, in lengths of `reach` for the angles.
Step solve(const std::vector<Residual>& all, const Vec3& pivot, double reach) {
  const std::array<double, 6> widths = tukey_widths(all, kNarrowest * reach);
  Matrix6 a = Matrix6::Zero();
  Vector6 b = Vector6::Zero();
  for (const Residual& r : all) {
    const double u = r.value / widths[side_of(r.normal)];
    if (std::abs(u) >= 1) continue;
    const double weight = (1 - u * u) * (1 - u * u);
    const Vec3 c = (1 / reach) * cross(r.point - pivot, r.normal);
    Vector6 row;
    row << c.x, c.y, c.z, r.normal.x, r.normal.y, r.normal.z;
    a += weight * row * row.transpose();
    b -= weight * r.value * row;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(a);
  Vector6 x = Vector6::Zero();
  for (int i = 0; i < 6; ++i) {
    const double value = eigen.eigenvalues()[i];
    if (value <= kSlides * eigen.eigenvalues()[5]) continue;
    const Vector6 v = eigen.eigenvectors().col(i);
    x += (v.dot(b) / value) * v;
  }
  const Vec3 turn{x[0] / reach, x[1] / reach, x[2] / reach}, shift{x[3], x[4], x[5]};
  Step out{rotation_by(turn), length(shift) + reach * length(turn)};
  out.move.shift = pivot + shift - rotate(out.move, pivot);
  return out;
}

double rms_of(const std::vector<Residual>& all) {
  double sum = 0;
  for (const Residual& r : all) sum += r.value * r.value;
  return std::sqrt(sum / double(std::max<std::size_t>(all.size(), 1)));
}

}  // namespace

Vec3 rotate(const RigidTransform& t, const Vec3& v) {
  return {dot(t.rotation[0], v), dot(t.rotation[1], v), dot(t.rotation[2], v)};
}

Vec3 apply(const RigidTransform& t, const Vec3& p) { return rotate(t, p) + t.shift; }

RigidTransform compose(const RigidTransform& a, const RigidTransform& b) {
  RigidTransform out;
  for (int column = 0; column < 3; ++column) {
    Vec3 v;
    for (int row = 0; row < 3; ++row)
      component(v, row) = component(b.rotation[std::size_t(row)], column);
    const Vec3 turned = rotate(a, v);
    for (int row = 0; row < 3; ++row)
      component(out.rotation[std::size_t(row)], column) = component(turned, row);
  }
  out.shift = apply(a, b.shift);
  return out;
}

TriMesh transformed(const TriMesh& mesh, const RigidTransform& t) {
  TriMesh out = mesh;
  if (t == RigidTransform{}) return out;
  for (auto& v : out.vertices) {
    const Vec3 p = apply(t, to_vec(v));
    v = {float(p.x), float(p.y), float(p.z)};
  }
  return out;
}

double angle_of(const RigidTransform& t) {
  const Vec3 axis{t.rotation[2].y - t.rotation[1].z, t.rotation[0].z - t.rotation[2].x,
                  t.rotation[1].x - t.rotation[0].y};
  const double trace = t.rotation[0].x + t.rotation[1].y + t.rotation[2].z;
  return mrsim::atan2(length(axis), trace - 1);
}

RigidTransform align_boxes(const Box3& part, const Box3& nominal) {
  RigidTransform out;
  out.shift = 0.5 * ((nominal.lo + nominal.hi) - (part.lo + part.hi));
  return out;
}

std::vector<RigidTransform> quarter_turns(const Box3& part, const Box3& nominal) {
  std::vector<RigidTransform> out;
  const Vec3 from = 0.5 * (part.lo + part.hi), to = 0.5 * (nominal.lo + nominal.hi);
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) {
      if (x % 3 == y % 3) continue;
      Vec3 first, second;
      component(first, x % 3) = x < 3 ? 1 : -1;
      component(second, y % 3) = y < 3 ? 1 : -1;
      RigidTransform t;
      t.rotation = {first, second, cross(first, second)};
      t.shift = to - rotate(t, from);
      out.push_back(t);
    }
  return out;
}

double rms_at(const std::vector<Vec3>& points, const NominalSurface& nominal,
              const RigidTransform& at, int threads) {
  return rms_of(residuals(points, nominal, at, threads));
}

IcpResult icp(const std::vector<Vec3>& points, const NominalSurface& nominal,
              const RigidTransform& start, int threads) {
  IcpResult out{start, 0, 0, 0};
  const Box3& box = nominal.tree().bounds();
  const double reach = 0.5 * distance(box.lo, box.hi);
  const Vec3 pivot = 0.5 * (box.lo + box.hi);
  std::vector<Residual> all = residuals(points, nominal, start, threads);
  out.rms_before = out.rms_after = rms_of(all);
  for (; out.steps < kMostSteps; ++out.steps) {
    const Step step = solve(all, pivot, reach);
    out.transform = compose(step.move, out.transform);
    all = residuals(points, nominal, out.transform, threads);
    if (step.size < kSettled * reach) break;
  }
  out.rms_after = rms_of(all);
  return out;
}

}  // namespace mrsim
