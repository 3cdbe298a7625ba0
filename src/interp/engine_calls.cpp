// Program flow: headers, subprograms, ends.
#include "core/text_io.h"
#include "interp/characters.h"
#include "interp/engine.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

std::size_t depth_limit(Dialect dialect) {
  if (dialect == Dialect::fanuc) return 10;
  return dialect == Dialect::codesys ? 14 : 16;
}

}  // namespace

// Headers and tape marks; decides what a call in this block is.
bool Engine::run_flow() {
  Activation& top = stack_.back();
  const Word* program = is(Dialect::codesys) ? nullptr : take('O');
  const Word* header = nullptr;
  for (const Word& word : block_.words)
    if (word.address == Address::function && word.code == Code::header) header = &word;
  const bool leader = header && !header->text.empty() && header->text[0] == '%';
  const bool section = program || (header && !section_name(block_.line, dialect_).empty());
  if (top.started && (section || (leader && !is(Dialect::codesys)))) {
    if (program)
      reporter_.add(Severity::warning, "program-end-missing",
                    fmt::format("the program before O{:g} has no {}: it is taken to end here",
                                program->value, top.call < 0 ? "M30" : "M99"),
                    program->column, program->length);
    else
      missing_return();
    if (!program && (is(Dialect::fanuc) || is(Dialect::iso))) end_of_tape();
    end_activation();
    block_.words.clear();
    ++epoch_;
    return_after_ = stop_after_ = false;
    return true;
  }
  if (!leader) top.started = true;
  if (const Word* call = take(Address::call)) call_word_ = call;
  if (const Word* l = is(Dialect::sinumerik) ? take('L') : nullptr) call_word_ = l;
  if (call_word_ && !alone(*call_word_)) return false;
  for (const Word& word : block_.words)
    if (is(Dialect::sinumerik) && word.code == Code::program_return && block_.words.size() > 1 &&
        word.address == Address::function)
      warning("call-not-alone", "RET stands alone in its block", word);
  if (call_word_ || find(letter('M'))) {  // repeats of a call
    take('P');
    if (!is(Dialect::codesys)) take('L');
  }
  return true;
}

// A call stands alone in its block; a name beside other words is a word that nobody knows.
bool Engine::alone(const Word& call) {
  bool others = false, known = true;
  for (const Word& word : block_.words) {
    if (&word == &call || word.address == letter('P')) continue;
    others = true;
    if (word.address != Address::call) continue;
    known =
        error("word-unknown", fmt::format("{} is not a word of this control", text_of(word)), word);
  }
  if (!others) return true;
  if (call.address == Address::call && !call.string)
    return error(
        "word-unknown",
        fmt::format("{} is not a word of this control{}, and a call stands alone in its block{}",
                    text_of(call), is(Dialect::sinumerik) ? " (alarm 12550)" : "",
                    is(Dialect::sinumerik) ? missing_equal_sign(call.text) : ""),
        call);
  return known && error("call-not-alone", "a call stands alone in its block", call);
}

int Engine::call_site(int line) {
  const Activation& top = stack_.back();
  const CallSite site{top.file, line, top.call};
  if (!program_.calls.empty()) {  // a call in a loop of calls is the same place each time
    const CallSite& last = program_.calls.back();
    if (last.file == site.file && last.line == site.line && last.outer == site.outer)
      return static_cast<int>(program_.calls.size()) - 1;
  }
  for (std::size_t i = program_.calls.size(), n = 0; i > 0 && n < 64; --i, ++n) {
    const CallSite& old = program_.calls[i - 1];
    if (old.file == site.file && old.line == site.line && old.outer == site.outer)
      return static_cast<int>(i - 1);
  }
  program_.calls.push_back(site);
  return static_cast<int>(program_.calls.size()) - 1;
}

