#include "mesh/solid/owner_set.h"

#include <bit>

namespace mrsim {

void OwnerSet::add(std::span<const std::int32_t> owners) {
  for (const std::int32_t owner : owners) {
    const auto bit = static_cast<std::uint32_t>(owner) + 1;  // the stock's is 0
    if (bit >= kDense) {
      sparse_.insert(owner);
      continue;
    }
    if (bit / 64 >= seen_.size()) seen_.resize(bit / 64 + 1 + seen_.size());
    seen_[bit / 64] |= std::uint64_t(1) << bit % 64;
  }
}

std::vector<std::int32_t> OwnerSet::sorted() const {
  std::vector<std::int32_t> out(sparse_.begin(), sparse_.lower_bound(-1));
  for (std::size_t word = 0; word < seen_.size(); ++word)
    for (std::uint64_t bits = seen_[word]; bits != 0; bits &= bits - 1)
      out.push_back(static_cast<std::int32_t>(word * 64 + std::size_t(std::countr_zero(bits))) - 1);
  out.insert(out.end(), sparse_.lower_bound(-1), sparse_.end());
  return out;
}

}  // namespace mrsim
