#include "interp/comments/comment_words.h"

#include <unordered_map>

namespace mrsim {
namespace {

struct WordRow {
  WordRole role;
  NumberSide side;
  std::string_view words;  // apart by blanks
};

namespace word_rows {
using enum WordRole;
using enum NumberSide;
constexpr WordRow kWordRows[] = {
    {adjective, either,
     "ROUGH ROUGHING FINISH FINISHING SOLID CARBIDE CARB CRB HSS HSSE HSSCO COBALT COB VHM HM LONG "
     "SHORT STUB EXTENDED EXT CENTER CUTTING SQUARE SQ UPCUT DOWNCUT SPIRAL STRAIGHT SINGLE DOUBLE "
     "COATED TIALN ALTIN TIN TICN ZRN FLAT JOBBER TWIST STANDARD STD TWO THREE FOUR FIVE SIX "
     "METRIC INCLUDED INCL DE DI OF LH RH RIGHT LEFT HAND PLANA PLANO PIANA CILINDRICA RECTA "
     "DROITE CYLINDRIQUE CARBURE "
     "CUTTER BIT METAL DURO MD WIDIA DESBASTE ACABADO FINITION EBAUCHE TRZPIENIOWY PALCOWY WALCOWY "
     "GROBO "
     "FINO DVOPERO TRIPERO STIRIPERO ~TIRIPERO ENOREZNO DVOREZNO TRIREZNO STIRIREZNO KARBIDNO "
     "PRSTASTO VRETENASTO FRONTALE FRONTAL MANGO INTEGRAL MONOBLOC RAYONNEE "
     "RAGGIATA DEUX TROIS QUATRE"},
    {flutes, either,
     "FLUTE FLUTES FLUTED FL FLT F Z TOOTH TEETH SCHNEIDER SCHNEIDIG SCHNEIDEN DENTS DENT TAILLES "
     "LEVRES "
     "DIENTES LABIOS TAGLIENTI DENTI OSTRZY OSTRZA ZOB ZOBI ZOB~ INSERTS"},
    {diameter, either,
     "DIA DIAM DIAMETER DURCHMESSER DIAMETRO DI~METRO DIAMETRE DIAM~TRE PREMER DMR SREDNICA "
     "~REDNICA"},
    {diameter, behind, "FI PHI DM DC"},
    {register_of, behind, "OFF OFFSET COMP REG REGISTER"},
    {WordRole::radius, either,
     "CR CRAD RC LR RAD RADIUS ECKENRADIUS ECKRADIUS RAYON RADIO RAGGIO PROMIEN RADIJ"},
    {radius_letter, either, "R"},
    {corner, either, "CORNER CRN CNR ECKEN ECKE"},
    {nose, either, "NOSE TNR RE NR"},
    {width, either,
     "WIDTH THICKNESS BREITE LARGEUR ANCHO LARGHEZZA EPAISSEUR SIRINA ~IRINA SZEROKOSC"},
    {width, behind, "W B EP"},
    {width, before, "WIDE BREIT THICK THK"},
    {length, either, "LOC LCF"},
    {angle, either, "ANGLE ANG KAPR WINKEL ANGULO ANGOLO KOT POINT PT"},
    {angle, behind, "A"},
    {taper, either, "TAPER"},
    {tip, either, "TIP TIPD TIPDIA SPITZE"},
    {other, either,
     "LENGTH LEN LG LAENGE L~NGE OAL OVERALL STICKOUT REACH SHANK SHK SHAFT SCHAFT NECK LBS RELIEF "
     "RPM SFM IPM IPT SPEED PITCH TPI STEIGUNG DEPTH TIEFE PROFONDEUR TRIEB"},
    {work, either,
     "STEP STEPOVER STEPDOWN PECK DOC WOC STOCK LEAVE ALLOWANCE AUFMASS ZUSTELLUNG TOL TOLERANCE "
     "PCD BCD LOCHKREIS TEILKREIS COLLET CHUCK HOLDER TOOLHOLDER SPANNZANGE FUTTER EDGE KANTE "
     "POCKET SLOT TASCHE NUT POCHE RAINURE CAJERA"},
    {work, behind, "THRU THROUGH EVERY TOP BOTTOM FLOOR WALL WALLS EDGES KANTEN"},
    {work, before, "APART SPACING CENTERS CENTRES BOSS BOLT"},
    {other, behind,
     "FEED MAX MIN H OP SETUP POS STATION TURRET L S N P Q G ER CAT BT HSK PN ART EDP"},
    {WordRole::count, before, "HOLES HOLE PLCS PLACES PL"},
    {other, before, "OUT DEEP DP TIEF XD SHCS BHCS FHCS SCREW BORE PLATE PROFILE CONTOUR"},
};
}  // namespace word_rows

}  // namespace

CommentWord comment_word(std::string_view word) {
  static const auto kRoles = [] {
    std::unordered_map<std::string_view, CommentWord> roles;
    for (const WordRow& row : word_rows::kWordRows)
      for (std::string_view rest = row.words; !rest.empty();) {
        const std::size_t blank = rest.find(' ');
        roles.try_emplace(rest.substr(0, blank), CommentWord{row.role, row.side});
        rest = blank == rest.npos ? std::string_view() : rest.substr(blank + 1);
      }
    return roles;
  }();
  const auto at = kRoles.find(word);
  return at == kRoles.end() ? CommentWord{} : at->second;
}

}  // namespace mrsim
