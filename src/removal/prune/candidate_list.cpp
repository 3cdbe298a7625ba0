#include "removal/prune/candidate_list.h"

namespace mrsim {

void CandidateList::reset(std::size_t slots, const Vec3& about) {
  const std::size_t lines = (slots + kPad - 1) / kPad + 1;
  slices_.clear();
  size_ = 0;
  origin = about;
  extent = 0;
  closed = true;
  if (lines * kPad <= stride_) return;
  stride_ = lines * kPad;
  numbers_.clear();  // nothing of it is copied
  numbers_.resize(stride_ * kCandidateColumns);
}

std::size_t CandidateList::begin_slice(std::uint32_t class_index, std::size_t numbers) {
  const std::size_t end = slices_.empty() ? 0 : slices_.back().first + slices_.back().count;
  slices_.push_back({class_index, (end + kPad - 1) / kPad * kPad, 0, numbers});
  return slices_.back().first;
}

void CandidateList::close_slice(std::size_t count) {
  if (count == 0) return slices_.pop_back();
  slices_.back().count = count;
  size_ += count;
}

}  // namespace mrsim
