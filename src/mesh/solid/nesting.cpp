#include "mesh/solid/nesting.h"

#include "core/numbers/solid_angle.h"
#include "core/numbers/units.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mrsim {
namespace {

using Surfaces = std::vector<SurfaceComponent>;

// Whether a component winds about a point off it.
struct WindingQuestion {
  std::uint32_t outer = 0;   // number of the component
  std::uint32_t search = 0;  // number of the search that asks
  Vec3 point;
  double angle = 0;
  bool is_yes() const { return std::fabs(angle) > kTwoPi; }  // half of the full 4 pi
};

// Calls body(component, corners) for each triangle.
template <class Body>
void for_each_triangle(const MeshAudit& audit, const MeshSource& mesh, Body body) {
  std::size_t index = 0;
  mesh.for_each_block([&](const MeshBlock& block) {
    const std::vector<std::uint32_t> components = audit.components_of(index++, block);
    for (std::size_t f = 0; f < components.size(); ++f) {
      const auto& t = block.triangles[f];
      body(components[f], to_vec(block.points[t[0]]), to_vec(block.points[t[1]]),
           to_vec(block.points[t[2]]));
    }
  });
}

bool contains(const Box3& outer, const Box3& inner) {
  return outer.lo.x <= inner.lo.x && outer.lo.y <= inner.lo.y && outer.lo.z <= inner.lo.z &&
         outer.hi.x >= inner.hi.x && outer.hi.y >= inner.hi.y && outer.hi.z >= inner.hi.z;
}

// The axis along which these boxes overlap least: the sum of their widths over that of all.
int sparse_axis(const Surfaces& surfaces) {
  Box3 all;
  Vec3 sum;
  for (const SurfaceComponent& s : surfaces) {
    extend(all, s.bounds.lo);
    extend(all, s.bounds.hi);
    sum = sum + (s.bounds.hi - s.bounds.lo);
  }
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double share = component(sum, axis) / component(all.hi - all.lo, axis);
    if (share < least) least = share, best = axis;
  }
  return best;
}

// The search for the component around another one. Ranks are places in the order of volumes.
struct Search {
  std::uint32_t inner = 0;
  std::uint32_t first = 0;           // all ranks below were asked
  std::vector<std::uint32_t> ranks;  // to ask now, ascending

  // Keeps the `most` lowest ranks that were not asked.
  void offer(std::uint32_t rank, std::size_t most) {
    if (rank < first || (ranks.size() == most && rank > ranks.back())) return;
    ranks.insert(std::lower_bound(ranks.begin(), ranks.end(), rank), rank);
    if (ranks.size() > most) ranks.pop_back();
  }
};

class Nesting {
 public:
  Nesting(const MeshAudit& audit, const MeshSource& mesh, const std::vector<std::uint32_t>& inner,
          const MayHold& may_hold)
      : audit_(audit), mesh_(mesh), surfaces_(audit.components()), may_hold_(may_hold) {
    sort_by_volume();
    sort_by_place();
    for (const std::uint32_t c : inner) searches_.push_back({c, 0, {}});
  }

  std::map<std::uint32_t, std::uint32_t> find() {
    for (std::size_t most = 4; !searches_.empty(); most *= 4) {
      choose_questions(most);
      std::erase_if(searches_, [](const Search& s) { return s.ranks.empty(); });
      if (searches_.empty()) break;
      ask();
    }
    return std::move(found_);
  }

 private:
  static constexpr std::uint32_t kNone = ~0u;

