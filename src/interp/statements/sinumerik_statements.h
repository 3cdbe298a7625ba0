// SINUMERIK's language: IF, FOR, WHILE, LOOP, REPEAT, CASE, GOTO, DEF, PROC with parameters, MCALL,
// repeats of parts of a program. Private to src/interp.
#pragma once

#include "interp/statements/statements.h"

#include <optional>
#include <vector>

namespace mrsim {

class SinumerikStatements : public Statements {
 public:
  SinumerikStatements(Control& control, BlockReader& reader);

  bool assignment(std::string_view line, std::size_t& p) override;
  bool starts_statement(std::string_view line, std::size_t p) override;
  bool has_modal_call() const override { return modal_call_.active; }
  void end_block(bool moved) override;
  bool call_program(const SubprogramName& name, long repeats, const Word& word) override;

 protected:
  bool statement(std::size_t p) override;

 private:
  struct Parameter {
    VariableType type = VariableType::real;
    std::string name;
    bool by_reference = false;
    bool is_array = false;
    std::optional<Value> initial;
  };
  struct Procedure {
    std::vector<Parameter> parameters;
    bool saves = false;  ///< SAVE: the modes of the caller come back
  };
  struct Argument {
    std::optional<Value> value;
    std::string variable;                   ///< where it is nothing but a variable: its name ...
    std::vector<Value> indices;             ///< ... and the element of an array
    std::optional<Variables::Array> array;  ///< a whole array, which has no value
  };
  struct SavedState {
    Modal modal;
    Frames frames;
  };
  struct ModalCall {
    bool active = false;
    SubprogramName name;
    std::vector<Argument> arguments;
  };

  bool assign_all(std::string_view line, std::size_t& p, std::string_view name,
                  std::span<const Value> indices, std::size_t from, std::size_t to);
  bool fill(std::string_view line, std::size_t& p, std::string_view name,
            std::span<const Value> at_index, bool repeats, std::size_t from);
  bool indices(std::string_view line, std::size_t& p, std::vector<Value>& out);
  bool branch(std::size_t from, std::size_t p);
  bool next_jump(const std::string& word, std::size_t p);
  bool loop(const FlowEntry& entry, std::size_t p);
  bool for_loop(const FlowEntry& entry, std::size_t p, bool first);
  bool loop_end(const FlowEntry& entry, std::size_t p);
  bool go_to(const std::string& word, std::size_t p);
  bool find_target(const std::string& target, bool forward, bool backward, Place& to);
  bool go_back(std::size_t from, std::size_t p);
  bool case_of(std::size_t p);
  bool define(std::size_t p);
  bool definitions(std::size_t& p, bool global);
  bool define_macro(std::size_t p, bool everywhere);
  std::string behind_attributes(std::size_t& p, bool& global);
  void read_definitions();
  bool define_one(std::size_t& p, VariableType type, std::size_t longest, bool global);
  bool repeat_part(const std::string& word, std::size_t p);
  bool call_part(std::size_t p);
  bool run_part(const std::vector<std::string>& labels, bool line_alone, double runs,
                std::size_t from, std::size_t p);
  bool run_text(std::size_t from, std::size_t p);
  bool call_by_path(std::size_t from, std::size_t p);
  bool call_statement(std::size_t from, std::size_t p);
  bool modal_call(std::size_t p);
  bool arguments(std::size_t& p, std::vector<Argument>& out);
  bool call(const SubprogramName& name, const std::vector<Argument>& arguments, long repeats,
            const Word& word, bool modal = false);
  bool bind(const Procedure& procedure, const std::vector<Argument>& arguments, const Word& word,
            CallRequest& request);
  void restore(const SavedState& saved);
  void give_back(const Argument& to);
  bool argument(std::size_t& p, Argument& out);
  std::vector<Parameter> read_parameters(std::string_view line, std::size_t& p);
  void take_initial_values(std::size_t p);
  Procedure read_procedure(const SubprogramPlace& place);
  std::string name_at(std::size_t& p) const;
  bool end_statement(std::size_t p);

  ModalCall modal_call_;
  bool stepping_ = false;  ///< at a FOR, because its ENDFOR was reached
  bool in_modal_call_ = false;
};

}  // namespace mrsim
