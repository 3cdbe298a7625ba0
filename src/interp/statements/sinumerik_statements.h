// SINUMERIK's statements: which one a block holds; IF, FOR, WHILE, LOOP, REPEAT, CASE, GOTO, RET,
// and repeats of parts of a program. Private to src/interp.
#pragma once

#include "interp/statements/cycle_files.h"
#include "interp/statements/sinumerik_calls.h"

#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

class SinumerikStatements : public SinumerikCalls {
 public:
  SinumerikStatements(Control& control, BlockReader& reader)
      : SinumerikCalls(control, reader), cycle_files_(control, reader) {}

  bool starts_statement(std::string_view line, std::size_t p) override;

 protected:
  bool statement(std::size_t p) override;

 private:
  bool asked(std::size_t& p, bool& holds);
  bool branch(std::size_t from, std::size_t p);
  bool jump_if(bool holds, const std::string& word, std::size_t p);
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

  CycleFiles cycle_files_;
  bool stepping_ = false;  ///< the program is at a FOR again, because it reached ENDFOR
};

}  // namespace mrsim
