// Jumps and calls that the statements of all controls share: where they lead, and whether they may.
#include "interp/statements/statements.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

bool Statements::jump_in_loop(const Place& to) {
  const auto state = [this](const VariableKey& key) { return variables_.state_of(key); };
  LoopWatch& watch = reader_.watch();
  if (to.line >= block_.line_number ||
      !watch.comes_back(reader_.depth(), variables_.levels(), to, state))
    return reader_.jump(to);
  const std::string names = variables_.names_of(watch.deciding());
  const std::string why =
      names.empty()
          ? "no condition in it leads out"
          : fmt::format("what its conditions ask for ({}) is the same in each pass", names);
  return fail(
      "program-endless",
      fmt::format("this loop never ends{}: {}",
                  reporter_.errors() > 0 ? ", behind an error that may be the cause" : "", why),
      0, 1);
}

bool Statements::jump_always(const Place& to) {
  if (decided_ || reader_.depth() > 1) return jump_in_loop(to);
  if (to.line + 1 >= block_.line_number) {
    jumped_over_.emplace_back(block_.line_number, to.line);
    return reader_.jump(to);
  }
  const auto over = std::find_if(jumped_over_.begin(), jumped_over_.end(), [&](const auto& part) {
    return part.first <= to.line && to.line < part.second;
  });
  if (over != jumped_over_.end()) {  // a part that has not run yet
    jumped_over_.erase(over);
    return reader_.jump(to);
  }
  reporter_.add(Severity::note, "program-loops",
                "the jump back starts the program again: simulated once", 0, 1);
  reader_.end_program();
  return true;
}

// False, and reported: a jump would reach a part of a structure that --block-skip leaves out.
bool Statements::is_whole(const FlowEntry& entry) {
  const ProgramOutline& all = places_.outline();
  for (int i = entry.first; i >= 0; i = all.entry(i).next) {
    const FlowEntry& part = all.entry(i);
    if (!skips_level(options_.block_skip, part.skip)) continue;
    reporter_.set_place(block_.file, part.at.line + 1, block_.call, {});
    return fail("structure",
                "--block-skip leaves out this part of a branch or loop, and not all of it",
                part.at.position, part.at.position + 1);
  }
  return true;
}

const FlowEntry* Statements::entry_at(std::size_t p) {
  const ProgramOutline& all = places_.outline();
  const Place here = reader_.place_at(p);
  const int i = all.find(here);
  if (const OutlineFault* wrong = all.fault_in(all.section_at(here))) {
    reporter_.set_place(block_.file, wrong->at.line + 1, block_.call, {});
    fail("structure", wrong->text, wrong->at.position, wrong->at.position + 1);
    return nullptr;
  }
  if (i >= 0) return is_whole(all.entry(i)) ? &all.entry(i) : nullptr;
  fail("structure", "this statement stands where the control does not look for it", p, p + 1);
  return nullptr;
}

bool Statements::jump_behind(const FlowEntry& entry) {
  Place to = entry.at;
  to.position = entry.behind;
  return reader_.jump(to);
}

bool Statements::jump_to_number(const Word& word, bool from_main) {
  Place to;
  reader_.leave_stretches();
  if (places_.find_number(static_cast<long>(word.value), true, true, to))
    return from_main ? jump_always(to) : reader_.jump(to);
  error("jump-target",
        fmt::format("there is no block N{:.0f} in this program (alarm 128)", word.value), word);
  reader_.stop();
  return false;
}

bool Statements::call_number(const Word& word, long repeats) {
  Place to;
  if (!places_.find_number(static_cast<long>(word.value), true, true, to))
    return error("jump-target",
                 fmt::format("there is no block N{:.0f} in this program", word.value), word);
  CallRequest request;
  request.file = reader_.file();
  request.begin = to;
  request.repeats = repeats;
  return reader_.enter(std::move(request), word);
}

bool Statements::call_at_block(const SubprogramName& name, const Word& block) {
  const auto program = reader_.locate(name, block);
  if (!program) return false;
  const long number = std::lround(block.value);
  CallRequest request;
  request.file = program->file;
  Place end;
  if (!places_.find_blocks(*program, number, number, request.begin, end))
    return error("jump-target", fmt::format("there is no block N{} in that program", number),
                 block);
  return reader_.enter(std::move(request), block);
}

}  // namespace mrsim
