#include "removal/sweep/sweep_lists.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "removal/forms/helix_sweep.h"
#include "removal/sweep/bounded_sweeps.h"
#include "removal/sweep/sorted_list.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace mrsim {
namespace {

using Form = SweepClass::Form;

struct Parts {
  ListPart forms[kOtherForm];
  const ListPart& of(Form form) const { return forms[static_cast<std::size_t>(form)]; }
  /// False where the sweep has to be evaluated on its own.
  bool add(std::uint32_t tag, std::size_t slot) {
    const std::uint32_t form = tag >> kTagShift;
    if (form == kOtherForm) return false;
    forms[form].add(tag & kTagRow, slot);
    return true;
  }
};

// A chunk of one form needs no scattering: its results go where they belong at once.
template <class Record>
void evaluate(const FormKernels<Record>& kernels, const Record* records, const ListPart& part,
              std::size_t whole, const Vec3& p, double* out) {
  if (part.n == 0) return;
  if (part.n == whole) return kernels.list(records, part.rows, part.n, p, out);
  double values[kListChunk];
  kernels.list(records, part.rows, part.n, p, values);
  for (std::size_t k = 0; k < part.n; ++k) out[part.slots[k]] = values[k];
}

bool is_upright(std::uint32_t tag) {
  return is_other(tag) && single_form(tag) == SingleForm::upright;
}

// The quarters of upright arcs: those above the centre and those below, which take other steps.
class UprightParts {
 public:
  UprightParts(const SweepColumns& c, const Vec3& p, std::optional<double> least, double* out)
      : c_(c),
        p_(p),
        nearest_only_(least),
        limit_(least.value_or(std::numeric_limits<double>::infinity())),
        out_(out) {}

  void add(std::uint32_t row, std::size_t slot) {
    out_[slot] = std::numeric_limits<double>::infinity();
    for (const UprightRecord& quarter : c_.quarters_of(row)) {
      ListPart& part = halves_[quarter.half < 0 ? 1 : 0];
      part.add(static_cast<std::uint32_t>(&quarter - c_.upright_quarters.data()), slot);
      if (part.n == kListChunk) evaluate(part);
    }
  }
  void finish() {
    for (ListPart& part : halves_)
      if (part.n > 0) evaluate(part);
  }

 private:
  void evaluate(ListPart& part) {
    double found[kListChunk];
    sweep_kernels().upright_list(c_.upright_quarters.data(), part.rows, part.n, p_, limit_,
                                 nearest_only_, found);
    for (std::size_t k = 0; k < part.n; ++k) {
      out_[part.slots[k]] = std::min(out_[part.slots[k]], found[k]);
      if (nearest_only_) limit_ = std::min(limit_, found[k]);
    }
    part.n = 0;
  }

