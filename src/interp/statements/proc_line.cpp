#include "interp/statements/proc_line.h"

#include "core/text/text_io.h"
#include "interp/statements/sinumerik_text.h"
#include "interp/text/characters.h"
#include "interp/text/source.h"

#include <string_view>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kHeaderLines = 50;  // lines at the head of a subprogram in which PROC is looked for

bool is_block_number(std::string_view word) {
  return word.size() > 1 && word[0] == 'N' &&
         word.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

}  // namespace

std::optional<ProcLine> find_proc_line(const SubprogramPlace& place) {
  LineSource source(place.file, std::size_t(1) << 14);
  source.seek(place.offset, place.line);
  std::string_view line;
  for (int i = 0; i < kHeaderLines && source.next(line); ++i) {
    std::size_t p = 0, code = 0;  // behind the block number
    std::string word = word_at(line, p);
    if (is_block_number(word)) {
      code = p;
      word = word_at(line, p);
    }
    if (word == "PROC") return ProcLine{std::string(line), p};
    const std::size_t first = line.find_first_not_of(" \t\r", code);
    if (first != std::string_view::npos && line[first] != ';' && line[first] != '%') break;
  }
  return std::nullopt;
}

std::string shown_place(const SubprogramPlace& place) {
  if (place.line == 0 && place.offset == 0) return to_utf8(place.file);
  return fmt::format("the program in line {} of {}", place.line + 1, to_utf8(place.file));
}

}  // namespace mrsim
