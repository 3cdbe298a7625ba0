// A line of NC text in upper case, without its comments, for code that looks for signs of a control
// before the program is read.
#pragma once

#include <string>
#include <string_view>

namespace mrsim {

/// Whether the ":" at `at` names a program, as an O does: ":1234 (NAME)". A ":" before words is the
/// number of a block: ":30 T1 M6".
bool names_program(std::string_view line, std::size_t at);

/// Whether the line is a remark of WinCNC: square brackets about all of it, from `from` on.
bool is_remark(std::string_view line, std::size_t from);

/// Whether the text is words of NC and nothing else: "X2 Y5;".
bool looks_like_block(std::string_view text);

/// PART-1 of "<PART-1>" at `at`, the name of a program of FANUC's 30i; empty if there is none.
std::string_view bracketed_name(std::string_view line, std::size_t at);

/// "OSUB", "OSUB (NAME)": the name of a program of Okuma, and nothing else.
bool names_okuma_program(std::string_view line, std::size_t at);

/// "G85 NLAP1 D4" of Okuma's lathes: a turning cycle by the name of its contour.
bool calls_lap(std::string_view code);

/// One line and its comments apart.
struct LineScan {
  std::string code;  ///< upper case
  std::string_view comment;
  char comment_kind = '\0';
  bool ends_block = false;  ///< ';' with nothing behind it
};

/// Fills `out`. Tells comments from calls with brackets, and a ";" that ends a block from one that
/// begins a comment.
void scan_line(std::string_view line, LineScan& out);

/// Which kinds of words a line of plain motion has.
struct PlainLine {
  bool line = false;    ///< G0, G1
  bool arc = false;     ///< G2, G3
  bool second = false;  ///< Y, J
  bool third = false;   ///< Z, K
  bool radius = false;  ///< R
};

/// True for a line of nothing but N, G0 to G3 and X Y Z I J K R F S, as most lines of a long
/// program are. scan_line() and the functions below would find nothing else in it, and cost far
/// more.
bool read_plain(std::string_view line, PlainLine& out);

/// Whether `token` stands in the text with no letter before it.
bool has(std::string_view text, std::string_view token);
/// Whether the word stands in the comment with no letters beside it.
bool has_whole_word(std::string_view comment, std::string_view word);
/// Whether a word (a letter and its number) stands in the text: G2 does not stand in "G21".
bool has_word(std::string_view text, std::string_view word);
/// Whether a word of this axis stands in the text: "G0X", "G90 X1", "Y#1", "Y[#2+1]", "YP1" and
/// "Y(P1+2)" have one.
bool has_axis(std::string_view text, char axis);

}  // namespace mrsim
