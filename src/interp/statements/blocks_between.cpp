#include "interp/statements/blocks_between.h"

#include "core/text/text_io.h"
#include "interp/text/line_scan.h"
#include "interp/text/source.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kMostLines = 1000;
constexpr std::size_t kLongest = 20000;  // characters of a line that is looked at
constexpr std::size_t kShown = 40;       // characters of a block in the message
constexpr std::size_t kMostShown = 3;    // blocks in the message

bool is_active(std::string_view code) {
  for (const char letter : {'X', 'Y', 'Z', 'U', 'W', 'T'})
    if (has_axis(code, letter)) return true;
  for (const char* word : {"G41", "G42", "M2", "M02", "M30", "M99", "M97", "M98", "M6", "M06",
                           "G65", "G70", "G71", "G72", "G73"})
    if (has_word(code, word)) return true;
  return has(code, "GOTO");
}

}  // namespace

std::vector<ActiveBlock> active_blocks(const std::string& file, const Place& from,
                                       const Place& to) {
  std::vector<ActiveBlock> out;
  if (from.offset >= to.offset) return out;
  LineSource source(file, std::size_t(1) << 16);
  source.seek(from.offset, from.line);
  std::string_view line;
  LineScan scan;
  for (int n = 0; n < kMostLines && source.next_offset() < to.offset && source.next(line); ++n) {
    if (line.size() > kLongest) continue;
    scan_line(line, scan);
    if (!is_active(scan.code)) continue;
    const std::size_t begin = line.find_first_not_of(" \t"), end = line.find_last_not_of(" \t\r;");
    out.push_back(
        {source.line_number(), to_utf8(line.substr(begin, std::min(end + 1 - begin, kShown)))});
  }
  return out;
}

std::string lines_text(const std::vector<ActiveBlock>& blocks) {
  std::string shown;
  for (std::size_t i = 0; i < std::min(blocks.size(), kMostShown); ++i)
    shown += (i > 0 ? "; " : "") + blocks[i].text;
  if (blocks.size() > kMostShown) shown += "; ...";
  const int first = blocks.front().line, last = blocks.back().line;
  return first == last ? fmt::format("line {} ({})", first, shown)
                       : fmt::format("lines {} to {} ({})", first, last, shown);
}

}  // namespace mrsim
