#include "interp/turning/linuxcnc_turning.h"

#include "core/numbers/rounding.h"
#include "interp/path/arc.h"
#include "interp/text/code_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kMostContourPieces = 100'000;
constexpr double kMostFinishes = 10'000;

}  // namespace

bool LinuxCncTurning::run() {
  where_ = *block_.oneshot;
  modal_.motion = Code::rapid;
  modal_.drill.number = 0;
  const int by_10 = static_cast<int>(std::lround(where_.value * 10));
  number_ = by_10 / 10;
  rough_ = {};
  finish_ = {};
  rough_.across = number_ == 72;
  rough_.pockets = by_10 % 10 == 1 ? Pockets::none : by_10 % 10 == 2 ? Pockets::rest : Pockets::all;
  const std::string name = text_of(where_);
  const Word* q = take('Q');
  if (!q || q->value < 0 || q->value != std::floor(q->value))
    return error("value-missing", name + " needs Q, the number of the subprogram of its contour",
                 q ? *q : where_);
  contour_ = static_cast<long>(q->value);
  if (!goes_on(where_)) return false;
  if (modal_.plane != kPlaneZX)
    return error("cycle-plane", name + " needs the plane X Z: G18 before it", where_);
  if (modal_.comp != Code::comp_off && number_ != 70)
    return error("cycle-compensation", name + " under radius compensation: G40 before it", where_);
  if (!own_words() || !go_to_start()) return false;
  waits_ = true;
  return true;
}

bool LinuxCncTurning::own_words() {
  const auto value = [&](char c, double& out) {
    if (const Word* word = take(c)) out = word->value;
  };
  for (const char c : {'U', 'W'})
    if (const Word* word = peek(c))
      return error("not-supported",
                   fmt::format("{} beside {} is not supported", c, text_of(where_)), *word);
  if (number_ == 70) {
    double passes = 1;
    value('D', finish_.first);
    value('E', finish_.last);
    value('P', passes);
    if (passes < 1 || passes > kMostFinishes || passes != std::floor(passes))
      return error("value-range", "P is the number of passes, from 1 on", *peek('P'));
    finish_.passes = static_cast<int>(passes);
    if (finish_.passes > 1 && modal_.comp != Code::comp_off)
      return error("not-supported", "G70 in several passes under radius compensation", *peek('P'));
    return true;
  }
  value('D', rough_.allowance);
  value('I', rough_.step);
  value('R', rough_.retract);
  if (rough_.step <= 0)
    return error("value-range", "I is the depth of a pass, above 0", *peek('I'));
  if (rough_.retract < 0)
    return error("value-range", "R is the way back from the contour, not below 0", *peek('R'));
  return true;
}

// X and Z are the beginning of the cycle, to which a rapid goes first.
bool LinuxCncTurning::go_to_start() {
  Target to;
  if (!axes_.target(to, position_.programmed)) return false;
  const Code comp = modal_.comp;
  modal_.comp = Code::comp_off;
  if (!to.named.empty()) moves_.step(to, where_, MotionKind::rapid);
  modal_.comp = comp;
  return true;
}

void LinuxCncTurning::end_block() {
  if (!waits_) return;
  waits_ = false;
  place_ = block_.place();
  modal_before_ = modal_;
  CallRequest request;
  request.on_start = [this] {
    reading_ = true;
    pieces_.clear();
    sources_.clear();
    at_ = position_.programmed;
    modal_.motion = Code::rapid;
    errors_before_ = reporter_.errors();
  };
  request.on_end = [this] { end_contour(); };
  const Word where = where_;
  statements_->call_sub(fmt::format("{}", contour_), std::move(request), where);
}

void LinuxCncTurning::end_program() {
  if (!reading_) return;
  reading_ = false;
  reporter_.set_place(place_.file, place_.line, place_.call, {});
  error("program-end-missing", "the program ends inside the contour of this cycle", where_);
}

// U and W count from the end of the block before. They become X and Z.
bool LinuxCncTurning::increment(char letter_from, char axis) {
  for (Word& word : block_.words) {
    if (word.address != letter(letter_from)) continue;
    for (const Word& other : block_.words)
      if (other.address == letter(axis))
        return error("address-twice", "an axis is given absolute and incremental", word);
    if (modal_.incremental)
      return error("cycle-contour", fmt::format("{} in the contour and G91", letter_from), word);
    const bool diameter = axis == 'X' && modal_.diameter == Code::diameter_on;
    word.address = letter(axis);
    word.value += component(at_, axis - 'X') / scale() * (diameter ? 2 : 1);
  }
  return true;
}

