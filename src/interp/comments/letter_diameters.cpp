#include "interp/comments/letter_diameters.h"

#include "interp/comments/shank_words.h"

#include <utility>

namespace mrsim {
namespace {

class LetterReader {
 public:
  LetterReader(CommentView& view, ToolFacts& facts) : view_(view), facts_(facts) {}

  void read_signs();
  void read_letter_d();

 private:
  double length_register_beside() const;
  bool is_beside_its_register(std::size_t size, double length_register) const;
  void read_second_d(std::size_t i);
  bool read_before_shank(std::size_t i);

  CommentView& view_;
  ToolFacts& facts_;
};

// Reads diameters behind signs: "Ø5", "D=6.", "D: 12. R: 0.". "D: 1" may be a register.
void LetterReader::read_signs() {
  for (std::size_t i = 0; i + 1 < view_.size(); ++i) {
    const std::size_t value = view_.value_behind(i);
    if (value == CommentView::kNone || !(view_[value].value > 0)) continue;
    const bool sign = view_.is(i, "~") && !(i > 0 && view_.glued(i));
    const bool sized = view_.is(i + 1, ":") && (view_[value].decimals || view_.is(value + 1, "R"));
    const bool letter = view_.is(i, "D") && (view_.is(i + 1, "=") || sized) && value == i + 2;
    if (!sign && !letter) continue;
    facts_.names_tool |= letter;
    facts_.named.push_back(view_.length(value));
    view_.take(i, value + 1);
  }
}

// The number of the length register, H; -1: there is none. "D10H7" and "REAMER D10 H7" name a fit.
double LetterReader::length_register_beside() const {
  for (std::size_t i = 0; i + 1 < view_.size(); ++i)
    if (view_.is(i, "H") && view_[i + 1].is_number() && view_.glued(i + 1) && !view_.glued(i) &&
        !(facts_.trade_is(ToolTrade::hole) && i > 1 && view_.is(i - 2, "D")))
      return view_[i + 1].value;
  return -1;
}

// Whether D at `size` is a diameter because another D has the number of the length register: D10 in
// "FRAISE D10 H1 D1".
bool LetterReader::is_beside_its_register(std::size_t size, double length_register) const {
  if (view_[size + 1].value == length_register) return false;
  for (std::size_t i = 0; i + 1 < view_.size(); ++i)
    if (view_.is(i, "D") && view_[i + 1].is_number() && view_.glued(i + 1) &&
        view_[i + 1].value == length_register)
      return true;
  return false;
}

// Reads the D at i if the word for the shank stands behind it. It is the shank's in "D6 SHANK
// ENDMILL D3" and "D6 SHANK D3 CUT", but not in "ENDMILL D10 SHANK D12"; "D6 SHANK D3 ENDMILL" can
// be read both ways. False: it is the tool's diameter.
bool LetterReader::read_before_shank(std::size_t i) {
  if (is_size_of_shank(view_, i + 1)) return true;
  if (!is_shank(view_, i + 2)) return false;
  const std::size_t other = size_of_shank(view_, i + 2);
  const bool before_kind = !facts_.kind() || facts_.kind()->first > i;
  if (!before_kind || !view_.is(other - 1, "D") || view_[other].value >= view_[i + 1].value)
    return false;
  facts_.named.push_back(view_.length(i + 1));
  facts_.named.push_back(view_.length(other));
  return true;
}

// Reads "END MILL D5", "D10R1". Beside an H, D is the number of a register; behind a name in
// quotation marks (T="CUTTER 10" D1) it is that of a cutting edge.
void LetterReader::read_letter_d() {
  const double length_register = length_register_beside();
  for (std::size_t i = 0; i + 1 < view_.size(); ++i) {
    if (!view_.is(i, "D") || !view_.number(i + 1) || !view_.glued(i + 1)) continue;
    const CommentToken& value = view_[i + 1];
    view_.take(i, i + 2);
    if (read_before_shank(i)) continue;
    if (i > 0 && !cuts_behind_shank(view_, i - 1, i + 1) &&
        view_.is_one(i - 1, {"SHANK", "SHK", "SHAFT", "SCHAFT", "NECK", "HOLDER", "TOOLHOLDER",
                             "COLLET", "CHUCK", "ARBOR"}))
      continue;                                         // what holds it
    if (view_.is(i + 2, "=") && view_.number(i + 3)) {  // "D1=10": which of the diameters?
      if (value.value == 1) facts_.d1 = view_.length(i + 3);
      if (value.value == 2) facts_.d2 = view_.length(i + 3);
      view_.take(i + 2, i + 4);
      continue;
    }
    const bool edge = i > 0 && view_.is(i - 1, "\"") && !value.decimals;
    if (length_register >= 0 && !is_beside_its_register(i, length_register)) continue;
    if (edge || !(value.value > 0)) continue;
    if (!value.decimals && !facts_.id.empty() && value.text == facts_.id) continue;  // "T5 D5"
    if (facts_.letter_d && facts_.has_flat_tip()) read_second_d(i);
    if (!facts_.letter_d) facts_.letter_d = view_.length(i + 1);
    const bool radius = view_.is(i + 2, "R") && view_.glued(i + 2) && view_.glued(i + 3);
    facts_.pair |= radius && view_[i + 3].is_number();
  }
}

// Reads the second D: the tip in "CHAMFER MILL D10/D2"; in "D10 D2" it may name a register.
void LetterReader::read_second_d(std::size_t i) {
  const ToolLength second = view_.length(i + 1);
  if (second.value == facts_.letter_d.value) return;
  const bool joined = view_.glued(i) && view_.is_one(i - 1, {"/", "-"});
  if (!joined) {
    facts_.second_d = second;
    return;
  }
  facts_.tip = second;
  if (facts_.letter_d.value < second.value) std::swap(facts_.tip, facts_.letter_d);
}

}  // namespace

void read_letter_diameters(CommentView& view, ToolFacts& facts) {
  LetterReader reader(view, facts);
  reader.read_signs();
  reader.read_letter_d();
}

}  // namespace mrsim
