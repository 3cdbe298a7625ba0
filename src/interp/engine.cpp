#include "interp/engine.h"

#include "interp/characters.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {

Engine::Engine(const InterpOptions& options, Program& program, int leader_lines, MotionSink& sink)
    : options_(options),
      program_(program),
      sink_(sink),
      reporter_(sink, program),
      dialect_(program.dialect),
      leader_lines_(leader_lines),
      parser_(program.dialect, reporter_),
      subprograms_(program.files.front(), options.search_path, program.dialect),
      codes_(code_table(program.dialect, program.machine)),
      corners_(reporter_, [this](const PathMove& m) { compensation_.push(m); }),
      compensation_(reporter_, [this](const PathMove& m) { output(m.motion); }) {
  modal_ = start_modal(dialect_, program.machine);
  if (options.start) {
    position_.physical = position_.programmed = *options.start;
    position_.known = 7;
  }
  if (lathe()) position_.known |= 2;  // a lathe has no Y to give
  if (is(Dialect::fanuc) || is(Dialect::iso)) set_work("G54");
  rebuild_frame();
}

std::string Engine::text_of(const Word& word) const {
  return std::string(block_.line.substr(static_cast<std::size_t>(word.column),
                                        static_cast<std::size_t>(std::min(word.length, 40))));
}

bool Engine::error(const char* code, const std::string& text, const Word& word) {
  reporter_.add(Severity::error, code, text, word);
  return false;
}

void Engine::warning(const char* code, const std::string& text, const Word& word) {
  reporter_.add(Severity::warning, code, text, word);
}

void Engine::note_once(const char* code, const std::string& text, const Word& word,
                       const std::string& key) {
  reporter_.once(Severity::note, code, text, word, key);
}

CodeEntry Engine::lookup(const Word& word) const {
  if (word.address == Address::function) {
    CodeEntry entry = is(Dialect::sinumerik) ? find_function(upper_case(word.text)) : CodeEntry{};
    entry.code = word.code;
    return entry;
  }
  const double by_10 = word.value * 10;
  if (by_10 < 0 || by_10 >= 1e5 || by_10 != std::floor(by_10)) return {};
  const int number = static_cast<int>(by_10);
  if (number % 10 == 0 && number < 10000) return codes_[static_cast<std::size_t>(number / 10)];
  return find_g_code(dialect_, program_.machine, number);
}

void Engine::run() {
  stack_.emplace_back();
  stack_.back().source = std::make_unique<LineSource>(program_.files.front());
  std::string_view leader;
  for (int i = 0; i < leader_lines_; ++i) stack_.back().source->next(leader);
  while (!stack_.empty()) {
    if (!read_block()) {
      missing_return();
      end_activation();
      continue;
    }
    if (++executed_ > options_.max_blocks) {
      reporter_.add(Severity::error, "program-endless",
                    fmt::format("stopped after {} blocks", options_.max_blocks), 0, 1);
      stop();
      break;
    }
    execute();
  }
  corners_.flush();
  compensation_.flush();
  if (pending_angle_.active)
    reporter_.add_at(Severity::error, "angle-incomplete",
                     "the program ends after a block that gives only ANG=", pending_angle_.motion);
  if (cuts_ == 0 && reporter_.errors() == 0)
    reporter_.add_general(Severity::error, "program-without-cuts",
                          "the program has no G1, G2 or G3 move: nothing is cut");
}

bool Engine::read_block() {
  Activation& top = stack_.back();
  for (;;) {
    if (!top.has_line) {
      if (!top.source->next(top.line)) return false;
      top.has_line = true;
      top.position = 0;
    }
    block_.line = top.line;
    block_.line_number = top.source->line_number();
    reporter_.set_place(top.file, block_.line_number, top.call, top.line);
    if (parser_.next(block_, top.position)) return true;
    top.has_line = false;
  }
}

