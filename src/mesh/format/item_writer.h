// Many short records into a ByteSink, in their order, made by all cores.
#pragma once

#include "core/process/parallel.h"
#include "core/text/text_io.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace mrsim::detail {

/// Hands body(text, i), which appends record i to `text`, to `out` for every i in [0, count), in
/// order. Memory: some MB.
template <class Body>
void write_items(std::size_t count, int threads, const ByteSink& out, const Body& body) {
  constexpr std::size_t kChunk = 4096;
  const std::size_t round = 4 * static_cast<std::size_t>(resolve_threads(threads));
  std::vector<std::string> texts(std::min(round, count / kChunk + 1)), made(texts.size());
  std::size_t waiting = 0;  // chunks in `made`, which go out while the next ones are made
  const auto hand_on = [&] {
    for (std::size_t p = 0; p < waiting; ++p) out(made[p].data(), made[p].size());
  };
  for (std::size_t first = 0; first < count; first += round * kChunk) {
    const std::size_t chunks = std::min(round, (count - first + kChunk - 1) / kChunk);
    parallel_for(chunks + 1, threads, [&](std::size_t p) {
      if (p == 0) return hand_on();
      std::string& text = texts[p - 1];
      text.clear();
      const std::size_t begin = first + (p - 1) * kChunk, end = std::min(count, begin + kChunk);
      for (std::size_t i = begin; i < end; ++i) body(text, i);
    });
    std::swap(texts, made);
    waiting = chunks;
  }
  hand_on();
}

inline void write_text(const std::string& text, const ByteSink& out) {
  out(text.data(), text.size());
}

}  // namespace mrsim::detail
