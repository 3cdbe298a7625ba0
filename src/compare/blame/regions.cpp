#include "compare/blame/regions.h"

#include "core/numbers/disjoint_sets.h"
#include "core/numbers/vec.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr std::size_t kMostLines = 8, kMostBeside = 4;

// A sample out of tolerance; `index` counts through the part's samples, then the nominal's.
struct Member {
  std::array<std::int32_t, 3> cell;
  bool gouge;
  std::uint32_t index;
  std::uint32_t group = 0;
  auto key() const { return std::tie(gouge, cell); }
};

class Clusters {
 public:
  Clusters(const RegionInput& in, const Acceptance& band) : in_(in) {
    const double spacing = std::sqrt(std::max(in.part.samples.weight, in.nominal.samples.weight));
    size_ = std::max(1.5 * spacing, 1e-6);
    collect(in.part, 0, band);
    collect(in.nominal, std::uint32_t(in.part.hits.size()), band);
    std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) {
      return a.key() != b.key() ? a.key() < b.key() : a.index < b.index;
    });
    join();
  }

  /// Members of each cluster, clusters in no particular order.
  std::vector<std::vector<std::uint32_t>> take() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const Member& m : members_) pairs.emplace_back(groups_.least(m.group), m.index);
    std::sort(pairs.begin(), pairs.end());
    std::vector<std::vector<std::uint32_t>> out;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (i == 0 || pairs[i].first != pairs[i - 1].first) out.emplace_back();
      out.back().push_back(pairs[i].second);
    }
    return out;
  }

 private:
  void collect(const DeviationField& field, std::uint32_t offset, const Acceptance& band) {
    for (std::uint32_t i = 0; i < field.hits.size(); ++i) {
      const double d = field.hits[i].distance;
      if (d >= band.lo && d <= band.hi) continue;
      const Vec3& p = field.samples.points[i];
      members_.push_back({{cell(p.x), cell(p.y), cell(p.z)}, d < band.lo, offset + i});
    }
  }
  std::int32_t cell(double x) const {
    return std::int32_t(std::clamp(std::floor(x / size_), -2e9, 2e9));
  }

  // Makes one group of each cell and side, then joins the groups of neighbouring cells.
  void join() {
    std::vector<std::uint32_t> firsts;
    for (std::uint32_t i = 0; i < members_.size(); ++i) {
      if (i == 0 || members_[i].key() != members_[i - 1].key()) firsts.push_back(i);
      members_[i].group = std::uint32_t(firsts.size() - 1);
    }
    groups_.grow(firsts.size());
    for (std::uint32_t g = 0; g < firsts.size(); ++g) {
      Member probe = members_[firsts[g]];
      const std::array<std::int32_t, 3> c = probe.cell;
      for (int k = 14; k < 27; ++k) {  // the 13 neighbours that come later
        probe.cell = {c[0] + k / 9 - 1, c[1] + k / 3 % 3 - 1, c[2] + k % 3 - 1};
        const auto at = std::lower_bound(
            firsts.begin(), firsts.end(), probe,
            [&](std::uint32_t i, const Member& m) { return members_[i].key() < m.key(); });
        if (at != firsts.end() && members_[*at].key() == probe.key())
          groups_.join(g, std::uint32_t(at - firsts.begin()));
      }
    }
  }

  const RegionInput& in_;
  double size_ = 1;
  std::vector<Member> members_;
  DisjointSets groups_;
};

// The two fields as one list.
struct Both {
  const RegionInput& in;
  bool on_part(std::uint32_t i) const { return i < in.part.hits.size(); }
  const DeviationField& field(std::uint32_t i) const { return on_part(i) ? in.part : in.nominal; }
  std::uint32_t local(std::uint32_t i) const {
    return on_part(i) ? i : i - std::uint32_t(in.part.hits.size());
  }
  double deviation(std::uint32_t i) const { return field(i).hits[local(i)].distance; }
  const Vec3& point(std::uint32_t i) const { return field(i).samples.points[local(i)]; }
  double weight(std::uint32_t i) const {
    return local(i) < field(i).samples.spread ? field(i).samples.weight : 0;
  }
  Vec3 normal(std::uint32_t i) const {
    return normalized(
        area_normal(on_part(i) ? in.part_mesh : in.nominal_mesh, field(i).samples.faces[local(i)]));
  }
};

