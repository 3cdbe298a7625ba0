#include "removal/sweep/sweep_numbers.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"

#include <algorithm>

namespace mrsim {
namespace {

// Keeps the sweeps whose bounds meet the box, ascending. A pack and its mirror image hold the same
// sweeps.
void keep_bounded(const SweepColumns& c, const Box3& box, std::vector<std::uint32_t>& sweeps) {
  std::erase_if(sweeps, [&](std::uint32_t i) {
    const Box3 b = c.bounds_of(c.refs[i]);
    return is_empty({max(b.lo, box.lo), min(b.hi, box.hi)});
  });
  std::sort(sweeps.begin(), sweeps.end());
  sweeps.erase(std::unique(sweeps.begin(), sweeps.end()), sweeps.end());
}

// The sweeps of packs of the turn tree that a ball about the box meets.
void append_turned(const SweepColumns& c, std::span<const std::uint32_t> numbers, const Box3& box,
                   std::vector<std::uint32_t>& sweeps) {
  static thread_local TurnTree::Packs packs;
  static thread_local std::vector<TurnMember> members;
  packs.clear();
  members.clear();
  for (const std::uint32_t id : numbers)
    packs.push_back(id - static_cast<std::uint32_t>(c.refs.size()));
  const TurnRegion region = turn_region(box);
  c.turn_tree.members(region, {}, length(region.half) + kRounding, 0, packs, members);
  for (const TurnMember& member : members) sweeps.push_back(member.sweep);
}

// The plain sweeps of a list and those that `append` finds in its packs, if their bounds meet the
// box.
template <class Append>
std::vector<std::uint32_t> sweeps_about(const SweepColumns& c, std::span<const std::uint32_t> list,
                                        const Box3& box, const Append& append) {
  const auto numbers = c.numbers_of(list);
  const auto plain = c.sweeps_of(numbers);
  std::vector<std::uint32_t> sweeps(plain.begin(), plain.end());
  append(numbers.turned, sweeps);
  keep_bounded(c, box, sweeps);
  return sweeps;
}

}  // namespace

std::vector<std::uint32_t> all_numbers(const SweepColumns& c, double longest) {
  std::vector<std::uint32_t> list, packs;
  const auto append = [&](const auto& self, std::uint32_t number) -> void {
    if (number < kFirstPack)
      list.push_back(number);
    else if (c.packs[number].length <= longest)
      packs.push_back(number);
    else
      c.packs.for_each_child(number, [&](std::uint32_t child) { self(self, child); });
  };
  std::uint32_t next = 0;  // sweep that is not yet in the list
  const auto append_single = [&](std::uint32_t end) {
    for (; next < end; ++next)
      if (c.refs[next].kind != SweepKind::turn) list.push_back(next);
  };
  for (const std::uint32_t root : c.packs.roots()) {
    append_single(c.packs[root].first);
    append(append, root);
    next = c.packs[root].last + 1;
  }
  const auto sweeps = static_cast<std::uint32_t>(c.refs.size());
  append_single(sweeps);
  for (const std::uint32_t pack : c.turn_tree.roots()) list.push_back(sweeps + pack);
  std::sort(packs.begin(), packs.end());
  list.insert(list.end(), packs.begin(), packs.end());
  return list;
}

std::vector<std::uint32_t> sweeps_bounded(const SweepColumns& c,
                                          std::span<const std::uint32_t> list, const Box3& box) {
  return sweeps_about(c, list, box, [&](std::span<const std::uint32_t> turned, auto& sweeps) {
    for (const std::uint32_t id : turned)
      c.turn_tree.append_sweeps(id - static_cast<std::uint32_t>(c.refs.size()), sweeps);
  });
}

std::vector<std::uint32_t> sweeps_meeting(const SweepColumns& c,
                                          std::span<const std::uint32_t> list, const Box3& box) {
  return sweeps_about(c, list, box, [&](std::span<const std::uint32_t> turned, auto& sweeps) {
    append_turned(c, turned, box, sweeps);
  });
}

}  // namespace mrsim
