#include "removal/sweep/sorted_list.h"

#include <algorithm>

namespace mrsim {

void SortedList::prepare(const SweepColumns& c, std::span<const std::uint32_t> list) {
  if (table_ == c.serial && std::ranges::equal(list, list_)) return;
  table_ = c.serial;
  list_.assign(list.begin(), list.end());
  bounded_.clear(), others_.clear();
  for (FormPart& part : forms_) part.ids.clear(), part.rows.clear();
  for (const std::uint32_t id : list) {
    const std::uint32_t tag = c.tags[id];
    if (!is_other(tag)) {
      FormPart& part = forms_[tag >> kTagShift];
      part.ids.push_back(id), part.rows.push_back(tag & kTagRow);
    } else {
      const SingleForm form = single_form(tag);
      const bool is_listed = form == SingleForm::upright || form == SingleForm::turned;
      (is_listed ? others_ : bounded_).push_back(id);
    }
  }
}

}  // namespace mrsim
