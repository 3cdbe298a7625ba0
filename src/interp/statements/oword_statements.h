// LinuxCNC's O words: sub, call, return, if, while, do, repeat, break, continue, and its
// assignments, which hold from the next block on. Private to src/interp.
#pragma once

#include "interp/statements/statements.h"
#include "interp/words/saved_modes.h"

#include <array>
#include <vector>

namespace mrsim {

class OwordStatements : public Statements {
 public:
  OwordStatements(Control& control, BlockReader& reader);

  bool assignment(std::string_view line, std::size_t& p) override;
  bool starts_statement(std::string_view line, std::size_t p) override;
  bool take_block() override;
  bool end_of_main() override;
  bool saved_modes(int m, const Word& word) override {
    return saved_modes_.run(m, reader_.depth(), word);
  }
  bool call_program(const SubprogramName& name, long repeats, const Word& word) override;
  bool call_sub(const std::string& name, CallRequest&& request, const Word& word) override;

 protected:
  bool statement(std::size_t p) override;

 private:
  /// An assignment, which takes effect at the end of its block.
  struct Pending {
    bool named = false;
    double number = 0;
    std::string name;
    Value value;
    std::size_t from = 0, to = 0;
  };

  void commit();
  void message(std::string_view comment);
  static Place past(const FlowEntry& entry);
  bool jump_past(const FlowEntry& entry) { return reader_.jump(past(entry)); }
  bool oword(const FlowEntry& entry, std::size_t p);
  bool branch(const FlowEntry& entry, std::size_t p);
  bool loop(const FlowEntry& entry, std::size_t p);
  bool loop_again(const FlowEntry& entry);
  long& passes_left(int entry) {
    return repeats_[{static_cast<int>(variables_.levels()), block_.file, entry}];
  }
  bool call(const std::string& name, std::size_t from, std::size_t p);
  bool enter_sub(const std::string& name, CallRequest request, std::vector<double> arguments,
                 const Word& word);
  bool locate_in(const std::string& file, const std::string& name, CallRequest& request,
                 const Word& word);
  bool locate(const std::string& name, CallRequest& request, const Word& word);
  bool leave(std::size_t p, bool required);
  bool values(std::size_t p, std::vector<double>& out);
  std::size_t end_of_line(std::size_t p) const;
  bool ends_line(std::size_t& p);

  SavedModes saved_modes_;
  std::vector<Pending> pending_;
  bool titled_ = false;  ///< the main program begins with a bare O word
  bool has_owords_ = false;
  bool arriving_ = false;  ///< at an elseif, because the conditions before it are false
  std::map<std::array<int, 3>, long> repeats_;  ///< passes that are left, by level, file and entry
};

}  // namespace mrsim
