// What motions of a lathe's tool show of its kind, where no data describe it. Private to
// src/interp.
#pragma once

#include <mrsim/types.h>

#include <string_view>

namespace mrsim {

/// A tool without data, or with only an insert, is taken to turn the outside. Its motions show
/// where that cannot be: it drills, bores, or plunges as a blade does.
class UndescribedTool {
 public:
  struct Kind {
    std::string_view does;     ///< "plunges and goes back, as a blade does"; empty: nothing
    std::string_view option;   ///< an example of what to write behind --tool 3=
    std::string_view comment;  ///< an example of what to write in a comment
    bool bores = false;
  };

  /// The next motion, in the order of the program; `face`: Z of the program's zero; `faces`: it is
  /// one of a cycle that cuts a face, whose passes are no plunges of a blade.
  Kind told_by(const Motion& motion, double face, bool faces);

 private:
  bool drills(const Motion& motion, bool feeds);
  bool bores(const Motion& motion, bool feeds, double face);
  bool plunges(const Motion& motion, bool feeds, double face);
  bool faces_on(double z, double face);

  static constexpr double kNothingCut = 1e99;
  bool drilled_ = false;                      ///< the last motion fed along the axis
  double inmost_cut_ = kNothingCut;           ///< how near to the axis the last feeds along -Z were
  double cut_along_ = 0;                      ///< how far along -Z since then
  bool rapid_ = false;                        ///< the last motion was a rapid
  bool plunging_ = false;                     ///< feeds along X from where a rapid has led
  double plunged_from_ = 0, plunged_to_ = 0;  ///< X
  int tool_ = -1;                             ///< of the last motion
  bool faced_ = false;                        ///< that tool has cut the face
  double faced_z_ = 0, faced_to_ = 0;         ///< Z of its last pass there, and X at its end
};

}  // namespace mrsim
