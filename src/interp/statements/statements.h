// The language of a control while a program runs: values of expressions, assignments, and
// statements that decide which block comes next. This class has what all controls share; a class
// for each control derives from it and has the statements of that control. Private to src/interp.
#pragma once

#include "interp/calls/block_reader.h"
#include "interp/language/variables.h"
#include "interp/statements/program_places.h"
#include "interp/statements/system_values.h"
#include "interp/text/language_reader.h"

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {

class Statements : public ControlPart, public LanguageReader {
 public:
  /// The language of this control; null: it has none here.
  static std::unique_ptr<Statements> make(Control& control, BlockReader& reader);

  Answer value(std::string_view line, std::size_t& p, Word& word, bool whole) override;
  bool assignment(std::string_view line, std::size_t& p) override;
  bool starts_function(std::string_view line, std::size_t p) const override;
  bool is_variable(std::string_view name) override { return variables_.is_defined(name); }

  /// Carries out the statement of the block. One that fails ends the program.
  void run();
  /// Called before the words of a block are looked at. True: the block is done with.
  virtual bool take_block() { return false; }
  /// M70 to M73 save and restore modes. False: reported.
  virtual bool saved_modes(int m, const Word& word);
  /// Called where the text of the main program ends without a word that ends it. False: reported.
  virtual bool end_of_main() { return true; }
  /// Whether MCALL of a program is in force.
  virtual bool has_modal_call() const { return false; }
  using Approach = std::function<void(std::size_t)>;  ///< goes to a place, by its number
  /// Runs the program of MCALL at so many places; `approach` goes to the place of its number.
  /// False: reported.
  virtual bool call_modal(std::size_t places, const Approach& approach, const Word& word);
  /// Called after a block of words. `moved`: it had a motion.
  virtual void end_block(bool moved) { (void)moved; }
  /// Calls a program by number or name without arguments. False: reported.
  virtual bool call_program(const SubprogramName& name, long repeats, const Word& word) {
    return reader_.call(name, repeats, word);
  }
  /// Calls a subprogram of the control's language without arguments, with the callbacks of
  /// `request`. False: reported.
  virtual bool call_sub(const std::string& name, CallRequest&& request, const Word& word);
  /// Sets who knows the data of the tool in the spindle.
  void set_tools(ToolChanger& tools) { system_.set_tools(tools); }
  /// The values of a call. `argument` is the text between its brackets, a part of the block's line.
  /// A value may be left out. False: reported.
  bool call_values(std::string_view argument, std::vector<std::optional<Value>>& out);
  /// The value of an expression that stands in no block. A fault is reported at `word`. False:
  /// reported.
  bool value_of(std::string_view expression, Value& out, const Word& word);
  /// The value of a numbered variable. False: it has no value, or a value that is no number.
  bool variable(double number, double& out);
  void set_variable(double number, double value);
  /// M99 P goes on at a block number of the program that is being read. False: reported.
  bool jump_to_number(const Word& word, bool from_main);
  /// M97 P calls the blocks from a block number on. False: reported.
  bool call_number(const Word& word, long repeats);
  /// Calls a subprogram from the block whose number is the value of `block`. False: reported.
  bool call_at_block(const SubprogramName& name, const Word& block);
  /// Tells at the end of the program which values of --set it has not read.
  void tell_unread_presets();
  /// Finds blocks, labels and programs.
  ProgramPlaces& places() { return places_; }

 protected:
  Statements(Control& control, BlockReader& reader, const ExpressionRules& rules,
             VariableForm variables, OutlineForm outline);

  /// Carries out the statement at `p` of block_.line. False: reported, or the program cannot go on.
  virtual bool statement(std::size_t p) = 0;

  bool fail(const char* code, const std::string& text, std::size_t from, std::size_t to);
  bool report(const Fault& fault);
  bool condition(std::size_t& p, bool& out);
  /// Jumps without a condition. A jump back in a main program that has asked for no value is one
  /// that starts the program again for the next part: it ends the program instead.
  bool jump_always(const Place& to);
  /// Jumps where variables alone decide whether the program comes back here. False: reported, as
  /// too many steps or a loop that never ends.
  bool jump_in_loop(const Place& to);
  bool number(std::size_t& p, double& out, bool whole);
  bool target_number(std::string_view line, std::size_t& p, double& out);
  /// Sets a local variable of the macro that a call begins.
  void set_argument(int number, double value);
  bool store(double number, const Value& value, std::size_t from, std::size_t to);
  bool store(std::string_view name, std::span<const Value> indices, const Value& value,
             std::size_t from, std::size_t to);

  /// The entry of the statement at `p`. Null: a fault of the structure, which is reported.
  const FlowEntry* entry_at(std::size_t p);
  bool is_whole(const FlowEntry& entry);
  bool jump_behind(const FlowEntry& entry);
  std::string letters(std::size_t& p) const { return letters_of(block_.line, p); }
  static std::string letters_of(std::string_view line, std::size_t& p);
  char at(std::size_t p) const { return p < block_.line.size() ? block_.line[p] : '\0'; }
  std::size_t skip_blanks(std::size_t p) const;
  Word place_word(std::size_t from, std::size_t to) const;

  BlockReader& reader_;
  SystemValues system_;
  Variables variables_;
  Evaluator evaluator_;
  ProgramPlaces places_;
  bool decided_ = false;  ///< the program has asked for a value that may change its way

 private:
  bool evaluate(std::string_view line, std::size_t& p, const Word& word, bool whole, Value& out);

  std::vector<std::pair<int, int>> jumped_over_;  ///< lines between which nothing has run yet
  std::deque<std::string> texts_;                 ///< texts to which words of the block point
};

}  // namespace mrsim
