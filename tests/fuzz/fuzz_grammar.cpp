// Bytes as choices in a grammar of NC programs: loops, calls, cycles and frames that are well
// formed, so that the control's language is reached and not only its parser. Budgets are low.
#include "interp_checks.h"

#include <cstdint>
#include <initializer_list>
#include <string>

#include <fmt/format.h>

namespace {

using namespace mrsim;
using namespace mrsim::fuzz;

constexpr int kDeepest = 4;               // statements inside one another
constexpr std::size_t kLongest = 40'000;  // characters

class Grammar {
 public:
  Grammar(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  virtual ~Grammar() = default;

  std::string program() {
    head();
    while (at_ < size_ && out_.size() < kLongest) statement(0);
    subprograms();
    return out_;
  }

 protected:
  virtual void head() = 0;
  virtual void subprograms() = 0;
  virtual void special(int depth) = 0;
  virtual std::string variable() = 0;
  virtual std::string bracket(const std::string& text) = 0;

  unsigned pick(unsigned n) { return at_ < size_ ? data_[at_++] % n : 0; }
  std::string one_of(std::initializer_list<const char*> list) {
    return list.begin()[pick(static_cast<unsigned>(list.size()))];
  }
  void line(const std::string& text) { out_ += text + "\n"; }
  std::string number() {
    return fmt::format("{:.4g}", (static_cast<int>(pick(201)) - 100) / (1.0 + pick(8)));
  }
  std::string expression(int depth) {
    const unsigned form = depth > 3 ? pick(2) : pick(6);
    if (form == 0) return number();
    if (form == 1) return variable();
    if (form == 2) return one_of({"SIN", "COS", "ABS", "SQRT"}) + bracket(expression(depth + 1));
    const std::string a = expression(depth + 1), b = expression(depth + 1);
    return bracket(a + one_of({"+", "-", "*", "/"}) + b);
  }
  virtual std::string value() { return pick(4) == 0 ? bracket(expression(0)) : number(); }
  std::string words(std::initializer_list<const char*> letters) {
    std::string text;
    for (const char* letter : letters)
      if (pick(2) == 0) text += " " + (letter + value());
    return text;
  }
  void statements(int depth) {
    for (unsigned n = pick(4); n > 0 && out_.size() < kLongest; --n) statement(depth + 1);
  }
  void statement(int depth) {
    switch (depth >= kDeepest ? pick(4) : pick(7)) {
      case 0:
        return line(one_of({"G0", "G1", "G1", ""}) + words({"X", "Y", "Z", "F"}));
      case 1:
        return line(one_of({"G2", "G3"}) + words({"X", "Y", "I", "J", "Z"}));
      case 2:
        return line(one_of({"G90", "G91", "G17", "G18", "G19", "G40", "G41 D1", "G42 D1", "G54",
                            "G55", "G20", "G21", "G94", "G95"}));
      case 3:
        return cycle();
      default:
        return special(depth);
    }
  }
  virtual void cycle() {
    line(one_of({"G73", "G81", "G82", "G83", "G84", "G85", "G86", "G89", "G80", "G98", "G99"}) +
         words({"X", "Y", "Z", "R", "Q", "P", "F"}));
  }

  std::string out_;

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

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
        return line(variable() + "=" + expression(0));
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
        return line(one_of({"M98 P100", "M98 P20100", "M98 P200 L2", "M97 P9", "G67"}));
      case 5:
        return line(one_of({"G65 P200", "G66 P200", "G66.1 P200", "G65 P9810"}) +
                    words({"A", "B", "I", "J", "K", "I", "X"}));
      case 6:
        return line(
            one_of({"G68", "G51", "G51.1", "G52", "G92", "G16", "G10 L2 P1", "G10 L12 P1"}) +
            words({"X", "Y", "R", "P"}));
      default:
        return line(
            one_of({"G69", "G50", "G50.1 X0", "G15", "G52 X0 Y0", "G28 X0", "M99", "T1 M6"}));
    }
  }
  void subprograms() override {
    line("M30\nN9 G91 X1\nG90\nM99\nO100\nG1 X#1 Y#2\nM98 P200\nM99");
    line("O200\n#3=#3+1\nIF[#3 GT 50]GOTO5\nG1 X#24 Z#1\nM98 P100\nN5 M99");
  }

