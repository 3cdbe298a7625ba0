// FANUC Macro B: IF, WHILE DO END, GOTO, and the macro calls G65, G66, G66.1, G67.
// Private to src/interp.
#pragma once

#include "interp/statements/statements.h"

#include <array>
#include <vector>

namespace mrsim {

class MacroStatements : public Statements {
 public:
  MacroStatements(Control& control, BlockReader& reader);

  bool starts_statement(std::string_view line, std::size_t p) override;
  bool take_block() override;
  void end_block(bool moved) override;
  bool call_program(const SubprogramName& name, long repeats, const Word& word) override;

 protected:
  bool statement(std::size_t p) override;
  std::size_t end_of_block(std::size_t p) const;

 private:
  /// Values of local variables by number.
  struct Arguments {
    std::array<double, Variables::kLocals> values{};
    std::uint64_t given = 0;  ///< a bit each
  };
  struct ModalCall {
    bool every_block = false;  ///< G66.1
    SubprogramName program;
    long repeats = 1;
    Arguments arguments;
  };

  bool if_statement(std::size_t p);
  bool while_statement(std::size_t at, std::size_t p);
  bool loop_end(std::size_t at);
  bool go_to(std::size_t p);
  bool collect(const Word* code, bool first, Arguments& out);
  bool call_macro(const SubprogramName& program, long repeats, const Arguments& arguments,
                  std::size_t modal, const Word& where);
  const ModalCall* modal_call(bool every_block) const;
  bool run_modal(const ModalCall& call, const Arguments& arguments);
  bool probing(long number, const Word& code);
  bool macro_call(const Word& code);

  std::vector<ModalCall> modal_calls_;       ///< G66 in G66: the last one runs
  std::vector<std::size_t> modal_in_macro_;  ///< of each macro under way: modal calls of its moves
};

}  // namespace mrsim
