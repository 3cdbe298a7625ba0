#include "interp/path/piece_distance.h"

#include "core/rounding.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

bool beside_arc(const PlanePiece& arc, Vec2 p) {
  return length(p - arc.center) > kRounding && position_on(arc, p) <= extent(arc) + kTurnRounding;
}

Vec2 nearest_of_line(const PlanePiece& line, Vec2 p) {
  const Vec2 d = line.end - line.start;
  const double square = dot(d, d);
  if (square <= kRounding * kRounding) return line.start;
  return line.start + std::clamp(dot(p - line.start, d) / square, 0.0, 1.0) * d;
}

}  // namespace

double distance_to(const PlanePiece& piece, Vec2 p) {
  if (!piece.arc) return length(p - nearest_of_line(piece, p));
  if (beside_arc(piece, p)) return std::abs(length(p - piece.center) - piece.radius);
  return std::min(length(p - piece.start), length(p - piece.end));
}

double place_nearest(const PlanePiece& piece, Vec2 p) {
  if (!piece.arc) return length(nearest_of_line(piece, p) - piece.start);
  if (beside_arc(piece, p)) return std::min(position_on(piece, p), extent(piece));
  return length(p - piece.start) <= length(p - piece.end) ? 0 : extent(piece);
}

// The least distance lies at an end of one of the two, at the foot of the centre, or where both
// meet.
double distance_between(const PlanePiece& way, const PlanePiece& piece) {
  double least = std::min(distance_to(piece, way.start), distance_to(piece, way.end));
  least = std::min({least, distance_to(way, piece.start), distance_to(way, piece.end)});
  std::array<Vec2, 2> hits;
  const int n = intersect(way, piece, hits);
  for (int i = 0; i < n; ++i) {
    const Vec2 p = nearest_of_line(way, hits[static_cast<std::size_t>(i)]);
    least = std::min(least, distance_to(piece, p));
  }
  if (piece.arc) least = std::min(least, distance_to(piece, nearest_of_line(way, piece.center)));
  return least;
}

}  // namespace mrsim
