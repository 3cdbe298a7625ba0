// LinuxCNC: O words.
#pragma once

#include "grammar.h"

namespace mrsim::fuzz {

class LinuxCnc : public Grammar {
 public:
  using Grammar::Grammar;

 private:
  void head() override {
    line(
        "o100 sub\n#3=[#3+1]\nG1 X#1 Y#2 F9\no101 if [#3 lt 9]\no100 call [1] [#3]\no101 endif\n"
        "o100 endsub [#3]\n#1=1\n#2=2\n#3=0\nG21 G90 F100");
  }
  std::string variable() override {
    return one_of({"#1", "#2", "#3", "#<a>", "#<_value>", "#5420"});
  }
  std::string bracket(const std::string& text) override { return "[" + text + "]"; }
  std::string condition() {
    return "[" + expression(2) + one_of({" lt ", " gt ", " eq ", " ne ", " and ", " or "}) +
           number() + "]";
  }
  void cycle() override {
    if (pick(3) != 0) return Grammar::cycle();
    line(one_of({"G5", "G5.1", "G5.2", "G5.3", "G33", "G33.1", "G76", "G43.1", "G43.2", "G43.2 H1",
                 "G10 L2 P1", "G10 L10 P1", "G92"}) +
         words({"X", "Y", "Z", "I", "J", "K", "P", "Q", "R", "L"}));
  }
  void special(int depth) override {
    const int o = 200 + ++labels_;
    switch (pick(6)) {
      case 0:
        return line(one_of({"#1", "#2", "#3", "#<a>"}) + " = " + bracket(expression(0)));
      case 1:
        line(fmt::format("o{} if {}", o, condition()));
        statements(depth);
        line(fmt::format("o{} else", o));
        statements(depth);
        return line(fmt::format("o{} endif", o));
      case 2:
        line(fmt::format("o{} repeat {}", o, bracket(number())));
        statements(depth);
        return line(fmt::format("o{} endrepeat", o));
      case 3:
        line(fmt::format("o{} while {}", o, condition()));
        line("#1=[#1+1]");
        statements(depth);
        line(fmt::format("o{} {}", o, one_of({"break", "continue"})));
        return line(fmt::format("o{} endwhile", o));
      case 4:
        return line("o100 call " + bracket(expression(0)) + " " + bracket(number()));
      default:
        return line(one_of({"G80", "G92.1", "G49", "G40", "G61", "G64 P.1", "M6 T1", "G7", "G8"}));
    }
  }
  void subprograms() override { line("M2"); }

  int labels_ = 0;
};

}  // namespace mrsim::fuzz
