#include "interp/path/turn_profile.h"

#include "core/numbers/rounding.h"
#include "interp/path/level_cuts.h"
#include "interp/path/plane_piece.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mrsim {
namespace {

using Pieces = std::vector<ProfilePiece>;

constexpr double kSmall = 1e-3;  // shorter pieces are left out
constexpr double kGap = 1e-2;    // between offset pieces: an arc closes a larger gap
constexpr std::size_t kMostWork = 10'000'000;

/// The contour turned so that it runs towards -x, and its end is not below its beginning.
struct View {
  bool across = false;
  double along = 1, up = 1;

  Vec2 to(Vec2 p) const {
    const Vec2 turned = across ? Vec2{p.y, -p.x} : p;
    return {along * turned.x, up * turned.y};
  }
  Vec2 from(Vec2 q) const {
    const Vec2 turned{along * q.x, up * q.y};
    return across ? Vec2{-turned.y, turned.x} : turned;
  }
  bool mirrors() const { return along * up < 0; }
};

View view_of(const Pieces& pieces, bool across) {
  View view;
  view.across = across;
  const Vec2 first = view.to(pieces.front().end), last = view.to(pieces.back().end);
  view.up = first.y > last.y ? -1 : 1;
  view.along = first.x < last.x ? -1 : 1;
  return view;
}

Pieces turned_to_view(Pieces pieces, const View& view) {
  for (ProfilePiece& piece : pieces) {
    piece.start = view.to(piece.start);
    piece.end = view.to(piece.end);
    piece.center = view.to(piece.center);
    piece.ccw = piece.ccw != view.mirrors();
  }
  return pieces;
}

double size_of(const ProfilePiece& piece) {
  const double chord = length(piece.end - piece.start);
  return piece.arc ? std::min(chord, length(piece.start - piece.center)) : chord;
}

// Whether the piece leads towards -x all the way: an arc does if it stays on one side of the height
// of its centre.
bool runs_on(const ProfilePiece& piece) {
  const double travel = piece.end.x - piece.start.x;
  if (piece.corner != ProfilePiece::Corner::none) return true;
  if (!piece.arc) return travel <= kSmall;
  const double side = piece.ccw ? 1 : -1;
  return side * (piece.start.y - piece.center.y) >= -kSmall &&
         side * (piece.end.y - piece.center.y) >= -kSmall && travel <= -kSmall;
}

// Moves the piece to the right of its direction: away from the material where `distance` is above
// 0.
void set_aside(ProfilePiece& piece, double distance) {
  if (piece.arc) {
    const double r = length(piece.start - piece.center);
    const double factor = (r + (piece.ccw ? distance : -distance)) / r;
    piece.start = piece.center + factor * (piece.start - piece.center);
    piece.end = piece.center + factor * (piece.end - piece.center);
    return;
  }
  const Vec2 back = piece.start - piece.end;
  const Vec2 shift = (distance / length(back)) * Vec2{-back.y, back.x};
  piece.start = piece.start + shift;
  piece.end = piece.end + shift;
}

Vec2 middle(Vec2 a, Vec2 b) { return 0.5 * (a + b); }

Vec2 nearer(Vec2 to, Vec2 a, Vec2 b) { return length(a - to) < length(b - to) ? a : b; }

Vec2 straight_meet(const ProfilePiece& a, const ProfilePiece& b) {
  return lines_meet(a.start, a.end - a.start, b.start, b.end - b.start, kTurnRounding)
      .value_or(middle(a.end, b.start));
}

// The place where line and circle meet, else where they are nearest to each other. The radius of
// the circle is taken at the arc's end.
Vec2 line_meets_circle(const ProfilePiece& line, const ProfilePiece& arc, Vec2 near) {
  const Vec2 d = line.end - line.start;
  const Vec2 unit = (1 / length(d)) * d;
  const Vec2 foot = line.start + dot(arc.center - line.start, unit) * unit;
  const Vec2 r = arc.end - arc.center, h = foot - arc.center;
  const double half = std::sqrt(std::max(0.0, dot(r, r) - dot(h, h)));
  return nearer(near, foot - half * unit, foot + half * unit);
}

Vec2 circles_meet(const ProfilePiece& a, const ProfilePiece& b) {
  const Vec2 d = b.center - a.center;
  const double apart = length(d), ra = length(a.start - a.center), rb = length(b.start - b.center);
  const Vec2 near = middle(a.end, b.start);
  if (apart <= kSameTurnPlace) return near;
  const double along = (apart * apart + ra * ra - rb * rb) / (2 * apart);
  const double half = std::sqrt(std::max(0.0, ra * ra - along * along));
  const Vec2 unit = (1 / apart) * d, foot = a.center + along * unit;
  const Vec2 side = half * Vec2{-unit.y, unit.x};
  // Two hollow arcs meet in a ridge, other arcs on the side from which the tool comes.
  return a.ccw || b.ccw ? foot - side : nearer(near, foot - side, foot + side);
}

// Ends the first piece and begins the second where they meet.
void join(ProfilePiece& a, ProfilePiece& b) {
  if (a.arc != b.arc && length(a.end - b.start) < kSameTurnPlace) return;
  a.end = b.start = a.arc && b.arc ? circles_meet(a, b)
                    : a.arc        ? line_meets_circle(b, a, b.start)
                    : b.arc        ? line_meets_circle(a, b, b.start)
                                   : straight_meet(a, b);
}

// Makes a fillet or chamfer of the piece's size between its neighbours. False: there is no room.
bool make_corner(ProfilePiece& corner, ProfilePiece& before, ProfilePiece& behind) {
  double size = corner.size;
  ProfilePiece a, b;
  const auto move = [&] {
    a = before;
    b = behind;
    set_aside(a, size);
    set_aside(b, size);
    return a.end.x - b.start.x <= kGap;
  };
  if (!move()) {
    size = -size;
    if (!move()) return false;
  }
  join(a, b);
  corner.center = middle(a.end, b.start);
  set_aside(a, -size);
  set_aside(b, -size);
  corner.start = before.end = a.end;
  corner.end = behind.start = b.start;
  corner.arc = corner.corner == ProfilePiece::Corner::fillet;
  corner.ccw = std::max(corner.start.y, corner.end.y) > corner.center.y;
  corner.corner = ProfilePiece::Corner::none;
  return true;
}

ProfileFault make_corners(Pieces& pieces) {
  for (std::size_t i = 1; i + 1 < pieces.size(); ++i)
    if (pieces[i].corner != ProfilePiece::Corner::none &&
        !make_corner(pieces[i], pieces[i - 1], pieces[i + 1]))
      return {"the fillet or chamfer does not fit into the corner", pieces[i].source};
  std::erase_if(pieces, [](const ProfilePiece& piece) { return size_of(piece) < kSmall; });
  if (pieces.size() < 2) return {"the contour has no length"};
  return {};
}

ProfileFault check_direction(Pieces& pieces, const View& view) {
  ProfilePiece& way = pieces.front();
  way.start.x = std::max(way.start.x, way.end.x);
  for (const ProfilePiece& piece : pieces)
    if (!runs_on(piece))
      return {std::string("the contour runs back in ") + (view.across ? "X" : "Z"), piece.source};
  return {};
}

// Puts an arc between pieces whose ends have moved apart.
void close_gaps(Pieces& pieces, double step) {
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    if (pieces[i].end.x - pieces[i + 1].start.x <= kGap) continue;
    ProfilePiece a = pieces[i], b = pieces[i + 1], between;
    between.arc = true;
    between.ccw = step > 0;
    between.start = a.end;
    between.end = b.start;
    between.source = b.source;
    set_aside(a, -step);
    set_aside(b, -step);
    between.center = middle(a.end, b.start);
    pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(++i), between);
  }
}

