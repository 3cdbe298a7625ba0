#include "interp/text/okuma_words.h"

#include "interp/text/characters.h"
#include "interp/text/codes.h"
#include "interp/text/line_scan.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kCircleOfHoles = 34;  // G34
constexpr std::string_view kOkumaPatterns[] = {"LAA",  "ARC",  "GRDX", "GRDY",
                                               "SQRX", "SQRY", "OMIT", "RSTRT"};
constexpr std::string_view kOkumaAreas[] = {"FMILR", "FMILF", "PMIL", "PMILR", "RMILO", "RMILI"};
constexpr std::size_t kLongestBlockName = 9;  // "NAT0101" of Okuma

constexpr std::string_view kNoHole = "NCYL";  // the cycle makes no hole here

}  // namespace

// "$ XB=40 DB=1" continues the block of the line before; "$PART.MIN%" does not.
void join_okuma_lines(LineSource& source, std::uint64_t offset, std::string_view& line,
                      std::vector<char>& joined) {
  const int line_number = source.line_number();
  std::vector<char> text(line.begin(), line.end());
  const std::size_t alone = text.size();
  for (;;) {
    const std::uint64_t next = source.next_offset();
    const int number = source.line_number();
    std::string_view more;
    const bool read = source.next(more);
    const std::size_t sign = more.find_first_not_of(" \t");
    const std::size_t last = more.find_last_not_of(" \t\r");
    if (!read || sign == more.npos || more[sign] != '$' || more[last] == '%') {
      source.seek(next, number);
      break;
    }
    text.push_back(' ');
    text.insert(text.end(), more.begin() + static_cast<std::ptrdiff_t>(sign) + 1, more.end());
  }
  if (text.size() == alone) {  // reading ahead may have moved the line in memory
    source.seek(offset, line_number - 1);
    source.next(line);
    return;
  }
  joined = std::move(text);
  line = {joined.data(), joined.size()};
}

// HA and DA of Okuma are the registers of the tool in the spindle, HB and HC further ones of it.
// HP=1 is the number of a home position.
bool OkumaWords::register_word(Block& block) {
  const std::size_t from = p_;
  const char c = upper(at(p_)), n = upper(at(p_ + 1));
  if (dialect_ != Dialect::fanuc || (c != 'H' && c != 'D')) return false;
  Word word;
  word.address = letter(c);
  if (n >= 'A' && n <= 'C' && !is_name(at(p_ + 2))) {
    word.own = true;
    word.value = n - 'A' + 1;
    p_ += 2;
  } else if (c == 'H' && n == 'P' && at(p_ + 2) == '=' && starts_number(at(p_ + 3))) {
    word.address = letter('P');
    p_ += 3;
    if (!number(block, word, false)) return true;
  } else {
    return false;
  }
  push(block, word, from);
  return true;
}

// "BHC X Y I J K" of Okuma is Mitsubishi's G34: a circle of holes. Its other patterns and its areas
// are refused by name.
bool OkumaWords::pattern(Block& block) {
  const std::size_t from = p_;
  std::size_t end = p_;
  while (is_letter(at(end))) ++end;
  const std::string name = upper_case(line_.substr(p_, std::min<std::size_t>(end - p_, 6)));
  if (dialect_ != Dialect::fanuc) return false;
  if (name == kNoHole) {
    p_ = end;
    block.no_hole = true;
    return true;
  }
  if (name == "BHC") {
    p_ = end;
    Word word;
    word.address = letter('G');
    word.value = kCircleOfHoles;
    push(block, word, from);
    return true;
  }
  const auto listed = [&](const auto& names) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
  };
  if (!listed(kOkumaPatterns) && !listed(kOkumaAreas)) return false;
  p_ = end;
  unsupported(block, line_.substr(from, end - from),
              listed(kOkumaAreas) ? "an area that Okuma's OSP mills" : "a pattern of Okuma's OSP",
              from);
  return true;
}

