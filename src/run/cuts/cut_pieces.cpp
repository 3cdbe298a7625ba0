#include "run/cuts/cut_pieces.h"

#include "core/numbers/motions.h"
#include "core/numbers/trig.h"
#include "core/numbers/vec.h"
#include "core/process/memory_limit.h"
#include "removal/history/cut_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

namespace mrsim {
namespace {

int pieces_in(const CutList& cuts, const Motion& m, double voxel, const PieceRule& rule) {
  if (!is_cut(m) || m.tool < 0) return 1;
  return pieces_of(m, cuts.tools()[static_cast<std::size_t>(m.tool)], voxel, rule);
}

bool is_plunge(const Motion& m, const Tool& tool) {
  return m.kind == MotionKind::line && !is_turning(tool.type) && is_along_axis(m);
}

// The motion from share `from` of its way to share `to`.
Motion part_of(const Motion& m, double from, double to) {
  Motion out = m;
  if (m.kind != MotionKind::arc) {
    out.start = lerp(m.start, m.end, from);
    if (to < 1) out.end = lerp(m.start, m.end, to);
    return out;
  }
  const Vec3 arm = m.start - m.center, across = cross(m.axis, arm);
  const Vec3 along = dot(m.axis, arm) * m.axis;  // the part of the arm that does not turn
  const auto at = [&](double share) {
    const SinCos turned = sincos(m.sweep * share);
    return m.center + along + turned.cos * (arm - along) + turned.sin * across +
           (m.rise * share) * m.axis;
  };
  out.sweep = m.sweep * (to - from);
  out.rise = m.rise * (to - from);
  out.center = m.center + (m.rise * from) * m.axis;
  if (from > 0) out.start = at(from);
  if (to < 1) out.end = at(to);
  return out;
}

}  // namespace

int pieces_of(const Motion& m, const Tool& tool, double voxel, const PieceRule& rule) {
  if (m.kind == MotionKind::rapid || (m.kind == MotionKind::arc && !rule.arcs)) return 1;
  const PieceLength& length = is_plunge(m, tool) ? rule.plunge : rule.length;
  const double piece = std::max(length.diameters * tool.diameter, length.voxels * voxel);
  return static_cast<int>(std::clamp(std::floor(length_of(m) / piece), 1.0, rule.most));
}

double piece_voxel(const CutList& cuts, double voxel, const PieceRule& rule) {
  if (cuts.motions().size() > rule.in_all) return std::numeric_limits<double>::infinity();
  while (true) {
    std::size_t count = 0;
    for (const Motion& m : cuts.motions())
      count += static_cast<std::size_t>(pieces_in(cuts, m, voxel, rule));
    if (count <= rule.in_all || count == cuts.motions().size()) return voxel;
    voxel *= 2;
  }
}

CutPieces divide_cuts(const CutList& cuts, double voxel, const PieceRule& rule) {
  CutPieces out;
  if (!std::isfinite(voxel)) {
    out.first.resize(cuts.motions().size() + 1);
    std::iota(out.first.begin(), out.first.end(), std::size_t(0));
    return out;
  }
  std::size_t pieces = 0;
  for (const Motion& m : cuts.motions())
    pieces += static_cast<std::size_t>(pieces_in(cuts, m, voxel, rule));
  require_memory(double(pieces) * sizeof(Motion),
                 fmt::format("what each of {} pieces of cuts removes", pieces));
  out.motions.reserve(pieces);
  out.first.reserve(cuts.motions().size() + 1);
  for (const Motion& m : cuts.motions()) {
    out.first.push_back(out.motions.size());
    const int count = pieces_in(cuts, m, voxel, rule);
    for (int k = 0; k < count; ++k)
      out.motions.push_back(count == 1 ? m
                                       : part_of(m, static_cast<double>(k) / count,
                                                 static_cast<double>(k + 1) / count));
  }
  out.first.push_back(out.motions.size());
  return out;
}

}  // namespace mrsim