bool Engine::legal_address(const Word& word) {
  static constexpr std::string_view kSinumerik = "ABCDFGHIJKLMNOPSTXYZ";
  static constexpr std::string_view kMill = "ABCDFGHIJKLMNOPQRSTXYZ";
  static constexpr std::string_view kLathe = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  static constexpr std::string_view kIso = "ABCDFGHIJKLMNOPQRSTXYZ";
  static constexpr std::string_view kCodesys = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  if (word.address >= Address::function) return true;
  const auto c = static_cast<char>(word.address);
  const std::string_view legal = is(Dialect::sinumerik) ? kSinumerik
                                 : is(Dialect::codesys) ? kCodesys
                                 : is(Dialect::iso)     ? kIso
                                 : lathe()              ? kLathe
                                                        : kMill;
  if (legal.find(c) != std::string_view::npos) return true;
  if (c == 'U' && !is(Dialect::sinumerik))  // the time of G4
    for (const Word& other : block_.words)
      if (other.address == letter('G') && other.value == 4) return true;
  if (is(Dialect::sinumerik) && c == 'R')
    return error("not-supported",
                 "R is a variable of SINUMERIK, which is not supported yet; "
                 "for a radius write CR=",
                 word);
  return error("address-unknown",
               fmt::format("unknown address {}{}", c, is(Dialect::fanuc) ? " (alarm 009)" : ""),
               word);
}

// Fills slots_; an address twice is an error, G and M words and a few of CODESYS excepted.
bool Engine::index_words() {
  ++epoch_;
  bool ok = true;
  for (std::size_t i = 0; i < block_.words.size(); ++i) {
    const Word& word = block_.words[i];
    if (!legal_address(word)) ok = false;
    Slot& slot = slots_[static_cast<std::size_t>(word.address)];
    const auto c = static_cast<char>(word.address);
    const bool repeats = c == 'G' || c == 'M' || word.address == Address::function ||
                         word.address == Address::data || (is(Dialect::sinumerik) && c == 'H') ||
                         (is(Dialect::codesys) && (c == 'E' || c == 'H' || c == 'L' || c == 'O'));
    if (slot.epoch == epoch_ && !repeats) {
      const bool axis = (c >= 'I' && c <= 'K') || (c >= 'X' && c <= 'Z');
      const std::string alarm =
          is(Dialect::sinumerik) ? axis ? " (alarm 16420)" : " (alarm 12010)" : "";
      ok = error(
          "address-twice",
          fmt::format("{} is given twice in the block{}",
                      word.address < Address::function
                          ? std::string(1, c)
                          : std::string(block_.line.substr(static_cast<std::size_t>(word.column),
                                                           static_cast<std::size_t>(word.length))),
                      alarm),
          word);
      continue;
    }
    if (slot.epoch == epoch_) continue;
    slot = {epoch_, static_cast<std::uint16_t>(std::min<std::size_t>(i, 65535)), repeats};
  }
  if (block_.words.size() > 65535)
    return error("block-too-long", "more than 65535 words in a block", block_.words.back());
  return ok;
}

void Engine::execute() {
  if (block_.skip_level >= 0 && (options_.block_skip >> block_.skip_level & 1U) != 0) return;
  if (!index_words()) block_.bad = true;
  if (!block_.comments.empty()) read_comments();
  if (block_.bad) return;
  if (block_.words.empty() && block_.function_name.empty()) return;
  ++blocks_;
  const Modal saved = modal_;
  const Position saved_position = position_;
  saved_tool_.reset();
  frames_changed_ = false;
  stop_after_ = return_after_ = false;
  call_word_ = m98_ = nullptr;
  if (!interpret_block()) {
    modal_ = saved;
    position_ = saved_position;
    if (frames_changed_) frames_ = saved_frames_;
    if (saved_tool_) tool_ = *saved_tool_;
    return;
  }
  has_loose_hint_ = false;
  if (stop_after_) return stop();
  if (m98_) {
    fanuc_call(*m98_);
  } else if (call_word_) {
    named_call(*call_word_);
  } else if (return_after_) {
    end_activation();
  }
}

