#include "interp/comments/work_words.h"

#include "interp/comments/comment_words.h"
#include "interp/comments/tool_id.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace mrsim {
namespace {

// Work that mills do, at whatever diameter, what they are for, and where: "SCHRUPPEN D16", "CONTOUR
// D12", "D12 FINISH WALLS".
constexpr std::string_view kMilling[] = {
    "MILLING",     "CUT",           "CUTTING",      "SEMI",        "CONTOUR",     "CONTOURING",
    "PROFILING",   "FACE",          "FACING",       "OUTSIDE",     "OUTER",       "AND",
    "USE",         "WITH",          "NAME",         "DESC",        "DESCRIPTION", "ZMIN",
    "ZMAX",        "FRAESEN",       "FR~SEN",       "SCHRUPPEN",   "SCHLICHTEN",  "SCHRUPP",
    "SCHLICHT",    "VORSCHLICHTEN", "VORSCHRUPPEN", "PLANEN",      "PLANFRAESEN", "PLANFR~SEN",
    "KONTUR",      "AUSSENKONTUR",  "FRESATURA",    "SPIANATURA",  "CONTORNO",    "CONTORNATURA",
    "SGROSSATURA", "SGROSSARE",     "FINITURA",     "FRESADO",     "PLANEADO",    "CONTORNEADO",
    "PERFILADO",   "FRAISAGE",      "SURFACAGE",    "CONTOURNAGE", "DETOURAGE",   "D~TOURAGE",
    "~BAUCHE",     "FREZOWANIE",    "PLANOWANIE",   "ZGRUBNE",     "ZGRUBNIE",    "WYKANCZAJACE",
    "FREZOVANI",   "FREZANJE",      "FREZEROVANIE", "FRESAMENTO",  "FACEAMENTO",  "CONTORNOS",
    "KEYWAY",      "SIDE",          "SIDES",        "FLOORS",      "SEITE",       "SEITEN",
    "WAND",        "BODEN",         "AUSSEN",       "INNEN",       "ALU",         "ALUMINIUM",
    "ALUMINUM",    "STEEL",         "STAHL",        "HPC",         "HSC",         "NEW",
    "NEU",         "NUMBER",        "NUMMER",       "NUMERO"};

// Of words about the work those that have a width or a diameter: "POCKET D30".
constexpr std::string_view kSized[] = {"POCKET",  "SLOT",      "TASCHE",   "NUT",  "POCHE",
                                       "RAINURE", "CAJERA",    "BOSS",     "BOLT", "PCD",
                                       "BCD",     "LOCHKREIS", "TEILKREIS"};

bool is_round_work(const CommentView& view, std::size_t i) {
  return view.word(i) && !view.taken(i) &&
         view.is_one(i, {"HOLE", "HOLES", "BORE", "BORES", "CIRCLE", "CIRCLES", "CIRCULAR", "RING",
                         "POCKET", "POCKETS", "RECESS", "BOSS", "BOSSES", "HELICAL", "HELIX"});
}

bool makes_holes(const ToolKind& kind) {
  using enum ToolTrade;
  return kind.trade == twist_drill || kind.trade == hole || kind.trade == tap;
}

}  // namespace

bool is_strange_word(const CommentView& view, std::size_t i) {
  if (!view.word(i) || view.taken(i) || is_word_for_tool(view, i)) return false;
  const std::string_view word = view[i].text;
  if (word.size() < 3 || std::ranges::find(kMilling, word) != std::end(kMilling)) return false;
  const WordRole role = comment_word(word).role;
  if (role == WordRole::work) return std::ranges::find(kSized, word) != std::end(kSized);
  return role == WordRole::none || role == WordRole::count;
}

bool mills_round_work(const CommentView& view, const ToolKind& mill) {
  if (!view.is(mill.first, "MILL")) return false;
  for (std::size_t i = 0; i < view.size(); ++i)
    if (is_round_work(view, i)) return true;
  return false;
}

bool names_next_tool(const CommentView& view) {
  for (std::size_t i = 0; i < view.size(); ++i)
    if (view.is_one(i, {"NEXT", "NAECHSTES", "N~CHSTES", "SUIVANT", "PROCHAIN", "SIGUIENTE",
                        "PROSSIMO", "NASTEPNE"}) &&
        (i == 0 || is_word_for_tool(view, i - 1) || is_word_for_tool(view, i + 1)))
      return true;
  return false;
}

bool names_last_tool(const CommentView& view) {
  for (std::size_t i = 0; i < view.size(); ++i)
    if (view.is_one(i, {"LAST", "PREVIOUS", "PREV", "LETZTES", "VORIGES", "PRECEDENT"}) &&
        (is_word_for_tool(view, i + 1) || (i > 0 && is_word_for_tool(view, i - 1))))
      return true;
  return false;
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
