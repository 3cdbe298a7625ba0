#include "removal/sweep/sweep_lists.h"

#include "core/vec.h"
#include "removal/forms/helix_sweep.h"
#include "removal/forms/slant_sweep.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace mrsim {
namespace {

constexpr std::size_t kChunk = 128;
constexpr double kBoundError = 1e-8;  // mm: rounding of bounds, with room

// The sweeps of one form in a chunk of a list: their rows, and where their results go.
struct Part {
  std::size_t n = 0;
  std::uint32_t rows[kChunk];
  std::uint32_t places[kChunk];
  void add(std::uint32_t row, std::size_t place) {
    rows[n] = row;
    places[n++] = static_cast<std::uint32_t>(place);
  }
};

struct Parts {
  Part forms[3];  // ball_line, plane_line, plane_arc
  /// False where the sweep has to be asked on its own.
  bool add(std::uint32_t tag, std::size_t place) {
    const std::uint32_t form = tag >> kTagShift;
    if (form == kOtherForm) return false;
    forms[form].add(tag & kTagRow, place);
    return true;
  }
};

// A chunk of one form needs no scattering: its results go where they belong at once.
template <class Record>
void run(const FormKernels<Record>& kernels, const Record* records, const Part& part,
         std::size_t whole, const Vec3& p, double* out) {
  if (part.n == 0) return;
  if (part.n == whole) return kernels.list(records, part.rows, part.n, p, out);
  double values[kChunk];
  kernels.list(records, part.rows, part.n, p, values);
  for (std::size_t k = 0; k < part.n; ++k) out[part.places[k]] = values[k];
}

// Whether a sweep is asked on its own, by no kernel of lists. Turned ones have a tree.
bool is_single(const SweepColumns& c, std::uint32_t id) {
  const std::uint32_t tag = c.tags[id];
  return is_other(tag) && single_form(tag) != SingleForm::turned;
}

// A list has such sweeps only if one of these columns holds any.
bool has_singles(const SweepColumns& c) {
  return !c.paths.empty() || !c.profiles.empty() || !c.ball_arcs.empty() || !c.frames.empty();
}

// No sweep is nearer to p than the box that holds it; minus infinity where p lies in the box.
double box_bound(const Box3& box, const Vec3& p) {
  const auto beyond = [](double low, double x, double high) {
    return std::max(std::max(low - x, x - high), 0.0);
  };
  const double x = beyond(box.lo.x, p.x, box.hi.x), y = beyond(box.lo.y, p.y, box.hi.y),
               z = beyond(box.lo.z, p.z, box.hi.z);
  const double square = x * x + y * y + z * z;
  return square > 0 ? std::sqrt(square) : -std::numeric_limits<double>::infinity();
}

void least_of(const SweepColumns& c, std::uint32_t id, PointColumns& points) {
  const SweepRef& ref = c.refs[id];
  std::uint64_t open = ~std::uint64_t(0) >> (PointColumns::kMost - points.count);
  if (c.is_chain(ref) && ref.frame == 0)
    return sweep_kernels().chain(c.chain_tools[ref.shape], c.chain_lines[ref.row], id, points);
  if (c.is_slant_line(ref) && ref.frame == 0)
    return sweep_kernels().slant(c.slant_lines[ref.row], id, points);
  if (ref.kind == SweepKind::path && ref.frame == 0) {
    const ToolPath& path = c.paths[ref.row];
    const Profile& tool = c.cutter(ref);
    if (path.bored) open &= sweep_kernels().bore(path.bore, id, points);
    if (path.lowest_turn && tool.is_rounded())
      return sweep_kernels().helix(helix_record(tool, path), id, open, points);
  }
  const Box3 box = c.bounds_of(ref);
  for (; open != 0; open &= open - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(open));
    const Vec3 p{points.x[k], points.y[k], points.z[k]};
    if (box_bound(box, p) > points.least[k] + kBoundError) continue;
    const double d = c.distance(id, p);
    if (d > points.least[k] || (d == points.least[k] && id > points.nearest[k])) continue;
    points.least[k] = d;
    points.nearest[k] = id;
  }
}

void least_of_turns(const SweepColumns& c, std::span<const std::uint32_t> ids,
                    PointColumns& points) {
  static thread_local PointColumns turned;
  static thread_local std::vector<TurnMember> members;
  members.clear();
  for (const std::uint32_t id : ids) append_sides(c.turns, id, c.refs[id].row, members);
  turned.count = points.count;
  const std::size_t padded =
      (points.count + PointColumns::kPad - 1) / PointColumns::kPad * PointColumns::kPad;
  for (std::size_t k = 0; k < padded; ++k) {
    turned.x[k] = std::sqrt(points.x[k] * points.x[k] + points.y[k] * points.y[k]);
    turned.y[k] = 0, turned.z[k] = points.z[k];
    turned.least[k] = points.least[k], turned.nearest[k] = points.nearest[k];
  }
  least_of(c.turns, members, turned);
  std::copy(turned.least, turned.least + padded, points.least);
  std::copy(turned.nearest, turned.nearest + padded, points.nearest);
}

