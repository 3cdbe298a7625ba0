#include "interp/calls/macros.h"

#include "core/text/text_io.h"
#include "interp/text/characters.h"

namespace mrsim {
namespace {

constexpr std::size_t kLongestLine = 4096;  // far above the longest block, which the parser checks

bool defines(std::string_view line) {
  std::size_t p = line.find_first_not_of(" \t");
  if (p != line.npos && upper(line[p]) == 'N') p = line.find_first_not_of("0123456789 \t", p + 1);
  return p != line.npos && upper_case(line.substr(p, 7)) == "DEFINE ";
}

}  // namespace

const std::string* Macros::find(std::string_view name) const {
  const auto at = texts_.find(name);
  return at == texts_.end() ? nullptr : &at->second;
}

bool expand_macros(std::string_view line, const Macros& own, const Macros& common,
                   std::vector<char>& out) {
  out.clear();
  if (defines(line)) return false;
  bool found = false, quoted = false;
  std::size_t p = 0;
  while (p < line.size() && out.size() < kLongestLine) {
    const std::size_t from = p++;
    if (line[from] == '"') quoted = !quoted;
    if (line[from] == ';' && !quoted) {
      p = from;
      break;
    }
    const std::string* text = nullptr;
    if (!quoted && is_name(line[from])) {
      while (p < line.size() && is_name(line[p])) ++p;
      const bool system = from > 0 && line[from - 1] == '$';
      const std::string name = upper_case(line.substr(from, p - from));
      if (!system) text = own.find(name);
      if (!system && !text) text = common.find(name);
    }
    found = found || text;
    const std::string_view piece = text ? std::string_view(*text) : line.substr(from, p - from);
    out.insert(out.end(), piece.begin(), piece.end());
  }
  out.insert(out.end(), line.begin() + static_cast<std::ptrdiff_t>(p), line.end());
  return found;
}

}  // namespace mrsim
