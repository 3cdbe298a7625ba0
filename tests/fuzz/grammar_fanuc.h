// FANUC: Macro B, subprograms, cycles of mills and lathes.
#pragma once

#include "grammar.h"

namespace mrsim::fuzz {

class Fanuc : public Grammar {
 public:
  using Grammar::Grammar;

 private:
  void head() override { line("O1\n#1=1 #2=2 #3=0\nG0 X0 Y0 Z0\nG1 X1 F100"); }
  std::string variable() override { return "#" + std::to_string(1 + pick(3)); }
  std::string bracket(const std::string& text) override { return "[" + text + "]"; }
  std::string condition() {
    const std::string left = variable(), op = one_of({"LT", "GT", "EQ", "NE", "LE", "GE"});
    return "[" + left + " " + op + " " + number() + "]";
  }

  void cycle() override {
    switch (pick(6)) {
      case 0:
        return line(one_of({"G12", "G13"}) + words({"I", "K", "Q", "Z"}) + " D1 F9");
      case 1:
        return line(one_of({"G70", "G71", "G72"}) + words({"I", "J", "K"}) + " L4");
      case 2:
        return turning();
      case 3:
        return line("G1" + words({"X", "Y"}) + one_of({",R", ",C", ",A"}) + value());
      case 4:
        return line(one_of({"G74", "G75", "G76", "G90", "G92", "G94"}) +
                    words({"X", "Z", "U", "W", "P", "Q", "R", "F", "K", "D"}));
      default:
        return Grammar::cycle();
    }
  }
  void turning() {
    const int first = 100 + 10 * ++contours_;
    line(one_of({"G71", "G72"}) + " U1 W1 R.5");
    line(fmt::format("{} P{} Q{}", one_of({"G70", "G71", "G72", "G73"}), first, first + 5) +
         words({"U", "W"}));
    line(fmt::format("N{} G0", first) + words({"X", "Z"}));
    for (unsigned n = pick(5); n > 0; --n)
      line(one_of({"G1", "G2", "G3"}) + words({"X", "Z", "R", "U", "W"}));
    line(fmt::format("N{} G1", first + 5) + words({"X", "Z"}));
  }
  void special(int depth) override {
    switch (pick(8)) {
      case 0:
        return line(variable() + one_of({"=", "=", "=(A)", "(]=", ".5="}) + expression(0));
      case 1:
        return line("IF" + condition() + "THEN " + variable() + "=" + number());
      case 2:
        line(fmt::format("IF{}GOTO{}", condition(), ++labels_));
        statements(depth);
        return line(fmt::format("N{}", labels_));
      case 3:
        if (loops_ == 3) return;
        line(fmt::format("WHILE{}DO{}", condition(), ++loops_));
        line("#1=#1+1");
        statements(depth);
        return line(fmt::format("END{}", loops_--));
      case 4:
        return line(one_of({"M98 P100", "M98 P20100", "M98 P200 L2", "M97 P9", "G67", "M98 P200 Q5",
                            "M98 P200 H5", "M98 Q9", "#3000=1"}));
      case 5:
        return line(one_of({"G65 P200", "G65 P300 L2", "G66 P200", "G66.1 P200", "G65 P9810"}) +
                    words({"A", "B", "I", "J", "K", "I", "X"}));
      case 6:
        return line(
            one_of({"G68", "G51", "G51.1", "G52", "G92", "G16", "G10 L2 P1", "G10 L12 P1"}) +
            words({"X", "Y", "R", "P"}));
      default:
        return line(one_of({"G69", "G50", "G50.1 X0", "G15", "G52 X0 Y0", "G28 X0", "M99", "T1 M6",
                            "G49", "G44 H1", "X1 ELSE", "IF[1EQ2]THEN", "ELSE", "ENDIF"}));
    }
  }
  void subprograms() override {
    line("M30\nN9 G91 X1\nG90\nM99\nO100\nG1 X#1 Y#2\nM98 P200\nM99");
    line("O200\n#3=#3+1\nIF[#3 GT 50]GOTO5\nG1 X#24 Z#1\nM98 P100\nN5 M99");
    line("O300\nG66 P200 A#1\nG1 X1\nG67\n#1=#1+1\nX#1\nM99");
  }

  int labels_ = 1000, loops_ = 0, contours_ = 0;
};

}  // namespace mrsim::fuzz