void least_of_packs(const SweepColumns& c, std::span<const std::uint32_t> ids,
                    PointColumns& points) {
  for (std::size_t k = 0; k < points.count; ++k) {
    TurnTree::Nearest best;
    best.distance = points.least[k], best.sweep = static_cast<std::uint32_t>(points.nearest[k]);
    const double rho = std::sqrt(points.x[k] * points.x[k] + points.y[k] * points.y[k]);
    for (const std::uint32_t id : ids)
      c.turn_tree.nearest(id - static_cast<std::uint32_t>(c.refs.size()), rho, points.z[k], best);
    points.least[k] = best.distance, points.nearest[k] = best.sweep;
  }
}

void take_nearer(double d, std::uint32_t id, TurnTree::Nearest& best) {
  if (d < best.distance || (d == best.distance && id < best.sweep))
    best.distance = d, best.sweep = id;
}

// Bounds below the distances of a chunk of sweeps that are asked on their own, which cost less than
// the distances: planes of straight moves, boxes of others.
class SingleBounds {
 public:
  SingleBounds(const SweepColumns& c, const Vec3& p) : c_(c), p_(p) {}

  /// Of up to kChunk sweeps: not above the distance but for rounding; where it is above `limit`,
  /// any bound that is. Minus infinity where nothing is known, infinity for a sweep that is not
  /// asked on its own.
  void find(std::span<const std::uint32_t> ids, double limit) {
    Part slants, chains;
    const bool one_tool = c_.chain_tools.size() == 1;
    std::int32_t tool = 0;  // of `chains`
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const std::uint32_t tag = c_.tags[ids[k]], row = tag & kSingleRow;
      bounds_[k] = std::numeric_limits<double>::infinity();
      if (!is_single(c_, ids[k])) continue;
      if (single_form(tag) == SingleForm::slant) {
        slants.add(row, k);
      } else if (single_form(tag) == SingleForm::chain) {
        const std::int32_t own = one_tool ? 0 : c_.refs[ids[k]].shape;
        if (chains.n > 0 && own != tool) add_chains(tool, limit, chains);
        tool = own;
        chains.add(row, k);
      } else {
        bounds_[k] = box_bound(c_.bounds_of(c_.refs[ids[k]]), p_);
      }
    }
    if (slants.n > 0) {
      sweep_kernels().slant_bounds(c_.slant_lines.data(), slants.rows, slants.n, p_, found_);
      scatter(slants);
    }
    if (chains.n > 0) add_chains(tool, limit, chains);
  }
  double operator[](std::size_t k) const { return bounds_[k]; }

 private:
  void add_chains(std::int32_t tool, double limit, Part& chains) {
    sweep_kernels().chain_bounds(c_.chain_tools[tool], c_.chain_lines.data(), chains.rows, chains.n,
                                 p_, limit, found_);
    scatter(chains);
    chains.n = 0;
  }
  void scatter(const Part& part) {
    for (std::size_t k = 0; k < part.n; ++k) bounds_[part.places[k]] = found_[k];
  }

  const SweepColumns& c_;
  Vec3 p_;
  double bounds_[kChunk];
  double found_[kChunk];
};

// The sweeps of a list that are asked on their own, with their bounds.
class BoundedSweeps {
 public:
  BoundedSweeps(const SweepColumns& c, const Vec3& p) : c_(c), p_(p) {}

  /// The nearest of them; what is left of the list, valid until the thread's next call.
  /// The one that was the nearest to the thread's last point, and then the one with the least
  /// bound, come first: few others can be nearer.
  /// Ends where one is nearer than `enough`.
  std::span<const std::uint32_t> nearest(std::span<const std::uint32_t> list, double enough,
                                         TurnTree::Nearest& best) {
    Memory& memory = thread_memory();
    memory.others.clear(), memory.singles.clear();
    const std::uint32_t last = memory.last;
    const bool has_last = std::ranges::binary_search(list, last) && is_single(c_, last);
    if (has_last) take(last, best.distance, best);
    SingleBounds bounds(c_, p_);
    for (; !list.empty(); list = list.subspan(std::min(kChunk, list.size()))) {
      if (best.distance < enough) break;
      const auto some = list.first(std::min(kChunk, list.size()));
      bounds.find(some, best.distance + kBoundError);
      for (std::size_t k = 0; k < some.size(); ++k) {
        if (has_last && some[k] == last) continue;
        if (!is_single(c_, some[k]))
          memory.others.push_back(some[k]);
        else if (bounds[k] < enough)  // it may well hold p
          take(some[k], best.distance, best);
        else if (bounds[k] <= best.distance + kBoundError)
          memory.singles.emplace_back(bounds[k], some[k]);
        if (best.distance < enough) break;
      }
    }
    if (best.distance < enough) {
      memory.last = best.sweep;
      return {};
    }
    auto& singles = memory.singles;
    if (!singles.empty())
      std::swap(singles.front(), *std::min_element(singles.begin(), singles.end()));
    for (const auto& [bound, id] : singles) {
      const double limit = best.distance + kBoundError;
      if (bound <= limit) take(id, limit, best);
    }
    if (std::isfinite(best.distance)) memory.last = best.sweep;
    return memory.others;
  }

