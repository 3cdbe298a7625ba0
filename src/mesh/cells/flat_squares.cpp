#include "mesh/cells/flat_squares.h"

#include <bit>

namespace mrsim::detail {
namespace {

// The cells whose eight neighbours are in the region as well.
CellRows eroded(const CellRows& in) {
  CellRows narrow{}, out{};
  for (std::size_t i = 0; i < in.size(); ++i) narrow[i] = in[i] & in[i] << 1 & in[i] >> 1;
  for (std::size_t i = 1; i + 1 < in.size(); ++i)
    out[i] = narrow[i - 1] & narrow[i] & narrow[i + 1];
  return out;
}

// Bit i: bits 2 i and 2 i + 1.
std::uint64_t paired(std::uint64_t x) {
  x &= x >> 1;
  x &= 0x5555555555555555u;
  x = (x | x >> 1) & 0x3333333333333333u;
  x = (x | x >> 2) & 0x0f0f0f0f0f0f0f0fu;
  x = (x | x >> 4) & 0x00ff00ff00ff00ffu;
  x = (x | x >> 8) & 0x0000ffff0000ffffu;
  return (x | x >> 16) & 0x00000000ffffffffu;
}

CellRows paired(const CellRows& in) {
  CellRows out{};
  for (std::size_t i = 0; 2 * i + 1 < in.size(); ++i) out[i] = paired(in[2 * i] & in[2 * i + 1]);
  return out;
}

bool any(const CellRows& rows) {
  std::uint64_t all = 0;
  for (const std::uint64_t r : rows) all |= r;
  return all != 0;
}

}  // namespace

std::vector<CellSquare> flat_squares(const CellRows& region, std::int32_t first, std::int32_t end) {
  CellRows cells{};
  const CellRows inner = eroded(region);
  for (std::int32_t i = first; i < end; ++i)
    cells[static_cast<std::size_t>(i - first)] =
        inner[static_cast<std::size_t>(i)] >> first & ~std::uint64_t(0) >> (64 - (end - first));
  std::vector<CellRows> levels;
  for (CellRows squares = paired(cells); any(squares); squares = paired(eroded(squares)))
    levels.push_back(squares);
  std::vector<CellSquare> out;
  for (std::size_t k = 0; k < levels.size(); ++k)
    for (std::size_t row = 0; row < levels[k].size(); ++row)
      for (std::uint64_t left = levels[k][row]; left != 0; left &= left - 1) {
        const int column = std::countr_zero(left);
        if (k + 1 < levels.size() && (levels[k + 1][row / 2] >> column / 2 & 1) != 0) continue;
        const std::int32_t size = 2 << k;
        out.push_back({first + static_cast<std::int32_t>(row) * size, first + column * size, size});
      }
  return out;
}

}  // namespace mrsim::detail
