#include "removal/collision/collision_movers.h"

#include "core/numbers/motions.h"
#include "core/numbers/vec.h"
#include "core/process/memory_limit.h"
#include "core/process/parallel.h"
#include "removal/collision/recent_places.h"
#include "removal/part/memory_plan.h"
#include "removal/tool/tool.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Bytes for each motion that may collide, without its sweeps: the motion and the results about it.
constexpr double kChosen = sizeof(Motion) + 300;

// How many motions back a retract looks for the cut it follows.
constexpr std::size_t kRecent = 16;

// How far a part of a tool reaches from the programmed point: across its axis, and along it.
struct Reach {
  double radius = 0, low = 0, high = 0;
};

Reach reach_of(const std::vector<Profile>& pieces) {
  Reach r;
  r.low = pieces.front().bottom();
  for (const Profile& piece : pieces) {
    r.radius = std::max(r.radius, piece.max_radius());
    r.high = piece.top();
  }
  return r;
}

Reach reach_of(const InsertOutline& insert) {
  Reach r;
  for (const Vec2 corner : insert.core) r.radius = std::max(r.radius, length(corner));
  r.radius += insert.round;
  return r;
}

// A box round all positions of the programmed point; generous for arcs.
Box3 path_box(const Motion& m) {
  Box3 b;
  extend(b, m.start);
  extend(b, m.end);
  if (m.kind != MotionKind::arc) return b;
  const Vec3 r{m.radius, m.radius, m.radius};
  for (const Vec3& center : {m.center, m.center + m.rise * m.axis}) {
    extend(b, center - r);
    extend(b, center + r);
  }
  return b;
}

// The box of a turning tool, seen from the bar that turns: all places round the axis.
Box3 turned(Box3 b) {
  const double r = std::max(std::fabs(b.lo.x), std::fabs(b.hi.x));
  b.lo.x = b.lo.y = -r;
  b.hi.x = b.hi.y = r;
  return b;
}

Box3 mover_box(const Motion& m, const Reach& reach, bool turning) {
  const Box3 path = path_box(m);
  if (turning) return turned(inflated(path, reach.radius));
  Box3 b = inflated(path, reach.radius);
  if (m.tool_axis == Vec3{0, 0, 1}) {
    b.lo.z = path.lo.z + reach.low;
    b.hi.z = path.hi.z + reach.high;
    return b;
  }
  return inflated(b, std::max(std::fabs(reach.low), std::fabs(reach.high)));
}

bool meets(const Box3& a, const Box3& b) {
  return a.lo.x < b.hi.x && b.lo.x < a.hi.x && a.lo.y < b.hi.y && b.lo.y < a.hi.y &&
         a.lo.z < b.hi.z && b.lo.z < a.hi.z;
}

bool has_part(const Tool& tool, ToolPart part) {
  if (part == ToolPart::cutter) return true;
  return part == ToolPart::shank ? !tool.shank.empty() : !tool.holder.empty();
}

class Selection {
 public:
  Selection(ToolPart part, std::span<const Motion> motions, std::span<const Tool> tools,
            const Box3& stock)
      : part_(part), motions_(motions), tools_(tools), stock_(stock), known_(tools.size()) {}

  bool may_collide(std::size_t at);
  /// Whether a rapid stays within what the motions just before it have cleared. Requires:
  /// may_collide(at). Any number of threads may call it at once.
  bool keeps_to_recent_places(std::size_t at, double touch) const;
  const std::vector<int>& shapeless() const { return shapeless_; }

 private:
  struct Known {
    bool asked = false;
    std::optional<Reach> reach;  // nothing: the tool has no such part
    ToolShape shape;
    bool widens = false;  // nowhere narrower further up, but for its end
  };
  const Known& known(int tool);
  bool follows_cut(std::size_t at, const Known& tool) const;
  bool stays_in(const Motion& cut, const Motion& rapid, const Known& tool) const;

  ToolPart part_;
  std::span<const Motion> motions_;
  std::span<const Tool> tools_;
  Box3 stock_;
  std::vector<Known> known_;
  std::vector<int> shapeless_;
};

const Selection::Known& Selection::known(int tool) {
  Known& k = known_[static_cast<std::size_t>(tool)];
  if (k.asked) return k;
  k.asked = true;
  const Tool& data = tools_[static_cast<std::size_t>(tool)];
  if (!has_part(data, part_)) return k;
  try {
    k.shape = make_tool_shape(data);
  } catch (const Error&) {  // a tool that cuts has been refused before
    shapeless_.push_back(tool);
    return k;
  }
  if (part_ == ToolPart::cutter)
    k.reach = k.shape.turning ? reach_of(k.shape.insert) : reach_of({k.shape.cutter});
  k.widens = !k.shape.turning && k.shape.cutter.extended_up().is_rising();
  const std::vector<Profile>& pieces = part_ == ToolPart::shank ? k.shape.shank : k.shape.holder;
  if (part_ != ToolPart::cutter && !pieces.empty()) k.reach = reach_of(pieces);
  return k;
}

