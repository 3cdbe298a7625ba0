// Many short records into a ByteSink, in their order, made by all cores.
#pragma once

#include "core/parallel.h"
#include "core/text_io.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace mrsim::detail {

/// Hands body(text, i), which appends record i to `text`, to `out` for every i in [0, count), in
/// order. Memory: some MB.
template <class Body>
void write_items(std::size_t count, int threads, const ByteSink& out, const Body& body) {
  constexpr std::size_t kPiece = 4096;
  const std::size_t round = 2 * static_cast<std::size_t>(resolve_threads(threads));
  std::vector<std::string> texts(round);
  for (std::size_t first = 0; first < count; first += round * kPiece) {
    const std::size_t pieces = std::min(round, (count - first + kPiece - 1) / kPiece);
    parallel_for(pieces, threads, [&](std::size_t p) {
      texts[p].clear();
      const std::size_t begin = first + p * kPiece, end = std::min(count, begin + kPiece);
      for (std::size_t i = begin; i < end; ++i) body(texts[p], i);
    });
    for (std::size_t p = 0; p < pieces; ++p) out(texts[p].data(), texts[p].size());
  }
}

inline void write_text(const std::string& text, const ByteSink& out) {
  out(text.data(), text.size());
}

}  // namespace mrsim::detail
