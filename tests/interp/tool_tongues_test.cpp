// Comments about tools in other languages than English.
#include "interp/tool_readings.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(ToolCommentReadings, EachTongueHasItsWords) {
  expect_readings({
      {mm, "FRÄSER Ø 20", "endmill 20"},
      {mm, "HPC-FRAESER 12 Z4", "endmill 12"},
      {mm, "SCHAFTFR. D16 ECKENRADIUS 1", "bullmill 16, corner 1"},
      {mm, "NC-ANBOHRER 10 90GRAD", "drill 10, point 90"},
      {mm, "ZENTRIERBOHRER 3.15", "drill 3.15, point 60"},
      {mm, "SENKER DIN 335 90GRAD D16.5", "chamfer 16.5, point 90"},
      {mm, "SENKER 90/16", "chamfer 16, point 90"},
      {mm, "FLACHSENKER D11", "endmill 11"},
      {mm, "POGLEBIACZ WALCOWY FI11", "endmill 11"},
      {mm, "AVELLANADOR PLANO D11", "endmill 11"},
      {mm, "FORET A LAMER D11", "endmill 11"},
      {mm, "T NUT HOLES 5MM DRILL", "drill 5"},
      {mm, "FREZ DO ROWKOW TEOWYCH FI 20", "? gives no width of the head"},
      {mm, "FRESA PER CAVE A T D20", "? gives no width of the head"},
      {mm, "FREZ TRAPEZOWY FI20 60", "? gives no angle of its flanks"},
      {mm, "KERNLOCHBOHRER 6.8 M8", "drill 6.8"},
      {mm, "WENDEPLATTENBOHRER D25", "drill 25"},
      {mm, "FRAISE BOULE D6", "ballmill 6"},
      {mm, "FRAISE 2 TAILLES D12", "endmill 12"},
      {mm, "FRAISE TORIQUE D10 R2", "bullmill 10, corner 2"},
      {mm, "FRAISE A CHANFREINER D10 90°", "chamfer 10, point 90"},
      {mm, "FORET À CENTRER D3", "drill 3, point 60"},
      {mm, "TARAUD M8", "endmill 8"},
      {mm, "FRAISE T D20 EP 5", "tslot 20, width 5"},
      {mm, "FRAISE DE 10", "endmill 10"},
      {mm, "FRESA DE BOLA 6", "ballmill 6"},
      {mm, "FRESA PLANA 12", "endmill 12"},
      {mm, "BROCA DE 8,5", "drill 8.5"},
      {mm, "BROCA DE CENTRAR 3", "drill 3, point 60"},
      {mm, "MACHO DE ROSCAR M10X1.5", "endmill 10"},
      {mm, "AVELLANADOR 90 GRADOS 12", "chamfer 12, point 90"},
      {mm, "FRESA SFERICA D8", "ballmill 8"},
      {mm, "PUNTA D8.5", "drill 8.5"},
      {mm, "MASCHIO M8", "endmill 8"},
      {mm, "ALESATORE 10", "endmill 10"},
      {mm, "FREZ 10", "endmill 10"},
      {mm, "FREZ FI12 Z4", "endmill 12"},
      {mm, "FREZ KULISTY R5", "ballmill 10"},
      {mm, "FREZ TRZPIENIOWY 8", "endmill 8"},
      {mm, "WIERTLO 5", "drill 5"},
      {mm, "WIERTŁO 8.5", "drill 8.5"},
      {mm, "NAWIERTAK 90 ST FI 10", "drill 10, point 90"},
      {mm, "GWINTOWNIK M8", "endmill 8"},
      {mm, "ROZWIERTAK 10H7", "endmill 10"},
      {mm, "POGŁĘBIACZ 90 FI 16", "chamfer 16, point 90"},
      {mm, "STEBLASTO FREZALO FI 10", "endmill 10"},
      {mm, "KROGLIČNO FREZALO R4", "ballmill 8"},
      {mm, "SVEDER 8.5", "drill 8.5"},
      {mm, "NAVOJNI SVEDER M8", "endmill 8"},
      {mm, "POVRTALO 10H7", "endmill 10"},
      {mm, "GREZILO 90 FI 16", "chamfer 16, point 90"},
      {mm, "VRTANJE FI 5", "-"},
  });
}

