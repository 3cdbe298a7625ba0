// A vector of numbers that starts on a cache line, for loops over whole registers. resize() does
// not set the numbers that it adds: pages that nobody writes to cost nothing.
//
// One array, unlike a vector of aligned structs: a pointer to its first number reaches them all.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace mrsim {

template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t kAlignment{64};

  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}
  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(::operator new(count * sizeof(T), kAlignment));
  }
  template <class U>
  void construct(U* number) {
    ::new (static_cast<void*>(number)) U;  // as it lies, unlike U()
  }
  void deallocate(T* numbers, std::size_t) { ::operator delete(numbers, kAlignment); }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

template <class T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

}  // namespace mrsim
