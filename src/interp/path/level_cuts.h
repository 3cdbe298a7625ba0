// The passes of LinuxCNC's G71 and G72 over a contour that runs towards -x of its plane, with the
// material below it: down to a level, along it to the contour, away, back; then along the contour
// to the next pocket. Private to turn_profile.cpp.
#pragma once

#include "interp/path/turn_profile.h"

namespace mrsim {

inline constexpr double kSameTurnPlace = 1e-6;  ///< in the program's unit

class LevelCuts {
 public:
  /// `pieces` begin with the way to the contour.
  LevelCuts(const std::vector<ProfilePiece>& pieces, const Roughing& how,
            std::vector<ProfileMove>& out)
      : pieces_(pieces), how_(how), out_(out), at_(pieces.front().start) {}

  /// Appends all passes to the moves. An empty fault: done.
  ProfileFault run();

 private:
  enum class Cut { done, next_piece, none };

  bool falls(std::size_t i, double level);
  bool arc_falls(std::size_t i, double level);
  bool rises(std::size_t i);
  void rise_only(std::size_t i);
  void arc_up(const ProfilePiece& piece);
  Cut cut(std::size_t& i);
  void cut_to(std::size_t i, double end);
  bool to_next_pocket(std::size_t& i);
  void fail(std::size_t i, std::string text);

  void line(Vec2 to, bool rapid = false);
  void arc(const ProfilePiece& piece, Vec2 to);

  const std::vector<ProfilePiece>& pieces_;
  const Roughing& how_;
  std::vector<ProfileMove>& out_;
  Vec2 at_;
  std::vector<Vec2>
      tops_;  ///< heights from which levels count: the start, then the rims of pockets
  std::size_t looks_ = 0;
  ProfileFault fault_;
};

}  // namespace mrsim
