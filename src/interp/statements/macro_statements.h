// FANUC Macro B: IF, WHILE DO END, GOTO, and the macro calls G65, G66, G66.1, G67.
// Private to src/interp.
#pragma once

#include "interp/statements/statements.h"

#include <array>
#include <memory>
#include <optional>
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
  /// Where the block that holds `p` ends.
  std::size_t end_of_block(std::size_t p) const;

 private:
  /// Values of local variables by number.
  struct Arguments {
    std::array<double, Variables::kLocals> values{};
    std::uint64_t given = 0;  ///< a bit for each variable that is given
  };
  /// Local variables at the end of a run, with which the next run of the same command begins.
  using Kept = std::shared_ptr<std::optional<Variables::Locals>>;
  struct ModalCall {
    bool every_block = false;  ///< G66.1
    SubprogramName program;
    long repeats = 1;
    Arguments arguments;
    Kept locals;
  };
  /// A macro that is running.
  struct MacroLevel {
    std::size_t modal = 0;  ///< how many of the modal calls before it its moves call
    std::size_t base = 0;   ///< how many modal calls there were before it
    bool simple = false;    ///< called by G65
  };

  std::size_t else_at(std::size_t p) const;
  bool if_statement(std::size_t from, std::size_t p);
  bool branch(std::size_t from, std::optional<bool> holds);
  bool while_statement(std::size_t at, std::size_t p);
  bool loop_end(std::size_t at);
  bool go_to(std::size_t p, bool taken);
  double argument_value(const Word& word) const;
  bool collect(const Word* code, Arguments& out);
  bool number_leads();
  bool stopped_by_alarm();
  bool no_argument(const Word& word, bool simple);
  bool call_macro(const SubprogramName& program, long repeats, const Arguments& arguments,
                  const Kept& kept, const MacroLevel& level, const Word& where);
  std::size_t modal_count() const;
  bool is_modal_unclear() const;
  const ModalCall* modal_call(bool every_block) const;
  bool run_modal(const ModalCall& call, const Arguments& arguments);
  bool probing(long number, const Word& code);
  bool macro_call(const Word& code);

  bool arriving_ = false;  ///< at an ELSEIF, because the conditions before it are false
  std::vector<ModalCall> modal_calls_;  ///< of G66 inside of G66 the last one runs
  std::vector<MacroLevel> levels_;
};

}  // namespace mrsim
