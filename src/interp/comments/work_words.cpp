#include "interp/comments/work_words.h"

#include "interp/comments/comment_words.h"
#include "interp/comments/tool_id.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace mrsim {
namespace {

// Words of several languages for holes, pockets and bosses, and for what drills, taps, reamers,
// countersinks and deburring tools do. A diameter beside them is that of the work or of such a
// tool.
constexpr std::string_view kOtherWork[] = {
    "BOHRUNG",    "BOHRUNGEN",   "BOHREN",    "AUFBOHREN",  "LOCH",        "ZAPFEN",
    "REIBEN",     "SENKUNG",     "SENKEN",    "ANSENKEN",   "ZENTRIEREN",  "ENTGRATEN",
    "FASEN",      "KREISTASCHE", "KREISNUT",  "INNENKREIS", "GEWINDEN",    "HOLE",
    "HOLES",      "BORE",        "HELICAL",   "CIRCULAR",   "CIRCLE",      "CIRCLES",
    "REAMING",    "TAPPING",     "DEBURRING", "CHAMFERING", "SPOTTING",    "CENTERING",
    "FORO",       "FORI",        "FORATURA",  "ALESATURA",  "MASCHIATURA", "LAMATURA",
    "SVASATURA",  "SMUSSO",      "SBAVATURA", "TROU",       "TROUS",       "PERCAGE",
    "PER~AGE",    "ALESAGE",     "AL~SAGE",   "TARAUDAGE",  "LAMAGE",      "CHANFREINAGE",
    "AGUJERO",    "AGUJEROS",    "TALADRADO", "CAJERA",     "ESCARIADO",   "ROSCADO",
    "AVELLANADO", "BISELADO",    "FURO",      "FUROS",      "FURACAO",     "ROSQUEAR",
    "OTWOR",      "OTW~R",       "OTWORY",    "WIERCENIE",  "GWINTOWANIE", "ROZWIERCANIE",
    "FAZOWANIE",  "VRTANI",      "VRT~NI",    "SVERLENIE",  "OTVERSTIE",   "RASTOCHKA",
    "POCKET",     "SLOT",        "TASCHE",    "NUT",        "POCHE",       "RAINURE",
    "BOSS",       "BOLT",        "PCD",       "BCD",        "LOCHKREIS",   "TEILKREIS",
    "VRTANJE",    "POVRTAVANJE", "GREZENJE",  "POSNEMANJE", "IZVRTINA",    "IZVRTINE",
    "LUKNJA",     "LUKNJE",      "BUSENJE",   "BU~ENJE",    "RUPA",        "RUPE",
    "ZEP",        "~EP",         "UTOR"};

bool is_round_work(const CommentView& view, std::size_t i) {
  return view.word(i) && !view.taken(i) &&
         view.is_one(i, {"HOLE", "HOLES", "BORE", "BORES", "CIRCLE", "CIRCLES", "CIRCULAR", "RING",
                         "POCKET", "POCKETS", "RECESS", "BOSS", "BOSSES"});
}

// Whether the word names a way to mill round work, or the teeth of a mill.
bool is_helical(const CommentView& view, std::size_t i) {
  return view.word(i) && !view.taken(i) && view.is_one(i, {"HELICAL", "HELIX"});
}

// Whether the word at i begins the comment; a word for tools may stand before it.
bool leads(const CommentView& view, std::size_t i) {
  return i == 0 || (i == 1 && is_word_for_tool(view, 0));
}

bool makes_holes(const ToolKind& kind) {
  using enum ToolTrade;
  return kind.trade == twist_drill || kind.trade == hole || kind.trade == tap;
}

}  // namespace

bool is_other_work(const CommentView& view, std::size_t i) {
  if (!view.word(i) || view.taken(i) || is_word_for_tool(view, i)) return false;
  const std::string_view word = view[i].text;
  return std::ranges::find(kOtherWork, word) != std::end(kOtherWork);
}

bool is_unknown_word(const CommentView& view, std::size_t i) {
  constexpr std::size_t kShortest = 4;  // shorter words may be abbreviations of anything
  if (!view.word(i) || view.taken(i) || is_word_for_tool(view, i)) return false;
  return view[i].text.size() >= kShortest && comment_word(view[i].text).role == WordRole::none;
}

bool mills_round_work(const CommentView& view, const ToolKind& mill) {
  if (!view.is(mill.first, "MILL")) return false;
  for (std::size_t i = 0; i < view.size(); ++i)
    if (is_round_work(view, i) || (is_helical(view, i) && i < mill.first)) return true;
  return false;
}

bool names_next_tool(const CommentView& view) {
  for (std::size_t i = 0; i < view.size(); ++i)
    if (leads(view, i) &&
        view.is_one(i, {"NEXT", "NAECHSTES", "N~CHSTES", "SUIVANT", "PROCHAIN", "SIGUIENTE",
                        "PROSSIMO", "NASTEPNE"}) &&
        (i == 0 || is_word_for_tool(view, i - 1) || is_word_for_tool(view, i + 1)))
      return true;
  return false;
}

bool names_last_tool(const CommentView& view) {
  const bool ends = (view.is(0, "END") && view.is(1, "OF")) ||
                    (view.is_one(0, {"DONE", "FINISHED"}) && view.is(1, "WITH")) ||
                    (view.is(0, "ENDE") && view.word(1)) ||
                    (view.is(0, "FIN") && view.is_one(1, {"DE", "DU"}));
  if (ends) return true;  // "END OF 10MM ENDMILL"
  for (std::size_t i = 0; i < view.size(); ++i)
    if (leads(view, i) &&
        view.is_one(i, {"LAST", "PREVIOUS", "PREV", "LETZTES", "VORIGES", "PRECEDENT"}) &&
        (is_word_for_tool(view, i + 1) || (i > 0 && is_word_for_tool(view, i - 1))))
      return true;
  return false;
}

bool tells_upkeep(const CommentView& view) {
  bool order = false, when = false;
  for (std::size_t i = 0; i < view.size(); ++i) {
    order |= view.is_one(i, {"REPLACE", "CHANGE", "CHECK", "INSPECT", "INDEX", "SWAP", "REGRIND",
                             "WECHSELN", "PRUEFEN", "REMPLACER", "CAMBIAR"});
    when |= view.is_one(
        i, {"EVERY", "WHEN", "IF", "WORN", "BROKEN", "DULL", "ALLE", "TOUS", "TOUTES", "CADA"});
  }
  return order && when;
}

bool names_hollow(const CommentView& view) {
  bool hollow = false;
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (is_word_for_tool(view, i) || view.is_one(i, {"CUTTER", "BIT", "="})) return false;
    hollow |= is_round_work(view, i) ||
              view.is_one(i, {"SLOT", "BOHRUNG", "BOHRUNGEN", "LOCH", "ZAPFEN", "KREISTASCHE",
                              "KREISNUT", "INNENKREIS", "TASCHE", "NUT", "FORO", "FORI", "TROU",
                              "TROUS", "POCHE", "RAINURE", "AGUJERO", "AGUJEROS", "CAJERA"});
  }
  return hollow;
}

bool is_diameter_of_work(const CommentView& view, const ToolKind* kind, std::size_t first,
                         std::size_t next) {
  if (kind && makes_holes(*kind)) return false;
  const auto diameter = [&](std::size_t i) {
    return view.word(i) && comment_word(view[i].text).role == WordRole::diameter;
  };
  return (diameter(first) && is_round_work(view, next)) ||
         (is_round_work(view, first) && diameter(next));
}

}  // namespace mrsim
