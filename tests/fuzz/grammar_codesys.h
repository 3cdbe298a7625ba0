// CODESYS: jumps by G20, counters, calls with arguments.
#pragma once

#include "grammar.h"

namespace mrsim::fuzz {

class Codesys : public Grammar {
 public:
  using Grammar::Grammar;

 private:
  void head() override {
    line("LET #A : LREAL\nLET #S : STRING\nN1 G36 O$x$ D2\nN2 G0 X0 Y0 Z0\nN3 G1 X1 F100");
  }
  std::string variable() override { return one_of({"#A", "$x$", "$y$", "pi"}); }
  std::string bracket(const std::string& text) override { return "{" + text + "}"; }
  void cycle() override {
    line(one_of({"G16", "G15", "G98", "G99", "G55", "G2", "G3", "G51", "G92", "G9"}) +
         words({"X", "Y", "Z", "I", "J", "K", "R"}) + one_of({"", " T90", " D1"}));
  }
  void special(int depth) override {
    const unsigned n = ++numbers_ * 10;
    switch (pick(8)) {
      case 0:
        return line("G36 O$x$ D" + bracket(expression(0)));
      case 1:
        line(fmt::format("N{} G36 O$n{}$ D{}\nN{} G91", n, n, pick(5), n + 1));
        statements(depth);
        line(fmt::format("N{} G37 O$n{}$ D-1", n + 2, n));
        return line(fmt::format("N{} G20 L{} K$n{}$ > 0", n + 3, n + 1, n));
      case 2:
        line(fmt::format("N{} G20 L?{} K$x$ < 3", n, n));
        statements(depth);
        return line(fmt::format("N{} X1 L!{}", n + 1, n));
      case 3:
        return line("Part{" + expression(1) + ", " + one_of({"'a'", "#S", "1"}) + "}");
      case 4:
        return line("DYNCALL{concat{'Pa', 'rt'}, " + number() + ", 'b'}");
      case 5:
        return line("G37 D" + number() + one_of({"", "\nG20 L1", " O#A", " O$s$"}));
      case 6:
        return line("N5 G1 X" + expression(0) + one_of({"", " + 1", " MOD 3", " * sin 2"}));
      default:
        return line(one_of({"N10 RETURN", "LET #B : BOOL", "G36 O#S D'text'", "G38 D1", "Part{}",
                            "G20 L99999", "G36 O$x$", "X$", "Y{1", "G2 I1 T720"}));
    }
  }
  void subprograms() override {
    line("SUBPROGRAM Part{#A : LREAL, #T : STRING}\nN1 G1 X#A\nN2 Part{#A+1, #T}\nEND_SUBPROGRAM");
  }

  unsigned numbers_ = 0;
};

}  // namespace mrsim::fuzz