  void sort_by_volume() {
    by_rank_.resize(surfaces_.size());
    rank_.resize(surfaces_.size());
    std::iota(by_rank_.begin(), by_rank_.end(), 0u);
    std::stable_sort(by_rank_.begin(), by_rank_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::fabs(surfaces_[a].volume()) < std::fabs(surfaces_[b].volume());
    });
    for (std::uint32_t r = 0; r < by_rank_.size(); ++r) rank_[by_rank_[r]] = r;
  }

  void sort_by_place() {
    axis_ = sparse_axis(surfaces_);
    by_place_.resize(surfaces_.size());
    std::iota(by_place_.begin(), by_place_.end(), 0u);
    std::sort(by_place_.begin(), by_place_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return component(surfaces_[a].bounds.lo, axis_) < component(surfaces_[b].bounds.lo, axis_);
    });
  }

  // Only what has the box of a component within its own can hold it. A plane goes along an axis and
  // keeps the boxes that it passes: O(n log n + n m), m of them at once.
  void choose_questions(std::size_t most) {
    std::vector<std::uint32_t> search_of(surfaces_.size(), kNone);
    for (std::uint32_t s = 0; s < searches_.size(); ++s) search_of[searches_[s].inner] = s;
    const auto offer = [&](std::uint32_t outer, std::uint32_t inner) {
      if (contains(surfaces_[outer].bounds, surfaces_[inner].bounds) && may_hold_(outer, inner))
        searches_[search_of[inner]].offer(rank_[outer], most);
    };
    std::vector<std::uint32_t> passed, asking;  // `asking`: the passed ones with a search
    for (const std::uint32_t c : by_place_) {
      const double low = component(surfaces_[c].bounds.lo, axis_);
      const auto is_behind = [&](std::uint32_t other) {
        return component(surfaces_[other].bounds.hi, axis_) < low;
      };
      std::erase_if(passed, is_behind);
      std::erase_if(asking, is_behind);
      for (const std::uint32_t other : asking) offer(c, other);
      passed.push_back(c);
      if (search_of[c] == kNone) continue;
      asking.push_back(c);
      for (const std::uint32_t other : passed)
        if (other != c) offer(other, c);
    }
  }

  // Ends the searches that a question answers with yes.
  void ask() {
    if (places_.empty()) places_ = first_places(audit_, mesh_);
    std::vector<WindingQuestion> questions;
    for (std::uint32_t s = 0; s < searches_.size(); ++s)
      for (const std::uint32_t rank : searches_[s].ranks)
        questions.push_back({by_rank_[rank], s, places_[searches_[s].inner], 0});
    answer(questions);
    std::vector<std::uint32_t> around(searches_.size(), kNone);  // the lowest rank
    for (const WindingQuestion& q : questions)
      if (q.is_yes()) around[q.search] = std::min(around[q.search], rank_[q.outer]);
    std::vector<Search> open;
    for (std::uint32_t s = 0; s < searches_.size(); ++s) {
      if (around[s] != kNone)
        found_.emplace(searches_[s].inner, by_rank_[around[s]]);
      else
        open.push_back({searches_[s].inner, searches_[s].ranks.back() + 1, {}});
    }
    searches_ = std::move(open);
  }

  void answer(std::vector<WindingQuestion>& questions) const {
    std::stable_sort(
        questions.begin(), questions.end(),
        [](const WindingQuestion& a, const WindingQuestion& b) { return a.outer < b.outer; });
    std::vector<std::size_t> begin(surfaces_.size() + 1, 0);  // of the questions about each one
    for (const WindingQuestion& q : questions) ++begin[q.outer + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for_each_triangle(audit_, mesh_,
                      [&](std::uint32_t outer, const Vec3& a, const Vec3& b, const Vec3& c) {
                        for (std::size_t i = begin[outer]; i < begin[outer + 1]; ++i) {
                          const Vec3& p = questions[i].point;
                          questions[i].angle += 2 * half_solid_angle(a - p, b - p, c - p);
                        }
                      });
  }

  const MeshAudit& audit_;
  const MeshSource& mesh_;
  const Surfaces& surfaces_;
  const MayHold& may_hold_;
  int axis_ = 0;
  std::vector<std::uint32_t> rank_, by_rank_, by_place_;
  std::vector<Vec3> places_;
  std::vector<Search> searches_;
  std::map<std::uint32_t, std::uint32_t> found_;
};

}  // namespace

std::vector<Vec3> first_places(const MeshAudit& audit, const MeshSource& mesh) {
  std::vector<Vec3> out(audit.components().size());
  std::vector<bool> known(out.size(), false);
  for_each_triangle(audit, mesh,
                    [&](std::uint32_t component, const Vec3& a, const Vec3& b, const Vec3& c) {
                      if (known[component]) return;
                      known[component] = true;
                      out[component] = 1.0 / 3 * (a + b + c);
                    });
  return out;
}

std::map<std::uint32_t, std::uint32_t> find_surfaces_around(const MeshAudit& audit,
                                                            const MeshSource& mesh,
                                                            const std::vector<std::uint32_t>& inner,
                                                            const MayHold& may_hold) {
  if (inner.empty()) return {};
  return Nesting(audit, mesh, inner, may_hold).find();
}

}  // namespace mrsim
