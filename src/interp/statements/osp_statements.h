// What Okuma's OSP adds to the macros of FANUC: CALL, MODIN, MODOUT, RTS, IF [ ] NAME, GOTO NAME,
// and variables by name: all programs share VC1 and V1, others belong to one program. Private to
// src/interp.
#pragma once

#include "interp/statements/macro_statements.h"

#include <string>
#include <utility>
#include <vector>

namespace mrsim {

class OspStatements : public MacroStatements {
 public:
  using MacroStatements::MacroStatements;

  bool starts_statement(std::string_view line, std::size_t p) override;
  bool assignment(std::string_view line, std::size_t& p) override;
  void end_block(bool moved) override;

 protected:
  bool statement(std::size_t p) override;

 private:
  void note_picture(std::size_t from);
  bool bracketed(std::size_t& p, bool& holds);
  /// A program, how often it runs, and the local variables that it begins with.
  struct Call {
    SubprogramName program;
    long repeats = 1;
    std::vector<std::pair<std::string, double>> arguments;
    Word place;
  };

  bool read_call(std::size_t p, Call& out);
  bool argument(std::size_t& p, Call& out);
  bool enter(const Call& call, bool modal = false);
  std::optional<std::size_t> named_target(std::size_t p) const;
  bool jump(std::size_t p, bool taken);
  bool set(std::string_view name, const Value& value, std::size_t from, std::size_t to);

  std::optional<Call> modal_;  ///< the program of MODIN
  int calls_ = 0;              ///< how many calls are running
  bool runs_modal_ = false;    ///< the program of MODIN is running
};

}  // namespace mrsim
