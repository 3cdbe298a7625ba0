#include "interp/engine.h"

#include "interp/control/start_modes.h"

#include <fmt/format.h>

namespace mrsim {

Engine::Engine(const InterpOptions& options, Program& program, int leader_lines, bool okuma,
               MotionSink& sink)
    : options_(options),
      reporter_(sink, program),
      control_(options, program, reporter_),
      reader_(control_),
      statements_(Statements::make(control_, reader_)),
      flow_(control_, reader_, statements_.get()),
      iso_(control_),
      index_(control_),
      axes_(control_),
      frames_(control_),
      tools_(control_),
      compensation_(control_, tools_),
      out_(control_, compensation_, sink),
      moves_(control_, axes_, frames_, tools_, compensation_, out_),
      modes_(control_, frames_, compensation_),
      values_(control_, tools_),
      events_(control_, out_),
      oneshots_(control_, axes_, frames_, moves_),
      holes_(control_, reader_, moves_),
      drilling_(control_, axes_, holes_),
      haas_(control_, axes_, moves_, compensation_, drilling_),
      pockets_(control_, axes_, tools_, moves_),
      haas_pocket_(control_, reader_, statements_.get(), axes_, compensation_, moves_, out_),
      figures_(control_, reader_, frames_.transforms()),
      engraving_(control_, statements_.get(), axes_, moves_),
      cycles_(control_, reader_, statements_.get(), holes_, frames_, tools_, moves_, out_),
      turning_(control_, axes_, moves_),
      contours_(control_, reader_, statements_.get(), moves_, out_),
      profiles_(control_, reader_, statements_.get(), axes_, moves_),
      stock_(control_),
      operator_(control_) {
  control_.work = options.table.work;
  control_.registers = options.table.offsets;
  control_.shift_machine();
  control_.modal = start_modal(program.dialect, program.machine);
  control_.modal.okuma = okuma;
  control_.modal.has_increments = okuma;  // G90 of its lathes is no turning cycle
  Position& position = control_.position;
  if (options.start) {
    position.physical = position.programmed = *options.start;
    position.known = kAllAxes;
  }
  if (program.machine == MachineKind::lathe) position.known |= kAxisY;  // a lathe has no Y to give
  frames_.start();
  if (statements_) statements_->set_tools(tools_);
  reader_.set_language(statements_.get());
  reader_.open(leader_lines);
}

void Engine::run() {
  while (!reader_.finished()) {
    if (!reader_.next()) {
      if (reader_.depth() == 1) tell_of_missing_end();
      reader_.end_of_text();
      continue;
    }
    if (++executed_ > options_.max_blocks) {
      reporter_.add(Severity::error, "program-endless",
                    fmt::format("stopped after {} blocks", options_.max_blocks), 0, 1);
      reader_.stop();
      break;
    }
    const std::size_t made = out_.made();
    out_.mark();
    execute();
    reader_.count_motions(out_.made() - made);
  }
  contours_.end_program();
  profiles_.end_program();
  cycles_.end_program();
  haas_pocket_.end_program();
  out_.flush();
  moves_.finish();
  if (control_.skips_data)
    reporter_.add_general(Severity::error, "not-supported",
                          "G10 L3 or L50 has no G11: nothing behind it has been read");
  if (out_.cuts() == 0 && reporter_.errors() == 0)
    reporter_.add_general(Severity::warning, "program-without-cuts",
                          "the program has no G1, G2 or G3 move: nothing is cut");
  tell_unused_options();
  stock_.compare_units(tools_.sized_in_inches(), out_.farthest_cut(), out_.slowest_turn());
  reporter_.finish();
}

// A file that was cut off by a full disk or a broken transfer ends in the middle of a cut. Programs
// of Grbl and pieces of programs often have no word at their end; the tool has left the part there.
void Engine::tell_of_missing_end() {
  if (statements_ && !statements_->end_of_main()) return;
  if (control_.dialect == Dialect::codesys || out_.made() == 0 || out_.captures()) return;
  if (reporter_.errors() > 0) return;  // its end may be among what was refused
  Motion last;
  last.file = last_block_.file;
  last.line = last_block_.line;
  last.column = 1;
  if (out_.ends_in_cut())
    reporter_.add_at(Severity::warning, "program-end-missing",
                     "the file ends here, in the middle of a cut, and no M30 or other word ends "
                     "the program: is the file complete?",
                     last);
  else
    reporter_.add_at(Severity::note, "program-end-missing",
                     "the file ends here, and no M30 or other word ends the program", last);
}

// Tells of options that had no effect: they may be misspelt, or meant for another program.
void Engine::tell_unused_options() {
  if (statements_) statements_->tell_unread_presets();
  std::string levels;
  for (int level = 0; level < 10; ++level)
    if (skips_level(options_.block_skip & ~skip_levels_, level))
      levels += fmt::format("{}{}", levels.empty() ? "" : ",", level);
  if (!levels.empty())
    reporter_.add_general(
        Severity::note, "block-skip-unused",
        fmt::format("--block-skip {} does nothing: no block that was read has that level", levels));
  // Without the option, too, the radius is that of the tool.
  const bool differs = options_.comp == CompRadius::wear || options_.comp == CompRadius::off;
  if (differs && !compensation_.asked_option())
    reporter_.add_general(
        Severity::note, "comp-unused",
        compensation_.was_on()
            ? "--comp does nothing: what D names tells the radius of each G41 and G42"
            : "--comp does nothing: the program has no G41 or G42 that counts");
}

void Engine::execute() {
  BlockWords& block = control_.block;
  for (const int level : {block.skip_level, block.inner_skip})
    if (level >= 0) skip_levels_ |= 1U << level;
  if (skips_level(options_.block_skip, block.skip_level)) return;
  block.begin();
  if (control_.unread_end != 0 && UnreadModes(control_).skips_iso_mode()) return;
  if (block.statement != Block::kNoStatement) return statements_->run();
  if (statements_ && statements_->take_block()) return;
  if (profiles_.reads_contour() && !profiles_.rewrite_increments()) block.bad = true;
  if (control_.dialect == Dialect::iso && !iso_.rewrite()) block.bad = true;
  if (control_.skips_data && !ends_data()) return;
  if (!index_.run()) block.bad = true;
  if (!block.comments.empty() && !engraving_.holds_text(block)) {
    tools_.read_comments();
    stock_.read_comments();
  }
  operator_.read_texts();
  if (block.bad) return;
  if (block.words.empty() && block.function_name.empty() && !block.modal_call) return;
  ++block.number;
  last_block_ = block.place();
  if (profiles_.reads_contour()) return profiles_.contour_block();
  if (interpret_or_restore()) end_block();
}

// A rejected block leaves no trace in the state.
bool Engine::interpret_or_restore() {
  const Modal modal = control_.modal;
  const Position position = control_.position;
  control_.saved_tool.reset();
  control_.saved_frames.reset();
  if (interpret_block()) return true;
  control_.modal = modal;
  control_.position = position;
  if (control_.saved_frames) control_.frames = *control_.saved_frames;
  if (control_.saved_tool) control_.tool = *control_.saved_tool;
  return false;
}

void Engine::end_block() {
  events_.after_motion();
  if (moved_) control_.paused = false;
  if (out_.cuts() > 0 && !stock_.is_settled()) stock_.settle();
  operator_.end_block(out_.cuts());
  tools_.end_block();
  flow_.end_block();
  contours_.end_block();
  profiles_.end_block();
  cycles_.end_block();
  haas_pocket_.end_block();
  figures_.end_block();
  if (statements_ && !reader_.finished()) statements_->end_block(moved_);
}

bool Engine::ends_data() {
  if (control_.block.has_code('G', 11)) control_.skips_data = false;
  return !control_.skips_data;
}

// Makes the move of the block, or holes at its end.
bool Engine::run_move() {
  if (control_.unread_end != 0 && !UnreadModes(control_).ends_swivel()) {
    UnreadModes(control_).pass_over();
    return true;
  }
  if (haas_.wants_block()) return haas_.run();
  if (pockets_.wants_block()) return pockets_.run();
  if (haas_pocket_.wants_block()) return haas_pocket_.run();
  if (figures_.wants_block()) return figures_.run();
  if (!control_.block.places.empty())
    return drilling_.at_points(control_.block.places, control_.block.words.front(), false);
  if (engraving_.wants_block()) return engraving_.run();
  if (drilling_.wants_block()) return drilling_.run();
  if (control_.block.turn_cycle != 0) return run_turning();
  if (turning_.wants_block()) return turning_.pass();
  if (control_.block.modal_call) return cycles_.modal_call();
  if (!control_.block.function_name.empty() && SinumerikCycles::knows(control_.block.function_name))
    return cycles_.run();
  if (!axes_.has_move()) return true;
  const Vec3 from = control_.position.programmed;
  moved_ = true;
  return moves_.run() && cycles_.run_modal(from);
}

// A turning cycle stands in a block that moves, or in a line of values for it.
bool Engine::run_turning() {
  if (control_.block.turn_cycle > 73) return turning_.run();
  return control_.dialect == Dialect::ngc ? profiles_.run() : contours_.run();
}

bool Engine::interpret_block() {
  const BlockWords& block = control_.block;
  moved_ = false;
  if (!modes_.apply() || !frames_.select_fixture()) return false;
  if (block.function_name == "WORKPIECE" && !WorkpieceWords(control_).run()) return false;
  if (!flow_.begin_block()) return false;
  if (reader_.finished()) return true;
  if (!flow_.m_words()) return false;
  if (!compensation_.allows_block()) return false;
  if (block.home && block.home_guessed)
    moves_.guess_retract(*block.home);
  else if (block.home)
    moves_.to_place(&options_.places.reference, kAxisZ, *block.home);
  const bool dwells = block.oneshot && block.oneshot_code == Code::dwell;
  if (!dwells && !values_.apply()) return false;
  events_.before_motion();
  oneshots_.settle_tip();
  if (block.pause) moves_.dwell(DwellTime(control_).of_cycle(*block.pause));
  frames_.transforms().end();
  if (block.oneshot && !oneshots_.run()) return false;
  if (!dwells) {
    if (block.frame_code && !frames_.run()) return false;
    if (control_.dialect == Dialect::iso && !iso_.check_polar()) return false;
    if (!run_move()) return false;
    compensation_.end_block(moves_.waits());
  }
  index_.report_unused();
  return true;
}

}  // namespace mrsim
