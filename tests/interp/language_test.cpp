// Variables, loops and subprograms: a program with loops moves like the same program written out.
#include "interp/path_of.h"
#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(Language, JumpsBackWithoutAConditionAreTheNextPart) {
  const std::pair<Dialect, const char*> rows[] = {
      {Dialect::fanuc, "N1 G1 X1 F1\n#501=5\nX2\nGOTO1\nM30\n"},
      {Dialect::fanuc, "N1 G1 X1 F1\nX2\nM99 P1\n"},
      {Dialect::sinumerik, "START:\nG1 X1 F1\nX2\nGOTOB START\nM30\n"}};
  for (const auto& [dialect, text] : rows) {
    const Program p = read_text(text, at_origin(dialect));
    EXPECT_EQ(path_of(p), "1,0,0 2,0,0 ") << text;
    EXPECT_EQ(codes(p), "");
    EXPECT_EQ(codes(p, Severity::note), "program-loops");
  }
  EXPECT_EQ(run(Dialect::fanuc, "G1 X1 F1\nGOTO3\nN2 X3\nGOTO4\nN3 X2\nGOTO2\nN4 X4\nM30\n"),
            "1,0,0 2,0,0 3,0,0 4,0,0 ")
      << "back to what has not run yet";
  EXPECT_EQ(run(Dialect::fanuc, "#1=0\nN1 G1 X#1 F1\n#1=#1+1\nIF[#1GT2]GOTO9\nGOTO1\nN9 M30\n"),
            "1,0,0 2,0,0 ");
}

TEST(Language, EndlessProgramsEnd) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.max_steps = 20000;
  EXPECT_EQ(codes(read_text("G1 X1 F1\nM98 P7 L9999\nM30\nO7\nM98 P8 L9999\nM99\nO8\nX1\nM99\n",
                            options)),
            "program-endless");
  EXPECT_EQ(codes(read_text("G1 X1 F1\nN1 GOTO 1\n", options)), "program-endless");
  EXPECT_EQ(codes(read_text("G1 X1 F1\nG65 P7\nM30\nO7\nG65 P7\nM99\n", options)),
            "subprogram-depth");
  options.dialect = Dialect::ngc;
  EXPECT_EQ(codes(read_text("G1 X1 F1\no1 while [1]\no1 endwhile\nM2\n", options)),
            "program-endless");
  options.dialect = Dialect::sinumerik;
  EXPECT_EQ(codes(read_text("G1 X1 F1\nLOOP\nENDLOOP\nM30\n", options)), "program-endless");
}

