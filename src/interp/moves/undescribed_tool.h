// What the motions of a lathe's tool say of one that no data describe. Private to src/interp.
#pragma once

#include <mrsim/types.h>

#include <string_view>

namespace mrsim {

/// The insert for the outside that such tools are taken to have does not do what drills, bars that
/// bore and blades do.
class UndescribedTool {
 public:
  struct Kind {
    std::string_view does;     ///< "plunges and goes back, as a blade does"; empty: nothing
    std::string_view option;   ///< what --tool 3= may have
    std::string_view comment;  ///< what a comment may say of it
  };

  /// The next motion, in the order of the program; `face`: Z of the program's zero.
  Kind told_by(const Motion& motion, double face);

 private:
  bool drills(const Motion& motion, bool feeds);
  bool bores(const Motion& motion, bool feeds);
  bool plunges(const Motion& motion, bool feeds, double face);

  static constexpr double kNothingCut = 1e99;
  bool drilled_ = false;                      ///< the last motion fed along the axis
  double inmost_cut_ = kNothingCut;           ///< how near to the axis the last feeds along -Z were
  bool rapid_ = false;                        ///< the last motion was one
  bool plunging_ = false;                     ///< fed along X from where a rapid has led
  double plunged_from_ = 0, plunged_to_ = 0;  ///< X
};

}  // namespace mrsim
