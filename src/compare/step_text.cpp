#include "compare/step_text.h"

#include "core/process/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kFarthest = 1e10;  // 10 km, were the unit a micrometre

// Whether the number at the front of `text` is farther than that; of what is no number, no.
bool is_far(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \r\n\t+"), text.size()));
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc::result_out_of_range) return std::abs(value) > kFarthest;
  return std::string_view(text.data(), end).find("E-") == text.npos;
}

struct EntityNames {
  std::vector<std::uint64_t> held, used;
};

// #12 where it stands before = is held, else used. Texts, comments and addresses (<file.stp#12>)
// hold none.
EntityNames entity_names(std::string_view text) {
  EntityNames names;
  const auto skip_past = [&](std::size_t at, std::string_view end) {
    const std::size_t found = text.find(end, at);
    return found == text.npos ? text.size() : found + end.size();
  };
  for (std::size_t at = text.find_first_of("'#</"); at < text.size();
       at = text.find_first_of("'#</", at)) {
    const char c = text[at++];
    if (c == '\'') at = skip_past(at, "'");
    if (c == '<') at = skip_past(at, ">");
    if (c == '/' && at < text.size() && text[at] == '*') at = skip_past(at + 1, "*/");
    if (c != '#') continue;
    std::uint64_t number = 0;
    const auto [end, fault] = std::from_chars(text.data() + at, text.data() + text.size(), number);
    if (fault != std::errc()) continue;
    at = static_cast<std::size_t>(end - text.data());
    const std::size_t next = text.find_first_not_of(" \t\r\n", at);
    const bool is_held = next != text.npos && text[next] == '=';
    (is_held ? names.held : names.used).push_back(number);
  }
  return names;
}

}  // namespace

void require_near(std::string_view text, const std::string& path) {
  for (std::size_t at = 0; (at = text.find("CARTESIAN_POINT", at)) != text.npos;) {
    const std::size_t end = std::min(text.find(';', at), text.size());
    for (at = text.find('(', at); at < end; at = text.find_first_of("(,", at + 1))
      if (is_far(text.substr(at + 1, end - at)))
        throw Error("step-too-far", path + " has a point farther than 10 km from the origin");
    at = end;
  }
}

void require_references(std::string_view text, const std::string& path) {
  EntityNames names = entity_names(text);
  std::sort(names.held.begin(), names.held.end());
  for (const std::uint64_t one : names.used)
    if (!std::binary_search(names.held.begin(), names.held.end(), one))
      throw Error("step-unreadable",
                  fmt::format("{} is damaged: it refers to #{}, which it does not hold; export it "
                              "again",
                              path, one));
}

}  // namespace mrsim