// A knife for parting was a turning insert, as only NOZ was known.
TEST(ToolCommentReadings, SouthSlavicTonguesHaveTheirWords) {
  expect_readings({
      {lathe_mm, "NOZ ZA ODREZOVANJE 3MM", "grooving, width 3"},
      {lathe_mm, "ODREZOVALNI NO\xC5\xBD 3MM", "grooving, width 3"},
      {lathe_mm, "ZAREZOVALNI NOZ 3MM", "grooving, width 3"},
      {lathe_mm, "UTORNI NOZ 2MM", "grooving, width 2"},
      {lathe_mm, "ODREZNI 3", "grooving, width 3"},
      {lathe_mm, "NOZ ZA UTORE 3MM", "grooving, width 3"},
      {lathe_mm, "VRTALNI DROG R0.4", "boring, insert 35, nose 0.4"},
      {lathe_mm, "NOZ 3MM", "? tells a width as blades have, and no insert"},
      {lathe_mm, "CUCHILLA NEGRA 3MM", "? tells a width as blades have, and no insert"},
      {lathe_mm, "NOZ 3MM R0.4", "turning, insert 35, nose 0.4"},
      {lathe_mm, "STRUZNI NOZ 16MM", "turning, insert 35"},
      {lathe_mm, "STRUZNI NOZ R0.8", "turning, insert 35, nose 0.8"},
      {mm, "REZKALO 10", "endmill 10"},
      {mm, "T FREZALO D25 B6", "tslot 25, width 6"},
      {mm,
       "\xC4\x8C"
       "ELNO GREZILO 15",
       "endmill 15"},
      {mm, "POSNEMALNO FREZALO D12 90 ST", "chamfer 12, point 90"},
      {mm, "FREZALNA GLAVA 63", "endmill 63"},
      {mm, "T1 VRTANJE D8.5", "? names no kind of tool that is known"},
      {mm, "GLODALO D10", "endmill 10"},
      {mm, "KUGLASTO GLODALO 6", "ballmill 6"},
      {mm,
       "\xC4\x8C"
       "EONO GLODALO 63",
       "endmill 63"},
      {mm,
       "\xC4\x8C"
       "ELNA GLAVA 63",
       "endmill 63"},
      {mm, "BURGIJA 8.5", "drill 8.5"},
      {mm, "SVRDLO 8,5", "drill 8.5"},
      {mm, "ZABU\xC5\xA0IVA\xC4\x8C 3.15", "drill 3.15, point 60"},
      {mm, "UREZNIK M8", "endmill 8"},
      {mm, "RAZVRTA\xC4\x8C 8H7", "endmill 8"},
      {mm, "UPU\xC5\xA0TA\xC4\x8C D16 90", "chamfer 16, point 90"},
  });
}

// Each of these was a plain end mill.
TEST(ToolCommentReadings, CuttersOfOtherShapesAreNoEndMills) {
  expect_readings({
      {mm, "FRESA SIERRA D63 B2", "tslot 63, width 2"},
      {mm, "FRESA DISCO D63", "? gives no width of the head"},
      {mm, "FREZ PILKOWY D63 B2", "tslot 63, width 2"},
      {mm, "FREZA KOTOUCOVA D63 B4", "tslot 63, width 4"},
      {mm, "FREZALO ZA POSNETJE D12 90 ST", "chamfer 12, point 90"},
      {mm, "FREZALO V 90 D12", "chamfer 12, point 90"},
      {mm, "KONUSNO FREZALO D6", "? gives no taper angle"},
      {mm, "KOTNO FREZALO D20", "? names a kind of tool that needs more data"},
      {mm, "RADIUSNO FREZALO D10 R2", "? names a kind of tool that needs more data"},
      {mm, "FRESA QUARTO DI CERCHIO D10 R3", "? names a kind of tool that needs more data"},
      {mm, "FREZA NA ZAVITY D8", "endmill 8"},
      {mm, "STEP MILL D10", "? names a kind of tool that needs more data"},
      {mm, "GROOVE MILL D20 W3", "tslot 20, width 3"},
      {mm, "GROOVE MILL D20", "endmill 20"},
  });
  for (const char* unsure : {"FREZA XYZOVA D20", "FREZALO POSEBNO D20"})
    EXPECT_TRUE(read_tool_comment(unsure).may_be_another()) << unsure;
  for (const char* sure : {"DVOPERO FREZALO D10", "FRESA CILINDRICA FRONTALE D10", "FREZA D10 XYZW",
                           "FRAISE CARBURE D10", "FRAISE RAYONNEE D10 R1", "FRAISE DEUX LEVRES D10",
                           "POSEBNO STEBLASTO FREZALO D10"})
    EXPECT_FALSE(read_tool_comment(sure).may_be_another()) << sure;
}