ProfileFault join_all(Pieces& pieces) {
  for (std::size_t i = 0; i + 1 < pieces.size();) {
    if (!runs_on(pieces[i]))
      return {"the contour has no place for the allowance here", pieces[i].source};
    if (size_of(pieces[i]) < kSmall) {
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
      i -= i > 0 ? 1 : 0;
    } else {
      join(pieces[i], pieces[i + 1]);
      ++i;
    }
  }
  return {};
}

// Leaves an allowance on the contour, on the side from which the tool comes. A step is at
// most half of the shortest piece, so that a piece becomes short before it vanishes.
ProfileFault leave_allowance(Pieces& pieces, double allowance) {
  const ProfilePiece way = pieces.front();
  const Vec2 first = way.end - way.start, whole = pieces.back().start - way.start;
  if (cross(whole, first) < 0) allowance = -allowance;
  pieces.erase(pieces.begin());
  std::size_t work = 0;
  for (double done = 0; done != allowance;) {
    double step = std::abs(allowance - done);
    for (const ProfilePiece& piece : pieces) step = std::min(step, size_of(piece) / 2);
    const bool last = step >= std::abs(allowance - done);
    if (allowance < 0) step = -step;
    for (ProfilePiece& piece : pieces) set_aside(piece, step);
    std::erase_if(pieces, [](const ProfilePiece& piece) { return size_of(piece) < kSmall; });
    if (pieces.empty()) return {"the allowance leaves nothing of the contour"};
    close_gaps(pieces, step);
    if (ProfileFault fault = join_all(pieces); !fault.text.empty()) return fault;
    if (pieces.empty() || (work += pieces.size()) > kMostWork)
      return {"the contour's pieces are too small for the allowance"};
    done = last ? allowance : done + step;
  }
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
    pieces[i].end = pieces[i + 1].start = middle(pieces[i].end, pieces[i + 1].start);
  pieces.insert(pieces.begin(), way);
  pieces[0].end = pieces[1].start;
  return {};
}