  /// Where on a sweep the point is nearest, if it is the nearest line.
  std::optional<double> place_on(std::uint32_t sweep) const {
    return sweep == line_ ? std::optional(t_) : std::nullopt;
  }

 private:
  using Single = std::pair<double, std::uint32_t>;  // bound, sweep
  struct Memory {
    std::vector<std::uint32_t> others;
    std::vector<Single> singles;
    std::uint32_t last = 0;  // the nearest of the last list, if still one of this table
  };
  static Memory& thread_memory() {
    static thread_local Memory memory;
    return memory;
  }

  void take(std::uint32_t id, double limit, TurnTree::Nearest& best) {
    const SweepRef& ref = c_.refs[id];
    if (ref.frame != 0 || !(c_.is_slant_line(ref) || c_.is_chain(ref)))
      return take_nearer(c_.distance(id, p_), id, best);
    const PathSample s = c_.is_slant_line(ref) ? slant_minimum(c_.slant_lines[ref.row], p_)
                                               : chain_minimum(c_.chain_tools[ref.shape],
                                                               c_.chain_lines[ref.row], p_, limit);
    take_nearer(s.distance, id, best);
    if (best.sweep == id) t_ = s.t, line_ = id;
  }

  const SweepColumns& c_;
  Vec3 p_;
  std::uint32_t line_ = ~0u;  // the nearest so far, and where on it
  double t_ = 0;
};

// The line with the least bound at one of the points, asked first: few others can then be nearer to
// any of them.
void take_promising(const SweepColumns& c, std::span<const std::uint32_t> ids,
                    PointColumns& points) {
  constexpr std::size_t kWorth = 8;  // sweeps
  if (!has_singles(c) || ids.size() < kWorth) return;
  const std::size_t middle = points.count / 2;
  SingleBounds bounds(c, {points.x[middle], points.y[middle], points.z[middle]});
  double least = std::numeric_limits<double>::infinity();
  std::optional<std::uint32_t> best;
  for (; !ids.empty(); ids = ids.subspan(std::min(kChunk, ids.size()))) {
    const auto some = ids.first(std::min(kChunk, ids.size()));
    bounds.find(some, least);
    for (std::size_t k = 0; k < some.size(); ++k)
      if (bounds[k] < least) least = bounds[k], best = some[k];
  }
  if (best) least_of(c, *best, points);
}

}  // namespace

std::vector<std::uint32_t> all_numbers(const SweepColumns& c, double longest) {
  std::vector<std::uint32_t> list, packs;
  const auto append = [&](const auto& self, std::uint32_t number) -> void {
    if (number < kFirstPack)
      list.push_back(number);
    else if (c.packs[number].length <= longest)
      packs.push_back(number);
    else
      c.packs.for_each_child(number, [&](std::uint32_t child) { self(self, child); });
  };
  std::uint32_t next = 0;  // sweep that is not yet in the list
  const auto append_single = [&](std::uint32_t end) {
    for (; next < end; ++next)
      if (c.refs[next].kind != SweepKind::turn) list.push_back(next);
  };
  for (const std::uint32_t root : c.packs.roots()) {
    append_single(c.packs[root].first);
    append(append, root);
    next = c.packs[root].last + 1;
  }
  const auto sweeps = static_cast<std::uint32_t>(c.refs.size());
  append_single(sweeps);
  for (const std::uint32_t pack : c.turn_tree.roots()) list.push_back(sweeps + pack);
  std::sort(packs.begin(), packs.end());
  list.insert(list.end(), packs.begin(), packs.end());
  return list;
}

std::vector<std::uint32_t> sweeps_meeting(const SweepColumns& c,
                                          std::span<const std::uint32_t> list, const Box3& box) {
  const auto numbers = c.numbers_of(list);
  const auto plain = c.sweeps_of(numbers);
  std::vector<std::uint32_t> sweeps(plain.begin(), plain.end());
  for (const std::uint32_t id : numbers.turned)
    c.turn_tree.append_sweeps(id - static_cast<std::uint32_t>(c.refs.size()), sweeps);
  std::erase_if(sweeps, [&](std::uint32_t i) {
    const Box3 b = c.bounds_of(c.refs[i]);
    return is_empty({max(b.lo, box.lo), min(b.hi, box.hi)});
  });
  // A pack and its mirror image hold the same sweeps.
  std::sort(sweeps.begin(), sweeps.end());
  sweeps.erase(std::unique(sweeps.begin(), sweeps.end()), sweeps.end());
  return sweeps;
}