bool Selection::may_collide(std::size_t at) {
  const Motion& m = motions_[at];
  const bool rapid = m.kind == MotionKind::rapid;
  if (m.assumed_start || !moves(m) || m.tool < 0 || (part_ == ToolPart::cutter && !rapid))
    return false;
  const Known& k = known(m.tool);
  if (!k.reach || !meets(mover_box(m, *k.reach, k.shape.turning), stock_)) return false;
  // A lathe moves its inserts in the plane of X and Z only.
  if (k.shape.turning && (m.start.y != 0 || m.end.y != 0)) return false;
  // The way out of a thread: threads are not cut here, so the part does not have its groove.
  if (k.shape.turning && at > 0 && motions_[at - 1].lead != 0) return false;
  return part_ != ToolPart::cutter || !follows_cut(at, k);
}

bool Selection::keeps_to_recent_places(std::size_t at, double touch) const {
  const Known& k = known_[static_cast<std::size_t>(motions_[at].tool)];
  return k.widens &&
         mrsim::keeps_to_recent_places(motions_, at, k.shape.cutter, stock_.hi.z, touch);
}

bool Selection::follows_cut(std::size_t at, const Known& tool) const {
  const Motion& rapid = motions_[at];
  for (std::size_t back = 1; back <= std::min(kRecent, at); ++back) {
    const Motion& m = motions_[at - back];
    if (m.tool != rapid.tool || !(m.tool_axis == rapid.tool_axis)) return false;
    if (is_cut(m) && moves(m) && stays_in(m, rapid, tool)) return true;
  }
  return false;
}

// Whether start and end of the rapid lie on the cut's line, or above it where the tool clears all
// above it. Then so does all between them: a segment, and a strip above one, are convex. Of an arc
// its end counts.
bool Selection::stays_in(const Motion& cut, const Motion& rapid, const Known& tool) const {
  const Profile& cutter = tool.shape.cutter;
  const Vec3 from = cut.kind == MotionKind::arc ? cut.end : cut.start, travel = cut.end - from;
  const bool clears_above =
      tool.widens &&
      (cutter.open_top() ||
       (rapid.tool_axis.z == 1 && std::min(from.z, cut.end.z) + cutter.top() >= stock_.hi.z));
  const Vec3 up = rapid.tool_axis;
  const auto above = [&](const Vec3& p, double t) {
    const Vec3 w = p - (from + t * travel);
    const double height = clears_above ? std::max(0.0, dot(w, up)) : 0;
    return length(w - height * up) <= kSameTip;
  };
  const auto lies_in = [&](const Vec3& p) {
    const Vec3 across = clears_above ? travel - dot(travel, up) * up : travel;
    const double size = dot(across, across);
    const double t = size > 0 ? std::clamp(dot(p - from, across) / size, 0.0, 1.0) : 0;
    return above(p, t) || above(p, 0) || above(p, 1);
  };
  return lies_in(rapid.start) && lies_in(rapid.end);
}

void drop_if_kept(const Selection& selection, double touch, int threads,
                  std::vector<std::int32_t>& rapids) {
  std::vector<char> keeps(rapids.size());
  parallel_for(
      rapids.size(), threads,
      [&](std::size_t i) {
        keeps[i] = selection.keeps_to_recent_places(static_cast<std::size_t>(rapids[i]), touch);
      },
      64);
  std::size_t left = 0;
  for (std::size_t i = 0; i < rapids.size(); ++i)
    if (keeps[i] == 0) rapids[left++] = rapids[i];
  rapids.resize(left);
}

}  // namespace

Movers find_movers(ToolPart part, std::span<const Motion> motions, std::span<const Tool> tools,
                   std::size_t first, const Box3& stock, double touch, int threads,
                   std::vector<int>& shapeless) {
  Selection selection(part, motions, tools, stock);
  std::vector<std::int32_t> index;
  if (std::none_of(tools.begin(), tools.end(), [&](const Tool& t) { return has_part(t, part); }))
    first = motions.size();
  for (std::size_t i = first; i < motions.size(); ++i)
    if (selection.may_collide(i)) index.push_back(static_cast<std::int32_t>(i));
  if (part == ToolPart::cutter) drop_if_kept(selection, touch, threads, index);
  require_memory(kChosen * static_cast<double>(index.size()),
                 fmt::format("the search for collisions of {} motions", index.size()));
  std::vector<Motion> chosen;
  chosen.reserve(index.size());
  for (const std::int32_t i : index) chosen.push_back(motions[static_cast<std::size_t>(i)]);
  for (const int tool : selection.shapeless())
    if (std::find(shapeless.begin(), shapeless.end(), tool) == shapeless.end())
      shapeless.push_back(tool);
  const auto selected = part == ToolPart::cutter  ? SweepSelection::Part::cutter
                        : part == ToolPart::shank ? SweepSelection::Part::shank
                                                  : SweepSelection::Part::holder;
  const SweepSelection of_part{selected, part != ToolPart::cutter, /*rapids=*/true};
  require_table(chosen, tools, of_part);
  Movers movers{SweepTable(chosen, tools, of_part), {}};
  for (std::size_t i = 0; i < movers.sweeps.size(); ++i)
    movers.motions.push_back(index[static_cast<std::size_t>(movers.sweeps.motion(i))]);
  return movers;
}

}  // namespace mrsim
