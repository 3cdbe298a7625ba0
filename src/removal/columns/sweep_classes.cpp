// Which sweeps may be compared: classes of one form and one tool, and the heights of tips.
#include "removal/columns/sweep_classes.h"

#include "core/process/heap.h"
#include "core/process/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace mrsim {
namespace {

float rounded_down(double x) {
  return std::max(0.0f, std::nextafter(static_cast<float>(x), -1.0f));
}

ToolColumns tool_columns(const Profile& tool) {
  ToolColumns t;
  t.core = static_cast<float>(tool.core()), t.round = static_cast<float>(tool.round());
  t.height = static_cast<float>(tool.top());
  t.flat = tool.is_end_mill() ? rounded_down(tool.core()) : 0;
  t.rising = tool.is_rising();
  return t;
}

bool is_strip(const SweepRef& ref) {
  return ref.kind == SweepKind::ball_line || ref.kind == SweepKind::ball_arc;
}

// Two groups a tool: strips and plans are never compared.
std::int32_t group_of(const SweepRef& ref) {
  if (ref.frame != 0 || ref.kind == SweepKind::path || ref.kind == SweepKind::turn)
    return SweepClass{}.group;
  return 2 * ref.shape + (is_strip(ref) ? 1 : 0);
}

SweepClass class_of_sweep(const SweepColumns& c, const SweepRef& ref, SweepClass::Form form) {
  SweepClass k;
  k.form = form;
  if (ref.frame == 0 && ref.kind != SweepKind::turn && has_heights(c.cutter(ref)))
    k.heights = height_tool(c.cutter(ref));
  if (group_of(ref) == k.group) return k;
  k.kind = is_strip(ref) ? SweepClass::Kind::solid : SweepClass::Kind::plan;
  k.group = group_of(ref);
  k.tool = tool_columns(c.cutter(ref));
  return k;
}

// A number that two plan sweeps of one tool share exactly when their tips are equally high.
double tip_height(const SweepColumns& c, const SweepRef& ref) {
  if (ref.kind == SweepKind::plane_line) return c.plane_lines[ref.row].c[LineSlot::low];
  if (ref.kind == SweepKind::plane_arc) return c.plane_arcs[ref.row].c[ArcSlot::low];
  return c.profiles[ref.row].z;
}

bool is_plan(const SweepRef& ref) {
  return ref.frame == 0 && (ref.kind == SweepKind::plane_line || ref.kind == SweepKind::plane_arc ||
                            ref.kind == SweepKind::profile);
}

// Packs are classed by powers of four of their spread, and those of sweeps from those of packs:
// each class counts with its largest.
int pack_grade(const SweepPack& pack) {
  int grade = 0;
  for (double limit = 1; limit >= pack.spread && grade > -16; limit /= 4) --grade;
  return 2 * (grade + 16) + (pack.count > 0 ? 1 : 0);
}

class HeightNumbers {
 public:
  std::uint32_t of(double height) {
    if (!numbers_.empty() && height == last_) return number_;
    last_ = height;
    const auto next = static_cast<std::uint32_t>(numbers_.size());
    return number_ = numbers_.try_emplace(height, next).first->second;
  }

 private:
  std::unordered_map<double, std::uint32_t> numbers_;
  double last_ = 0;
  std::uint32_t number_ = 0;
};

// All sweeps are of one class, which has no height numbers.
bool are_alike(const SweepColumns& c, int threads) {
  const std::vector<SweepRef>& refs = c.refs;
  if (refs.empty() || is_plan(refs[0])) return false;
  const auto key = [&](std::size_t i) {
    return std::tuple(group_of(refs[i]), c.form_of(i), refs[i].shape);
  };
  std::atomic<bool> alike = true;
  parallel_for((refs.size() + kSweepsOfThread - 1) / kSweepsOfThread, threads,
               [&](std::size_t part) {
                 for (std::size_t i = part * kSweepsOfThread;
                      i < std::min((part + 1) * kSweepsOfThread, refs.size()); ++i)
                   if (is_plan(refs[i]) || key(i) != key(0)) return alike.store(false);
               });
  return alike;
}

// The classes of the columns, as they are met; numbered at the end.
class ClassList {
 public:
  explicit ClassList(SweepColumns& columns) : columns_(columns) {}

  void add_sweeps(int threads);
  void add_packs();
  void number_by_keys();