bool Engine::call_subprogram(const SubprogramName& name, long repeats, const Word& word) {
  const std::size_t limit = depth_limit(dialect_);
  if (stack_.size() > limit)
    return error("subprogram-depth",
                 fmt::format("more than {} subprograms inside one another{}", limit,
                             is(Dialect::fanuc)       ? " (alarm 077)"
                             : is(Dialect::sinumerik) ? " (alarm 14012)"
                                                      : ""),
                 word);
  const std::optional<SubprogramPlace> place = subprograms_.find(name);
  if (!place) {
    std::string text =
        name.text.empty() ? fmt::format("O{:04}", name.number) : to_utf8(name.text.substr(0, 80));
    return error(
        "subprogram-missing",
        fmt::format("subprogram {} is neither in the program's file nor beside it{}{}", text,
                    is(Dialect::fanuc)       ? " (alarm 076)"
                    : is(Dialect::sinumerik) ? " (alarm 14011)"
                                             : "",
                    is(Dialect::sinumerik) ? missing_equal_sign(name.text) : ""),
        word);
  }
  if (repeats <= 0) return true;
  Activation next;
  next.call = call_site(block_.line_number);
  std::size_t file = 0;
  while (file < program_.files.size() && program_.files[file] != place->file) ++file;
  if (file == program_.files.size()) program_.files.push_back(place->file);
  next.file = static_cast<int>(file);
  next.source = std::make_unique<LineSource>(place->file, std::size_t(1) << 16);
  next.source->seek(place->offset, place->line);
  next.begin = place->offset;
  next.begin_line = place->line;
  next.repeats = static_cast<int>(std::min<long>(repeats - 1, 1000000));
  stack_.push_back(std::move(next));
  return true;
}

// M98 P2 L50; M98 P500002: the last four digits are the program, those before them the count.
bool Engine::fanuc_call(const Word& word) {
  const Word* p = find(letter('P'));
  const Word* l = find(letter('L'));
  if (!p) return error("call-without-program", "M98 needs P with the number of a program", word);
  if (p->value < 1 || p->value != std::floor(p->value) || p->value > 99999999)
    return error("value-range", "P is the number of a program", *p);
  if (l && (l->value < 0 || l->value != std::floor(l->value) || l->value > 99999999))
    return error("value-range", "L is how often the program runs", *l);
  long number = static_cast<long>(p->value), repeats = 1;
  if (l) {
    repeats = static_cast<long>(l->value);
  } else if (number > 9999) {
    repeats = number / 10000;
    number %= 10000;
  }
  return call_subprogram({number, {}}, repeats, *p);
}

bool Engine::named_call(const Word& word) {
  const Word* p = find(letter('P'));
  long repeats = 1;
  if (p && is(Dialect::sinumerik)) {
    if (p->value < 1 || p->value > 9999 || p->value != std::floor(p->value))
      return error("value-range", "P is 1 to 9999 runs", *p);
    repeats = static_cast<long>(p->value);
  }
  SubprogramName name;
  name.text = std::string(word.text);
  if (word.address == letter('L')) name.text = text_of(word);
  return call_subprogram(name, repeats, word);
}

// A FANUC subprogram whose text ends without M99.
void Engine::missing_return() {
  if (!is(Dialect::fanuc) || stack_.size() < 2) return;
  reporter_.forget_text();
  Word place;
  place.length = 1;
  reporter_.once(Severity::warning, "program-end-missing",
                 "the subprogram ends without M99: it is taken to return here", place,
                 fmt::format("M99:{}:{}", stack_.back().file, stack_.back().begin));
}

// Behind the second % nothing is read.
void Engine::end_of_tape() {
  Activation& top = stack_.back();
  if (stack_.size() > 1) return;
  std::string_view line;
  while (top.source->next(line))
    if (line.find_first_not_of(" \t\r%") != std::string_view::npos) {
      reporter_.forget_text();
      reporter_.add(Severity::note, "tape-end",
                    "the % here ends the tape: the text behind it is not read", 0, 1);
      return;
    }
}

// The end of what is being read: the next run of a subprogram, or its caller.
void Engine::end_activation() {
  Activation& top = stack_.back();
  if (stack_.size() == 1) {
    if (m99_)
      reporter_.add(Severity::note, "program-loops",
                    "M99 in the main program starts it again: simulated once", 0, 1);
    return stop();
  }
  m99_ = false;
  if (top.repeats > 0) {
    --top.repeats;
    top.source->seek(top.begin, top.begin_line);
    top.has_line = top.started = false;
    return;
  }
  reporter_.forget_text();
  stack_.pop_back();
}

void Engine::stop() {
  reporter_.forget_text();
  stack_.clear();
}

}  // namespace mrsim