void append_turned_back(const std::vector<ProfileMove>& moves, const View& view,
                        std::vector<ProfileMove>& out) {
  for (ProfileMove move : moves) {
    move.end = view.from(move.end);
    move.center = view.from(move.center);
    move.ccw = move.ccw != view.mirrors();
    out.push_back(move);
  }
}

// A contour that does not end where the cycle began gets a piece that leads there, across the cuts.
void lead_out(Pieces& pieces, bool across) {
  const ProfilePiece &way = pieces.front(), &last = pieces.back();
  const auto side = [&](Vec2 p) { return across ? p.x : p.y; };
  const auto along = [&](Vec2 p) { return across ? p.y : p.x; };
  if (along(last.end) == along(last.start)) return;
  if (side(way.end - way.start) * side(way.start - last.end) >= 0) return;
  ProfilePiece out;
  out.source = last.source;
  out.start = last.end;
  out.end = across ? Vec2{way.start.x, last.end.y} : Vec2{last.end.x, way.start.y};
  pieces.push_back(out);
}

bool all_run_on(const Pieces& pieces) { return std::all_of(pieces.begin(), pieces.end(), runs_on); }

}  // namespace

ProfileFault rough_profile(Pieces pieces, const Roughing& how, std::vector<ProfileMove>& out) {
  lead_out(pieces, how.across);
  const View view = view_of(pieces, how.across);
  pieces = turned_to_view(std::move(pieces), view);
  if (ProfileFault fault = make_corners(pieces); !fault.text.empty()) return fault;
  if (ProfileFault fault = check_direction(pieces, view); !fault.text.empty()) return fault;
  if (ProfileFault fault = leave_allowance(pieces, how.allowance); !fault.text.empty())
    return fault;
  std::vector<ProfileMove> moves(1);
  moves[0].end = pieces.front().start;
  const ProfilePiece& last = pieces.back();
  if (last.end.y < pieces.front().start.y) {
    ProfilePiece up;
    up.start = last.end;
    up.end = {last.end.x, pieces.front().start.y};
    up.source = last.source;
    pieces.push_back(up);
  }
  ProfileFault fault = LevelCuts(pieces, how, moves).run();
  append_turned_back(moves, view, out);
  return fault;
}

ProfileFault finish_profile(Pieces pieces, const Finishing& how, std::vector<ProfileMove>& out) {
  const Pieces contour(pieces.begin() + 1, pieces.end());
  const bool across = !all_run_on(turned_to_view(contour, view_of(contour, false)));
  const View view = view_of(pieces, across);
  pieces = turned_to_view(std::move(pieces), view);
  if (ProfileFault fault = make_corners(pieces); !fault.text.empty()) return fault;
  if (ProfileFault fault = check_direction(pieces, view); !fault.text.empty()) return fault;
  std::vector<ProfileMove> moves;
  for (int pass = how.passes; pass > 0; --pass) {
    Pieces path = pieces;
    const double share = static_cast<double>(pass - 1) / how.passes;
    ProfileFault fault = leave_allowance(path, share * (how.first - how.last) + how.last);
    if (!fault.text.empty()) return fault;
    ProfileMove start;
    start.end = path[0].start;
    start.approach = true;
    moves.push_back(start);
    for (std::size_t i = 0; i < path.size(); ++i) {
      ProfileMove move;
      move.kind = i == 0        ? ProfileMove::Kind::rapid
                  : path[i].arc ? ProfileMove::Kind::arc
                                : ProfileMove::Kind::line;
      move.end = path[i].end;
      move.center = path[i].center;
      move.ccw = path[i].ccw;
      moves.push_back(move);
    }
  }
  append_turned_back(moves, view, out);
  return {};
}

}  // namespace mrsim
