#include "interp/language/values_read.h"

#include "core/text/text_io.h"
#include "interp/language/operations.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {

std::string ValuesRead::text(std::string_view line) const {
  std::string text;
  for (std::size_t i = 0; i < count_; ++i) {
    const One& one = first_[i];
    text += text.empty() ? " (" : ", ";
    text += to_utf8(line.substr(one.from, std::min<std::size_t>(one.to - one.from, 40)));
    text += one.plain ? fmt::format(" = {}", value_text(one.number)) : std::string(" is vacant");
  }
  return text.empty() ? text : text + ")";
}

}  // namespace mrsim