TEST(ToolCommentReadings, LeftHandIsReadInEachTongue) {
  for (const char* left :
       {"LEVI NOZ R0.8", "LINKER DREHSTAHL R0.8", "OUTIL A GAUCHE CNMG 120408",
        "CNMG 120408 IZQUIERDA", "CNMG 120408 SINISTRO", "CUCHILLA IZQUIERDA DESBASTE R0.8"})
    EXPECT_TRUE(read_tool_comment(left).left_hand) << left;
  for (const char* other :
       {"DESNI NOZ R0.8", "CNMG 120408 COTE GAUCHE", "CNMG 120408 LEVA STRAN",
        "CNMG 120408 LINKES FUTTER", "CNMG DESBASTE HUSILLO IZQUIERDO", "CNMG 120408 BROCHE GAUCHE",
        "CNMG 120408 FACE GAUCHE", "CNMG LINKER ABSATZ", "CNMG 120408 LINKES ENDE"})
    EXPECT_FALSE(read_tool_comment(other).left_hand) << other;
  EXPECT_EQ(read_tool_comment("NAREBRICENJE").trade, ToolTrade::no_cutter);
}

TEST(ToolCommentReadings, OtherTonguesHaveTheirWords) {
  expect_readings({
      {mm, "FREZA DEGET 10", "endmill 10"},
      {mm, "FRESA DE TOPO 10", "endmill 10"},
      {mm, "PINNFR\xC3\x84S 10", "endmill 10"},
      {mm, "BORR 8.5", "drill 8.5"},
      {mm, "TAPPIJYRSIN 10", "endmill 10"},
      {mm, "KIERRETAPPI M8", "endmill 8"},
      {mm, "UJJMAR\xC3\x93 10", "endmill 10"},
      {mm, "V\xC3\x9DSTRU\xC5\xBDN\xC3\x8DK 8H7", "endmill 8"},
      {mm, "RAYBA 8H7", "endmill 8"},
      {lathe_mm, "UBERACI NUZ R0.8", "turning, insert 35, nose 0.8"},
  });
}

// Controls without Cyrillic letters: Russian in Latin ones.
TEST(ToolCommentReadings, RussianMayStandInLatinLetters) {
  expect_readings({
      {lathe_mm, "SVERLO 1.5", "drill 1.5"},
      {mm, "SVERLO D10.2", "drill 10.2"},
      {mm, "T1 SVERLENIE D10.2", "drill 10.2"},
      {mm, "CENTROVKA D3", "drill 3, point 60"},
      {mm, "SVERLO CENTROVOCHNOE 3", "drill 3, point 60"},
      {mm, "METCHIK M8", "endmill 8"},
      {mm, "RAZVERTKA 10H7", "endmill 10"},
      {mm, "ZENKOVKA D16", "chamfer 16, point 90"},
      {mm, "FREZA D12", "endmill 12"},
      {mm, "FREZA SFERICHESKAYA D6", "ballmill 6"},
      {mm, "FREZA TORCEVAYA D63", "endmill 63"},
      {lathe_mm, "T3 OTREZ 3MM", "grooving, width 3"},
      {lathe_mm, "T3 KANAVKA B3", "grooving, width 3"},
      {lathe_mm, "REZEC PROHODNOY R0.8", "turning, insert 35, nose 0.8"},
      {lathe_mm, "PROHODNOY CNMG 120408", "turning, insert 80, nose 0.8"},
      {lathe_mm, "REZEC REZBOVOY", "threading, insert 60"},
  });
}

TEST(ToolCommentReadings, PunteadoNamesASpotDrill) {
  expect_readings({
      {mm, "PUNTEADO D12", "drill 12, point 90"},
  });
}

}  // namespace
}  // namespace mrsim
