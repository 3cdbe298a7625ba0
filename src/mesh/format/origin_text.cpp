#include "mesh/format/origin_text.h"

#include "mesh/format/text_scan.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kMostLegendText = 80;

// Names stand to the end of the line.
std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text;
}

std::optional<std::int32_t> to_int32(std::string_view word) {
  const auto value = detail::to_integer(word);
  if (!value || *value < -1 || *value > 2147483647) return {};
  return std::int32_t(*value);
}

}  // namespace

std::vector<std::string> origin_lines(const OwnerTable& table) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < table.files.size(); ++i)
    lines.push_back(fmt::format("file {} {}", i, one_line(table.files[i])));
  for (std::size_t i = 0; i < table.tools.size(); ++i)
    lines.push_back(fmt::format("tool {} {}", i, one_line(table.tools[i])));
  for (const FaceOrigin& o : table.origins)
    lines.push_back(fmt::format("owner {} {} {} {}", o.owner, o.file, o.line, o.tool));
  return lines;
}

std::vector<std::string> legend_lines(const std::vector<ColorLabel>& legend) {
  std::vector<std::string> lines;
  for (const auto& [color, text] : legend)
    lines.push_back(
        fmt::format("legend {} {} {} {}", color[0], color[1], color[2], one_line(text)));
  return lines;
}

std::optional<ColorLabel> read_legend_line(std::string_view line) {
  detail::TextScan scan(line);
  if (scan.word_in_line() != "legend") return {};
  ColorLabel out;
  for (std::uint8_t& c : out.color) {
    const auto value = detail::to_integer(scan.word_in_line());
    if (!value || *value < 0 || *value > 255) return {};
    c = std::uint8_t(*value);
  }
  out.text = scan.rest_of_line().substr(0, kMostLegendText);
  return out;
}

std::optional<std::int32_t> OriginReader::read(std::string_view line) {
  detail::TextScan scan(line);
  const std::string_view kind = scan.word_in_line();
  const auto first = to_int32(scan.word_in_line());
  if (!first) return {};
  if (kind == "group") return first;
  // Names come in order: a number that leaves a gap is not one of ours.
  if (kind == "file" && std::size_t(*first) == table_.files.size())
    table_.files.emplace_back(scan.rest_of_line());
  if (kind == "tool" && std::size_t(*first) == table_.tools.size())
    table_.tools.emplace_back(scan.rest_of_line());
  if (kind == "owner" && *first >= 0) {
    const auto file = to_int32(scan.word_in_line()), at = to_int32(scan.word_in_line()),
               tool = to_int32(scan.word_in_line());
    if (file && at && tool) table_.origins.push_back({*first, *file, std::max(*at, 0), *tool});
  }
  return {};
}

OwnerTable OriginReader::take() {
  auto& origins = table_.origins;
  const auto less = [](const FaceOrigin& a, const FaceOrigin& b) { return a.owner < b.owner; };
  const auto same = [](const FaceOrigin& a, const FaceOrigin& b) { return a.owner == b.owner; };
  std::stable_sort(origins.begin(), origins.end(), less);
  origins.erase(std::unique(origins.begin(), origins.end(), same), origins.end());
  for (FaceOrigin& o : origins) {
    if (std::size_t(o.file) >= table_.files.size()) o.file = -1;
    if (std::size_t(o.tool) >= table_.tools.size()) o.tool = -1;
  }
  return std::move(table_);
}

}  // namespace mrsim
