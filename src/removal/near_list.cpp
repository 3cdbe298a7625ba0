// Lists of sweeps, made for a block.
#include "removal/near_list.h"

#include "removal/sweep_columns.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

// Writes the columns of one run; keeps track of the largest value.
class RunWriter {
 public:
  RunWriter(NearList& list, const std::vector<std::uint32_t>& levels)
      : list_(list), levels_(levels) {}

  void strip(std::size_t slot, const double* c) {
    const Vec3 o = list_.origin;
    const double x = c[0] - o.x, y = c[1] - o.y, z = c[2] - o.z, s = c[6];
    put(slot, {x, y, z, c[3], c[4], c[5], s, 1 / (1 + s * s)});
    widen(x, y, z);
    widen(x + c[3] * c[5], y + c[4] * c[5], z + s * c[5]);
  }
  void line(std::size_t slot, const double* c, std::uint32_t id) {
    const Vec3 o = list_.origin;
    const double x = c[0] - o.x, y = c[1] - o.y, z = c[4] - c[6] - o.z;
    put(slot, {x, y, c[2], c[3], 1 / std::max(c[2] * c[2] + c[3] * c[3], 1e-30), z, level_of(id)});
    widen(x, y, z);
    widen(x + c[2], y + c[3], z);
  }
  void arc(std::size_t slot, const double* c, std::uint32_t id) {
    const Vec3 o = list_.origin;
    const double x = c[0] - o.x, y = c[1] - o.y, z = c[7] - c[9] - o.z;
    put(slot, {x, y, c[2], c[3], c[4], c[5], c[6], z, level_of(id)});
    widen(std::fabs(x) + c[2], std::fabs(y) + c[2], z);
  }
  void id(std::size_t slot, std::uint32_t id) {
    list_.column(kIdColumn)[slot] = std::bit_cast<float>(id);
  }
  double extent() const { return extent_; }
  double level_of(std::uint32_t id) const { return sweep_level(levels_[id]); }

 private:
  void put(std::size_t slot, std::initializer_list<double> values) {
    std::size_t i = 0;
    for (const double v : values) list_.column(i++)[slot] = static_cast<float>(v);
  }
  void widen(double x, double y, double z) {
    extent_ = std::max({extent_, std::fabs(x), std::fabs(y), std::fabs(z)});
  }

  NearList& list_;
  const std::vector<std::uint32_t>& levels_;
  double extent_ = 0;
};
}  // namespace

void NearList::reset(std::size_t slots, const Vec3& about) {
  const std::size_t lines = (slots + kPad - 1) / kPad + 1;
  runs_.clear();
  size_ = 0;
  origin = about;
  extent = 0;
  closed = true;
  if (lines * kPad <= stride_) return;
  stride_ = lines * kPad;
  lines_.resize(lines * kNearColumns);
}

std::size_t NearList::open_run(std::uint32_t of) {
  const std::size_t end = runs_.empty() ? 0 : runs_.back().first + runs_.back().count;
  runs_.push_back({of, (end + kPad - 1) / kPad * kPad, 0});
  return runs_.back().first;
}

void NearList::close_run(std::size_t count) {
  if (count == 0) return runs_.pop_back();
  runs_.back().count = count;
  size_ += count;
}

// Classes in the order of their groups, so that runs that may be compared follow one another.
void SweepTable::list(std::span<const std::uint32_t> ids, const Vec3& origin, NearList& out) const {
  const Columns& c = *columns_;
  static thread_local std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted;
  const auto packs = ids.subspan(c.sweeps_of(ids).size());
  ids = c.sweeps_of(ids);
  const bool one = c.class_of.empty();
  std::size_t runs = 2;
  if (!one) {
    sorted.clear();
    for (const std::uint32_t id : ids) sorted.emplace_back(c.class_of[id], id);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 1; k < sorted.size(); ++k) runs += sorted[k].first != sorted[k - 1].first;
  }
  out.reset(NearList::room(ids.size() + packs.size(), runs), origin);
  RunWriter writer(out, c.levels);
  double tools = 0;
  for (std::size_t k = 0; k < ids.size();) {
    const std::uint32_t of = one ? 0 : sorted[k].first;
    const SweepClass& type = c.classes[of];
    const std::size_t first = out.open_run(of);
    std::size_t slot = first;
    for (; k < ids.size() && (one || sorted[k].first == of); ++k, ++slot) {
      const std::uint32_t id = one ? ids[k] : sorted[k].second;
      const std::uint32_t row = c.tags[id] & kTagRow;
      if (type.form == SweepClass::Form::strip) writer.strip(slot, c.ball_lines[row].c);
      if (type.form == SweepClass::Form::line) writer.line(slot, c.plane_lines[row].c, id);
      if (type.form == SweepClass::Form::arc) writer.arc(slot, c.plane_arcs[row].c, id);
      writer.id(slot, id);
    }
    out.close_run(slot - first);
    out.closed = out.closed && type.form != SweepClass::Form::other;
    const ToolColumns& t = type.tool;
    tools =
        std::max<double>(tools, std::max(t.core + t.round, std::isinf(t.height) ? 0 : t.height));
  }
  out.extent = std::max(writer.extent(), tools);
  if (packs.empty()) return;
  out.closed = false;  // a pack costs several sweeps
  const std::size_t first = out.open_run(static_cast<std::uint32_t>(c.classes.size() - 1));
  for (std::size_t k = 0; k < packs.size(); ++k) writer.id(first + k, packs[k]);
  out.close_run(packs.size());
}
}  // namespace mrsim
