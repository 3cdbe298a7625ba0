#include "mesh/turned/turned_chords.h"

#include "core/numbers/vec.h"
#include "mesh/points/surface_search.h"

#include <algorithm>
#include <cmath>

namespace mrsim::detail {
namespace {

constexpr double kLeastBend = 0.17;  ///< radians, nearly: what bends less is no corner
constexpr double kChordAlong = 0.5;  ///< least cosine between a chord and the pieces it replaces
constexpr int kEvenSteps = 8;
constexpr double kStraightWithin = 1e-7;  ///< mm

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a, off = p - a;
  const double whole = dot(along, along);
  const double t = whole > 0 ? std::clamp(dot(off, along) / whole, 0.0, 1.0) : 0;
  return length(off - t * along);
}

class Chooser {
 public:
  Chooser(const Outline& outline, const ChordLimits& limits)
      : points_(outline.points), closed_(outline.closed), limits_(limits) {
    if (closed_) points_.push_back(points_.front());
    find_corners();
    way_.resize(points_.size());
    for (std::size_t k = 1; k < points_.size(); ++k)
      way_[k] = way_[k - 1] + distance(points_[k - 1].at, points_[k].at);
  }

  Outline choose(bool even) const {
    Outline out;
    out.closed = closed_;
    for (std::size_t k = 0; k + 1 < corners_.size(); ++k) {
      const std::vector<std::size_t> stops =
          even ? even_stops(corners_[k], corners_[k + 1])
               : stops_within(corners_[k], corners_[k + 1], limits_.height);
      for (std::size_t i = 0; i + 1 < stops.size(); ++i)
        out.points.push_back(chord(stops[i], stops[i + 1]));
    }
    if (!closed_) out.points.push_back(points_.back());
    return out;
  }

 private:
  // Begins a loop at a corner, so that no chord has to go round its beginning.
  void find_corners() {
    std::vector<std::size_t> bends;
    const std::size_t last = points_.size() - 1;
    for (std::size_t k = 0; k < last; ++k)
      if (points_[k].bend >= kLeastBend) bends.push_back(k);
    if (closed_ && !bends.empty() && bends.front() != 0) {
      points_.pop_back();
      std::rotate(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(bends.front()),
                  points_.end());
      points_.push_back(points_.front());
      const std::size_t first = bends.front();
      for (std::size_t& k : bends) k -= first;
    }
    corners_.push_back(0);
    for (const std::size_t at : bends)
      if (at > 0 && is_sharp(at, last)) corners_.push_back(at);
    corners_.push_back(last);
    keep_an_area();
  }

  // Whether the outline turns sharply at a point, as seen from points about as far away as a border
  // may move, but no farther than the last corner.
  bool is_sharp(std::size_t at, std::size_t last) const {
    std::size_t before = at, after = at;
    for (double way = 0; before > corners_.back() && way < limits_.border; --before)
      way += distance(points_[before - 1].at, points_[before].at);
    for (double way = 0; after < last && way < limits_.border; ++after)
      way += distance(points_[after].at, points_[after + 1].at);
    return distance_to_segment(points_[at].at, points_[before].at, points_[after].at) >
           limits_.shallow;
  }

  // A loop has three corners, a line from the axis to the axis two.
  void keep_an_area() {
    for (std::size_t least = closed_ ? 4 : 3; corners_.size() < least;) {
      double most = -1;
      std::size_t farthest = 0;
      for (std::size_t k = 0; k + 1 < corners_.size(); ++k)
        for (std::size_t i = corners_[k] + 1; i < corners_[k + 1]; ++i) {
          const double off = distance_to_segment(points_[i].at, points_[corners_[k]].at,
                                                 points_[corners_[k + 1]].at);
          if (off > most) most = off, farthest = i;
        }
      if (most < 0) return;
      corners_.insert(std::lower_bound(corners_.begin(), corners_.end(), farthest), farthest);
    }
  }

