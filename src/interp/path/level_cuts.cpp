#include "interp/path/level_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mrsim {
namespace {

constexpr double kNoMove = 1e-3;      // arcs shorter than this are not run
constexpr double kBottomless = -1e9;  // a level below everything
constexpr std::size_t kMostSteps = 200'000;
constexpr std::size_t kMostLooks = 200'000'000;  // how often pieces are looked at

/// Where a piece passes a height: up to two places in x.
struct Crossings {
  double x[2] = {0, 0};
  int count = 0;
  void add(double value) {
    if (count < 2) x[count++] = value;
  }
  double first() const { return x[0]; }
  double last() const { return x[count - 1]; }
};

// Whether a point of the circle lies on an arc of up to half a turn.
bool within(const ProfilePiece& arc, Vec2 p) {
  const double sense = arc.ccw ? 1 : -1;
  const Vec2 q = p - arc.center;
  return sense * cross(arc.start - arc.center, q) >= -kSameTurnPlace &&
         sense * cross(arc.end - arc.center, q) <= kSameTurnPlace;
}

Crossings crossings(const ProfilePiece& piece, double y) {
  Crossings out;
  if (piece.arc) {
    const double r = length(piece.start - piece.center), up = y - piece.center.y;
    const double square = (r - up) * (r + up);
    if (square < -kSameTurnPlace) return out;
    const double half = std::sqrt(std::max(0.0, square));
    for (const double x : {piece.center.x + half, piece.center.x - half})
      if (within(piece, {x, y})) out.add(x);
    return out;
  }
  const auto [low, high] = std::minmax(piece.start.y, piece.end.y);
  if (low > y + kSameTurnPlace || high < y - kSameTurnPlace) return out;
  if (high - low < kSameTurnPlace) {
    out.add(piece.start.x);
    out.add(piece.end.x);
  } else {
    const double share = (y - piece.start.y) / (piece.end.y - piece.start.y);
    out.add(piece.start.x + share * (piece.end.x - piece.start.x));
  }
  return out;
}

}  // namespace

void LevelCuts::fail(std::size_t i, std::string text) {
  if (fault_.text.empty())
    fault_ = {std::move(text), pieces_[std::min(i, pieces_.size() - 1)].source};
}

void LevelCuts::line(Vec2 to, bool rapid) {
  out_.push_back({rapid ? ProfileMove::Kind::rapid : ProfileMove::Kind::line, to, {}});
}

void LevelCuts::arc(const ProfilePiece& piece, Vec2 to) {
  out_.push_back({ProfileMove::Kind::arc, to, piece.center, piece.ccw});
  at_ = to;
}

// Follows piece `i` down, at most to the level. False: the piece does not fall here.
bool LevelCuts::falls(std::size_t i, double level) {
  const ProfilePiece& piece = pieces_[i];
  if (piece.arc) return arc_falls(i, level);
  if (piece.start.y <= piece.end.y + kSameTurnPlace) return false;
  Vec2 to = piece.end;
  if (level >= piece.end.y) {
    const Crossings found = crossings(piece, level);
    if (found.count == 0) {
      fail(i, "the contour begins below the level of a pass here");
      return false;
    }
    to = {found.first(), level};
  }
  line(to, i == 0);
  at_ = to;
  return true;
}

bool LevelCuts::arc_falls(std::size_t i, double level) {
  const ProfilePiece& piece = pieces_[i];
  if (at_.x - piece.end.x <= kSameTurnPlace) {  // this piece has been cut
    at_ = piece.end;
    return true;
  }
  Crossings found = crossings(piece, level);
  if (found.count == 0) found = crossings(piece, level - kSameTurnPlace);
  if (piece.ccw ? at_.x - kSameTurnPlace > piece.center.x : at_.x <= piece.center.x) return false;
  if (piece.ccw) {  // the arc falls behind its top
    const bool below = found.count == 0 || found.last() > piece.center.x;
    arc(piece, below ? piece.end : Vec2{found.last(), level});
  } else if (found.count == 0) {  // the arc falls to its bottom, and rises again
    arc(piece, piece.end);
  } else if (found.first() >= piece.center.x) {
    arc(piece, {found.first(), level});
  }
  return true;
}

// Follows piece `i` up. False: it falls from here on, or the top of an arc has been reached.
bool LevelCuts::rises(std::size_t i) {
  const ProfilePiece& piece = pieces_[i];
  if (!piece.arc) {
    if (piece.end.y + kSameTurnPlace < piece.start.y) return false;
    if (length(at_ - piece.start) > kSameTurnPlace) {
      fail(i, "the contour can not be followed here");
      return false;
    }
    line(piece.end);
    at_ = piece.end;
    return true;
  }
  if (piece.ccw ? at_.x < piece.center.x : at_.x > piece.center.x) return false;
  arc_up(piece);
  return !piece.ccw;
}