// "OSUB" of Okuma names a program.
bool OkumaWords::program(Block& block) {
  if (dialect_ != Dialect::fanuc || !block.words.empty() || !names_okuma_program(line_, p_))
    return false;
  const std::size_t from = p_;
  while (is_letter(at(p_)) || is_digit(at(p_))) ++p_;
  Word word;
  word.address = Address::function;
  word.code = Code::header;
  word.text = line_.substr(from, p_ - from);
  push(block, word, from);
  return true;
}

// "<PART-1>" of FANUC's 30i names a program: as a header, or instead of P behind a call.
bool OkumaWords::program_in_brackets(Block& block) {
  const std::string_view name = bracketed_name(line_, p_);
  const std::size_t from = p_;
  if (dialect_ != Dialect::fanuc || name.empty()) return false;
  const bool calls = std::any_of(block.words.begin(), block.words.end(), [](const Word& word) {
    return word.address == letter(word.value < 97 ? 'G' : 'M') &&
           (word.value == 65 || word.value == 66 || word.value == 98 || word.value == 198);
  });
  if (!calls && (!block.words.empty() || line_.find_first_not_of(" \t") != from)) return false;
  p_ += name.size() + 2;
  Word word;
  word.address = calls ? letter('P') : Address::function;
  word.code = calls ? Code::unknown : Code::header;
  word.string = calls;
  word.text = name;
  push(block, word, from);
  return true;
}

// "VC1=2" and "DIA = 50" of Okuma set a variable. "X=5" is a word.
bool OkumaWords::assigns_name() const {
  if (dialect_ != Dialect::fanuc || !language_) return false;
  const bool common = upper(at(p_)) == 'V' && is_digit(at(p_ + 1));
  if (!common && !is_letter(at(p_ + 1))) return false;
  std::size_t end = p_;
  while (is_letter(at(end)) || is_digit(at(end))) ++end;
  while (blank(at(end)) && end < line_.size()) ++end;
  return at(end) == '=';
}

// "NAT01 T010101" of Okuma: the block has a name instead of a number.
bool OkumaWords::block_name(Block& block) {
  std::size_t end = p_ + 1;
  while (is_letter(at(end)) || is_digit(at(end))) ++end;
  const bool first = block.words.empty() && !block.has_number;
  if (dialect_ != Dialect::fanuc || !first || upper(at(p_)) != 'N' ||
      end - p_ > kLongestBlockName || !is_letter(at(p_ + 1)) || is_name(at(end)) || at(end) == '=')
    return false;
  const std::string name = upper_case(line_.substr(p_, end - p_));
  if (name == kNoHole) return false;
  Word word;
  word.column = static_cast<int>(p_);
  word.length = static_cast<int>(end - p_);
  reporter_.once(Severity::note, "block-name",
                 fmt::format("{} is the name of its block, as on Okuma's controls: left out", name),
                 word, "block-name");
  block.has_number = true;
  block.name = line_.substr(p_, end - p_);
  p_ = end;
  return true;
}

// "G84 XA=80 DA=4 FA=0.2" behind G85: depths and feeds from a place on.
void OkumaWords::skip_conditions(Block& block) {
  reporter_.once(
      Severity::note, "cycle-contour",
      "G84 of LAP, other depths and feeds on the way, is not read: the shape is the same",
      block.words.back(), "G84");
  block.words.pop_back();
  p_ = std::min(line_.find('(', p_), line_.size());
}

// "G85 NLAP1 D4" of Okuma: NLAP1 is the name of the block that begins the contour.
bool OkumaWords::contour_name(Block& block) {
  const bool calls = std::any_of(block.words.begin(), block.words.end(), [](const Word& word) {
    return word.address == letter('G') && word.value >= 85 && word.value <= 88;
  });
  std::size_t end = p_ + 1;
  while (is_letter(at(end)) || is_digit(at(end))) ++end;
  if (dialect_ != Dialect::fanuc || !calls || upper(at(p_)) != 'N' || !is_letter(at(p_ + 1)) ||
      upper_case(line_.substr(p_, end - p_)) == kNoHole)
    return false;
  block.contour = line_.substr(p_, end - p_);
  p_ = end;
  return true;
}

}  // namespace mrsim