  // Takes as few stops as the limit needs, and of all such choices the one with the lowest chords.
  std::vector<std::size_t> even_stops(std::size_t from, std::size_t to) const {
    std::vector<std::size_t> best = stops_within(from, to, limits_.height);
    if (best.size() <= 2) return best;
    double low = 0, high = limits_.height;
    for (int k = 0; k < kEvenSteps; ++k) {
      const double middle = 0.5 * (low + high);
      std::vector<std::size_t> even = stops_within(from, to, middle);
      if (even.size() <= best.size()) {
        best = std::move(even);
        high = middle;
      } else {
        low = middle;
      }
    }
    return best;
  }

  std::vector<std::size_t> stops_within(std::size_t from, std::size_t to, double limit) const {
    std::vector<std::size_t> out{from};
    while (out.back() < to) out.push_back(farthest(out.back(), to, limit));
    return out;
  }

  // The end of a chord from `from` that is within the limit while one a little longer is not.
  std::size_t farthest(std::size_t from, std::size_t to, double limit) const {
    if (stands_for(from, to, limit)) return to;
    std::size_t good = from + 1, step = 1;
    while (good + step < to && stands_for(from, good + step, limit)) {
      good += step;
      step *= 2;
    }
    for (; step > 0; step /= 2)
      if (good + step < to && stands_for(from, good + step, limit)) good += step;
    return good;
  }

  double height(std::size_t from, std::size_t to) const {
    double off = 0, own = 0;
    for (std::size_t k = from; k < to; ++k) {
      off = std::max(off, distance_to_segment(points_[k].at, points_[from].at, points_[to].at));
      own = std::max(own, points_[k].height);
    }
    return off + own;
  }

  bool stands_for(std::size_t from, std::size_t to, double limit) const {
    if (to == from + 1) return true;
    if (height(from, to) > limit) return false;
    const Vec3 along = points_[to].at - points_[from].at;
    for (std::size_t k = from; k < to; ++k) {
      const Vec3 chord = points_[k + 1].at - points_[k].at;
      const double size = length(chord);
      if (size > 4 * limits_.height && dot(chord, along) < kChordAlong * size * length(along))
        return false;
    }
    const auto [first, last] = longest_run(from, to);
    return run_length(from, first) <= limits_.border && run_length(last, to) <= limits_.border;
  }

  double run_length(std::size_t from, std::size_t to) const { return way_[to] - way_[from]; }

  // The longest part of one owner, the first of equal ones.
  std::pair<std::size_t, std::size_t> longest_run(std::size_t from, std::size_t to) const {
    std::pair<std::size_t, std::size_t> best{from, from};
    double longest = -1;
    for (std::size_t k = from; k < to;) {
      std::size_t end = k + 1;
      while (end < to && points_[end].face.owner == points_[k].face.owner) ++end;
      const double size = run_length(k, end);
      if (size > longest) longest = size, best = {k, end};
      k = end;
    }
    return best;
  }

  OutlinePoint chord(std::size_t from, std::size_t to) const {
    OutlinePoint p = points_[from];
    p.face = points_[longest_run(from, to).first].face;
    p.height = height(from, to);
    p.excess = 0;
    return p;
  }

  std::vector<OutlinePoint> points_;  ///< a loop's first one again at the end
  std::vector<double> way_;           ///< mm along the outline, by points
  bool closed_;
  ChordLimits limits_;
  std::vector<std::size_t> corners_;
};

}  // namespace

Outline straightened(const Outline& outline) {
  const auto is_amid = [](const OutlinePoint& a, const OutlinePoint& b, const OutlinePoint& c) {
    return b.bend == 0 && same_face(a.face, b.face) && a.height <= kStraightWithin &&
           b.height <= kStraightWithin && distance_to_segment(b.at, a.at, c.at) <= kStraightWithin;
  };
  Outline out;
  out.closed = outline.closed;
  for (const OutlinePoint& p : outline.points) {
    const std::size_t n = out.points.size();
    if (n > 1 && is_amid(out.points[n - 2], out.points[n - 1], p)) out.points.pop_back();
    out.points.push_back(p);
  }
  return out;
}

Outline fewest_chords(const Outline& outline, const ChordLimits& limits) {
  return Chooser(outline, limits).choose(false);
}

Outline even_chords(const Outline& outline, const ChordLimits& limits) {
  return Chooser(outline, limits).choose(true);
}

}  // namespace mrsim::detail
