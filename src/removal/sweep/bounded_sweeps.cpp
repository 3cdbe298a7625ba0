#include "removal/sweep/bounded_sweeps.h"

#include "core/numbers/vec.h"
#include "removal/forms/chain_sweep.h"
#include "removal/forms/slant_sweep.h"
#include "removal/simd/sweep_kernels.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr std::size_t kLongList = 32;  // sweeps: shorter lists are searched without runs of moves

constexpr std::uint32_t kChainTag =
    kOtherForm << kTagShift | static_cast<std::uint32_t>(SingleForm::chain) << kSingleShift;

bool is_chain_tag(std::uint32_t tag) { return (tag & ~kSingleRow) == kChainTag; }

// Lower bounds of the distances of a chunk of single sweeps. A bound costs less than a distance: it
// follows from planes for straight moves, and from the bounding box for others.
class SingleBounds {
 public:
  SingleBounds(const SweepColumns& c, const Vec3& p) : c_(c), p_(p) {}

  /// Finds lower bounds (up to 1e-8 mm) of the distances of up to kListChunk sweeps. A result above
  /// `limit` only means *above limit*. It is minus infinity where nothing is known.
  void find(std::span<const std::uint32_t> ids, double limit) {
    ListPart slants, chains, bores;
    is_known_.reset();
    OutlinePart lines, arcs;
    const bool one_tool = c_.chain_tools.size() == 1;
    std::int32_t tool = 0;  // of `chains`
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const std::uint32_t tag = c_.tags[ids[k]], row = tag & kSingleRow;
      if (is_chain_tag(tag)) {
        const std::int32_t own = one_tool ? 0 : c_.refs[ids[k]].shape;
        if (chains.n > 0 && own != tool) add_chains(tool, limit, chains);
        tool = own;
        chains.add(row, k);
      } else if (single_form(tag) == SingleForm::slant) {
        slants.add(row, k);
      } else if (single_form(tag) == SingleForm::bore) {
        bores.add(row, k);
      } else if (single_form(tag) == SingleForm::outline) {
        add_outline(ids[k], row, k, limit, c_.profiles[row].arc ? arcs : lines);
      } else {
        bounds_[k] = box_bound(c_.bounds_of(c_.refs[ids[k]]), p_);
      }
    }
    find_outlines(limit, lines);
    find_outlines(limit, arcs);
    if (slants.n > 0) {
      sweep_kernels().slant_bounds(c_.slant_lines.data(), slants.rows, slants.n, p_, found_);
      scatter(slants);
    }
    if (chains.n > 0) add_chains(tool, limit, chains);
    if (bores.n > 0) find_bores(ids, bores);
  }
  double operator[](std::size_t k) const { return bounds_[k]; }
  /// Whether the bound is the distance.
  bool is_known(std::size_t k) const { return is_known_[k]; }

 private:
  void add_chains(std::int32_t tool, double limit, ListPart& chains) {
    sweep_kernels().chain_bounds(c_.chain_tools[tool], c_.chain_lines.data(), chains.rows, chains.n,
                                 p_, limit, found_);
    scatter(chains);
    chains.n = 0;
  }
  // A turn that is not whole may end far from p.
  void find_bores(std::span<const std::uint32_t> ids, const ListPart& bores) {
    std::uint8_t decided[kListChunk];
    sweep_kernels().bore_bounds(c_.bores.data(), bores.rows, bores.n, p_, found_, decided);
    scatter(bores);
    for (std::size_t k = 0; k < bores.n; ++k) {
      const std::uint32_t slot = bores.slots[k];
      is_known_[slot] = decided[k] != 0;
      if (!is_known_[slot])
        bounds_[slot] = std::max(bounds_[slot], box_bound(c_.bounds_of(c_.refs[ids[slot]]), p_));
    }
  }
  // Horizontal paths of one tool with an outline, all arcs or all lines.
  struct OutlinePart {
    ListPart part;
    std::int32_t tool = 0;
  };
  void add_outline(std::uint32_t id, std::uint32_t row, std::size_t place, double limit,
                   OutlinePart& paths) {
    const std::int32_t tool = c_.refs[id].shape;
    if (tool != paths.tool) find_outlines(limit, paths);
    paths.tool = tool;
    paths.part.add(row, place);
  }
  // Their distances take the place of bounds: no bound is better.
  void find_outlines(double limit, OutlinePart& paths) {
    ListPart& part = paths.part;
    if (part.n == 0) return;
    sweep_kernels().outline_list(c_.outlines[static_cast<std::size_t>(paths.tool)],
                                 c_.profiles.data(), part.rows, part.n, p_, limit, found_);
    scatter(part);
    part.n = 0;
  }
  void scatter(const ListPart& part) {
    for (std::size_t k = 0; k < part.n; ++k) bounds_[part.slots[k]] = found_[k];
  }

  const SweepColumns& c_;
  Vec3 p_;
  double bounds_[kListChunk];
  double found_[kListChunk];
  std::bitset<kListChunk> is_known_;
};

}  // namespace