SweepTable::Nearest nearest_sweep(const SweepColumns& c, std::span<const std::uint32_t> list,
                                  const Vec3& p, double enough) {
  const auto numbers = c.numbers_of(list);
  std::span<const std::uint32_t> plain = c.sweeps_of(numbers);
  TurnTree::Nearest best;
  BoundedSweeps singles(c, p);
  if (has_singles(c)) plain = singles.nearest(plain, enough, best);
  double d[kChunk];
  for (; !plain.empty(); plain = plain.subspan(std::min(kChunk, plain.size()))) {
    if (best.distance < enough) break;
    const auto some = plain.first(std::min(kChunk, plain.size()));
    sweep_distances(c, some, p, d);
    for (std::size_t k = 0; k < some.size(); ++k) take_nearer(d[k], some[k], best);
  }
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  for (const std::uint32_t id : numbers.turned)
    c.turn_tree.nearest(id - static_cast<std::uint32_t>(c.refs.size()), rho, p.z, best);
  return {best.distance, best.sweep, singles.place_on(best.sweep)};
}

void sweep_distances(const SweepColumns& c, std::span<const std::uint32_t> ids, const Vec3& p,
                     double* out) {
  const SweepKernels& kernels = sweep_kernels();
  // A program of one form alone needs no sorting: its rows are its indices.
  if (c.uniform && c.refs.front().kind == SweepKind::ball_line)
    return kernels.ball_line.list(c.ball_lines.data(), ids.data(), ids.size(), p, out);
  if (c.uniform && c.refs.front().kind == SweepKind::plane_line)
    return kernels.plane_line.list(c.plane_lines.data(), ids.data(), ids.size(), p, out);
  for (std::size_t from = 0; from < ids.size(); from += kChunk) {
    const std::size_t n = ids.size() - from < kChunk ? ids.size() - from : kChunk;
    Parts parts;
    for (std::size_t k = 0; k < n; ++k)
      if (!parts.add(c.tags[ids[from + k]], k)) out[from + k] = c.distance(ids[from + k], p);
    run(kernels.ball_line, c.ball_lines.data(), parts.forms[0], n, p, out + from);
    run(kernels.plane_line, c.plane_lines.data(), parts.forms[1], n, p, out + from);
    run(kernels.plane_arc, c.plane_arcs.data(), parts.forms[2], n, p, out + from);
  }
}

void least_distances(const SweepColumns& c, std::span<const std::uint32_t> ids,
                     PointColumns& points) {
  const SweepKernels& kernels = sweep_kernels();
  const auto numbers = c.numbers_of(ids);
  if (!numbers.turned.empty()) least_of_packs(c, numbers.turned, points);
  ids = c.sweeps_of(numbers);
  if (ids.empty()) return;
  if (c.uniform && c.refs.front().kind == SweepKind::ball_line)
    return kernels.ball_line.least(c.ball_lines.data(), ids.data(), ids.data(), ids.size(), points);
  if (c.uniform && c.refs.front().kind == SweepKind::plane_line)
    return kernels.plane_line.least(c.plane_lines.data(), ids.data(), ids.data(), ids.size(),
                                    points);
  const auto run = [&](const auto& form, const auto& records, const Part& part) {
    if (part.n == 0) return;
    std::uint32_t some[kChunk];
    for (std::size_t k = 0; k < part.n; ++k) some[k] = ids[part.places[k]];
    form.least(records.data(), part.rows, some, part.n, points);
  };
  static thread_local std::vector<std::uint32_t> turns;
  turns.clear();
  take_promising(c, ids, points);
  for (; !ids.empty(); ids = ids.subspan(std::min(kChunk, ids.size()))) {
    Parts parts;
    for (std::size_t k = 0; k < std::min(kChunk, ids.size()); ++k) {
      if (parts.add(c.tags[ids[k]], k)) continue;
      if (c.refs[ids[k]].kind == SweepKind::turn)
        turns.push_back(ids[k]);
      else
        least_of(c, ids[k], points);
    }
    run(kernels.ball_line, c.ball_lines, parts.forms[0]);
    run(kernels.plane_line, c.plane_lines, parts.forms[1]);
    run(kernels.plane_arc, c.plane_arcs, parts.forms[2]);
  }
  if (!turns.empty()) least_of_turns(c, turns, points);
}

}  // namespace mrsim
