// Random tools on random motions: either refused with an Error, or a distance that is a number,
// 1-Lipschitz, below zero only within the bounds, with unit gradients, and equal in lists.
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/prune/candidate_list.h"
#include "removal/prune/list_candidates.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/sweep/sweep_table.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

namespace {

using namespace mrsim;

// Numbers from the input; zeros when it is used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  unsigned byte() { return at_ < size_ ? data_[at_++] : 0; }
  /// In [lo, hi], in steps coarse enough to hit coincidences.
  double number(double lo, double hi) {
    const unsigned v = byte() << 8 | byte();
    return lo + (hi - lo) * (v / 65535.0);
  }
  double round_number(double hi) { return std::floor(number(0, 2 * hi)) / 2; }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

Tool random_tool(Bytes& in) {
  Tool t;
  t.id.assign(1, '1');
  t.type = static_cast<ToolType>(in.byte() % 14);
  t.diameter = in.round_number(12);
  t.corner_radius = in.byte() % 2 ? in.round_number(6) : 0;
  t.taper_angle = in.number(0, 1.5);
  t.tip_angle = in.byte() % 2 ? in.number(0, 3.1) : 0;
  t.tip_diameter = in.byte() % 2 ? in.round_number(10) : 0;
  t.neck_diameter = in.round_number(6);
  t.profile_radius = in.round_number(60);
  t.flute_length = in.byte() % 2 ? in.round_number(20) : 0;
  double z = 0;
  for (unsigned i = in.byte() % 6; i > 0; --i) {
    t.profile.push_back(
        {t.profile.empty() ? 0 : in.round_number(8), z, in.byte() % 3 ? 0 : in.number(-1, 1)});
    z += in.round_number(4);
  }
  const char shapes[] = "CDVTWSRKX";
  t.insert.assign(1, shapes[in.byte() % 9]);
  t.nose_radius = in.round_number(2);
  t.lead_angle = in.byte() % 2 ? in.number(0, 3.1) : 0;
  t.width = in.round_number(6);
  t.tip = static_cast<int>(in.byte() % 10);
  t.left_hand = in.byte() % 2;
  return t;
}

Vec3 random_point(Bytes& in, double size) {
  return {in.number(-size, size), in.number(-size, size), in.number(-size, size)};
}

Motion random_motion(Bytes& in, bool turning) {
  Motion m;
  m.tool = 0;
  m.line = 1;
  m.kind = in.byte() % 2 ? MotionKind::arc : MotionKind::line;
  m.start = random_point(in, 20);
  m.end = random_point(in, 20);
  const unsigned flat = in.byte();
  if (flat % 4 == 1) m.end.z = m.start.z;
  if (flat % 4 == 2) m.end.x = m.start.x, m.end.y = m.start.y;
  if (turning) m.start.y = m.end.y = 0;
  if (m.kind == MotionKind::line) return m;
  const Vec3 axes[] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, normalized(Vec3{1, 2, 3})};
  m.axis = turning ? axes[1] : axes[in.byte() % 4];
  const Vec3 w = m.end - m.start;
  m.center = m.start + (w - dot(w, m.axis) * m.axis);
  m.radius = distance(m.start, m.center);
  m.sweep = in.number(-20, 20);
  m.rise = turning || in.byte() % 2 ? 0 : in.number(-10, 10);
  return m;
}

void check(bool ok) {
  if (!ok) std::abort();
}

// `count`: of points asked at once.
void check_point(const SweepTable& s, std::size_t count, Bytes& in) {
  const double slack = 2 * s.max_error() + 1e-9;
  const Vec3 p = random_point(in, 30), q = p + random_point(in, in.byte() % 2 ? 1 : 0.01);
  const double d = s.distance(0, p), e = s.distance(0, q);
  check(std::isfinite(d) && std::isfinite(e));
  check(std::fabs(d - e) <= distance(p, q) + slack);
  const Box3 b = inflated(s.bounds(0), slack);
  check(d >= 0 || (p.x >= b.lo.x && p.y >= b.lo.y && p.z >= b.lo.z && p.x <= b.hi.x &&
                   p.y <= b.hi.y && p.z <= b.hi.z));
  const SweepSample at = s.sample(0, p);
  check(at.distance == d);
  check(std::fabs(length(s.gradient(0, p, at.patch)) - 1) < 1e-6);
  const std::uint32_t ids[] = {0, 0, 0};
  double out[3];
  s.distances(ids, p, out);
  check(out[0] == d && out[2] == d);
  CandidateList list;
  list_candidates(s, {ids, 1}, p, list);
  PointColumns points{};
  points.count = count;
  for (std::size_t k = 0; k < points.count; ++k) {
    const Vec3& at_k = k % 2 ? q : p;
    points.x[k] = at_k.x, points.y[k] = at_k.y, points.z[k] = at_k.z;
    points.least[k] = INFINITY;
  }
  least_distances(s, list, points);
  check(points.least[0] == d && points.least[1] == e && (count < 7 || points.least[6] == d));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes in(data, size);
  const Tool tool = random_tool(in);
  const Motion motion = random_motion(in, is_turning(tool.type));
  // Tools that are neither convex nor level cost a millisecond a value, tilted arcs half of one.
  const bool form = tool.type == ToolType::form;
  const int points = form ? 1 : motion.kind == MotionKind::arc ? 4 : 12;
  try {
    const SweepTable s({&motion, 1}, {&tool, 1});
    for (int k = 0; k < points && s.size() == 1; ++k) check_point(s, form ? 2 : 8, in);
  } catch (const Error&) {
  }
  return 0;
}
