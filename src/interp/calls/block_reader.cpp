#include "interp/calls/block_reader.h"

#include "core/text/text_io.h"
#include "interp/calls/main_program.h"
#include "interp/text/characters.h"
#include "interp/text/okuma_words.h"
#include "interp/text/sinumerik_words.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

std::size_t depth_limit(Dialect dialect) {
  if (dialect == Dialect::fanuc) return 10;
  if (dialect == Dialect::iso) return 15;
  return dialect == Dialect::codesys ? 14 : 16;
}

// After an error nothing is cut. Blocks are run only to find further faults, so loops get less
// time.
constexpr std::uint64_t kStepsBehindAnError = 1'000'000;
constexpr std::size_t kMostStretches = 200;  // calls and repeated parts inside one another

// Posts call programs of the machine's maker, such as L6 or O9020, which change the tool.
std::string advice_for_missing(const std::string& name, Dialect dialect) {
  const bool sinumerik = dialect == Dialect::sinumerik;
  if (!sinumerik && dialect != Dialect::fanuc) return "; --path names more folders";
  return fmt::format(
      "; --path names more folders. A program of the machine that cuts nothing may be a file {}{} "
      "with {}",
      name, sinumerik ? ".SPF" : "", sinumerik ? "M17" : "M99");
}

}  // namespace

BlockReader::BlockReader(Control& control)
    : ControlPart(control),
      parser_(control.dialect, control.reporter),
      subprograms_(control.program.files.front(), control.options.search_path, control.dialect) {
  parser_.set_skip(control.options.block_skip);
}

void BlockReader::open(int leader_lines) {
  stack_.emplace_back();
  stack_.back().source = std::make_unique<LineSource>(program_.files.front());
  std::string_view leader;
  for (int i = 0; i < leader_lines; ++i) stack_.back().source->next(leader);
  const std::optional<MainProgram> main =
      main_program_behind(program_.files.front(), control_.dialect);
  if (!main) return;
  stack_.back().source->seek(main->offset, main->line);
  reporter_.set_place(0, main->line + 1, -1, {});
  reporter_.add(Severity::note, "program-start",
                fmt::format("the program begins here, with {}: {}", main->name, main->why), 0, 1);
}

bool BlockReader::next() {
  Activation& top = stack_.back();
  for (;;) {
    if (!top.has_line) {
      if (!read_line(top)) return false;
      top.has_line = true;
      top.position = std::min(std::exchange(top.resume, 0), top.line.size());
    }
    block_.line = top.line;
    block_.line_number = top.line_number;
    block_.file = top.file;
    block_.call = top.call;
    reporter_.set_place(top.file, block_.line_number, top.call, top.line);
    watch_.begin_block();
    if (parser_.next(block_, top.position)) {
      if (block_.statement != Block::kNoStatement) top.started = true;
      return true;
    }
    top.has_line = false;
  }
}

bool BlockReader::read_line(Activation& top) {
  top.line_offset = top.source->next_offset();
  if (top.line_offset >= top.end || !top.source->next(top.line)) return false;
  top.line_number = top.source->line_number();
  top.replaced = false;
  if (is(Dialect::fanuc) && modal_.okuma)
    join_okuma_lines(*top.source, top.line_offset, top.line, top.joined);
  const Macros& own = program_read().macros;
  if (!(own.empty() && macros_.empty()) && expand_macros(top.line, own, macros_, top.joined))
    top.line = {top.joined.data(), top.joined.size()};
  return true;
}

// The innermost program or subprogram. A repeated part of a program is none.
BlockReader::Activation& BlockReader::program_read() {
  std::size_t i = stack_.size() - 1;
  while (i > 0 && !stack_[i].counts_as_call) --i;
  return stack_[i];
}

void BlockReader::define_macro(const std::string& name, std::string_view text, bool everywhere) {
  (everywhere ? macros_ : program_read().macros).define(name, text);
}

bool BlockReader::replace_line(std::string_view text) {
  if (!count_steps(1)) return false;
  Activation& top = stack_.back();
  top.joined = std::vector<char>(text.begin(), text.end());
  top.line = {top.joined.data(), top.joined.size()};
  top.position = 0;
  top.replaced = true;
  return true;
}

Place BlockReader::place_at(std::size_t position) const {
  const Activation& top = stack_.back();
  return {top.line_offset, top.line_number - 1, position};
}

bool BlockReader::count_steps(std::uint64_t steps) {
  reporter_.set_repeating();
  steps_ += steps;
  if (reporter_.errors() > 0) steps_behind_error_ += steps;
  const bool whole = steps_behind_error_ <= kStepsBehindAnError;
  if (whole && steps_ <= options_.max_steps) return true;
  reporter_.add(
      Severity::error, "program-endless",
      whole ? fmt::format("stopped after {} steps of loops and calls (--max-steps){}",
                          options_.max_steps, loop_.text(stack_.back().file, steps_))
            : fmt::format("stopped {} steps of loops and calls behind an error, which may be why "
                          "they do not end",
                          kStepsBehindAnError),
      0, 1);
  stop();
  return false;
}

bool BlockReader::count_motions(std::size_t motions) {
  watch_.count_work(motions);
  moved_ += motions > 0 ? 1U : 0U;
  return steps_ == 0 || motions < 2 || count_steps(motions - 1);
}

