#include "interp/text/tool_kind.h"

#include <string_view>

namespace mrsim {
namespace {

enum Form : std::uint8_t { firm, soft, no_shape, pointed, toothed };

struct Phrase {
  std::string_view words;  // apart by blanks; '*' at the end of a word stands for any ending
  ToolType type;
  Form form = firm;
  double tip_angle = 0;
};

// '~' stands for any character outside of ASCII. The first phrase that is found counts, so the
// particular stands before the general.
using enum ToolType;
constexpr Phrase kPhrases[] = {
    {"THREAD MILL*", endmill, toothed},
    {"THREADMILL*", endmill, toothed},
    {"GEWINDEFR*", endmill, toothed},
    {"DOVETAIL", form, no_shape},
    {"SCHWALBENSCHWANZ*", form, no_shape},
    {"FORM MILL", form, no_shape},
    {"FORM TOOL", form, no_shape},
    {"FORMFR*", form, no_shape},
    {"RADIUS MILL", form, no_shape},
    {"CORNER ROUNDING", form, no_shape},
    {"ROUNDOVER", form, no_shape},
    {"ROUND OVER", form, no_shape},
    {"TAPERED BALL", form, no_shape},
    {"SLITTING SAW", form, no_shape},
    {"PROBE", form, no_shape},
    {"BORING BAR", boring},
    {"BORING HEAD", endmill},
    {"AUSSPINDEL*", endmill},
    {"BOHRSTANGE", boring},
    {"TURNING BORING", boring},
    {"GROOVING TOOL", grooving},
    {"GROOVING INSERT", grooving},
    {"GROOVE TOOL", grooving},
    {"TURNING GROOVING", grooving},
    {"PARTING TOOL", grooving},
    {"PARTING BLADE", grooving},
    {"PART OFF TOOL", grooving},
    {"CUTOFF TOOL", grooving},
    {"CUT OFF TOOL", grooving},
    {"STECHSTAHL", grooving},
    {"RANURAR", grooving},
    {"THREADING TOOL", threading},
    {"THREADING INSERT", threading},
    {"TURNING THREADING", threading},
    {"GEWINDEDREH*", threading},
    {"TURNING TOOL", turning},
    {"TURNING INSERT", turning},
    {"GENERAL TURNING", turning},
    {"TURNING GENERAL", turning},
    {"TURN TOOL", turning},
    {"LATHE TOOL", turning},
    {"DREHMEI*", turning},
    {"DREHSTAHL", turning},
    {"SCHLICHTSTAHL", turning},
    {"SCHRUPPSTAHL", turning},
    {"STRU~*", turning},
    {"STRUZ*", turning},
    {"CUCHILLA", turning},
    {"NO~", turning},
    {"NOZ", turning},
    {"LOLLIPOP", lollipop},
    {"BARREL", barrel, soft},
    {"T SLOT", tslot},
    {"TSLOT", tslot},
    {"T NUTENFR*", tslot},
    {"SLOT DRILL", endmill},
    {"SPOT DRILL*", drill, firm, 90},
    {"SPOTDRILL*", drill, firm, 90},
    {"SPOTTING DRILL", drill, firm, 90},
    {"NC ANBOHRER", drill, firm, 90},
    {"ANBOHRER", drill, firm, 90},
    {"CENTER DRILL*", drill, firm, 60},
    {"CENTRE DRILL*", drill, firm, 60},
    {"CENTERDRILL*", drill, firm, 60},
    {"ZENTRIERBOHRER", drill, firm, 60},
    {"GEWINDEBOHRER", endmill},
    {"TAP", endmill, soft},
    {"TAPPING", endmill, soft},
    {"REAMER", endmill},
    {"REIBAHLE", endmill},
    {"COUNTER BORE", endmill, soft},
    {"COUNTERBORE", endmill, soft},
    {"COUNTERSINK", chamfer, soft, 90},
    {"COUNTER SINK", chamfer, soft, 90},
    {"KEGELSENKER", chamfer, firm, 90},
    {"V BIT*", chamfer, pointed},
    {"VBIT*", chamfer, pointed},
    {"VCARVE BIT", chamfer, pointed},
    {"V GROOVE*", chamfer, pointed},
    {"ENGRAV*", chamfer, pointed},
    {"GRAVIER*", chamfer, pointed},
    {"CHAMFER MILL", chamfer, firm, 90},
    {"CHAMFER TOOL", chamfer, firm, 90},
    {"CHAMFER CUTTER", chamfer, firm, 90},
    {"CHAMFER", chamfer, soft, 90},
    {"FASENFR*", chamfer, firm, 90},
    {"TAPERED MILL", taper, pointed},
    {"TAPER MILL", taper, pointed},
    {"TAPERED ENDMILL", taper, pointed},
    {"TAPERED END MILL", taper, pointed},
    {"BALLNOSE*", ballmill},
    {"BALL NOSE*", ballmill},
    {"BALLMILL", ballmill},
    {"BALL", ballmill, soft},
    {"KUGEL", ballmill, soft},
    {"KUGELFR*", ballmill},
    {"KROGL*", ballmill},
    {"KROGEL*", ballmill},
    {"ESFERICA", ballmill, soft},
    {"FRESA DE BOLA", ballmill},
    {"SFERICA", ballmill, soft},
    {"HEMISPHERIQUE", ballmill, soft},
    {"BULLNOSE*", bullmill},
    {"BULL NOSE*", bullmill},
    {"BULL", bullmill, soft},
    {"TORUS", bullmill, soft},
    {"TORUSFR*", bullmill},
    {"TORICA", bullmill, soft},
    {"END MILL", endmill},
    {"ENDMILL", endmill},
    {"FLAT END*", endmill},
    {"FLAT MILL", endmill},
    {"FACE MILL", endmill},
    {"FACEMILL", endmill},
    {"SHELL MILL", endmill},
    {"SQUARE MILL", endmill},
    {"SLOT MILL", endmill},
    {"SLOTMILL", endmill},
    {"FLY CUTTER", endmill},
    {"ROUTER BIT", endmill},
    {"STRAIGHT BIT", endmill},
    {"FREZALO", endmill},
    {"STEBLAST*", endmill},
    {"SCHAFTFR*", endmill},
    {"SCHRUPPFR*", endmill},
    {"SCHLICHTFR*", endmill},
    {"PLANFR*", endmill},
    {"LANGLOCHFR*", endmill},
    {"BOHRNUTENFR*", endmill},
    {"FRAESER", endmill},
    {"FR~SER", endmill},
    {"FRESA", endmill},
    {"FRAISE", endmill},
    {"DRILL", drill, soft},
    {"BOHRER", drill},
    {"SPIRALBOHRER", drill},
    {"SVEDER", drill},
    {"BROCA", drill},
    {"FORET", drill},
    {"UPCUT", endmill, soft},
    {"DOWNCUT", endmill, soft},
    {"FLAT", endmill, soft},
    {"MILL", endmill, soft},
    {"EM", endmill, soft},
    {"TURNING", turning, soft},
    {"GROOVING", grooving, soft},
    {"PARTING", grooving, soft},
    {"CUTOFF", grooving, soft},
    {"THREADING", threading, soft},
    {"GROOVE", grooving, soft},
    {"PART OFF", grooving, soft},
    {"PARTOFF", grooving, soft},
    {"CUT OFF", grooving, soft},
    {"THREAD", threading, soft},
};

bool matches(std::string_view pattern, const CommentToken& token) {
  if (token.kind != CommentToken::Kind::word) return false;
  if (pattern.back() == '*') return token.text.starts_with(pattern.substr(0, pattern.size() - 1));
  return token.text == pattern;
}

// The token behind the phrase that begins at `at`, or 0. "T-SLOT" has a dash between its words.
std::size_t match_phrase(std::string_view words, const std::vector<CommentToken>& tokens,
                         std::size_t at) {
  for (bool first = true; !words.empty(); first = false) {
    const std::size_t blank = words.find(' ');
    if (!first && at < tokens.size() && tokens[at].is("-") && tokens[at].glued) ++at;
    if (at >= tokens.size() || !matches(words.substr(0, blank), tokens[at])) return 0;
    ++at;
    words = blank == words.npos ? std::string_view() : words.substr(blank + 1);
  }
  return at;
}

}  // namespace

std::optional<ToolKind> find_tool_kind(const std::vector<CommentToken>& tokens) {
  for (const Phrase& phrase : kPhrases) {
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      const std::size_t end = match_phrase(phrase.words, tokens, i);
      if (end == 0) continue;
      ToolKind kind;
      kind.type = phrase.type;
      kind.firm = phrase.form != soft;
      kind.indescribable = phrase.form == no_shape;
      kind.plain_teeth = phrase.form == toothed;
      kind.needs_angle = phrase.form == pointed;
      kind.tip_angle = phrase.tip_angle;
      kind.first = i;
      kind.end = end;
      return kind;
    }
  }
  return std::nullopt;
}

}  // namespace mrsim