// Follows an arc to its end, or to its top if it falls behind that.
void LevelCuts::arc_up(const ProfilePiece& piece) {
  Vec2 to = piece.end;
  if (piece.ccw && to.x < piece.center.x)
    to = piece.center + Vec2{0, length(piece.start - piece.center)};
  if (length(at_ - to) > kNoMove) arc(piece, to);
  at_ = to;
}

// Passes over pockets: goes to where the piece rises above the height of the tool, and follows it
// up.
void LevelCuts::rise_only(std::size_t i) {
  const ProfilePiece& piece = pieces_[i];
  if (!piece.arc && piece.end.y < piece.start.y) return;
  const Crossings found = crossings(piece, at_.y);
  if (found.count == 0) return;
  const double x = piece.arc && !piece.ccw ? found.last() : found.first();
  if (piece.arc && (piece.ccw ? x < piece.center.x : x > piece.center.x)) return;
  at_.x = x;
  line(at_);
  if (piece.arc) return arc_up(piece);
  line(piece.end);
  at_ = piece.end;
}

// Cuts along the level to the contour, leaves it, and goes back to where the cut began.
void LevelCuts::cut_to(std::size_t i, double end) {
  const double travel = at_.x - end;
  const double away = how_.retract > 0 ? std::min(how_.retract, travel / 2) : 0;
  const Vec2 from = at_;
  line({end, from.y});
  line({end + away, from.y + away}, true);
  line({from.x - away, from.y + away}, true);
  line(from, i == 0);
}

LevelCuts::Cut LevelCuts::cut(std::size_t& i) {
  for (std::size_t k = i; k < pieces_.size(); ++k) {
    ++looks_;
    const Crossings found = crossings(pieces_[k], at_.y);
    if (found.count == 0) continue;
    const double end = k == i ? found.last() : found.first();
    if (end - kSameTurnPlace > at_.x) continue;  // behind the tool
    if (std::abs(end - at_.x) >= kSameTurnPlace) {
      cut_to(i, end);
      return Cut::done;
    }
    if (k == i) continue;
    if (length(at_ - pieces_[k].start) >= kSameTurnPlace) return Cut::done;  // nothing to cut
    i = k;
    return Cut::next_piece;
  }
  return Cut::none;
}

// Follows the contour up until it falls. False: its end has been reached.
bool LevelCuts::to_next_pocket(std::size_t& i) {
  while (i < pieces_.size() && rises(i)) ++i;
  if (i >= pieces_.size() || !fault_.text.empty()) return false;
  if (how_.pockets == Pockets::rest) {
    if (tops_.size() > 1 && at_.y > tops_.back().y) tops_.pop_back();
    if (tops_.size() == 1) tops_.push_back(at_);
  }
  return true;
}

ProfileFault LevelCuts::run() {
  tops_.assign(1, at_);
  std::size_t i = 0;
  if (how_.pockets == Pockets::rest)  // goes down at once where the first passes have cut
    while (i < pieces_.size() && falls(i, kBottomless)) ++i;
  double level = tops_.back().y;
  for (std::size_t steps = 0; i < pieces_.size() && fault_.text.empty(); ++steps) {
    if (steps > kMostSteps || looks_ > kMostLooks) {
      fail(i, "the contour takes more passes than are read for a cycle");
      break;
    }
    if (level - kSameTurnPlace > at_.y) {
      const double down = std::ceil((level - kSameTurnPlace - at_.y) / how_.step);
      if (down > static_cast<double>(kMostSteps)) {
        fail(i, "the depth of a pass is too small for the contour");
        break;
      }
      level -= std::max(1.0, down) * how_.step;
      continue;
    }
    if (!falls(i, level)) {
      if (how_.pockets == Pockets::none) {
        for (; i < pieces_.size(); ++i) rise_only(i);
      } else if (to_next_pocket(i)) {
        level = tops_.back().y;
      } else {
        break;
      }
    } else if (std::abs(at_.y - level) > kSameTurnPlace) {
      ++i;  // the level lies below this piece
    } else {
      const Cut one = cut(i);
      if (one == Cut::done) level -= how_.step;
      if (one == Cut::none && ++i < pieces_.size()) fail(i, "a pass meets no contour here");
    }
  }
  return fault_;
}

}  // namespace mrsim