  const SweepColumns& c_;
  const Vec3& p_;
  bool nearest_only_;
  double limit_;
  double* out_;
  ListPart halves_[2];
};

void least_of(const SweepColumns& c, std::uint32_t id, PointColumns& points) {
  const SweepRef& ref = c.refs[id];
  std::uint64_t open = ~std::uint64_t(0) >> (PointColumns::kMost - points.count);
  if (c.is_chain(ref) && ref.frame == 0)
    return sweep_kernels().chain(c.chain_tools[ref.shape], c.chain_lines[ref.row], id, points);
  if (c.is_slant_line(ref) && ref.frame == 0)
    return sweep_kernels().slant(c.slant_lines[ref.row], id, points);
  if (ref.frame == 0 && c.has_outline(ref))
    return sweep_kernels().outline(c.outlines[static_cast<std::size_t>(ref.shape)],
                                   c.profiles[ref.row], id, points);
  if (is_upright(c.tags[id])) {
    const auto quarters = c.quarters_of(ref.row);
    return sweep_kernels().upright(quarters.data(), quarters.size(), id, points);
  }
  if (c.is_bore(ref) && ref.frame == 0) {
    open &= sweep_kernels().bore(c.bores[ref.row], id, points);
    if (open == 0) return;
    return sweep_kernels().helix(helix_record(c.cutter(ref), c.paths.arc(ref.row)), id, open,
                                 points);
  }
  const Box3 box = c.bounds_of(ref);
  for (; open != 0; open &= open - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(open));
    const Vec3 p{points.x[k], points.y[k], points.z[k]};
    if (box_bound(box, p) > points.least[k] + kBoundError) continue;
    const double d = c.distance(id, p, points.least[k] + kBoundError);
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

// The sweep with the least bound at one of the points, measured first: few others can then be
// nearer to any of them.
void take_promising(const SweepColumns& c, std::span<const std::uint32_t> ids,
                    PointColumns& points) {
  constexpr std::size_t kWorth = 8;  // sweeps
  if (ids.size() < kWorth) return;
  const std::size_t middle = points.count / 2;
  const std::optional<std::uint32_t> best =
      least_bound(c, ids, {points.x[middle], points.y[middle], points.z[middle]});
  if (best) least_of(c, *best, points);
}

// Calls f with as much of a list as is evaluated together, until it returns false.
template <class F>
void in_chunks(std::size_t count, const F& f) {
  for (std::size_t from = 0; from < count; from += kListChunk)
    if (!f(from, std::min(count - from, kListChunk))) return;
}

// A list is evaluated until one is nearer than `enough`.
class NearestOfList {
 public:
  NearestOfList(const SweepColumns& c, const Vec3& p, double enough, TurnTree::Nearest& best)
      : c_(c), p_(p), enough_(enough), best_(best) {}

  template <class Record>
  void take(const FormKernels<Record>& kernels, const std::vector<Record>& records,
            const FormPart& part) {
    if (is_done()) return;
    in_chunks(part.ids.size(), [&](std::size_t from, std::size_t n) {
      kernels.list(records.data(), part.rows.data() + from, n, p_, distances_);
      return take_nearest(std::span(part.ids).subspan(from, n));
    });
  }
  void take(std::span<const std::uint32_t> ids) {
    if (is_done()) return;
    in_chunks(ids.size(), [&](std::size_t from, std::size_t n) {
      sweep_distances(c_, ids.subspan(from, n), p_, distances_, best_.distance);
      return take_nearest(ids.subspan(from, n));
    });
  }

 private:
  bool take_nearest(std::span<const std::uint32_t> ids) {
    for (std::size_t k = 0; k < ids.size(); ++k) take_nearer(distances_[k], ids[k], best_);
    return !is_done();
  }
  bool is_done() const { return best_.distance < enough_; }

  const SweepColumns& c_;
  Vec3 p_;
  double enough_;
  TurnTree::Nearest& best_;
  double distances_[kListChunk];
};

const SortedList& sorted(const SweepColumns& c, std::span<const std::uint32_t> list) {
  static thread_local SortedList last;
  last.prepare(c, list);
  return last;
}

// Whether all sweeps have one form, so that a sweep's number is its row.
bool is_one_form(const SweepColumns& c) {
  return c.uniform && (c.refs.front().kind == SweepKind::ball_line ||
                       c.refs.front().kind == SweepKind::plane_line);
}

// Distances of a chunk of a list, but for those that have no kernel of lists, `singles`.
void kernel_distances(const SweepColumns& c, std::span<const std::uint32_t> ids, const Vec3& p,
                      std::optional<double> least, double* out, ListPart& singles) {
  const SweepKernels& kernels = sweep_kernels();
  Parts parts;
  UprightParts uprights(c, p, least, out);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const std::uint32_t tag = c.tags[ids[k]];
    if (parts.add(tag, k)) continue;
    if (is_upright(tag))
      uprights.add(tag & kSingleRow, k);
    else
      singles.add(tag & kSingleRow, k);
  }
  evaluate(kernels.ball_line, c.ball_lines.data(), parts.of(Form::strip), ids.size(), p, out);
  evaluate(kernels.plane_line, c.plane_lines.data(), parts.of(Form::line), ids.size(), p, out);
  evaluate(kernels.plane_arc, c.plane_arcs.data(), parts.of(Form::arc), ids.size(), p, out);
  uprights.finish();
}

}  // namespace

