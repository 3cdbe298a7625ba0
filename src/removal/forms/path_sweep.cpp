#include "removal/forms/path_sweep.h"

#include "core/numbers/units.h"
#include "removal/forms/disc_sweep.h"
#include "removal/forms/flank_sweep.h"
#include "removal/forms/helix_sweep.h"
#include "removal/forms/path_search.h"
#include "removal/forms/slant_sweep.h"
#include "removal/forms/upright_sweep.h"
#include "removal/simd/scalar_forms.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace mrsim {
namespace {

// Tools with forms of their own, from `begin` to `end` of the path.
std::optional<PathSample> solved(const Profile& tool, const ToolPath& path, const Vec3& p,
                                 double begin, double end) {
  if (path.disc) return disc_minimum(tool, path, p, begin, end);
  return path.flanked ? flank_minimum(tool, path, p, begin, end) : std::nullopt;
}

}  // namespace

PathSample path_distance(const Profile& tool, const ToolPath& path, const Vec3& p, double limit) {
  if (is_slant(tool, path)) return slant_minimum(slant_record(tool, path), p);
  if (const auto least = solved(tool, path, p, 0, path.sweep)) return *least;
  if (path.upright) return upright_minimum(tool, path, p);
  if (has_stretches(tool, path)) return helix_minimum(tool, path, p);
  if (path.lowest_turn) return search_lowest_turn(tool, path, p, limit);
  return search_path(tool, path, p, 0, path.arc ? path.sweep : 1, limit);
}

double path_value(const Profile& tool, const ToolPath& path, const Vec3& p, double limit) {
  if (path.upright) return upright_value(tool, path, p);
  if (path.bored)
    if (const lane::Bore wall = lane::bore(bore_record(tool, path).c, p.x, p.y, p.z); wall.decided)
      return wall.distance;
  if (path.flanked)
    if (const auto least = flank_value(tool, path, p)) return *least;
  return path_distance(tool, path, p, limit).distance;
}

int path_branch(const ToolPath& path, double t) {
  if (path.upright) return upright_branch(path, t);
  const int last = static_cast<int>(path.sweep / (kPi / 2));
  const int branch = static_cast<int>(t / (kPi / 2));
  return branch < last ? branch : last;
}

std::pair<double, double> branch_ends(const ToolPath& path, int branch) {
  const double end = std::min((branch + 1) * (kPi / 2), path.sweep);
  return {std::min(branch * (kPi / 2), end), end};
}

PathSample branch_distance(const Profile& tool, const ToolPath& path, const Vec3& p, int branch) {
  if (path.upright) return upright_branch_minimum(tool, path, p, branch);
  const auto [begin, end] = branch_ends(path, branch);
  if (const auto least = solved(tool, path, p, begin, end)) return *least;
  if (has_stretches(tool, path)) return helix_branch_minimum(tool, path, p, branch);
  return search_path(tool, path, p, begin, end);
}

PathSample piece_distance(const Profile& piece, const ToolPath& path, const Vec3& p, int branch) {
  const auto [begin, end] = path.arc ? branch_ends(path, branch) : std::pair(0.0, 1.0);
  return search_path(piece, path, p, begin, end);
}

}  // namespace mrsim
