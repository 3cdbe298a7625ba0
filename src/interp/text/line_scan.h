// A line of NC text for those who only look for signs: upper case, comments set aside.
#pragma once

#include <string>
#include <string_view>

namespace mrsim {

/// Whether the ":" at `at` names a program, as an O does: ":1234 (NAME)". Before words it is the
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

/// What one line says, comments taken out.
struct LineScan {
  std::string code;  ///< upper case
  std::string_view comment;
  char comment_kind = '\0';
  bool ends_block = false;  ///< ';' with nothing behind it
};

/// Comments are distinguished from calls with brackets, and the ";" that ends a block from that of
/// a comment.
void scan_line(std::string_view line, LineScan& out);

/// What a line of plain motion says of its control.
struct PlainLine {
  bool line = false;    ///< G0, G1
  bool arc = false;     ///< G2, G3
  bool second = false;  ///< Y, J
  bool third = false;   ///< Z, K
  bool radius = false;  ///< R
};

/// True for a line of N, G0 to G3 and X Y Z I J K R F S alone, as most lines of a long program are:
/// what else scan_line() and the functions below find is not in it. Costs a few of their calls.
bool read_plain(std::string_view line, PlainLine& out);

/// True when `token` stands in the text with no letter before it.
bool has(std::string_view text, std::string_view token);
/// A word of a comment, no letters beside it.
bool has_whole_word(std::string_view comment, std::string_view word);
/// Letter followed by exactly this number.
bool has_word(std::string_view text, std::string_view word);
/// "G0X", "G90 X1", "Y#1", "Y[#2+1]", "YP1" and "Y(P1+2)" have the axis with a value.
bool has_axis(std::string_view text, char axis);

}  // namespace mrsim
