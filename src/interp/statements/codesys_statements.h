// The language of CODESYS SoftMotion: variables #NAME and $NAME$, LET, calls with arguments, and
// the jumps and assignments G20, G36 and G37. Private to src/interp.
#pragma once

#include "interp/statements/statements.h"

#include <map>
#include <string>
#include <vector>

namespace mrsim {

class CodesysStatements : public Statements {
 public:
  CodesysStatements(Control& control, BlockReader& reader);

  bool starts_statement(std::string_view line, std::size_t p) override;
  bool assignment(std::string_view line, std::size_t& p) override;
  bool starts_function(std::string_view line, std::size_t p) const override;
  bool call_program(const SubprogramName& name, long repeats, const Word& word) override;

 protected:
  bool statement(std::size_t p) override;

 private:
  /// A formal parameter of a subprogram.
  struct Formal {
    std::string name;
    VariableType type = VariableType::real;
  };

  bool jump(std::size_t p);
  bool write(bool adds, std::size_t p);
  bool change(std::string_view target, bool adds, const Value& value, std::size_t from,
              std::size_t to);
  bool define(std::size_t p);
  bool call_statement(std::size_t from);
  bool call(const SubprogramName& name, const std::vector<Value>& given, const Word& where);
  bool formals(const SubprogramPlace& place, const Word& where, std::vector<Formal>& out);
  bool find_label(long index, Place& out);
  std::size_t behind_comments(std::size_t p) const;
  bool end_statement(std::size_t p);

  double counter_ = -1;  ///< the decoder's variable, for G20 G36 G37 without a name
  std::map<std::pair<std::uint64_t, long>, std::pair<bool, Place>>
      labels_;  ///< labels that were looked up before
};

}  // namespace mrsim
