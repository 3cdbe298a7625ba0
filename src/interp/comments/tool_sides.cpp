#include "interp/comments/tool_sides.h"

#include "interp/comments/comment_words.h"
#include "interp/comments/tool_id.h"

#include <algorithm>
#include <string_view>

namespace mrsim {
namespace {

// Lists of words with blanks between them. '*' at the end of a word stands for any ending, '~' for
// a character outside of ASCII.
constexpr std::string_view kOutside =
    "OD EXT EXTERNAL OUTSIDE AUSSEN* EXTERIEUR EXTERIEURE ZEWN* ZUNANJ* EXTERIOR EXTERNO EXTERNA "
    "ESTERNO ESTERNA EXTERNE VANJSK* SPOLJ* NGOAI VNEJS* VN~J* VONKAJ* KULSO* K~LS* BUITEN* "
    "UTVANDIG* UTV~NDIG*";
constexpr std::string_view kInside =
    "ID INT INTERNAL INSIDE INNEN* INTERIOR INTERIEUR INTERIEURE INTERNE INTERNO INTERNA WEWN* "
    "UNUTR* UNUTARN* TRONG NOTRANJ* VNIT* VNUTOR* VN~TOR* BELSO* BELS~* BINNEN* INVANDIG* "
    "INV~NDIG*";
constexpr std::string_view kBores =
    "BORE BORING ALESAGE ALESER MANDRINADO MANDRINAR MANDRILAR MANDRILADO MANDRILAMENTO ALESATURA "
    "BAREN* WYTACZ* VYVRT*";
constexpr std::string_view kTurns =
    "TURN TURNING FACE FACING PROFILE PROFILER PROFILING DREHEN PLANEN CHARIOTAGE DRESSAGE "
    "TORNEADO "
    "CILINDRAR "
    "CILINDRADO REFRENTADO FACEAR TORNITURA SFACCIATURA";
// Beside the word for a thread these name the turning before it.
constexpr std::string_view kTurnsBefore =
    "TURN TURNED RELIEF DREHEN VORDREHEN FREISTICH CHARIOTAGE TORNEADO CILINDRAR CILINDRADO "
    "TORNITURA TOCZENIE";
constexpr std::string_view kRough =
    "ROUGH ROUGHER ROUGHING FINISH FINISHER FINISHING RGH RGHR FIN SCHRUPPEN SCHLICHTEN EBAUCHE "
    "FINITION DESBASTE DESB "
    "ACABADO ACABAMENTO SGROSSATURA FINITURA";
constexpr std::string_view kFaceGrooves =
    "AXIAL* FRONTAL* CZOLOW* CZO~OW* CELNI STIRNSTECH* STIRNEINST* PLANSTECH* PLANEINST*";

bool is_word_of(const CommentView& view, std::size_t i, std::string_view words) {
  if (!view.word(i)) return false;
  const std::string_view text = view[i].text;
  for (std::string_view rest = words; !rest.empty();) {
    const std::size_t blank = rest.find(' ');
    const std::string_view word = rest.substr(0, blank);
    if (word.ends_with('*') ? text.starts_with(word.substr(0, word.size() - 1)) : text == word)
      return true;
    rest = blank == rest.npos ? std::string_view() : rest.substr(blank + 1);
  }
  return false;
}

// Whether the code of a boring bar begins at i: "A20S-SCLCR", "S16Q SDUCR".
bool begins_bar_code(const CommentView& view, std::size_t i) {
  const bool bar = view.is_one(i, {"A", "S", "E", "C"}) && view.has(i + 1) &&
                   view[i + 1].is_number() && view.glued(i + 1) && view.word(i + 2) &&
                   view.glued(i + 2) && view[i + 2].text.size() == 1;
  const std::size_t holder = view.is(i + 3, "-") ? i + 4 : i + 3;
  return bar && view.word(holder) && view[holder].text.size() == 5;
}

// Whether a diameter of that side is named in Turkish: "IC CAP" is the inner, "DIS CAP" the outer
// one.
bool is_turkish(const CommentView& view, std::size_t i,
                std::initializer_list<std::string_view> side) {
  return view.is_one(i, side) && view.is_one(i + 1, {"CAP", "~AP"});
}

constexpr std::string_view kLeft = "LEFT LT LINKE* LINKS GAUCHE IZQUIERDA SINISTRA SINISTRO";
constexpr std::string_view kLeftHand =
    "LINKER LINKES GAUCHE IZQUIERDA IZQUIERDO SINISTRA SINISTRO LEVI LEVA LEVO LIJEVI LIJEVA LEWY "
    "LEVY "
    "LEV~ LAVY LAV~";
constexpr std::string_view kRight = "RIGHT RT RECHTE* RECHTS DROITE DROIT DERECHA DESTRA DESTRO";
constexpr std::string_view kMiddle = "CENTER CENTRE MIDDLE MITTE MITTIG MILIEU MEDIO CENTRO";
constexpr std::string_view kCorner =
    "CORNER EDGE TIP ECKE KANTE SCHNEIDE SCHNEIDENECKE SPITZE COIN ARETE ESQUINA SPIGOLO";
constexpr std::string_view kBlade = "BLADE INSERT TIP SCHNEIDE PLATTE STECHER PLAQUETTE INSERTO";
constexpr std::string_view kPlaces = "SIDE END FACE WALL SHOULDER FLANK OF SEITE";
constexpr std::string_view kBreaks = "CHAMFER* CHAMF CHFR BREAK* DEBURR* FASE FASEN CHANFREIN";

// Whether one of `others` stands before or behind the word at i.
bool is_beside(const CommentView& view, std::size_t i, std::string_view others) {
  return is_word_of(view, i + 1, others) || (i > 0 && is_word_of(view, i - 1, others));
}

// Reads which point of a blade is programmed: "PARTING 3MM LEFT CORNER", "TIP RIGHT", "CENTER OF
// BLADE".
BladePoint read_blade_point(const CommentView& view) {
  BladePoint point = BladePoint::untold;
  bool breaks = false;
  for (std::size_t i = 0; i < view.size(); ++i) {
    breaks |= is_word_of(view, i, kBreaks);
    const bool corner = is_beside(view, i, kCorner);
    const std::size_t behind = view.is(i + 1, "OF") ? i + 2 : i + 1;
    if (corner && is_word_of(view, i, kLeft)) point = BladePoint::left;
    if (corner && is_word_of(view, i, kRight)) point = BladePoint::right;
    if (is_word_of(view, i, kRight) && is_word_of(view, i + 1, kPlaces))
      point = BladePoint::unclear;
    if (is_word_of(view, i, kMiddle) &&
        (is_word_of(view, behind, kBlade) || (i > 0 && is_word_of(view, i - 1, kBlade))))
      point = BladePoint::middle;
  }
  if (!breaks) return point;  // "CHAMFER RIGHT CORNER" is said of the groove, perhaps
  return point == BladePoint::right ? BladePoint::unclear : BladePoint::untold;
}

// The orientation of the tip that i begins: "TIP 3", "TIP DIRECTION: 2", "TIP #8"; 0: none.
int orientation_at(const CommentView& view, std::size_t i) {
  if (!view.is(i, "TIP")) return 0;
  std::size_t at = i + 1;
  while (view.is_one(at, {"ORIENTATION", "DIRECTION", "TYPE", "NO", "#", "=", ":", "-"})) ++at;
  if (!view.whole(at) || view[at].value < 1 || view[at].value > 9) return 0;
  return static_cast<int>(view[at].value);
}

constexpr std::string_view kFlatThreads =
    "ACME TRAPEZ* TRAPEZOID* BUTTRESS SAGENGEW* SAEGENGEW* S~GENGEW* RUNDGEW* KNUCKLE FLACHGEW*";
constexpr std::string_view kWhitworth = "WHITWORTH BSW BSF BSP BSPP BSPT ROHRGEWINDE";

// Whether a thread without pointed teeth is named: "TR20X4", "16ER 5 TR", "SQUARE THREAD".
bool is_flat_thread(const CommentView& view, std::size_t i) {
  if (is_word_of(view, i, kFlatThreads)) return true;
  if (view.is(i, "SQUARE")) return view.is_one(i + 1, {"THREAD", "THREADING"});
  const auto numbered = [&](std::size_t k) { return view.has(k) && view[k].is_number(); };
  return view.is(i, "TR") && (numbered(i + 1) || (i > 0 && numbered(i - 1)));
}

constexpr std::string_view kSlotMills = "NUTENFR* NUTFR* SCHLITZFR* RILLENFR* RAINURER RANURAR";
constexpr std::string_view kSlots = "CAVE ROWK* UTOR* DRAZK* DR~ZK* RANURAS RAINURES";

bool names_back_turning(const CommentView& view, std::size_t i) {
  if (view.is_one(i, {"BACKTURN", "BACKTURNING", "BACKBORING"})) return true;
  const std::size_t work = view.is(i + 1, "-") ? i + 2 : i + 1;
  return view.is(i, "BACK") && view.is_one(work, {"TURN", "TURNING", "BORING"});
}

// Whether the adjective at i is said of the tool, "LINKER DREHSTAHL", "OUTIL A GAUCHE", "CNMG
// 120408 SINISTRO", and not of a spindle or a side of the part: "CNMG LINKES FUTTER", "BROCHE
// GAUCHE".
bool is_of_tool(const CommentView& view, std::size_t i) {
  const auto tool = [&](std::size_t at) { return view.taken(at) || is_word_for_tool(view, at); };
  if (tool(i + 1)) return true;
  if (view.word(i + 1) && comment_word(view[i + 1].text).role != WordRole::adjective) return false;
  const std::size_t before = i > 1 && view.is(i - 1, "A") ? i - 2 : i - 1;
  return i == 0 || tool(before) || !view.word(before);
}

// Whether the comment has an angle that only inserts have: "80 DEG".
bool has_angle_of_insert(const CommentView& view) {
  for (std::size_t i = 0; i < view.size(); ++i)
    if (view[i].angle && (view[i].value == 35 || view[i].value == 55 || view[i].value == 80))
      return true;
  return false;
}

}  // namespace

void drop_rougher(const CommentView& view, ToolFacts& facts) {
  const bool turns = facts.insert || has_angle_of_insert(view) ||
                     std::any_of(facts.kinds.begin(), facts.kinds.end(),
                                 [](const ToolKind& k) { return is_turning(k.type); });
  std::erase_if(facts.kinds, [&](const ToolKind& k) {
    if (k.end != k.first + 1 || !view.is_one(k.first, {"ROUGHER", "RGHR"})) return false;
    const std::size_t before = k.first == 0 ? CommentView::kNone : k.first - 1;
    const bool sided =
        view.is_one(before, {"OD", "ID"}) && (before == 0 || !view.is_size(before - 1));
    const bool sized =
        view.is_size(before) && !view[before].angle &&
        !(facts.insert && before >= facts.insert->first && before < facts.insert->end);
    return !sized && (turns || sided);
  });
}

bool names_slot_mill(const CommentView& view, std::size_t i) {
  if (is_word_of(view, i, kSlotMills)) return true;
  return i > 0 && is_word_of(view, i, kSlots) &&
         view.is_one(i - 1, {"PER", "DO", "ZA", "NA", "PARA", "A"});
}

// "VNMG LEFT HAND" and "CNMG LH" say it; "LEFT CORNER" is said of a blade, "LEFT END" of the part.
bool is_left_hand(const CommentView& view, std::size_t i) {
  if (!view.is_one(i, {"LEFT", "LH", "LINKS"}) &&
      !(is_word_of(view, i, kLeftHand) && is_of_tool(view, i)))
    return false;
  return !is_beside(view, i, kCorner) && !is_word_of(view, i + 1, kPlaces);
}

// "INNENGEWINDE" and "BORE CCMT 09T304" are inside; "FACE AND BORE" works outside too.
void read_side_words(const CommentView& view, ToolFacts& facts) {
  bool outside = false, bores = false, turns = false, rough = false;
  for (std::size_t i = 0; i < view.size(); ++i) {
    outside |= is_word_of(view, i, kOutside) || is_turkish(view, i, {"DIS", "DI~", "D~~"});
    bores |= is_word_of(view, i, kBores);
    facts.full_radius |= (view.is(i, "FULL") && view.is_one(i + 1, {"RADIUS", "RAD", "R"})) ||
                         view.is(i, "VOLLRADIUS");
    facts.inside |= begins_bar_code(view, i) || is_turkish(view, i, {"IC", "I~", "~~", "~C"});
    turns |= is_word_of(view, i, kTurns);
    rough |= is_word_of(view, i, kRough);
    facts.turns_before |= is_word_of(view, i, kTurnsBefore);
    facts.inside |= is_word_of(view, i, kInside) && !view.is_one(i + 1, {":", "="});
    facts.face_groove |= is_word_of(view, i, kFaceGrooves);
    facts.face_groove |=
        view.is(i, "FACE") && view.is_one(i + 1, {"GROOVE", "GROOVING", "GROOVER"});
  }
  facts.turned_side = outside || turns || rough || facts.inside;
  facts.bores = bores && !turns && !outside;
  facts.inside = (facts.inside || facts.bores) && !outside;
}

void read_turning_words(const CommentView& view, ToolFacts& facts) {
  const bool turns =
      facts.insert || facts.blade || (facts.kind() && is_turning(facts.kind()->type));
  if (!turns) return;
  bool hand = false;
  for (std::size_t i = 0; i < view.size(); ++i) {
    hand |= view.is_one(i, {"LEFT", "LH", "LINKS", "RIGHT", "RH", "RECHTS", "NEUTRAL"});
    if (const int tip = orientation_at(view, i); tip > 0) facts.orientation = tip;
    facts.back_turn |= names_back_turning(view, i);
    facts.flat_thread |= is_flat_thread(view, i);
    facts.whitworth |= is_word_of(view, i, kWhitworth);
  }
  facts.back_turn &= !hand;
  facts.blade_point = read_blade_point(view);
}

}  // namespace mrsim