// Two words of one modal group contradict each other; what happens then is the dialect's.
bool Engine::claim_group(const Word& word, const CodeEntry& entry) {
  const bool dynamics = entry.group == Group::exact || entry.group == Group::path;
  if (entry.group == Group::none || entry.group == Group::other ||
      (dynamics && !is(Dialect::sinumerik)))
    return true;
  const std::uint64_t bit = std::uint64_t(1) << static_cast<unsigned>(entry.group);
  if ((groups_ & bit) == 0) {
    groups_ |= bit;
    return true;
  }
  if (is(Dialect::fanuc)) return true;
  if (is(Dialect::sinumerik))
    return error("group-twice",
                 entry.group == Group::frame
                     ? "two frame words in one block (alarm 12070)"
                     : "two words of one G group in one block (alarm 12060)",
                 word);
  warning("group-twice", "two words of one G group in one block: the last one counts", word);
  return true;
}

// A modal cycle is run at every point up to G80 or a word of motion: those go with it.
bool Engine::refuse_cycle(const Word& word, const CodeEntry& entry) {
  in_cycle_ = entry.group != Group::oneshot;
  return error("not-supported",
               fmt::format("{} is a canned cycle, which is not supported yet{}", text_of(word),
                           in_cycle_ ? "; neither are its points in the blocks behind it" : ""),
               word);
}

bool Engine::apply_code(const Word& word, const CodeEntry& entry) {
  switch (entry.code) {
    case Code::unknown:
      return error("g-unknown",
                   fmt::format("G{:g} is not known to this control{}", word.value,
                               is(Dialect::sinumerik) ? " (alarm 12470)"
                               : is(Dialect::fanuc)   ? " (alarm 010)"
                                                      : ""),
                   word);
    case Code::cycle:
      return refuse_cycle(word, entry);
    case Code::unsupported:
      return error("not-supported", fmt::format("{} is not supported yet", text_of(word)), word);
    case Code::ignored:
      if (entry.number == 80) in_cycle_ = false;
      return true;
    case Code::rapid:
    case Code::line:
    case Code::arc_cw:
    case Code::arc_ccw:
    case Code::arc_point:
    case Code::arc_tangent:
    case Code::thread:
    case Code::thread_growing:
    case Code::thread_shrinking:
    case Code::tap_in:
    case Code::tap_out:
      in_cycle_ = false;
      motion_code_ = &word;
      modal_.motion = entry.code;
      return true;
    default:
      return apply_modal_code(word, entry);
  }
}

bool Engine::interpret_block() {
  motion_code_ = oneshot_ = frame_code_ = nullptr;
  block_motion_ = Code::unknown;
  suppress_ = comp_selected_ = comp_moved_ = tool_change_ = false;
  const Code comp_before = modal_.comp;
  groups_ = 0;
  bool ok = true;
  for (const Word& word : block_.words) {
    if (word.address != letter('G') && word.address != Address::function) continue;
    const CodeEntry entry = lookup(word);
    if (!claim_group(word, entry) || !apply_code(word, entry)) ok = false;
  }
  if (!ok) return false;
  if (!block_.function_name.empty() && !workpiece()) return false;
  if (!run_flow()) return false;
  if (stack_.empty()) return true;
  if (!apply_m_words()) return false;
  if (oneshot_code_ == Code::dwell && oneshot_) return dwell() && report_unused();
  if (!apply_values()) return false;
  if (oneshot_ && !run_oneshot()) return false;
  if (frame_code_ && !run_frame()) return false;
  if (in_cycle_ && has_move()) return false;  // said with the cycle
  if (has_move() && !move()) return false;
  check_comp_selection(comp_before);
  return report_unused();
}

// A known address that nothing in its block wanted.
bool Engine::report_unused() {
  for (const Word& word : block_.words) {
    const Slot& slot = slots_[static_cast<std::size_t>(word.address)];
    if (slot.epoch != epoch_ || slot.used) continue;
    warning("word-without-effect",
            fmt::format("{} has no effect in this block",
                        block_.line.substr(static_cast<std::size_t>(word.column),
                                           static_cast<std::size_t>(std::min(word.length, 40)))),
            word);
  }
  return true;
}

}  // namespace mrsim
