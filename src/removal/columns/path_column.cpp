#include "removal/columns/path_column.h"

namespace mrsim {

void PathColumn::push_back(const ToolPath& path) {
  if (path.arc) {
    numbers_.push_back(kArc | static_cast<std::uint32_t>(arcs_.size()));
    arcs_.push_back(path);
  } else {
    numbers_.push_back(static_cast<std::uint32_t>(lines_.size()));
    lines_.push_back({path.start, path.travel});
  }
}

void PathColumn::append(const PathColumn& part, std::size_t done, std::size_t all) {
  const auto first_line = static_cast<std::uint32_t>(lines_.size());
  const auto first_arc = static_cast<std::uint32_t>(arcs_.size());
  reserve_ahead(numbers_, part.numbers_.size(), done, all);
  for (const std::uint32_t number : part.numbers_)
    numbers_.push_back(number + ((number & kArc) != 0 ? first_arc : first_line));
  reserve_ahead(lines_, part.lines_.size(), done, all);
  lines_.insert(lines_.end(), part.lines_.begin(), part.lines_.end());
  reserve_ahead(arcs_, part.arcs_.size(), done, all);
  arcs_.insert(arcs_.end(), part.arcs_.begin(), part.arcs_.end());
}

std::size_t PathColumn::memory() const {
  return bytes_of(numbers_) + bytes_of(lines_) + bytes_of(arcs_);
}

}  // namespace mrsim
