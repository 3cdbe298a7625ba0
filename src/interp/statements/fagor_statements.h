// The language of the ISO family (Fagor 8055): P parameters, and statements in brackets: IF, GOTO,
// RPT, CALL, PCALL, MCALL. Private to src/interp.
#pragma once

#include "interp/statements/statements.h"

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {

class FagorStatements : public Statements {
 public:
  FagorStatements(Control& control, BlockReader& reader);

  bool starts_statement(std::string_view line, std::size_t p) override;
  void end_block(bool moved) override;

 protected:
  bool statement(std::size_t p) override;

 private:
  enum class CallKind : std::uint8_t { plain, own_parameters, modal };
  /// Values of local parameters by number.
  using Arguments = std::vector<std::pair<int, double>>;
  struct ModalCall {
    bool active = false;
    long subprogram = 0;
    Arguments arguments;
    Word place;
  };

  bool action(std::size_t p);
  bool if_statement(std::size_t p);
  bool assignments(std::size_t p);
  bool go_to(std::size_t p);
  bool repeat_part(std::size_t p);
  bool call_statement(const std::string& word, std::size_t p);
  bool arguments(std::size_t& p, Arguments& out);
  bool call(long subprogram, CallKind kind, const Arguments& arguments, const Word& where);
  bool go_back(std::size_t p);
  bool label(std::size_t& p, Place& out);
  bool ends_here(std::size_t p);
  bool finish(std::size_t behind);
  bool end_action(std::size_t p) { return ends_here(p) && finish(close_ + 1); }
  std::size_t else_at(std::size_t p) const;

  std::size_t close_ = 0;  ///< the bracket that closes the statement
  std::size_t end_ = 0;    ///< where the action that is being read must end
  std::set<long> unique_;  ///< block numbers that stand only once in the file
  ModalCall modal_call_;
  bool in_modal_call_ = false;
};

}  // namespace mrsim
