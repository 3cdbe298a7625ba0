// SINUMERIK's calls of subprograms: with arguments, by a path, modal ones (MCALL) and texts that
// are run as a block (EXECSTRING). Private to src/interp.
#pragma once

#include "interp/statements/sinumerik_assignments.h"
#include "interp/statements/sinumerik_procedures.h"

#include <functional>
#include <vector>

namespace mrsim {

class SinumerikCalls : public SinumerikAssignments {
 public:
  bool has_modal_call() const override { return modal_call_.active; }
  bool call_modal(std::size_t places, const Approach& approach, const Word& word) override;
  void end_block(bool moved) override;
  bool call_program(const SubprogramName& name, long repeats, const Word& word) override;

 protected:
  SinumerikCalls(Control& control, BlockReader& reader);

  /// MCALL NAME(...), or MCALL alone, which ends it. `p` of this and the next three: behind the
  /// statement's word. False: an error was reported.
  bool modal_call(std::size_t p);
  /// EXECSTRING. `from` of this and the next two: where the statement begins.
  bool run_text(std::size_t from, std::size_t p);
  /// PCALL and a path.
  bool call_by_path(std::size_t from, std::size_t p);
  /// NAME(1, 2), or CALL and an expression.
  bool call_statement(std::size_t from, std::size_t p);
  /// The values between the brackets at `p`, which ends behind them. False: reported.
  bool arguments(std::size_t& p, std::vector<ProcedureArgument>& out);
  /// The main program's PROC, behind whose name `p` stands: its parameters get their values.
  void take_initial_values(std::size_t p) { procedures_.take_initial_values(block_.line, p); }

 private:
  struct ModalCall {
    bool active = false;
    SubprogramName name;
    std::vector<ProcedureArgument> arguments;
  };

  bool argument(std::size_t& p, ProcedureArgument& out);
  /// `before`: of a modal call, carried out before each run.
  bool call(const SubprogramName& name, const std::vector<ProcedureArgument>& arguments,
            long repeats, const Word& word, std::function<void()> before = {});

  SinumerikProcedures procedures_;
  ModalCall modal_call_;
  bool in_modal_call_ = false;
};

}  // namespace mrsim
