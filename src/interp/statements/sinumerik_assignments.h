// SINUMERIK's variables in blocks: assignments, DEF, DEFINE, files of definitions. Private to
// src/interp.
#pragma once

#include "interp/statements/statements.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

class SinumerikAssignments : public Statements {
 public:
  bool assignment(std::string_view line, std::size_t& p) override;

 protected:
  SinumerikAssignments(Control& control, BlockReader& reader);

  /// The name at `p` in capitals; `p` ends behind it.
  std::string name_at(std::size_t& p) const;
  bool end_statement(std::size_t p);
  bool indices(std::string_view line, std::size_t& p, std::vector<Value>& out);
  bool define(std::size_t p);
  bool define_macro(std::size_t p, bool everywhere);

 private:
  bool assign_all(std::string_view line, std::size_t& p, std::string_view name,
                  std::span<const Value> indices, std::size_t from, std::size_t to);
  bool fill(std::string_view line, std::size_t& p, std::string_view name,
            std::span<const Value> at_index, bool repeats, std::size_t from);
  bool definitions(std::size_t& p, bool global);
  std::string behind_attributes(std::size_t& p, bool& global);
  void read_definitions();
  bool define_one(std::size_t& p, VariableType type, std::size_t longest, bool global);
};

}  // namespace mrsim
