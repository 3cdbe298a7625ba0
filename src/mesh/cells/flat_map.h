// A map from 64-bit keys to indices, open addressing, for the mesher's lattice: no iteration, so no
// order to depend on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace mrsim::detail {

class FlatMap {
 public:
  explicit FlatMap(std::size_t expected = 0) { rehash(expected); }

  /// The value of the key, inserted as `fresh` where it is new (then second is true). Requires: key
  /// is not ~0.
  std::pair<std::int32_t, bool> insert(std::uint64_t key, std::int32_t fresh) {
    if (2 * (count_ + 1) > slots_.size()) rehash(2 * count_ + 2);
    Slot& s = slots_[slot_of(key)];
    if (s.key == key) return {s.value, false};
    s = {key, fresh};
    ++count_;
    return {fresh, true};
  }

  /// The value of the key, -1 where it is unknown.
  std::int32_t find(std::uint64_t key) const {
    const Slot& s = slots_[slot_of(key)];
    return s.key == key ? s.value : -1;
  }

 private:
  static constexpr std::uint64_t kEmpty = ~std::uint64_t(0);
  struct Slot {
    std::uint64_t key = kEmpty;
    std::int32_t value = -1;
  };

  std::size_t slot_of(std::uint64_t key) const {
    std::uint64_t h = (key ^ key >> 31) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
    std::size_t i = h & (slots_.size() - 1);
    while (slots_[i].key != key && slots_[i].key != kEmpty) i = (i + 1) & (slots_.size() - 1);
    return i;
  }

  void rehash(std::size_t expected) {
    std::size_t size = 64;
    while (size < 2 * expected) size *= 2;
    std::vector<Slot> old(size);
    old.swap(slots_);
    for (const Slot& s : old)
      if (s.key != kEmpty) slots_[slot_of(s.key)] = s;
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace mrsim::detail
