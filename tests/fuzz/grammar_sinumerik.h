// SINUMERIK: variables, loops, marks, cycles and frames.
#pragma once

#include "grammar.h"

namespace mrsim::fuzz {

class Sinumerik : public Grammar {
 public:
  using Grammar::Grammar;

 private:
  void head() override {
    line(
        "DEF REAL AA=1, BB[3]\nDEF INT COUNT=0\nDEF FRAME FR\nDEF CHAR VC=\"B\"\n"
        "DEF STRING[9] VS=\"ABC\"\nDEFINE ASIDE AS G1 X5\nR1=1 R2=2 R3=0\nT1 D1 M6\nG0 X0 Y0 Z0 "
        "F100 S100");
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
        return line(one_of({"CYCLE72(\"KONTUR\",", "CYCLE95(\"KONTUR\",", "CYCLE93(", "CYCLE951(",
                            "CYCLE62(\"KONTUR\",0)\nCYCLE63(\"\",", "CYCLE92(",
                            "CYCLE62(\"KONTUR\",0)\nCYCLE952(\"\",\"\",\"\",", "CYCLE97(",
                            "CYCLE98(", "CYCLE99(", "CYCLE60(\"AB 7\","}) +
                    list(22) + ")");
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
    switch (pick(11)) {
      case 0:
        return line(one_of({"R1", "R2", "R3", "AA", "COUNT", "BB[2]", "$P_UIFR[1,X,TR]",
                            "$P_PFRAME[Y,TR]", "$TC_DP6[1,1]", "FR[X,TR]", "FR[Y,RT]", "FR[Z,SC]",
                            "FR[X,MI]", "VC", "$P_PFRAME[X,RT]"}) +
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
        line(fmt::format("IF {0} GOTOF MARK{1} IF {2} GOTOF MARK{1}", condition(), label,
                         condition()));
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
      case 9:
        return line(one_of({"BB=REP(2,2)", "BB[1]=SET(1,,3)", "VS=VS<<VC", "VS[0]=VC", "VC=VS[1]",
                            "$P_PFRAME=FR:CROT(X,30,Z,40)", "FR=$P_PFRAME:CMIRROR(X)", "ASIDE",
                            "MCALL HOLE(BB,R1)", "HOLE(BB,R2)", "HOLE(BB,BB[0])", "AWAY P2",
                            "EXECSTRING(\"R3=\"<<R1)", "EXECSTRING(\"IF R1<3 GOTOF DONE\")"}));
      default:
        return line(one_of({"CUTCONON", "CUTCONOF", "G500", "KONT", "NORM", "G64", "M17", "STOPRE",
                            "MSG(\"A\")", "SUPA G0 Z0", "G74 X1=0"}));
    }
  }
  void subprograms() override {
    line("DONE: M30\nE_LAB_A_KONTUR: G1 X0 Y0\nX10 Y0 Z-5\nX10 Y10\nE_LAB_E_KONTUR: X0");
    line(
        "%_N_HOLE_SPF\nPROC HOLE(VAR REAL AR[], VAR REAL AT) SAVE\nTRANS X=AR[0]\nZ=AT\nZ0\n"
        "AR[0]=AT\nAT=AT+1\nRET\n%_N_AWAY_SPF\nDEFINE ASIDE AS Y5\nASIDE\nR3=R3+1\n"
        "IF R3<9\nRET(\"DONE\",1)\nENDIF\nRET(,,2)");
  }

  int labels_ = 0;
};

}  // namespace mrsim::fuzz
