// The only wrapper round TBB outside of OpenVDB's own tools. Work is given by index, so results
// written by index are the same for any number of threads.
#pragma once

#include <cstddef>
#include <functional>

namespace mrsim {

/// Runs `body(i)` for every i in [0, count), each exactly once, on at most `threads` threads (0 =
/// all cores, 1 = the caller's). The first exception stops the loop and is rethrown. `grain`
/// indices are taken together.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body,
                  std::size_t grain = 1);

/// parallel_for() for bodies that keep something from one index to the next: `body(begin, end)` for
/// chunks of `chunk` indices, the last one shorter.
void parallel_for_chunks(std::size_t count, int threads, std::size_t chunk,
                         const std::function<void(std::size_t, std::size_t)>& body);

/// Number of threads that `threads` (0 = all cores) stands for.
int resolve_threads(int threads);

/// Limits OpenVDB's and every other TBB loop inside `body` to `threads` threads.
void with_threads(int threads, const std::function<void()>& body);

}  // namespace mrsim