bool BlockReader::jump(const Place& to) {
  Activation& top = stack_.back();
  const bool back = to.offset <= top.line_offset;
  if (back) loop_.come_back(top.file, to);
  if (!count_steps(1 + (back ? std::exchange(moved_, 0) : 0))) return false;
  if (to.offset == top.line_offset && top.has_line && !top.replaced) {
    top.position = std::min(to.position, top.line.size());
    return true;
  }
  top.source->seek(to.offset, to.line);
  top.has_line = false;
  top.resume = to.position;
  return true;
}

// A file stays open for the next call, with its buffer.
std::unique_ptr<LineSource> BlockReader::source_of(const std::string& file) {
  const auto at = idle_.find(file);
  if (at == idle_.end() || at->second.empty())
    return std::make_unique<LineSource>(file, std::size_t(1) << 16);
  std::unique_ptr<LineSource> source = std::move(at->second.back());
  at->second.pop_back();
  return source;
}

bool BlockReader::enter(CallRequest request, const Word& word) {
  const std::size_t limit = depth_limit(control_.dialect);
  if (request.counts_as_call && levels_ >= limit)
    return error("subprogram-depth",
                 fmt::format("more than {} subprograms inside one another{}", limit,
                             is(Dialect::fanuc)       ? " (alarm 077)"
                             : is(Dialect::sinumerik) ? " (alarm 14012)"
                                                      : ""),
                 word);
  if (request.repeats <= 0) return true;
  if (!count_steps(1)) return false;
  if (stack_.size() > kMostStretches)
    return error("subprogram-depth", "too many repeats inside one another", word);
  Activation next;
  next.call = request.counts_as_call ? call_site(block_.line_number) : stack_.back().call;
  next.file = file_index(request.file);
  next.source = source_of(request.file);
  next.source->seek(request.begin.offset, request.begin.line);
  next.resume = request.begin.position;
  next.begin = request.begin;
  next.end = request.end;
  next.counts_as_call = request.counts_as_call;
  next.started = !request.counts_as_call;
  next.repeats = static_cast<int>(std::min<long>(request.repeats - 1, 100'000'000));
  next.on_start = std::move(request.on_start);
  next.on_end = std::move(request.on_end);
  next.on_left = std::move(request.on_left);
  levels_ += next.counts_as_call ? 1U : 0U;
  if (next.on_start) next.on_start();
  stack_.push_back(std::move(next));
  return true;
}

void BlockReader::pop() {
  watch_.leave(stack_.size());
  reporter_.forget_text();
  Activation& top = stack_.back();
  levels_ -= top.counts_as_call ? 1U : 0U;
  idle_[program_.files[static_cast<std::size_t>(top.file)]].push_back(std::move(top.source));
  stack_.pop_back();
}

void BlockReader::leave_stretches() {
  while (stack_.size() > 1 && !stack_.back().counts_as_call) pop();
}

int BlockReader::call_site(int line) {
  const Activation& top = stack_.back();
  const CallSite site{top.file, line, top.call};
  if (!program_.calls.empty()) {  // a call in a loop has the same place each time
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

void BlockReader::tell_second(const std::string& name, int first, int second, const Word& word) {
  reporter_.once(
      Severity::warning, "subprogram-twice",
      fmt::format("{} stands in this file more than once: the program of line {} is run, "
                  "not that of line {}; a control has only one of that name",
                  name, first, second),
      word, name);
}

std::optional<SubprogramPlace> BlockReader::locate(const SubprogramName& name, const Word& word) {
  std::optional<SubprogramPlace> place = subprograms_.find(name);
  if (place) {
    const std::string called =
        name.number >= 0 ? fmt::format("O{}", name.number) : upper_case(name.text);
    called_.insert(called);
    if (place->again != 0 && !is(Dialect::ngc))  // LinuxCNC has O100 at each part of a structure
      tell_second(called, place->line + 1, place->again, word);
    return place;
  }
  const std::string text =
      name.text.empty() ? fmt::format("O{:04}", name.number) : to_utf8(name.text.substr(0, 80));
  const std::string meant = is(Dialect::sinumerik) ? missing_equal_sign(name.text) : "";
  error("subprogram-missing",
        fmt::format("subprogram {} is neither in the program's file nor beside it{}{}", text,
                    is(Dialect::fanuc)       ? " (alarm 076)"
                    : is(Dialect::sinumerik) ? " (alarm 14011)"
                                             : "",
                    meant.empty() ? advice_for_missing(text, control_.dialect) : meant),
        word);
  return place;
}

bool BlockReader::call(const SubprogramName& name, long repeats, const Word& word) {
  const std::optional<SubprogramPlace> place = locate(name, word);
  if (!place) return false;
  return enter(call_of(*place, repeats), word);
}

int BlockReader::file_index(const std::string& file) {
  std::size_t i = 0;
  while (i < program_.files.size() && program_.files[i] != file) ++i;
  if (i == program_.files.size()) program_.files.push_back(file);
  return static_cast<int>(i);
}

void BlockReader::stop() {
  reporter_.forget_text();
  stack_.clear();
}

}  // namespace mrsim