double box_bound(const Box3& box, const Vec3& p) {
  const auto beyond = [](double low, double x, double high) {
    return std::max(std::max(low - x, x - high), 0.0);
  };
  const double x = beyond(box.lo.x, p.x, box.hi.x), y = beyond(box.lo.y, p.y, box.hi.y),
               z = beyond(box.lo.z, p.z, box.hi.z);
  const double square = x * x + y * y + z * z;
  return square > 0 ? std::sqrt(square) : -std::numeric_limits<double>::infinity();
}

std::optional<std::uint32_t> least_bound(const SweepColumns& c, std::span<const std::uint32_t> ids,
                                         const Vec3& p) {
  SingleBounds bounds(c, p);
  double least = std::numeric_limits<double>::infinity();
  std::optional<std::uint32_t> best;
  for (; !ids.empty(); ids = ids.subspan(std::min(kListChunk, ids.size()))) {
    const auto some = ids.first(std::min(kListChunk, ids.size()));
    bounds.find(some, least);
    for (std::size_t k = 0; k < some.size(); ++k)
      if (bounds[k] < least) least = bounds[k], best = some[k];
  }
  return best;
}

BoundedSweeps::Memory& BoundedSweeps::thread_memory() {
  static thread_local Memory memory;
  return memory;
}

void BoundedSweeps::nearest(std::span<const std::uint32_t> list, double enough,
                            TurnTree::Nearest& best) {
  if (list.empty()) return;
  Memory& memory = thread_memory();
  memory.singles.clear();
  const std::uint32_t last = memory.last;
  const bool has_last = std::ranges::binary_search(list, last);
  if (has_last) take(last, best.distance, best);
  if (list.size() >= kLongList && !c_.chain_lines.empty()) list = near_runs(list, best);
  SingleBounds bounds(c_, p_);
  for (; !list.empty(); list = list.subspan(std::min(kListChunk, list.size()))) {
    if (best.distance < enough) break;
    const auto some = list.first(std::min(kListChunk, list.size()));
    bounds.find(some, best.distance + kBoundError);
    for (std::size_t k = 0; k < some.size(); ++k) {
      if (!(bounds[k] <= best.distance + kBoundError) || (has_last && some[k] == last)) continue;
      if (bounds.is_known(k))
        take_nearer(bounds[k], some[k], best);
      else if (bounds[k] < enough)  // the sweep may hold p
        take(some[k], best.distance, best);
      else
        memory.singles.emplace_back(bounds[k], some[k]);
      if (best.distance < enough) break;
    }
  }
  if (best.distance < enough) {
    memory.last = best.sweep;
    return;
  }
  auto& singles = memory.singles;
  if (!singles.empty())
    std::swap(singles.front(), *std::min_element(singles.begin(), singles.end()));
  for (const auto& [bound, id] : singles) {
    const double limit = best.distance + kBoundError;
    if (bound <= limit) take(id, limit, best);
  }
  if (std::isfinite(best.distance)) memory.last = best.sweep;
}

// Drops the runs of moves that are farther away than the best sweep so far.
std::span<const std::uint32_t> BoundedSweeps::near_runs(std::span<const std::uint32_t> list,
                                                        TurnTree::Nearest& best) {
  MoveRuns& runs = thread_memory().runs;
  runs.prepare(c_, list);
  runs.measure(c_, p_, best.distance + kBoundError);
  if (!std::isfinite(best.distance))
    if (const auto id = runs.promising()) take(*id, best.distance, best);
  return runs.within(best.distance + kBoundError);
}

void BoundedSweeps::take(std::uint32_t id, double limit, TurnTree::Nearest& best) {
  const SweepRef& ref = c_.refs[id];
  if (ref.frame != 0 || !(c_.is_slant_line(ref) || c_.is_chain(ref)))
    return take_nearer(c_.distance(id, p_, limit + kBoundError), id, best);
  const PathSample s = c_.is_slant_line(ref) ? slant_minimum(c_.slant_lines[ref.row], p_)
                                             : chain_minimum(c_.chain_tools[ref.shape],
                                                             c_.chain_lines[ref.row], p_, limit);
  take_nearer(s.distance, id, best);
  if (best.sweep == id) t_ = s.t, line_ = id;
}

}  // namespace mrsim
