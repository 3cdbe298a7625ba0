// Fagor: statements in brackets, blocks to repeat, subroutines behind the end.
#pragma once

#include "grammar.h"

namespace mrsim::fuzz {

class Fagor : public Grammar {
 public:
  using Grammar::Grammar;

 private:
  void head() override { line("(P0=1, P1=2, P2=3)\nG0 X0 Y0 Z0\nG1 X1 F100"); }
  std::string variable() override { return one_of({"P0", "P1", "P2", "P7", "P100"}); }
  std::string bracket(const std::string& text) override { return "(" + text + ")"; }
  std::string condition() {
    const std::string a = expression(1);
    return a + one_of({" EQ ", " NE ", " GT ", " LE ", " AND ", " OR "}) + expression(1);
  }
  void cycle() override {
    if (pick(2) == 0) return Grammar::cycle();
    line(one_of({"G81", "G83", "G98", "G99", "G2", "G3", "G92"}) +
         words({"X", "Y", "Z", "I", "J", "K", "R"}) + one_of({"", " T90", " D1"}));
  }
  void special(int depth) override {
    const unsigned n = ++numbers_ * 10;
    switch (pick(8)) {
      case 0:
        line("(" + variable() + "=" + expression(0) + ")");
        return;
      case 1:
        line(fmt::format("N{} (P100=0)\nN{} X(P100)", n, n + 1));
        statements(depth);
        line(fmt::format("(P100=P100+1)\n(IF P100 LT {} GOTO N{})", pick(5), n + 1));
        return;
      case 2:
        line(fmt::format("N{} G91 X1\nN{} G90 YP1", n, n + 1));
        return line(fmt::format("(RPT N{},N{}) N{}", n, n + 1, pick(4)));
      case 3:
        return line("(IF " + condition() + " P1=" + number() + " ELSE CALL 2)");
      case 4:
        return line("(PCALL 1, A" + number() + ", P1=" + expression(1) + ", C" + bracket("1+P2") +
                    ")");
      case 5:
        return line(one_of({"(MCALL 1, B2)", "(MDOFF)", "(CALL 2)", "(GOTO N10)", "(RET)"}));
      case 6:
        return statements(depth);
      default:
        return line(one_of({"(SUB 9)", "M98 P1", "(EXEC P1)", "G68 R30", "G52 X1", "XSIN 30",
                            "(P1=NOT P1)", "(P2=ARG(P1,2))", "(RPT N10,N11)"}));
    }
  }
  void subprograms() override {
    line("M30\n(SUB 1)\nG1 XP0 YP1\n(CALL 2)\n(RET)\n(SUB 2)\n(P1=P1+1)\nZ-P1\n(RET)");
  }

  unsigned numbers_ = 0;
};

}  // namespace mrsim::fuzz
