#include "interp/words/okuma_turning.h"

#include <fmt/format.h>

namespace mrsim {

// Removes words that do not change the shape.
void OkumaTurning::drop(std::string_view letters) {
  for (Word& word : block_.words)
    if (word.address < Address::function &&
        letters.find(static_cast<char>(word.address)) != letters.npos)
      word.address = Address::data;
}

void OkumaTurning::move_to(char from, char to, double factor) {
  Word* const word = block_.search(from);
  if (!word) return;
  word->address = letter(to);
  word->value *= factor;
  word->point = true;  // its value is not in least increments
}

bool OkumaTurning::refuse(const Word& code, std::string_view what) {
  return error("not-supported",
               fmt::format("{} of Okuma's lathes ({}) is not supported yet", text_of(code), what),
               code);
}

bool OkumaTurning::rewrite() {
  if (!lathe() || !is(Dialect::fanuc) || !modal_.okuma) return true;
  if (block_.search('P') && block_.search('Q'))
    return true;  // FANUC's cycle, whose contour is given by blocks
  for (std::size_t i = 0; i < block_.words.size(); ++i) {
    Word& code = block_.words[i];
    if (code.address != letter('G')) continue;
    if (code.value == 31 || code.value == 33) return thread(code);
    if (code.value == 32) return refuse(code, "threads on a face");
    if (code.value == 34 || code.value == 35) return refuse(code, "threads with a growing lead");
    if (code.value == 71) return compound_thread(code);
    if (code.value == 72) return refuse(code, "threads on a face");
    if (code.value == 73) grooves(code);
    if (code.value == 74) deep_hole();
    if (code.value == 77 || code.value == 78) drop("K");  // K says where a tap begins
    if (code.value == 94) code.value = 98;                // G94 is the feed per minute
  }
  drop("E");  // E is the feed along the contour of LAP
  return !moves_other_axis();
}

// W of "G0 W-300" is the axis of the sub-spindle or the tailstock. X and Z are increments only
// behind G91.
bool OkumaTurning::moves_other_axis() {
  for (const Word& word : block_.words)
    if (word.address == letter('G') && (word.value == 4 || (word.value >= 70 && word.value < 90)))
      return false;
  for (const char c : {'U', 'W'})
    if (const Word* word = block_.search(c))
      return !error("not-supported",
                    fmt::format("{} is an axis of its own on Okuma's lathes, which is not "
                                "supported; for increments of X and Z they have G91",
                                c),
                    *word);
  return false;
}

// Whether I or A gives a taper.
bool OkumaTurning::has_taper(Word& code) {
  for (const char c : {'I', 'A'})
    if (const Word* word = block_.search(c); word && word->value != 0)
      return !refuse(code, "a tapered thread");
  drop("IA");
  return false;
}

// J is the number of threads on the length F.
void OkumaTurning::share_lead() {
  Word* const lead = block_.search('F');
  if (const Word* threads = block_.search('J'); threads && lead && threads->value > 0)
    lead->value /= threads->value;
  drop("J");
}

// "G33 X Z F", and then X alone for the next passes: the tool goes to X, cuts the thread, goes out
// and back, as G92 does.
bool OkumaTurning::thread(Word& code) {
  if (has_taper(code)) return false;
  share_lead();
  drop("EKLC");  // phases and run-out
  code.value = 92;
  return true;
}

// "G71 X Z B D U H F M33 M73": the height H and the first depth D are of the diameter, and B is the
// angle of the tip. M33 infeeds on both flanks. U and the order of depths do not change the shape.
bool OkumaTurning::compound_thread(Word& code) {
  if (!block_.search('X') && !block_.search('Z')) return true;  // it is no cycle
  const Word* const growth = block_.search('E');
  if (growth && growth->value != 0) return refuse(code, "a thread with a growing lead");
  if (has_taper(code)) return false;
  if (!block_.search('H') || !block_.search('D'))
    return error("value-missing", "G71 needs H, the height of the thread, and D, its first depth",
                 code);
  share_lead();
  drop("UELQ");
  bool both = false;
  for (Word& word : block_.words)
    if (word.address == letter('M') &&
        ((word.value >= 32 && word.value <= 34) || (word.value >= 73 && word.value <= 75))) {
      both |= word.value == 33;
      word.address = Address::data;
    }
  move_to('H', 'K', 0.5);
  move_to('D', 'D', 0.5);
  move_to('B', 'A', 1);
  code.value = 76;
  if (!both) return true;
  Word pattern = code;
  pattern.address = letter('P');
  pattern.value = 2;
  block_.words.push_back(pattern);
  return true;
}

// "G73 X Z K D L F" cuts grooves as G75 does: strokes of D, of the diameter, at places K apart.
void OkumaTurning::grooves(Word& code) {
  if (!block_.search('X') && !block_.search('Z')) return;
  drop("ILET");
  move_to('D', 'I', 0.5);
  code.value = 75;
}

// "G74 X Z I D L F": strokes of D at places I apart, of the diameter. The tool leaves the hole
// after L.
void OkumaTurning::deep_hole() {
  drop("KLET");
  move_to('D', 'K', 1);
  move_to('I', 'I', 0.5);
}

}  // namespace mrsim