// Only G0 to G3 and their words have an effect in a contour.
bool LinuxCncTurning::contour_words(const Word*& axis_word) {
  for (const Word& word : block_.words) {
    const auto c = static_cast<char>(word.address);
    if (word.address < Address::function && c != 'G') {
      if (std::string_view("XZUWIKRAC").find(c) != std::string_view::npos) {
        if (!axis_word) axis_word = &word;
        continue;
      }
    } else if (c == 'G') {
      const double g = word.value;
      if (g == 0 || g == 1 || g == 2 || g == 3) {
        modal_.motion = g == 0   ? Code::rapid
                        : g == 1 ? Code::line
                        : g == 2 ? Code::arc_cw
                                 : Code::arc_ccw;
        continue;
      }
      if (find_g_code(control_.dialect, program_.machine, static_cast<int>(g * 10)).group ==
          Group::motion)
        return error("cycle-contour",
                     fmt::format("the contour of a cycle has G0 to G3, and here {}", text_of(word)),
                     word);
    }
    note_once("cycle-contour",
              fmt::format("in the contour of a cycle {} and the like do not count", text_of(word)),
              word, "contour-words");
  }
  return true;
}

void LinuxCncTurning::contour_block() {
  const Word* axis_word = nullptr;
  if (contour_words(axis_word) && axis_word) move_to(*axis_word);
}

bool LinuxCncTurning::move_to(const Word& where) {
  ProfilePiece piece;
  Vec3 end = at_;
  Target to;
  if (!axes_.target(to, at_)) return false;
  to.programmed.y = at_.y;
  piece.arc = is_circular(modal_.motion);
  if (length(to.programmed - at_) <= kRounding) return true;
  const double unit = 1 / scale();
  if (piece.arc) {
    SolvedArc arc;
    if (!arcs_.solve(at_, frames_.total, arc)) return false;
    piece.center = centre(unit * in_plane(basis(), arc.center));
    piece.ccw = arc.sweep > 0;
    if (pieces_.empty())
      return error("cycle-contour", "the contour of a cycle begins with G0 or G1, the way to it",
                   where);
  }
  if (pieces_.size() > kMostContourPieces)
    return error("value-range", fmt::format("more than {} pieces", kMostContourPieces), where);
  end = to.programmed;
  piece.start = unit * in_plane(basis(), at_);
  piece.end = unit * in_plane(basis(), end);
  piece.source = static_cast<int>(sources_.size());
  Motion source;
  source.file = block_.file;
  source.line = block_.line_number;
  source.column = where.column + 1;
  source.call = block_.call;
  sources_.push_back(source);
  pieces_.push_back(piece);
  at_ = end;
  return add_corner();
}

// The centre that I and K give, also where the radii at the ends differ a little.
Vec2 LinuxCncTurning::centre(Vec2 otherwise) const {
  const Word *i = peek('I'), *k = peek('K');
  if (!i && !k) return otherwise;
  const Vec2 words{k ? k->value : 0, i ? i->value : 0};
  return modal_.center_absolute ? words : (1 / scale()) * in_plane(basis(), at_) + words;
}

// A is a fillet and C a chamfer at the end of the piece.
bool LinuxCncTurning::add_corner() {
  const Word* fillet = take('A');
  const Word* chamfer = take('C');
  if (fillet && chamfer)
    return error("cycle-contour", "A and C at one corner: a fillet or a chamfer", *chamfer);
  if (!fillet && !chamfer) return true;
  ProfilePiece corner;
  corner.corner = fillet ? ProfilePiece::Corner::fillet : ProfilePiece::Corner::chamfer;
  corner.size = (fillet ? fillet : chamfer)->value;
  corner.start = corner.end = pieces_.back().end;
  corner.source = pieces_.back().source;
  pieces_.push_back(corner);
  return true;
}

void LinuxCncTurning::end_contour() {
  reading_ = false;
  modal_ = modal_before_;
  put_back_block(place_);
  if (reporter_.errors() == errors_before_ && pieces_.size() > 1) cut();
}

void LinuxCncTurning::cut() {
  pieces_.front().start = (1 / scale()) * in_plane(basis(), position_.programmed);
  std::vector<ProfileMove> moves;
  const ProfileFault fault = number_ == 70 ? finish_profile(std::move(pieces_), finish_, moves)
                                           : rough_profile(std::move(pieces_), rough_, moves);
  pieces_.clear();
  if (!fault.text.empty()) {
    if (fault.source < 0)
      error("cycle-contour", fault.text, where_);
    else
      reporter_.add_at(Severity::error, "cycle-contour", fault.text,
                       sources_[static_cast<std::size_t>(fault.source)]);
    return;
  }
  mover_.begin(where_);
  for (const ProfileMove& move : moves) run_move(move);
}

void LinuxCncTurning::run_move(const ProfileMove& move) {
  const Vec2 from = mover_.position(), end = scale() * move.end;
  if (move.kind == ProfileMove::Kind::arc) {
    modal_.motion = move.ccw ? Code::arc_ccw : Code::arc_cw;
    if (length(end - from) <= kRounding) return;
    const Vec2 center = bisector_center(from, end, scale() * move.center);
    const PlaneArc arc = arc_about(from, end, center, move.ccw);
    mover_.piece({true, from, end, center, arc.radius, arc.sweep}, 0, 0);
    return;
  }
  const bool rapid = move.kind == ProfileMove::Kind::rapid;
  modal_.motion = rapid ? Code::rapid : Code::line;
  const Code comp = modal_.comp;
  if (move.approach) modal_.comp = Code::comp_off;
  mover_.compensated(end, rapid ? MotionKind::rapid : MotionKind::line);
  modal_.comp = comp;
}

}  // namespace mrsim
