#include "interp/text/sinumerik_arrays.h"

#include "interp/text/characters.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string>

namespace mrsim {
namespace {

// Names with an index in brackets that are without effect on geometry: SPOS[2]=90, ACC[X]=50.
constexpr std::string_view kHarmlessArrays[] = {
    "SPOS",    "SPOSA",   "POLF",     "POLFMASK", "ACC",     "OVRA",     "FA",  "FL",   "FGREF",
    "VELOLIM", "ACCLIMA", "VELOLIMA", "LIMS",     "JERKLIM", "JERKLIMA", "FXS", "FXST", "FXSW"};

struct GroupOfCodes {
  int group;
  std::initializer_list<double> codes;
};

// G[n]=m is the m-th code of group n.
const GroupOfCodes kGroups[] = {{1, {0, 1, 2, 3}},
                                {6, {17, 18, 19}},
                                {7, {40, 41, 42}},
                                {8, {500, 54, 55, 56, 57}},
                                {10, {60, 64, 641, 642, 643, 644, 645}},
                                {13, {70, 71, 700, 710}},
                                {14, {90, 91}},
                                {15, {93, 94, 95, 96, 97}},
                                {18, {450, 451}}};

double code_of_group(double group, double index) {
  for (const GroupOfCodes& row : kGroups)
    if (row.group == group && index >= 1 && index <= static_cast<double>(row.codes.size()))
      return row.codes.begin()[static_cast<std::size_t>(index) - 1];
  return -1;
}

}  // namespace

// The axis of POS[B], whose bracket is closed at `close`.
std::string SinumerikArrays::axis_of(std::size_t close) const {
  std::string axis = upper_case(line_.substr(p_ + 1, close - p_ - 1));
  std::erase(axis, ' ');
  return axis;
}

void SinumerikArrays::read(Block& block, std::size_t from, const std::string& name) {
  const std::string_view token = line_.substr(from, name.size());
  const bool read = language_ && (name == "AX" || name == "G");
  std::size_t close = line_.find(']', p_);
  // POS[Z3]=-200, POSA[Q1]=0: a sub-spindle, a tailstock or a loader.
  const bool moves = name.starts_with("POS") && close != std::string_view::npos;
  const std::string moved = moves ? axis_of(close) : "";
  const bool harmless = std::find(std::begin(kHarmlessArrays), std::end(kHarmlessArrays), name) !=
                            std::end(kHarmlessArrays) ||
                        (moves && (moved.size() > 1 || moved < "X" || moved > "Z"));
  Word index;
  if (read) {
    ++p_;
    if (!expression(block, index, true)) return;
    skip_blanks();
    close = at(p_) == ']' ? p_ : std::string_view::npos;
  }
  if (!read && name.starts_with('_')) {  // _ZSD[2]: data of the machine
    fault(block, "variable-unset",
          name + " is not defined (alarm 12550): DEF it, or give its .DEF file with --path", from,
          p_);
    while (p_ < line_.size() && line_[p_] != ';') ++p_;
    return;
  }
  if ((!read && !harmless) || close == std::string_view::npos)
    return unsupported(block, token, "an array", from);
  p_ = close + 1;
  skip_blanks();
  if (at(p_) != '=') return unsupported(block, token, "an array", from);
  ++p_;
  Word word;
  word.address = Address::data;
  if (!value(block, word)) return;
  if (moved.size() == 1) word.code = static_cast<Code>(moved[0]);  // ABC may turn the tool
  if (name == "AX") {
    const char axis = index.string && index.text.size() == 1 ? upper(index.text[0]) : '\0';
    if (axis < 'X' || axis > 'Z')
      return unsupported(block, token, "an axis other than X Y Z", from);
    word.address = letter(axis);
    if (word.string)
      return fault(block, "expression", "a number is needed here (alarm 12150)", from, p_);
  } else if (name == "G") {
    word.address = letter('G');
    const double code = code_of_group(index.value, word.value);
    if (code < 0) return unsupported(block, token, "a code of this group", from);
    word.value = code;
  }
  push(block, word, from);
}

}  // namespace mrsim