 private:
  // Group, form, shape; grade of a pack, -1 for sweeps.
  using Key = std::tuple<std::int32_t, SweepClass::Form, std::int32_t, int>;
  std::uint32_t number_of(const Key& key, const SweepClass& k) {
    const auto [at, added] = seen_.try_emplace(key, static_cast<std::uint32_t>(found_.size()));
    if (added) found_.push_back(k);
    return at->second;
  }

  SweepColumns& columns_;
  std::map<Key, std::uint32_t> seen_;
  std::vector<SweepClass> found_;
  std::size_t sweep_classes_ = 0;
};

// Where all sweeps are alike, the first tells the class of all.
void ClassList::add_sweeps(int threads) {
  SweepColumns& c = columns_;
  HeightNumbers numbers;
  Key last{-2, {}, 0, 0};
  std::uint32_t last_class = 0;
  c.class_of.resize(are_alike(c, threads) ? 1 : c.refs.size());
  for (std::size_t i = 0; i < c.class_of.size(); ++i) {
    const SweepRef& ref = c.refs[i];
    const SweepClass::Form form = c.form_of(i);
    const Key key{group_of(ref), form, ref.shape, -1};
    if (key != last) last = key, last_class = number_of(key, class_of_sweep(c, ref, form));
    c.class_of[i] = last_class;
    if (!is_plan(ref)) continue;
    if (c.height_numbers.empty()) c.height_numbers.resize(c.refs.size());
    c.height_numbers[i] = numbers.of(tip_height(c, ref));
  }
  sweep_classes_ = found_.size();
}

void ClassList::add_packs() {
  SweepColumns& c = columns_;
  for (SweepPack& pack : c.packs.all()) {
    SweepClass k = found_[c.class_of[c.class_of.size() == 1 ? 0 : pack.first]];
    const SweepClass::Form form = c.form_of(pack.first);
    k.packs = true;
    pack.class_index = number_of({k.group, form, c.refs[pack.first].shape, pack_grade(pack)}, k);
    SweepClass& of = found_[pack.class_index];
    of.spread = std::max<double>(of.spread, pack.spread);
    of.expand_below = std::max<double>(of.expand_below, pack.expand_below);
  }
}

// In the order of the keys the classes of a group follow one another.
void ClassList::number_by_keys() {
  SweepColumns& c = columns_;
  std::vector<std::uint32_t> new_index(found_.size());
  for (const auto& [key, old] : seen_) {
    new_index[old] = static_cast<std::uint32_t>(c.classes.size());
    c.classes.push_back(found_[old]);
  }
  if (sweep_classes_ <= 1) c.class_of = {};  // the key of the only class is the least
  for (std::uint32_t& of : c.class_of) of = new_index[of];
  for (SweepPack& pack : c.packs.all()) pack.class_index = new_index[pack.class_index];
}

}  // namespace

void cut_segments(SweepColumns& c) {
  constexpr std::size_t kSweepsTogether = 1024;  // sweeps
  std::vector<LineRecord> some;
  for (std::size_t i = 0; i < c.refs.size(); ++i) {
    const SweepRef& ref = c.refs[i];
    const bool path = ref.kind == SweepKind::path, profile = ref.kind == SweepKind::profile;
    if (!c.first_segment.empty())
      c.first_segment[i] = static_cast<std::uint32_t>(c.segments.size() + some.size());
    if (ref.frame == 0 && (path || profile) && has_heights(c.cutter(ref))) {
      const bool cut = path ? append_segments(*c.paths[ref.row], some)
                            : append_segments(c.profiles[ref.row], some);
      if (cut && c.first_segment.empty()) c.first_segment.resize(c.refs.size() + 1);
    }
    if ((i + 1) % kSweepsTogether != 0 && i + 1 != c.refs.size()) continue;
    reserve_ahead(c.segments, some.size(), i + 1, c.refs.size());
    c.segments.insert(c.segments.end(), some.begin(), some.end());
    some.clear();
  }
  if (!c.first_segment.empty())
    c.first_segment.back() = static_cast<std::uint32_t>(c.segments.size());
}

void classify(SweepColumns& c, int threads) {
  ClassList classes(c);
  classes.add_sweeps(threads);
  classes.add_packs();
  classes.number_by_keys();
  SweepClass turn;
  turn.form = SweepClass::Form::turn;
  if (!c.turns.empty()) c.classes.push_back(turn);
}

}  // namespace mrsim
