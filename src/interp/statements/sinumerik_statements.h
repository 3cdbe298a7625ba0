// SINUMERIK's language: IF, FOR, WHILE, LOOP, REPEAT, CASE, GOTO, calls with arguments, MCALL,
// repeats of parts of a program. Private to src/interp.
#pragma once

#include "interp/statements/sinumerik_assignments.h"
#include "interp/statements/sinumerik_procedures.h"

#include <vector>

namespace mrsim {

class SinumerikStatements : public SinumerikAssignments {
 public:
  SinumerikStatements(Control& control, BlockReader& reader);

  bool starts_statement(std::string_view line, std::size_t p) override;
  bool has_modal_call() const override { return modal_call_.active; }
  void end_block(bool moved) override;
  bool call_program(const SubprogramName& name, long repeats, const Word& word) override;

 protected:
  bool statement(std::size_t p) override;

 private:
  struct ModalCall {
    bool active = false;
    SubprogramName name;
    std::vector<ProcedureArgument> arguments;
  };

  bool branch(std::size_t from, std::size_t p);
  bool next_jump(const std::string& word, std::size_t p);
  bool loop(const FlowEntry& entry, std::size_t p);
  bool for_loop(const FlowEntry& entry, std::size_t p, bool first);
  bool loop_end(const FlowEntry& entry, std::size_t p);
  bool go_to(const std::string& word, std::size_t p);
  bool find_target(const std::string& target, bool forward, bool backward, Place& to);
  bool go_back(std::size_t from, std::size_t p);
  bool case_of(std::size_t p);
  bool repeat_part(const std::string& word, std::size_t p);
  bool call_part(std::size_t p);
  bool run_part(const std::vector<std::string>& labels, bool line_alone, double runs,
                std::size_t from, std::size_t p);
  bool run_text(std::size_t from, std::size_t p);
  bool call_by_path(std::size_t from, std::size_t p);
  bool call_statement(std::size_t from, std::size_t p);
  bool modal_call(std::size_t p);
  bool arguments(std::size_t& p, std::vector<ProcedureArgument>& out);
  bool call(const SubprogramName& name, const std::vector<ProcedureArgument>& arguments,
            long repeats, const Word& word, bool modal = false);
  bool argument(std::size_t& p, ProcedureArgument& out);

  SinumerikProcedures procedures_;
  ModalCall modal_call_;
  bool stepping_ = false;  ///< at a FOR, because its ENDFOR was reached
  bool in_modal_call_ = false;
};

}  // namespace mrsim
