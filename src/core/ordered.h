// Work in parts that are made side by side and taken in their order.
#pragma once

#include "core/parallel.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

namespace mrsim {

/// Calls take(make(k)) for k = 0, 1, ... count - 1, one after another, while the next parts are
/// made; at most two parts a thread are there at once. Throws what the first part at fault throws.
template <typename Make, typename Take>
void make_in_order(std::size_t count, int threads, Make make, Take take) {
  struct Part {
    std::optional<decltype(make(std::size_t{}))> made;
    std::exception_ptr error;
  };
  const auto together = static_cast<std::size_t>(resolve_threads(threads));
  std::vector<Part> parts, before;
  const auto take_before = [&] {
    for (Part& part : before) {
      if (part.error) std::rethrow_exception(part.error);
      take(std::move(*part.made));
      part.made.reset();
    }
  };
  for (std::size_t first = 0; first < count; first += together) {
    parts.clear();
    parts.resize(std::min(together, count - first));
    parallel_for(parts.size() + 1, threads, [&](std::size_t k) {
      if (k == 0) return take_before();
      try {
        parts[k - 1].made.emplace(make(first + k - 1));
      } catch (...) {
        parts[k - 1].error = std::current_exception();
      }
    });
    std::swap(parts, before);
  }
  take_before();
}

}  // namespace mrsim
