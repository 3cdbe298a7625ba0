#include "run/cuts/cut_kinds.h"

#include "core/numbers/motions.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/tool/tool.h"
#include "run/cuts/cut_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace mrsim {
namespace {

// Share of a pointed tool's radius below which its grooves are narrow.
constexpr double kNarrow = 0.5;
// Share of the cuts above which helices, or upright arcs, are many, and level or pointed ones are
// most.
constexpr double kManyOfCuts = 0.25, kMostOfCuts = 0.8, kHalfOfCuts = 0.5;

bool is_helix(const Motion& motion) { return motion.kind == MotionKind::arc && motion.rise != 0; }

bool is_upright_arc(const Motion& motion) {
  return motion.kind == MotionKind::arc && std::abs(dot(motion.axis, motion.tool_axis)) < 0.5;
}

bool is_flat(const ToolShape& shape) {
  return !shape.turning && shape.cutter.is_end_mill() && shape.cutter.round() == 0;
}

bool is_pointed(const ToolShape& shape) { return !shape.turning && !shape.cutter.is_end_mill(); }

class KindFinder {
 public:
  KindFinder(const CutList& cuts, double stock_top) : stock_top_(stock_top) {
    for (const Tool& tool : cuts.tools()) shapes_.push_back(make_tool_shape(tool));
    for (const Motion& motion : cuts.motions())
      if (is_cut(motion)) cuts_.push_back(&motion);
    find_lowest_tips();
  }

  CutKinds find() const {
    CutKinds kinds;
    kinds.radius = smallest_radius();
    kinds.depth = shallowest_mill();
    kinds.grooves = groove_lengths();
    kinds.are_level =
        has_share(kMostOfCuts, [&](const Motion& m) { return is_level(m) && is_by(m, is_flat); });
    kinds.are_pointed = has_share(
        kMostOfCuts, [&](const Motion& m) { return !is_upright_line(m) && is_by(m, is_pointed); });
    const auto rises = [](const Motion& m) { return !is_level(m) && !is_upright_line(m); };
    kinds.are_slanted =
        has_share(kMostOfCuts, rises) || has_share(kHalfOfCuts, [&](const Motion& m) {
          return rises(m) && m.kind == MotionKind::line;
        });
    kinds.search_arcs = std::ranges::any_of(cuts_, [&](const Motion* m) {
      return (is_helix(*m) || is_upright_arc(*m)) && is_by(*m, is_pointed);
    });
    kinds.have_many_helices = has_share(kManyOfCuts, is_helix);
    kinds.have_many_upright_arcs = has_share(kManyOfCuts, [&](const Motion& m) {
      return is_upright_arc(m) && is_by(m, [](const ToolShape& shape) {
               return !shape.turning && !(shape.cutter.is_end_mill() && shape.cutter.core() == 0);
             });
    });
    kinds.have_winding_helix =
        std::ranges::any_of(cuts_, [&](const Motion* m) { return leaves_crests(*m); });
    return kinds;
  }

 private:
  template <class Is>
  bool has_share(double share, const Is& is) const {
    const auto count = std::ranges::count_if(cuts_, [&](const Motion* m) { return is(*m); });
    return static_cast<double>(count) > share * static_cast<double>(cuts_.size());
  }

  template <class Is>
  bool is_by(const Motion& motion, const Is& is) const {
    return motion.tool >= 0 && is(shapes_[static_cast<std::size_t>(motion.tool)]);
  }

  // The lowest tip of each tool's cuts; infinite where it does not cut along its own axis Z.
  void find_lowest_tips() {
    lowest_.assign(shapes_.size(), std::numeric_limits<double>::infinity());
    for (const Motion* motion : cuts_) {
      if (motion->tool < 0) continue;
      double& z = lowest_[static_cast<std::size_t>(motion->tool)];
      const bool is_upright = motion->tool_axis == Vec3{0, 0, 1};
      z = is_upright ? std::min({z, motion->start.z, motion->end.z})
                     : -std::numeric_limits<double>::infinity();
    }
  }

  double shallowest_mill() const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < lowest_.size(); ++k)
      if (lowest_[k] < stock_top_ && !shapes_[k].turning)
        least = std::min(least, stock_top_ - lowest_[k]);
    return least;
  }

  // That of the cutter at the stock's top, since a V-bit of 6 mm leaves grooves of 0.1 mm when it
  // engraves.
  double smallest_radius() const {
    double least = 0;
    for (std::size_t k = 0; k < lowest_.size(); ++k) {
      if (!(lowest_[k] < stock_top_)) continue;
      const ToolShape& shape = shapes_[k];
      const double radius =
          shape.turning
              ? shape.radius
              : std::min(shape.radius, shape.cutter.max_radius_below(stock_top_ - lowest_[k]));
      if (radius > 0 && (least == 0 || radius < least)) least = radius;
    }
    return least;
  }

  // With the width at the stock's top. Three creases run along each groove, within that width.
  double groove_lengths() const {
    double sum = 0;
    for (const Motion* motion : cuts_) {
      if (!is_by(*motion, is_pointed) || !(motion->tool_axis == Vec3{0, 0, 1})) continue;
      const ToolShape& shape = shapes_[static_cast<std::size_t>(motion->tool)];
      const double depth = stock_top_ - std::min(motion->start.z, motion->end.z);
      if (!(depth > 0)) continue;
      const double radius = shape.cutter.max_radius_below(depth);
      if (radius > 0 && radius < kNarrow * shape.radius) sum += length_of(*motion) / (2 * radius);
    }
    return sum;
  }

  // Between the turns of a helix: it counts as one sweep where sweeps are counted.
  bool leaves_crests(const Motion& motion) const {
    return is_helix(motion) && std::abs(motion.sweep) > 1.5 * kTwoPi &&
           is_by(motion, [](const ToolShape& shape) {
             return is_pointed(shape) || !shape.cutter.is_rising() || shape.cutter.round() > 0;
           });
  }

  double stock_top_;
  std::vector<ToolShape> shapes_;    ///< of the list's tools
  std::vector<const Motion*> cuts_;  ///< of the list
  std::vector<double> lowest_;       ///< by tool
};

}  // namespace

CutKinds kinds_of(const CutList& cuts, double stock_top) {
  return KindFinder(cuts, stock_top).find();
}

bool is_thread_pass(const Motion& motion, std::span<const Tool> tools) {
  return motion.lead != 0 && is_cut(motion) && motion.tool >= 0 &&
         is_turning(tools[static_cast<std::size_t>(motion.tool)].type);
}

}  // namespace mrsim
