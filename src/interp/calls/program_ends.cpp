// Where the text of a program ends: at a header, at a tape mark, at the end of the file, or at a
// word that ends it.
#include "interp/calls/block_reader.h"
#include "interp/text/characters.h"

#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

// G291 of SINUMERIK, above the number of a program in ISO mode.
bool begins_iso_mode(const Block& block) {
  return block.words.size() == 1 && block.words[0].address == letter('G') &&
         block.words[0].value == 291;
}

}  // namespace

bool BlockReader::ends_at_header(const Word* program) {
  Activation& top = stack_.back();
  const Word* header = nullptr;
  for (const Word& word : block_.words)
    if (word.address == Address::function && word.code == Code::header) header = &word;
  const bool leader = header && !header->text.empty() && header->text[0] == '%';
  const bool section = program || (header && !section_name(block_.line, control_.dialect).empty());
  if (!top.started || !(section || (leader && !is(Dialect::codesys)))) {
    if (!leader && !begins_iso_mode(block_)) top.started = true;
    return false;
  }
  if (leader && upper_case(header->text.substr(1, 4)) == "WAIT") return false;  // CNCjs: it pauses
  const bool commented =
      leader && header->text.find_first_not_of("% \t\r") != std::string_view::npos;
  if (commented && is(Dialect::ngc)) {  // a line for the sender, as CNCjs and gSender have them
    reporter_.once(Severity::warning, "sender-line",
                   "lines of % and a text are for the sender of the program: read over", *header,
                   "sender-line");
    return false;
  }
  if (program)
    warn_of_header(*program, fmt::format("O{:g}", program->value));
  else if (section && is(Dialect::sinumerik))
    warn_of_header(*header, section_name(block_.line, control_.dialect));
  else
    missing_return();
  if (section && stack_.size() == 1) top.source->seek(top.line_offset, top.line_number - 1);
  if (!program && leader && !is(Dialect::sinumerik) && !is(Dialect::codesys))
    end_of_tape(commented);
  end_activation(false);
  return true;
}

// Warns that a header stands where the program before it should have ended.
void BlockReader::warn_of_header(const Word& header, const std::string& name) {
  const bool main = stack_.back().call < 0;
  const char* const end = main ? "M30" : is(Dialect::sinumerik) ? "M17" : "M99";
  reporter_.once(Severity::warning, "program-end-missing",
                 fmt::format("the program before {} has no {}: it is taken to end here", name, end),
                 header, fmt::format("header:{}:{}", block_.file, block_.line_number));
}

void BlockReader::end_of_text() {
  missing_return();
  end_activation(false);
}

// Reports a FANUC subprogram whose text ends without M99.
void BlockReader::missing_return() {
  if (!is(Dialect::fanuc) || stack_.size() < 2 || !stack_.back().counts_as_call) return;
  if (stack_.back().end != std::numeric_limits<std::uint64_t>::max()) return;  // a contour
  reporter_.forget_text();
  Word place;
  place.length = 1;
  reporter_.once(Severity::warning, "program-end-missing",
                 "the subprogram ends without M99: it is taken to return here", place,
                 fmt::format("M99:{}:{}", stack_.back().file, stack_.back().begin.offset));
}

// Nothing is read behind the second %. If text stands beside it, it may be meant as a comment.
void BlockReader::end_of_tape(bool commented) {
  Activation& top = stack_.back();
  if (stack_.size() > 1) return;
  std::string_view line;
  while (top.source->next(line))
    if (line.find_first_not_of(" \t\r%") != std::string_view::npos) {
      reporter_.forget_text();
      reporter_.add(commented ? Severity::warning : Severity::note, "tape-end",
                    fmt::format("the % here ends the tape: the text behind it is not read{}",
                                commented ? "; a comment is written ( )" : ""),
                    0, 1);
      return;
    }
}

void BlockReader::end_activation(bool loops) {
  Activation& top = stack_.back();
  if (stack_.size() == 1) {
    if (loops)
      reporter_.add(Severity::note, "program-loops",
                    "M99 in the main program starts it again: simulated once", 0, 1);
    return end_program();
  }
  if (top.on_end) top.on_end();
  if (top.repeats > 0) {
    watch_.leave(stack_.size());
    if (!count_steps(1)) return;
    --top.repeats;
    if (top.on_start) top.on_start();
    top.source->seek(top.begin.offset, top.begin.line);
    top.has_line = false;
    top.started = !top.counts_as_call;
    top.resume = top.begin.position;
    return;
  }
  const std::function<void()> on_left = std::move(top.on_left);
  pop();
  if (on_left) on_left();
}

// Tells of programs behind the end of the first one that were not called, such as a second job.
void BlockReader::tell_of_others() {
  LineSource& source = *stack_.front().source;
  std::string_view line;
  int others = 0;
  std::string first;
  while (source.next(line)) {
    const std::string name = section_name(line, control_.dialect);
    if (name.empty() || called_.contains(name)) continue;
    if (is(Dialect::sinumerik) && !names_main_program(line)) continue;
    if (others++ == 0) first = fmt::format("{} in line {}", name, source.line_number());
  }
  if (others == 0) return;
  reporter_.forget_text();
  reporter_.add(Severity::note, "program-not-run",
                fmt::format("the program ends here: {}{} is not called, and not run", first,
                            others == 1 ? "" : fmt::format(" (and {} more)", others - 1)),
                0, 1);
}

void BlockReader::end_program() {
  if (is(Dialect::fanuc) || is(Dialect::sinumerik)) tell_of_others();
  stop();
}

}  // namespace mrsim