DeviationRegion describe(const std::vector<std::uint32_t>& members, const Both& both) {
  DeviationRegion out;
  std::uint32_t worst = members.front();
  double summed = 0, weight = 0, on_part = 0, on_nominal = 0;
  for (const std::uint32_t i : members) {
    const double d = both.deviation(i), w = both.weight(i);
    if (std::abs(d) > std::abs(both.deviation(worst))) worst = i;
    extend(out.extent, both.point(i));
    summed += w * d;
    weight += w;
    (both.on_part(i) ? out.area : out.nominal_area) += w;
    (both.on_part(i) ? on_part : on_nominal) += w * std::abs(d);
  }
  out.place = both.point(worst);
  out.normal = both.normal(worst);
  out.worst = both.deviation(worst);
  out.gouge = out.worst < 0;
  out.mean = weight > 0 ? summed / weight : out.worst;
  out.volume = on_part > 0 ? on_part : on_nominal;
  return out;
}

struct Score {
  double sum = 0, worst = 0;
};

// Area times distance of each line within the region. Vertices alone, where a region is smaller
// than the spacing of samples, count with a tiny area each. The nominal's samples speak through
// the part's face nearest to them where the part has no sample in the region.
std::map<LineKey, Score> scores(const std::vector<std::uint32_t>& members, const Both& both) {
  std::map<LineKey, Score> out;
  const bool any_part = both.on_part(members.front());  // ascending: the part's come first
  for (const std::uint32_t i : members) {
    if (any_part && !both.on_part(i)) break;
    const DeviationField& field = both.field(i);
    const std::uint32_t at = both.local(i);
    const std::uint32_t face = both.on_part(i) ? field.samples.faces[at] : field.hits[at].triangle;
    const double d = both.deviation(i);
    Score& score = out[both.in.lines.of(face)];
    score.sum += std::max(both.weight(i), 1e-6 * field.samples.weight) * std::abs(d);
    if (std::abs(d) > std::abs(score.worst)) score.worst = d;
  }
  return out;
}

void blame_cutters(const std::vector<std::uint32_t>& members, const Both& both,
                   DeviationRegion& region) {
  std::vector<std::pair<LineKey, Score>> ranked;
  double total = 0;
  for (const auto& entry : scores(members, both)) {
    ranked.push_back(entry);
    total += entry.second.sum;
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.second.sum > b.second.sum; });
  for (const auto& [key, score] : ranked) {
    const double share = total > 0 ? score.sum / total : 0;
    if (key.is_stock()) {
      // A part without owners does not know what is stock.
      if (!both.in.part_mesh.owners.empty()) region.stock_share = share;
    } else if (region.lines.size() < kMostLines) {
      BlamedLine line = name_line(key, both.in.part_mesh.origin, both.in.texts);
      line.share = share;
      line.worst = score.worst;
      region.lines.push_back(std::move(line));
    }
  }
}

// For material that no line has touched: the lines whose cuts come nearest to it.
void blame_neighbours(const std::vector<std::uint32_t>& members, const Both& both,
                      const CutSurface& cut, DeviationRegion& region) {
  std::map<LineKey, double> found;
  const std::size_t step = members.size() / 256 + 1;
  const auto look = [&](const Vec3& p) {
    const CutSurface::Nearest near = cut.nearest(p);
    const auto [at, is_new] = found.emplace(near.line, near.distance);
    if (!is_new) at->second = std::min(at->second, near.distance);
  };
  region.lines.clear();  // the lines that border left material did not leave it
  look(region.place);
  for (std::size_t i = 0; i < members.size(); i += step) look(both.point(members[i]));
  std::vector<std::pair<double, LineKey>> ranked;
  for (const auto& [key, d] : found) ranked.emplace_back(d, key);
  std::sort(ranked.begin(), ranked.end());
  for (std::size_t i = 0; i < std::min(ranked.size(), kMostBeside); ++i) {
    BlamedLine line = name_line(ranked[i].second, both.in.part_mesh.origin, both.in.texts);
    line.beside = true;
    line.distance = ranked[i].first;
    region.lines.push_back(std::move(line));
  }
}

}  // namespace

std::vector<DeviationRegion> find_regions(const RegionInput& input, const Acceptance& band,
                                          std::size_t most, std::size_t& count) {
  auto clusters = Clusters(input, band).take();
  count = clusters.size();
  const Both both{input};
  std::vector<std::pair<DeviationRegion, std::size_t>> found;
  for (std::size_t i = 0; i < clusters.size(); ++i)
    found.emplace_back(describe(clusters[i], both), i);
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return std::abs(a.first.worst) > std::abs(b.first.worst);
  });
  if (found.size() > most) found.resize(most);
  const CutSurface cut(input.part_mesh, input.lines);
  std::vector<DeviationRegion> out;
  for (auto& [region, cluster] : found) {
    blame_cutters(clusters[cluster], both, region);
    const bool untouched = region.stock_share > 0.5 || region.lines.empty();
    if (!region.gouge && untouched && !cut.empty())
      blame_neighbours(clusters[cluster], both, cut, region);
    out.push_back(std::move(region));
  }
  return out;
}

}  // namespace mrsim
