#include "mesh/turned/turned_outline.h"

#include "core/numbers/vec.h"
#include "core/process/parallel.h"
#include "mesh/cells/cells.h"
#include "mesh/turned/turned_strands.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

namespace mrsim::detail {
namespace {

constexpr double kSureVoxels = 2;  ///< about the surface, where d is the same whatever the list

struct Leaf {
  Square square;
  Candidates candidates;
};

// The voxels about the surface.
class Leaves {
 public:
  Leaves(const ExactField& field, const HalfPlaneLattice& lattice)
      : field_(field), lattice_(lattice) {
    const Candidates all = field.all();
    descend({{0, 0}, lattice.size()}, all);
  }
  const std::vector<Leaf>& all() const { return leaves_; }

 private:
  void descend(const Square& q, std::span<const std::uint32_t> in) {
    const Box3 box{lattice_.at(q.low), lattice_.at(q.corner(2))};
    Candidates own;
    if (field_.restrict_to(reach_of(box, lattice_.voxel()), kSureVoxels * lattice_.voxel(), in,
                           own) != ExactField::Region::mixed)
      return;
    if (q.size == lattice_.per_voxel()) {
      leaves_.push_back({q, std::move(own)});
      return;
    }
    for (int k = 0; k < 4; ++k)
      descend({{q.low.x + (k & 1) * (q.size / 2), q.low.z + (k >> 1) * (q.size / 2)}, q.size / 2},
              own);
  }

  const ExactField& field_;
  const HalfPlaneLattice& lattice_;
  std::vector<Leaf> leaves_;
};

// A chord that begins where the last one begins replaces it, except at the axis.
void append(const OutlinePoint& p, std::vector<OutlinePoint>& out) {
  if (out.empty() || distance(out.back().at, p.at) >= kSamePlace) {
    out.push_back(p);
    return;
  }
  OutlinePoint& last = out.back();
  last = {last.at.x == 0 ? last.at : p.at, p.face, p.height, p.excess, std::max(last.bend, p.bend)};
}

// Strands end to end: first those that begin at the axis.
std::vector<Outline> joined(const std::vector<Strand>& strands) {
  using Start = std::pair<std::uint64_t, std::size_t>;
  std::vector<Start> starts;
  std::vector<std::uint64_t> ends;
  for (std::size_t k = 0; k < strands.size(); ++k) {
    starts.emplace_back(strands[k].from, k);
    ends.push_back(strands[k].to);
  }
  std::sort(starts.begin(), starts.end());
  std::sort(ends.begin(), ends.end());
  const auto next = [&](const Strand& s) {
    const auto found = std::lower_bound(starts.begin(), starts.end(), Start{s.to, 0});
    return found != starts.end() && found->first == s.to ? found->second : strands.size();
  };
  std::vector<char> used(strands.size(), 0);
  std::vector<Outline> out;
  const auto follow = [&](std::size_t k) {
    Outline line;
    Vec3 end;
    for (; k < strands.size() && !used[k]; k = next(strands[k])) {
      used[k] = 1;
      for (const OutlinePoint& p : strands[k].points) append(p, line.points);
      end = strands[k].end;
    }
    line.closed = k < strands.size();
    if (!line.closed) {
      append({end, line.points.back().face, 0, 0, 0}, line.points);
      line.points.back().at = end;
    }
    out.push_back(std::move(line));
  };
  for (std::size_t k = 0; k < strands.size(); ++k)
    if (!std::binary_search(ends.begin(), ends.end(), strands[k].from)) follow(k);
  for (std::size_t k = 0; k < strands.size(); ++k)
    if (!used[k]) follow(k);
  return out;
}

// A piece or a hole as small as the smallest squares.
FoundThin unresolved(const Outline& line, const HalfPlaneLattice& lattice) {
  const OutlinePoint &a = line.points.front(), &b = line.points.back();
  const auto [low, high] = std::minmax(a.face.owner, b.face.owner);
  const double block = kThinBlock * lattice.voxel();
  const auto index = [&](double x) { return static_cast<std::int32_t>(x / block); };
  const double size = lattice.voxel() / lattice.per_voxel();
  return {{a.at, true, size, {low, high}},
          key({index(a.at.x), 0, index(a.at.z - lattice.at({}).z)})};
}

}  // namespace

TurnedSection turned_section(const ExactField& field, double voxel, double height, double finest,
                             int threads) {
  const HalfPlaneLattice lattice(field.bounds(), voxel, finest);
  const Leaves leaves(field, lattice);
  std::vector<TracedSquare> found(leaves.all().size());
  parallel_for(
      found.size(), threads,
      [&](std::size_t k) {
        const Leaf& leaf = leaves.all()[k];
        found[k] = trace_square(field, lattice, leaf.square, leaf.candidates, height);
      },
      8);
  TurnedSection section;
  section.squares = leaves.all().size();
  std::vector<Strand> strands;
  for (TracedSquare& f : found) {
    std::move(f.strands.begin(), f.strands.end(), std::back_inserter(strands));
    section.lost.insert(section.lost.end(), f.thin.begin(), f.thin.end());
  }
  for (Outline& line : joined(strands))
    if (line.points.size() > 2)
      section.outlines.push_back(std::move(line));
    else
      section.lost.push_back(unresolved(line, lattice));
  return section;
}

}  // namespace mrsim::detail