SweepTable::Nearest nearest_sweep(const SweepColumns& c, std::span<const std::uint32_t> list,
                                  const Vec3& p, double enough) {
  const auto numbers = c.numbers_of(list);
  const std::span<const std::uint32_t> plain = c.sweeps_of(numbers);
  TurnTree::Nearest best;
  BoundedSweeps bounded(c, p);
  NearestOfList nearest(c, p, enough, best);
  if (is_one_form(c)) {
    nearest.take(plain);
  } else if (!plain.empty()) {
    const SweepKernels& kernels = sweep_kernels();
    const SortedList& by_form = sorted(c, plain);
    bounded.nearest(by_form.bounded(), enough, best);
    nearest.take(kernels.ball_line, c.ball_lines, by_form.ball_lines());
    nearest.take(kernels.plane_line, c.plane_lines, by_form.plane_lines());
    nearest.take(kernels.plane_arc, c.plane_arcs, by_form.plane_arcs());
    nearest.take(by_form.others());
  }
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  for (const std::uint32_t id : numbers.turned)
    c.turn_tree.nearest(id - static_cast<std::uint32_t>(c.refs.size()), rho, p.z, best);
  return {best.distance, best.sweep, bounded.place_on(best.sweep)};
}

void sweep_distances(const SweepColumns& c, std::span<const std::uint32_t> ids, const Vec3& p,
                     double* out, std::optional<double> least) {
  const SweepKernels& kernels = sweep_kernels();
  // A program of one form alone needs no sorting: its rows are its indices.
  if (c.uniform && c.refs.front().kind == SweepKind::ball_line)
    return kernels.ball_line.list(c.ball_lines.data(), ids.data(), ids.size(), p, out);
  if (c.uniform && c.refs.front().kind == SweepKind::plane_line)
    return kernels.plane_line.list(c.plane_lines.data(), ids.data(), ids.size(), p, out);
  in_chunks(ids.size(), [&](std::size_t from, std::size_t n) {
    const auto some = ids.subspan(from, n);
    ListPart singles;
    kernel_distances(c, some, p, least, out + from, singles);
    for (std::size_t k = 0; k < singles.n; ++k)
      out[from + singles.slots[k]] = c.distance(some[singles.slots[k]], p);
    return true;
  });
}

void near_distances(const SweepColumns& c, std::span<const std::uint32_t> ids, const Vec3& p,
                    double margin, double* out) {
  double nearest = kInfinity;
  in_chunks(ids.size(), [&](std::size_t from, std::size_t n) {
    const auto some = ids.subspan(from, n);
    ListPart singles;
    std::fill_n(out + from, n, kInfinity);
    kernel_distances(c, some, p, {}, out + from, singles);
    nearest = std::min(nearest, *std::min_element(out + from, out + from + n));
    double bounds[kListChunk];
    for (std::size_t k = 0; k < singles.n; ++k)
      bounds[k] = box_bound(c.bounds_of(c.refs[some[singles.slots[k]]]), p);
    const auto take = [&](std::size_t k) {
      if (bounds[k] > nearest + margin) return;
      double& d = out[from + singles.slots[k]];
      d = c.distance(some[singles.slots[k]], p, nearest + margin);
      nearest = std::min(nearest, d);
    };
    // Few others are as near as the one whose box is nearest.
    const auto first =
        static_cast<std::size_t>(std::min_element(bounds, bounds + singles.n) - bounds);
    if (singles.n > 0) take(first);
    for (std::size_t k = 0; k < singles.n; ++k)
      if (k != first) take(k);
    return true;
  });
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
  const auto evaluate = [&](const auto& form, const auto& records, const FormPart& part) {
    in_chunks(part.ids.size(), [&](std::size_t from, std::size_t n) {
      form.least(records.data(), part.rows.data() + from, part.ids.data() + from, n, points);
      return true;
    });
  };
  static thread_local std::vector<std::uint32_t> turns;
  turns.clear();
  const SortedList& list = sorted(c, ids);
  take_promising(c, list.bounded(), points);
  for (const std::uint32_t id : list.bounded()) least_of(c, id, points);
  for (const std::uint32_t id : list.others()) {
    if (c.refs[id].kind == SweepKind::turn)
      turns.push_back(id);
    else
      least_of(c, id, points);
  }
  evaluate(kernels.ball_line, c.ball_lines, list.ball_lines());
  evaluate(kernels.plane_line, c.plane_lines, list.plane_lines());
  evaluate(kernels.plane_arc, c.plane_arcs, list.plane_arcs());
  if (!turns.empty()) least_of_turns(c, turns, points);
}

}  // namespace mrsim
