#include "removal/columns/sweep_columns.h"

#include "removal/columns/plan_foot.h"
#include "removal/forms/path_sweep.h"
#include "removal/forms/sweep_motion.h"
#include "removal/forms/tool_at_rest.h"
#include "removal/simd/scalar_forms.h"

#include <algorithm>

namespace mrsim {

Box3 SweepColumns::bounds_of(const SweepRef& ref) const {
  if (ref.kind == SweepKind::ball_line) return bounds_of_line(ref, ball_lines[ref.row]);
  if (ref.kind == SweepKind::plane_line) return bounds_of_line(ref, plane_lines[ref.row]);
  return bounds[static_cast<std::size_t>(ref.kind)][ref.row];
}

Box3 SweepColumns::bounds_of_number(std::size_t number) const {
  if (number < refs.size()) return bounds_of(refs[number]);
  if (number >= kFirstPack) {
    const auto at = static_cast<std::uint32_t>(number);
    const SweepPack& pack = packs[at];
    const SweepRef& first = refs[pack.first];
    if (first.kind == SweepKind::ball_line || first.kind == SweepKind::plane_line)
      return inflated(bounds_of_line(first, packs.chord(at)), pack.spread);
    Box3 box;
    for (std::uint32_t i = pack.first; i <= pack.last; ++i) extend(box, bounds_of(refs[i]));
    return box;
  }
  std::vector<std::uint32_t> sweeps;
  turn_tree.append_sweeps(static_cast<std::uint32_t>(number - refs.size()), sweeps);
  Box3 box;
  for (const std::uint32_t s : sweeps) extend(box, bounds_of(refs[s]));
  return box;
}

Box3 SweepColumns::bounds_of_line(const SweepRef& ref, const LineRecord& record) const {
  const Profile& tool = cutter(ref);
  const double* c = record.c;
  Box3 path;
  if (ref.kind == SweepKind::ball_line) {
    extend(path, Vec3{c[BallSlot::x], c[BallSlot::y], c[BallSlot::z] - c[BallSlot::radius]});
    extend(path,
           Vec3{c[BallSlot::x] + c[BallSlot::ux] * c[BallSlot::length],
                c[BallSlot::y] + c[BallSlot::uy] * c[BallSlot::length],
                c[BallSlot::z] - c[BallSlot::radius] + c[BallSlot::slope] * c[BallSlot::length]});
  } else {
    extend(path, Vec3{c[LineSlot::x], c[LineSlot::y], c[LineSlot::low] - c[LineSlot::round]});
    extend(path, Vec3{c[LineSlot::x] + c[LineSlot::dx], c[LineSlot::y] + c[LineSlot::dy],
                      c[LineSlot::low] - c[LineSlot::round]});
  }
  return sweep_bounds(tool, path, ref.frame > 0 ? &frames[ref.frame - 1] : nullptr);
}

double SweepColumns::distance(const SweepRef& ref, const Vec3& p, double limit) const {
  switch (ref.kind) {
    case SweepKind::ball_line:
      return lane::ball_line(ball_lines[ref.row].c, p.x, p.y, p.z);
    case SweepKind::plane_line:
      return lane::plane_line(plane_lines[ref.row].c, p.x, p.y, p.z);
    case SweepKind::plane_arc:
      return lane::plane_arc(plane_arcs[ref.row].c, p.x, p.y, p.z);
    case SweepKind::ball_arc:
      return ball_arc_distance(ball_arcs[ref.row], ball_arcs[ref.row].whole, p);
    case SweepKind::profile: {
      const ProfileRow& row = profiles[ref.row];
      const double rho = row.arc ? lane::arc_rho(row.c, p.x, p.y) : lane::line_rho(row.c, p.x, p.y);
      return tool_distance(cutter(ref), rho, p.z - row.z);
    }
    case SweepKind::path:
      if (is_chain(ref) || is_slant_line(ref)) return path_sample(ref, p).distance;
      return path_value(cutter(ref), *paths[ref.row], p, limit);
    case SweepKind::turn:
      return turn_distance(turns[ref.row], p);
  }
  return 0;
}

PathSample SweepColumns::path_sample(const SweepRef& ref, const Vec3& p) const {
  if (is_chain(ref)) return chain_minimum(chain_tools[ref.shape], chain_lines[ref.row], p);
  if (is_slant_line(ref)) return slant_minimum(slant_lines[ref.row], p);
  return path_distance(cutter(ref), *paths[ref.row], p);
}

SweepColumns::Foot SweepColumns::foot(const SweepRef& ref, const Vec3& p) const {
  if (ref.frame != 0) return {};
  if (ref.kind == SweepKind::ball_arc) {
    const BallArcFoot f = ball_arc_foot(ball_arcs[ref.row], ball_arcs[ref.row].whole, p);
    return {f.squared, f.point - p, false};
  }
  if (ref.kind != SweepKind::profile) return {};
  const PlanFoot f = plan_foot(horizontal_view(*this, ref), p, Half::any);
  return {f.rho * f.rho, {f.x - p.x, f.y - p.y, profiles[ref.row].z - p.z}, !profiles[ref.row].arc};
}

SweepColumns::Numbers SweepColumns::numbers_of(std::span<const std::uint32_t> list) const {
  if (list.empty() || list.back() < refs.size()) return {list, {}, {}};
  const auto below = [&](std::size_t limit) {
    return static_cast<std::size_t>(std::lower_bound(list.begin(), list.end(), limit) -
                                    list.begin());
  };
  const std::size_t sweeps = below(refs.size()), turned = below(kFirstPack);
  return {list.first(sweeps), list.subspan(sweeps, turned - sweeps), list.subspan(turned)};
}

std::span<const std::uint32_t> SweepColumns::sweeps_of(const Numbers& list) const {
  if (list.packs.empty()) return list.sweeps;
  static thread_local std::vector<std::uint32_t> expanded;
  expanded.assign(list.sweeps.begin(), list.sweeps.end());
  for (const std::uint32_t pack : list.packs) append_sweeps(pack, expanded);
  return expanded;
}

}  // namespace mrsim