// Of the programs that never end, as many motions as the first watch takes.
TEST(Language, LoopsThatNothingCanEndAreToldSoon) {
  const struct {
    Dialect dialect;
    const char* text;
    const char* asked;
  } cases[] = {
      {Dialect::fanuc, "G1 X1 F1\nWHILE[1EQ1]DO1\nX0\nX1\nEND1\nM30\n", "leads out"},
      {Dialect::fanuc, "#1=0\n#2=0\nWHILE[#1LT9]DO1\nG1 X#2 F1\n#2=#2+.001\nEND1\nM30\n", "(#1)"},
      {Dialect::fanuc, "#1=0\nN1 G91 G1 X1 F1\nIF[#1LT9]GOTO1\nM30\n", "(#1)"},
      {Dialect::fanuc,
       "#1=0\nWHILE[#1EQ0]DO1\n#3=0\nWHILE[#3LT5]DO2\nG1 X#3 F1\n#3=#3+1\nEND2\nEND1\nM30\n",
       "(#1, #3)"},
      {Dialect::fanuc,
       "#1=0\n#2=0\nWHILE[#1EQ0]DO1\nM98 P7\n#2=#2+1\nG65 P8 X#2\nEND1\nM30\n"
       "O7\n#3=0\nWHILE[#3LT5]DO2\n#3=#3+1\nEND2\nM99\nO8\nG1 X#24 F1\nM99\n",
       "(#1, #3)"},
      {Dialect::ngc, "F1\no1 while [1]\nG1 X1\nX2\no1 endwhile\nM2\n", "leads out"},
      {Dialect::ngc,
       "F1\n#<a> = 1\no1 do\no2 repeat [3]\nG1 X[#<a>]\no2 endrepeat\no1 while [#<a> GT 0]\nM2\n",
       "(#<A>)"},
      {Dialect::sinumerik, "R1=1 R2=0\nG1 F1\nWHILE R1==1\nX=R2\nR2=R2+0.001\nENDWHILE\nM30\n",
       "(R1)"},
      {Dialect::sinumerik, "G1 F1\nLOOP\nX1\nX2\nENDLOOP\nM30\n", "leads out"},
      {Dialect::codesys, "N1 G36 O$a$ D1\nN2 G1 X1 F100\nN3 G1 X0\nN4 G20 L2 K$a$\n", "($A$)"},
      {Dialect::iso, "G1 F100 X1\n(P1=1)\nN10 X2\nX3\n(IF P1 EQ 1 GOTO N10)\nM30\n", "(P1)"},
  };
  for (const auto& one : cases) {
    SCOPED_TRACE(one.text);
    const Program p = read_text(one.text, at_origin(one.dialect));
    EXPECT_EQ(codes(p), "program-endless");
    ASSERT_FALSE(p.diagnostics.empty());
    EXPECT_NE(p.diagnostics.back().text.find(one.asked), std::string::npos)
        << p.diagnostics.back().text;
    EXPECT_LT(p.motions.size(), 100'000U);
  }
}

// What ends these loops is hidden: behind other variables, names, calls and counts of passes.
TEST(Language, LongLoopsThatEndAreRun) {
  const struct {
    Dialect dialect;
    const char* text;
    std::size_t motions;
  } cases[] = {
      {Dialect::fanuc, "#1=0\nWHILE[#1LT15000]DO1\nG1 X#1 F1\n#1=#1+1\nEND1\nM30\n", 14'999},
      {Dialect::fanuc,
       "#1=0\n#2=0\n#3=0\nWHILE[#1LT15000]DO1\nG91 G1 X1 F1\n#3=#3+1\n#2=#3\n#1=#2\nEND1\nM30\n",
       15'000},
      {Dialect::fanuc, "#1=0\n#3=1\nWHILE[#1LT15000]DO1\nG91 G1 X1 F1\n#[#3]=#[#3]+1\nEND1\nM30\n",
       15'000},
      {Dialect::fanuc,
       "#100=0\n#101=0\nWHILE[#100LT15000]DO1\nG65 P8 A#101\nEND1\nM30\n"
       "O8\nG91 G1 X1 F1\n#101=#1+1\n#100=#101\nM99\n",
       15'000},
      {Dialect::fanuc, "#100=0\nWHILE[#5041LT15000]DO1\nG91 G1 X1 F1\nEND1\nM30\n", 15'000},
      {Dialect::fanuc,
       "M98 P7 L3000\nM30\nO7\n#3=0\nWHILE[#3LT5]DO2\n#3=#3+1\nG91 G1 X1 F1\nEND2\nM99\n", 15'000},
      {Dialect::fanuc,
       "G65 P7 L3000\nM30\nO7\n#3=0\nN2 #3=#3+1\nG91 G1 X1 F1\nIF[#3LT5]GOTO2\nM99\n", 15'000},
      {Dialect::ngc,
       "F1\no1 repeat [3000]\n#1=0\no2 while [#1 LT 5]\nG91 G1 X1\n#1=[#1+1]\no2 endwhile\n"
       "o1 endrepeat\nM2\n",
       15'000},
      {Dialect::codesys,
       "N1 G36 D15000\nN2 G91 G1 X1 F100\nN3 G37 D-1\nN4 G20 L2\nN5 G36 O$a$ D15000\n"
       "N6 G1 X1\nN7 G37 O$a$ D-1\nN8 G20 L6 K$a$\n",
       30'000},
      {Dialect::sinumerik, "G1 F1\nFOR R1=1 TO 15000\nX=IC(1)\nENDFOR\nM30\n", 15'000},
      {Dialect::sinumerik,
       "G1 F1\nAA: R1=0\nWHILE R1<5\nX=IC(1)\nR1=R1+1\nENDWHILE\nENDLABEL:\n"
       "REPEAT AA P=2999\nM30\n",
       15'000},
      // the number of the variable that is set
      {Dialect::sinumerik,
       "R1=30000 R2=0\nWHILE R2==0\nR[R1]=1\nR1=R1-1\nENDWHILE\nG1 F1 X1\nM30\n", 1},
      {Dialect::fanuc,
       "#100=0\n#1=999\nWHILE[#100EQ0]DO1\nIF[#1EQ399]THEN #1=199\n#3=0\nWHILE[#3LT30]DO2\n"
       "#3=#3+1\nEND2\n#[#1]=1\n#1=#1-1\nEND1\nG1 X1 F1\nM30\n",
       1},
      {Dialect::ngc,
       "#4000=0\n#1=31\no1 while [#4000 EQ 0]\n#[#1]=1\n#1=[#1+1]\n#2=0\no2 while [#2 LT 20]\n"
       "#2=[#2+1]\no2 endwhile\no1 endwhile\nG1 X1 F1\nM2\n",
       1},
      // the arguments of G66, an argument that is vacant, and a vacant word under G66
      {Dialect::fanuc,
       "#100=0\n#1=0\nWHILE[#100LT1]DO1\n#1=#1+1\nG66 P8 A#1\nG0 X1\nG67\nEND1\nG1 X0 F1\nM30\n"
       "O8\n#100=FIX[#1/20000]\nM99\n",
       2},
      {Dialect::fanuc,
       "#100=0\n#500=#0\n#501=1\n#1=0\nWHILE[#100LT1]DO1\n#1=#1+1\n"
       "G65 P8 A#[500+FIX[#1/20000]]\nEND1\nG1 X1 F1\nM30\n"
       "O8\nIF[#1EQ#0]GOTO20\n#100=1\nN20 M99\n",
       1},
      {Dialect::fanuc,
       "#100=0\n#500=#0\n#501=1\n#1=0\nG66 P8\nWHILE[#100LT1]DO1\n#1=#1+1\n"
       "G0 X#[500+FIX[#1/20000]]\nEND1\nG67\nG1 X0 F1\nM30\nO8\n#100=1\nM99\n",
       2},
      // arrays that PROC gives back
      {Dialect::sinumerik,
       "%_N_MAIN_MPF\nDEF REAL ARR[5]\nR5=0\nWHILE R5==0\nSUBA(ARR)\nENDWHILE\nG1 X1 F1\nM30\n"
       "%_N_SUBA_SPF\nPROC SUBA(VAR REAL TT[])\nTT[1]=TT[1]+1\nIF TT[1]>50000\nR5=1\nENDIF\nRET\n",
       1},
      {Dialect::sinumerik,
       "%_N_MAIN_MPF\nDEF REAL ARR[5]\nR1=0\nWHILE ARR[0]==0\nR1=R1+1\nSUBA(ARR)\nENDWHILE\n"
       "G1 X1 F1\nM30\n"
       "%_N_SUBA_SPF\nPROC SUBA(VAR REAL TT[])\nTT[0]=TRUNC(R1/50000)\nRET\n",
       1},
  };
  for (const auto& one : cases) {
    SCOPED_TRACE(one.text);
    const Program p = read_text(one.text, at_origin(one.dialect));
    EXPECT_EQ(codes(p), "");
    EXPECT_EQ(p.motions.size(), one.motions);
  }
}

TEST(Language, SkippedBlocksAreNotEvaluated) {
  InterpOptions options = at_origin(Dialect::fanuc);
  options.block_skip = 1;
  EXPECT_EQ(path_of(read_text("G1 X1 F1\n/X#5\n/GOTO 7\n/#1=#6\nX2\n", options)), "1,0,0 2,0,0 ");
}

TEST(Owords, OwordsBranchAndLoop) {
  EXPECT_EQ(run(Dialect::ngc,
                "G1 F100 X1\n#1=0\no1 while [#1 lt 3]\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\n"
                "o2 endif\nX[#1*10]\no1 endwhile\nM2\n"),
            "1,0,0 10,0,0 30,0,0 ");
  EXPECT_EQ(run(Dialect::ngc,
                "G1 F100 X1\n#1=0\no1 do\n#1=[#1+1]\nX[#1*10]\no1 while [#1 lt 3]\no3 repeat [2]\n"
                "G91 Y1\nG90\no3 endrepeat\nM2\n"),
            "1,0,0 10,0,0 20,0,0 30,0,0 30,1,0 30,2,0 ");
  const auto branch = [](int value) {
    return run(Dialect::ngc,
               fmt::format("G1 F100 X1\n#<v>={}\no1 if [#<v> eq 1]\nX10\no1 elseif [#<v> eq 2]\n"
                           "X20\no1 elseif [#<v> eq 3]\nX30\no1 else\nX40\no1 endif\nY1\nM2\n",
                           value));
  };
  EXPECT_EQ(branch(1), "1,0,0 10,0,0 10,1,0 ");
  EXPECT_EQ(branch(2), "1,0,0 20,0,0 20,1,0 ");
  EXPECT_EQ(branch(3), "1,0,0 30,0,0 30,1,0 ");
  EXPECT_EQ(branch(4), "1,0,0 40,0,0 40,1,0 ");
}

TEST(Owords, SubsReturnValuesAndHaveLocals) {
  EXPECT_EQ(run(Dialect::ngc,
                "o<area> sub\n#<local>=[#1*#2]\n#1=99\no<area> endsub [#<local>]\n"
                "G1 F100 X1\n#1=7\no<area> call [3] [4]\nX#<_value> Y#1\nM2\n"),
            "1,0,0 12,7,0 ");
  EXPECT_EQ(run(Dialect::ngc,
                "o<fact> sub\no1 if [#1 le 1]\no<fact> return [1]\no1 endif\n"
                "o<fact> call [#1-1]\no<fact> endsub [#1*#<_value>]\n"
                "G1 F100 X1\no<fact> call [5]\nX#<_value>\nM2\n"),
            "1,0,0 120,0,0 ");
  EXPECT_EQ(run(Dialect::ngc, "G1 F100 X1\no<a> sub\n#<x>=5\no<a> endsub\no<a> call\nX#<x>\nM2\n"),
            "1,0,0 variable-unset");
  EXPECT_EQ(run(Dialect::ngc, "G1 F100 X1\no<missing> call\nM2\n"), "1,0,0 subprogram-missing");
  EXPECT_EQ(run(Dialect::ngc, "G1 F100 X1\no1 sub\no2 sub\no2 endsub\no1 endsub\no1 call\nM2\n"),
            "1,0,0 structure");
}

TEST(Owords, SubprogramsMayLieInFilesOfTheirOwn) {
  const TempFolder scratch;
  scratch.write("square.ngc", "o<square> sub\nG1 X#1\nY#1\nX0\nY0\no<square> endsub\nM2\n");
  const std::string main =
      scratch.write("main.ngc", "G1 F100 Z1\no<square> call [5]\no<square> call [2]\nM2\n");
  EXPECT_EQ(path_of(read_program(main, at_origin(Dialect::ngc))),
            "0,0,1 5,0,1 5,5,1 0,5,1 0,0,1 2,0,1 2,2,1 0,2,1 0,0,1 ");
  const std::string outside = scratch.write("out.ngc", "G1 F100 Z1\no<../square> call [5]\nM2\n");
  EXPECT_EQ(path_of(read_program(outside, at_origin(Dialect::ngc))), "0,0,1 subprogram-missing");
}

TEST(Owords, AFileOfItsOwnGivesTheSubOfItsNameOnly) {
  const TempFolder scratch;
  scratch.write("square.ngc",
                "o<square> sub\nG1 X#1\no200 call\no<square> endsub\no200 sub\nY9\n"
                "o200 endsub\n");
  const std::string main = scratch.write("main.ngc", "G1 F100 Z1\no<square> call [5]\nM2\n");
  EXPECT_EQ(path_of(read_program(main, at_origin(Dialect::ngc))), "0,0,1 5,0,1 subprogram-missing");
  const std::string own =
      scratch.write("own.ngc", "G1 F100 Z1\no<square> call [5]\nM2\no200 sub\nY3\no200 endsub\n");
  EXPECT_EQ(path_of(read_program(own, at_origin(Dialect::ngc))), "0,0,1 5,0,1 5,3,1 ");
}

// LinuxCNC: "File ended with no percent sign (%) or program end (M2)". Grbl's files end anywhere.
TEST(Owords, AProgramWithOWordsEndsWithM2OrPercent) {
  const std::string loop = "G1 F100 X1\no1 repeat [1]\nX2\no1 endrepeat\n";
  EXPECT_EQ(run(Dialect::ngc, loop), "1,0,0 2,0,0 program-end-missing");
  EXPECT_EQ(run(Dialect::ngc, loop + "M2\n"), "1,0,0 2,0,0 ");
  EXPECT_EQ(run(Dialect::ngc, loop + "M30\n"), "1,0,0 2,0,0 ");
  EXPECT_EQ(run(Dialect::ngc, "%\n" + loop + "%\n"), "1,0,0 2,0,0 ");
  EXPECT_EQ(run(Dialect::ngc, "G1 F100 X1\n"), "1,0,0 ");
  const std::string sub = "o2 sub\nX3\no2 endsub\n";
  EXPECT_EQ(run(Dialect::ngc, "o1\nG1 F100 X1\no2 call\n" + sub + "M2\n"),
            "1,0,0 3,0,0 program-end-missing");
  EXPECT_EQ(run(Dialect::ngc, "o1\nG1 F100 X1\no2 call\nM2\n" + sub), "1,0,0 3,0,0 ");
  EXPECT_EQ(run(Dialect::ngc, sub + "o1\nG1 F100 X1\no2 call\nM2\n"), "1,0,0 3,0,0 ");
}

TEST(Owords, AssignmentsHoldFromTheNextBlock) {
  EXPECT_EQ(run(Dialect::ngc, "#3=15\nG1 F100 X1\n#3=6 X#3\nX#3\nM2\n"), "1,0,0 15,0,0 6,0,0 ");
}

TEST(Sinumerik, LoopsEqualTheWrittenOutProgram) {
  const std::string plain = "1,0,0 10,1,0 20,2,0 30,3,0 ";
  const auto s = Dialect::sinumerik;
  EXPECT_EQ(run(s, "G1 F100 X1\nFOR R1=1 TO 3\nX=R1*10 Y=R1\nENDFOR\nM30\n"), plain);
  EXPECT_EQ(run(s, "G1 F100 X1\nR1=1\nWHILE R1<=3\nX=R1*10 Y=R1\nR1=R1+1\nENDWHILE\nM30\n"), plain);
  EXPECT_EQ(run(s, "G1 F100 X1\nR1=0\nREPEAT\nR1=R1+1\nX=R1*10 Y=R1\nUNTIL R1>=3\nM30\n"), plain);
  EXPECT_EQ(run(s,
                "G1 F100 X1\nR1=0\nLOOP\nR1=R1+1\nIF R1>3 GOTOF ENDE\nX=R1*10 Y=R1\nENDLOOP\n"
                "ENDE: M30\n"),
            plain);
  EXPECT_EQ(run(s, "G1 F100 X1\nR1=1\nAGAIN: X=R1*10 Y=R1\nR1=R1+1\nIF R1<=3 GOTOB AGAIN\nM30\n"),
            plain);
  EXPECT_EQ(run(s, "G1 F100 X1\nR1=0\nN10 R1=R1+1 X=R1*10 Y=R1\nIF R1<3 GOTOB N10\nM30\n"), plain);
  EXPECT_EQ(run(s, "G1 F100 X1\nR1=0\nPART:\nR1=R1+1\nX=R1*10 Y=R1\nREPEAT PART P=2\nM30\n"),
            plain);
  EXPECT_EQ(run(s,
                "DEF INT COUNT, LAST=3\nG1 F100 X1\nFOR COUNT=1 TO LAST\nX=COUNT*10 Y=COUNT\n"
                "ENDFOR\nM30\n"),
            plain);
}

// Each end belongs to one kind of loop; the error stands at the end and names both.
TEST(Language, AnEndOfAnotherLoopIsAnError) {
  const auto fault = [](Dialect dialect, const std::string& text) {
    const Program p = read_text(text, at_origin(dialect));
    if (p.diagnostics.size() != 1) return codes(p);
    const Diagnostic& d = p.diagnostics[0];
    return fmt::format("{} {}: {}", d.code, d.place.line, d.text);
  };
  const auto s = Dialect::sinumerik;
  EXPECT_EQ(fault(s, "G1 F100 X1\nR1=0\nWHILE R1<3\nR1=R1+1\nX=R1\nENDFOR\nM30\n"),
            "structure 6: ENDFOR does not belong to the WHILE of line 3, which is not closed");
  EXPECT_EQ(fault(s, "G1 F100 X1\nFOR R1=1 TO 3\nX=R1\nENDLOOP\nM30\n"),
            "structure 4: ENDLOOP does not belong to the FOR of line 2, which is not closed");
  EXPECT_EQ(fault(s, "G1 F100 X1\nR1=0\nLOOP\nX1\nUNTIL R1==0\nM30\n"),
            "structure 5: UNTIL does not belong to the LOOP of line 3, which is not closed");
  EXPECT_EQ(fault(s, "G1 F100 X1\nR1=0\nREPEAT\nX1\nENDWHILE\nM30\n"),
            "structure 5: ENDWHILE does not belong to the REPEAT of line 3, which is not closed");
  EXPECT_EQ(fault(s, "G1 F100 X1\nR1=0\nIF R1==0\nLOOP\nX1\nENDIF\nENDLOOP\nM30\n"),
            "structure 6: ENDIF does not belong to the LOOP of line 4, which is not closed");
  EXPECT_EQ(fault(Dialect::ngc, "G1 F100 X1\no1 repeat [2]\nX2\no1 endwhile\nM2\n"),
            "structure 4: ENDWHILE does not belong to the REPEAT of line 2, which is not closed");
  EXPECT_EQ(fault(s, "G1 F100 X1\nENDFOR\nM30\n"),
            "structure 2: nothing begins what ENDFOR goes on with or ends");
}

TEST(Sinumerik, BranchesAndCasesChooseOneWay) {
  const auto s = Dialect::sinumerik;
  const auto branch = [&](int value) {
    return run(s, fmt::format("R1={}\nG1 F100 X1\nIF R1==1\nX10\nELSE\nIF R1==2\nX20\nELSE\nX30\n"
                              "ENDIF\nENDIF\nY1\nM30\n",
                              value));
  };
  EXPECT_EQ(branch(1), "1,0,0 10,0,0 10,1,0 ");
  EXPECT_EQ(branch(2), "1,0,0 20,0,0 20,1,0 ");
  EXPECT_EQ(branch(3), "1,0,0 30,0,0 30,1,0 ");
  const auto jump = [&](int value) {
    return run(s, fmt::format("R1={}\nG1 F100 X1\nCASE R1 OF 1 GOTOF ONE 2 GOTOF TWO DEFAULT GOTOF "
                              "REST\nONE: X10\nTWO: X20\nREST: X30\nM30\n",
                              value));
  };
  EXPECT_EQ(jump(1), "1,0,0 10,0,0 20,0,0 30,0,0 ");
  EXPECT_EQ(jump(2), "1,0,0 20,0,0 30,0,0 ");
  EXPECT_EQ(jump(9), "1,0,0 30,0,0 ");
  EXPECT_EQ(run(s, "G1 F100 X1\nGOTOC NOWHERE\nX2\nGOTOF NOWHERE\nX3\n"),
            "1,0,0 2,0,0 jump-target");
}

TEST(Sinumerik, ExpressionsWhereverANumberStands) {
  EXPECT_EQ(run(Dialect::sinumerik,
                "R1=30 R2=5\nG1 F=R1*10 X=R1*SIN(30) Y=-R2\nX=AC(R1+1) Y=IC(R2*2)\nG2 X=R1+11 "
                "CR=R2\nM30\n"),
            "15,-5,0 31,5,0 41,5,0 ");
  EXPECT_EQ(run(Dialect::sinumerik,
                "DEF REAL PP[3]=SET(1,2,3)\nDEF STRING[10] SS=\"A\"\nG1 F100 X=PP[0] "
                "Y=PP[2]\nPP[1]=PP[0]+9\n"
                "X=PP[1]\nIF SS==\"A\" GOTOF LAB\nX99\nLAB: Y0\nTRANS X=PP[1]\nX0\nM30\n"),
            "1,3,0 10,3,0 10,0,0 ");
}

TEST(Sinumerik, ProceduresTakeAndChangeParameters) {
  const TempFolder scratch;
  scratch.write("HOLE.SPF",
                "PROC HOLE(REAL DEPTH, REAL BACK=2, VAR REAL COUNT)\nG1 Z=-DEPTH\nZ=BACK\n"
                "COUNT=COUNT+1\nRET\n");
  const std::string main = scratch.write(
      "MAIN.MPF",
      "DEF REAL NN=0\nEXTERN HOLE(REAL,REAL,VAR REAL)\nG1 F100 X1\nHOLE(5,,NN)\nX2\nHOLE(3,1,NN)\n"
      "X=NN*10\nM30\n");
  EXPECT_EQ(path_of(read_program(main, at_origin(Dialect::sinumerik))),
            "1,0,0 1,0,-5 1,0,2 2,0,2 2,0,-3 2,0,1 20,0,1 ");
  scratch.write("TIP.SPF", "PROC TIP SAVE\nG91 G1 Z-1\nZ1\nRET\n");
  const std::string modal =
      scratch.write("MODAL.MPF", "G90 G1 F100 X1\nMCALL TIP\nX2\nX3\nMCALL\nX4\nM30\n");
  EXPECT_EQ(path_of(read_program(modal, at_origin(Dialect::sinumerik))),
            "1,0,0 2,0,0 2,0,-1 2,0,0 3,0,0 3,0,-1 3,0,0 4,0,0 ");
}

// A main program's parameters have the values that PROC gives them, or those from outside.
TEST(Sinumerik, ParametersOfTheMainProgramHaveDefaults) {
  const std::string text = "PROC PART(REAL LONG=40, INT TIMES=2) SAVE\nG1 X=LONG F9\nY=TIMES\n";
  EXPECT_EQ(path_text(read_text(text, at_origin(Dialect::sinumerik))), "l40,0,0 l40,2,0");
  InterpOptions told = at_origin(Dialect::sinumerik);
  told.variables = {{"LONG", "7"}};
  EXPECT_EQ(path_text(read_text(text, told)), "l7,0,0 l7,2,0");
  EXPECT_EQ(
      path_text(read_text("PROC PART(REAL LONG)\nG1 X=LONG F9\n", at_origin(Dialect::sinumerik))),
      " | variable-unset");
}

TEST(Language, SystemVariablesOfGeometryAreRead) {
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100 X3\nX#4107\nD7 X1\nX#4107\n"), "3,0,0 0,0,0 1,0,0 7,0,0 ")
      << "no D was given yet";
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100 X3 Y4\nX[#5001+10] Y#5002\nG#4001 X1\n"),
            "3,4,0 13,4,0 1,4,0 ");
  EXPECT_EQ(run(Dialect::ngc, "G1 F100 X3 Y4\nX[#5420+10] Y#<_y>\nM2\n"), "3,4,0 13,4,0 ");
  EXPECT_EQ(run(Dialect::ngc,
                "G98\nG1 F100 X[#<_retract_old_z>+2*#<_retract_r_plane>]\nG99\n"
                "X[#<_retract_old_z>+2*#<_retract_r_plane>]\nM2\n"),
            "1,0,0 2,0,0 ");
  EXPECT_EQ(run(Dialect::ngc, "G90.1\nG1 F100 X[#<_ijk_absolute_mode>+#<_spindle_rpm_mode>]\nM2\n"),
            "2,0,0 ");
  EXPECT_EQ(run(Dialect::ngc, "G1 F100 X#5161\nM2\n"), "variable-number");
  InterpOptions placed = at_origin(Dialect::ngc);
  placed.places.zero = {{"G54", {}}};
  placed.places.reference = {7, 8, 9};
  EXPECT_EQ(path_of(read_text("G1 F100 X#5161 Y#5162\nM2\n", placed)), "7,8,0 ");
  EXPECT_EQ(run(Dialect::sinumerik, "G1 F100 X3 Y4\nX=$P_EP[X]+10\n"), "3,4,0 13,4,0 ");
  EXPECT_EQ(run(Dialect::fanuc, "G1 F100 X3\nX#3011\n"), "3,0,0 variable-number");
}

// A fault in a loop is told once, and such a loop is given up early: the fault may be why it does
// not end.
TEST(Limits, ALoopWithAFaultIsToldOfOnce) {
  const Program p = read_text("DEF INT NN=3\nG1 F9 X1\nWHILE NN>0\nNN)NN-1\nX2\nENDWHILE\nM30\n",
                              at_origin(Dialect::sinumerik));
  EXPECT_EQ(codes(p), "character number-without-address address-twice program-endless");
  EXPECT_NE(p.diagnostics.back().text.find("behind an error"), std::string::npos) << listing(p);
  EXPECT_EQ(
      codes(read_text("G1 F9 X1\n#1=0\nWHILE[#1LT3]DO1\nG1 X[#1+1] Q;\nT\n#1=#1+1\nEND1\nM30\n",
                      at_origin(Dialect::fanuc))),
      codes(read_text("G1 F9 X1\n#1=0\nG1 X[#1+1] Q;\nT\nM30\n", at_origin(Dialect::fanuc))));
}

}  // namespace
}  // namespace mrsim