  int labels_ = 1000, loops_ = 0, contours_ = 0;
};

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
    line(
        one_of({"G5", "G5.1", "G5.2", "G5.3", "G33", "G33.1", "G76", "G43.1", "G10 L2 P1", "G92"}) +
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

class Sinumerik : public Grammar {
 public:
  using Grammar::Grammar;

 private:
  void head() override {
    line("DEF REAL AA=1, BB[3]\nDEF INT COUNT=0\nR1=1 R2=2 R3=0\nT1 D1 M6\nG0 X0 Y0 Z0 F100 S100");
  }
  std::string variable() override { return one_of({"R1", "R2", "R3", "AA", "BB[1]", "$P_EP[X]"}); }
  std::string bracket(const std::string& text) override { return "(" + text + ")"; }
  std::string value() override { return "=" + (pick(3) == 0 ? expression(0) : number()); }
  std::string condition() {
    return variable() + one_of({"<", ">", "==", "<>", "<=", ">="}) + number();
  }

  void cycle() override {
    switch (pick(7)) {
      case 0:
        return line(one_of({"CYCLE81(", "CYCLE83(", "MCALL CYCLE82(", "HOLES1(", "HOLES2("}) +
                    list(14) + ")");
      case 1:
        return line(
            one_of({"POCKET1(", "POCKET3(", "POCKET4(", "SLOT1(", "SLOT2(", "LONGHOLE(", "CYCLE61(",
                    "CYCLE71(", "CYCLE76(", "CYCLE77(", "CYCLE90(", "CYCLE899("}) +
            list(24) + ")");
      case 2:
        return line(one_of({"CYCLE72(\"KONTUR\",", "CYCLE95(\"KONTUR\",", "CYCLE97("}) + list(18) +
                    ")");
      case 3:
        return line(one_of({"TRANS", "ATRANS", "ROT", "AROT", "SCALE", "ASCALE", "MIRROR"}) +
                    words({"X", "Y", "Z"}));
      case 4:
        return line("G1" + words({"X", "Y"}) + one_of({" RND=", " CHF=", " CHR=", " ANG="}) +
                    number());
      case 5:
        return line(one_of({"G2", "G3", "CIP"}) +
                    words({"X", "Y", "CR", "AR", "I1", "J1", "TURN"}));
      default:
        return line(one_of({"MCALL", "G110", "G111", "G1 AP=30 RP=5", "G33 Z-5 K1", "G4 F1",
                            "DIAMON", "G451", "G96 S100", "OFFN=1"}));
    }
  }
  std::string list(unsigned most) {
    std::string text;
    for (unsigned n = pick(most) + 1; n > 0; --n)
      text += (pick(4) == 0 ? "" : number()) + (n > 1 ? "," : "");
    return text;
  }
  void special(int depth) override {
    const int label = ++labels_;
    switch (pick(10)) {
      case 0:
        return line(one_of({"R1", "R2", "R3", "AA", "COUNT", "BB[2]", "$P_UIFR[1,X,TR]",
                            "$P_PFRAME[Y,TR]", "$TC_DP6[1,1]"}) +
                    "=" + expression(0));
      case 1:
        line("IF " + condition());
        statements(depth);
        line("ELSE");
        statements(depth);
        return line("ENDIF");
      case 2:
        line(fmt::format("FOR COUNT=0 TO {}", pick(4)));
        statements(depth);
        return line("ENDFOR");
      case 3:
        line(fmt::format("WHILE R1<{}", pick(12)));
        line("R1=R1+1");
        statements(depth);
        return line("ENDWHILE");
      case 4:
        line("REPEAT");
        line("R2=R2+1");
        statements(depth);
        return line(fmt::format("UNTIL R2>{}", pick(12)));
      case 5:
        line(fmt::format("IF {} GOTOF MARK{}", condition(), label));
        statements(depth);
        return line(fmt::format("MARK{}: R3=R3+1", label));
      case 6:
        line(fmt::format("PART{}: G91 X1", label));
        line(fmt::format("ENDP{}: G90", label));
        return line(fmt::format("REPEAT PART{0} ENDP{0} P={1}", label, pick(4)));
      case 7:
        return line(fmt::format("CASE {} OF 1 GOTOF DONE DEFAULT GOTOF DONE", variable()));
      case 8:
        return line("$P_UIFR[2]=CTRANS(X," + expression(0) + "):CROT(Z," + number() + ")");
      default:
        return line(one_of({"CUTCONON", "CUTCONOF", "G500", "KONT", "NORM", "G64", "M17", "STOPRE",
                            "MSG(\"A\")", "SUPA G0 Z0", "G74 X1=0"}));
    }
  }
  void subprograms() override {
    line("DONE: M30\nE_LAB_A_KONTUR: G1 X0 Y0\nX10 Y0 Z-5\nX10 Y10\nE_LAB_E_KONTUR: X0");
  }

  int labels_ = 0;
};

// Fagor: statements in brackets, blocks to repeat, subroutines behind the end.
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

// CODESYS: jumps by G20, counters, calls with arguments.
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

std::string program_of(Dialect dialect, const std::uint8_t* data, std::size_t size) {
  switch (dialect) {
    case Dialect::ngc:
      return LinuxCnc(data, size).program();
    case Dialect::sinumerik:
      return Sinumerik(data, size).program();
    case Dialect::iso:
      return Fagor(data, size).program();
    case Dialect::codesys:
      return Codesys(data, size).program();
    default:
      return Fanuc(data, size).program();
  }
}

// The first byte chooses the control; the highest values are those of the languages added last.
Dialect dialect_of(std::uint8_t choice) {
  if (choice >= 240) return Dialect::codesys;
  if (choice >= 224) return Dialect::iso;
  if (choice >= 200) return Dialect::sinumerik;
  return choice % 3 == 0 ? Dialect::ngc : Dialect::fanuc;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2 || size > 4096) return 0;
  const Dialect dialect = dialect_of(data[0]);
  write_program(program_of(dialect, data + 1, size - 1));
  const int machine = data[0] % 2 == 0 ? 0 : 5;
  InterpOptions options = options_of(static_cast<int>(dialect) - 1 + machine);
  options.require_tools = false;
  options.max_steps = 100'000;
  read_program(options);
  return 0;
}
