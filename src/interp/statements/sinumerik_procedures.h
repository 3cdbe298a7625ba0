// PROC of SINUMERIK: the parameters and options in a subprogram's first lines, and how the values
// of a call are bound to them. Private to src/interp.
#pragma once

#include "interp/calls/block_reader.h"
#include "interp/language/evaluator.h"
#include "interp/language/variables.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// The argument of a call for one parameter.
struct ProcedureArgument {
  std::optional<Value> value;
  std::string variable;                ///< if it is only a variable, its name ...
  std::vector<Value> indices;          ///< ... and the indices of the element
  std::optional<VariableArray> array;  ///< a whole array, which has no value
};

class SinumerikProcedures : public ControlPart {
 public:
  SinumerikProcedures(Control& control, Variables& variables, Evaluator& evaluator)
      : ControlPart(control), variables_(variables), evaluator_(evaluator) {}

  /// Makes the request set the parameters where the subprogram starts, and give back VAR parameters
  /// and saved modes where it ends. False: an error was reported at `word`.
  bool bind(const SubprogramPlace& place, const std::vector<ProcedureArgument>& given,
            const Word& word, CallRequest& request);
  /// Gives the parameters of a main program, which is not called, the values of its PROC. `p`
  /// stands behind PROC.
  void take_initial_values(std::string_view line, std::size_t p);

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
    bool has_header = false;  ///< it begins with PROC
    bool saves = false;       ///< SAVE: the modes of the caller come back
  };
  struct SavedState {
    Modal modal;
    Frames frames;
  };

  std::vector<Parameter> read_parameters(std::string_view line, std::size_t& p);
  struct Bound {
    Parameter parameter;
    ProcedureArgument argument;
    bool is_given = false;  ///< by the call; else the argument is the default
  };
  bool arguments_of(const SubprogramPlace& place, const Procedure& procedure,
                    const std::vector<ProcedureArgument>& given, const Word& word,
                    std::vector<Bound>& out);
  void define_parameters(const std::vector<Bound>& bound);
  std::vector<ProcedureArgument> values_back(const std::vector<Bound>& bound);
  Procedure read_procedure(const SubprogramPlace& place);
  void restore(const SavedState& saved);
  void give_back(const ProcedureArgument& to);

  Variables& variables_;
  Evaluator& evaluator_;
};

}  // namespace mrsim
