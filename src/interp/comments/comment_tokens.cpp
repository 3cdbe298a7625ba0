#include "interp/comments/comment_tokens.h"

#include "core/numbers/units.h"
#include "core/text/text_io.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <optional>

namespace mrsim {
namespace {

using Token = CommentToken;
using Tokens = std::vector<CommentToken>;

constexpr std::size_t kMostTokens = 200;

bool starts_value(std::string_view text, std::size_t i) {
  return is_digit(text[i]) || (text[i] == '.' && i + 1 < text.size() && is_digit(text[i + 1]));
}

// Reads "6", "6.", ".25", "6,35". A comma between digits is a decimal point unless another comma or
// point is near: "3.17,0.0" is two numbers.
Token number_token(std::string_view text, std::size_t& at) {
  const std::size_t from = at;
  bool point = false, comma = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (is_digit(c)) continue;
    if (c == '.' && !point && !comma) {
      point = true;
      continue;
    }
    if (c != ',' || point || comma || at + 1 >= text.size() || !is_digit(text[at + 1])) break;
    const std::size_t end = text.find_first_not_of("0123456789", at + 1);
    if (end != text.npos && (text[end] == ',' || text[end] == '.')) break;
    comma = true;
  }
  Token token;
  token.kind = Token::Kind::number;
  token.text = text.substr(from, at - from);
  token.decimals = point || comma;
  std::string digits(token.text.substr(0, 20));
  std::replace(digits.begin(), digits.end(), ',', '.');
  token.value = parse_number(digits).value_or(0);
  return token;
}

bool is_one_of(const Token& token, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return token.is(w); });
}

Tokens raw_tokens(std::string_view text) {
  Tokens out;
  bool blank = true;
  for (std::size_t i = 0; i < text.size() && out.size() < kMostTokens;) {
    if (text[i] == ' ' || text[i] == '\t' || text[i] == '_') {
      blank = true;
      ++i;
      continue;
    }
    Token token;
    const std::size_t from = i;
    if (text[i] == '.' && !blank && !out.empty() && is_one_of(out.back(), {"NO", "NR", "NUM"})) {
      out.back().dotted = true;  // "NO.21"
      ++i;
      continue;
    }
    if (starts_value(text, i)) {
      token = number_token(text, i);
      if (from > 0 && text[from - 1] == '_' && token.text.starts_with("00") && !token.decimals)
        token.kind = Token::Kind::word;  // "UGT0201_001"
    } else if (is_letter(text[i]) || text[i] == '~') {
      while (i < text.size() && (is_letter(text[i]) || text[i] == '~')) ++i;
      token.kind = Token::Kind::word;
      token.text = text.substr(from, i - from);
    } else {
      token.text = text.substr(i++, 1);
      if (token.text == "." && !out.empty() && out.back().kind == Token::Kind::word && !blank) {
        out.back().dotted = true;
        continue;
      }
    }
    token.glued = !blank;
    blank = false;
    out.push_back(token);
  }
  return out;
}

// Whether a number behind this token is that of a tool: in "TOOL 1 1/2 ENDMILL" the 1 belongs to
// TOOL, while "FACE MILL 1 1/2" has one number.
bool numbers_a_tool(const Token& token) {
  return is_one_of(token, {"T", "TOOL", "WERKZEUG", "WKZ", "HERRAMIENTA", "OUTIL", "UTENSILE",
                           "ORODJE", "NARZEDZIE", "NO", "NR", "NUMBER", "NUMMER", "OP", "H", "D"});
}

bool is_inch_part(double denominator) {
  for (const double part : {2, 4, 8, 16, 32, 64, 128})
    if (denominator == part) return true;
  return false;
}

// Parts the tool's number from a size behind its hyphen: "T1-3/4 EM", "T01-.75 EM".
void part_tool_number(Tokens& tokens) {
  for (std::size_t i = 0; i + 3 < tokens.size(); ++i) {
    const Token &number = tokens[i + 1], &size = tokens[i + 3];
    const bool hyphen = tokens[i + 2].is("-") && tokens[i + 2].glued && size.glued;
    const bool named = tokens[i].is("T") && !tokens[i].glued && number.is_number() && number.glued;
    const bool fraction = i + 4 < tokens.size() && tokens[i + 4].is("/");
    if (!hyphen || !named || number.decimals || !size.is_number()) continue;
    if (!size.decimals && !fraction) continue;
    tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    tokens[i + 2].glued = false;
    return;
  }
}

// Makes one number of the pieces of "1/4", "1-1/2", "1 1/2".
void join_fractions(Tokens& tokens) {
  const auto whole = [&](std::size_t i) {
    return i < tokens.size() && tokens[i].is_number() && !tokens[i].decimals;
  };
  const auto is_tools = [&](std::size_t i) {  // "TOOL - 1  3/4 FLAT ENDMILL"
    if (i < 1) return false;
    if (tokens[i - 1].is("#")) return true;  // "TOOL #1 1/2 ENDMILL"
    const bool sign = tokens[i - 1].is("-") || tokens[i - 1].is(":") || tokens[i - 1].is("=");
    return numbers_a_tool(tokens[i - (sign && i > 1 ? 2 : 1)]);
  };
  for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
    if (!tokens[i].is("/") || !whole(i - 1) || !whole(i + 1) || tokens[i + 1].value < 2) continue;
    if (!tokens[i].glued || !tokens[i + 1].glued) continue;
    Token fraction = tokens[i - 1];
    if (fraction.value >= tokens[i + 1].value) continue;  // "16/9" is no size of a tool
    if (!is_inch_part(tokens[i + 1].value)) continue;     // "10/90" is a size and an angle
    fraction.value /= tokens[i + 1].value;
    fraction.fraction = true;
    std::size_t first = i - 1;
    const bool apart =
        first >= 1 && whole(first - 1) && tokens[first - 1].value < 10 && !is_tools(first - 1);
    const bool dash = first >= 2 && tokens[first - 1].is("-") && whole(first - 2) &&
                      tokens[first - 1].glued && fraction.glued && tokens[first - 2].value < 10;
    if (apart || dash) {
      first -= apart ? 1 : 2;
      fraction.value += tokens[first].value;
      fraction.glued = tokens[first].glued;
    }
    tokens[first] = fraction;
    tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                 tokens.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    i = first + 1;
  }
}

// Whether the token is a star that stands for a degree sign, "80* TURNING TOOL"; "5*10" is a
// product.
bool is_degree_star(const Tokens& tokens, std::size_t i, const Token& number) {
  return tokens[i].is("*") && tokens[i].glued && number.value < 180 &&
         !(i + 1 < tokens.size() && tokens[i + 1].is_number());
}

// How many tokens from `i` on say that `number` is the angle of a point: "135 SPLIT POINT", "118
// PT".
std::size_t point_words(const Tokens& tokens, std::size_t i, const Token& number) {
  if (number.decimals || number.fraction || number.value < 60 || number.value >= 180) return 0;
  const std::size_t point = tokens[i].is("SPLIT") ? i + 1 : i;
  if (point >= tokens.size() || !is_one_of(tokens[point], {"POINT", "PT"})) return 0;
  return point + 1 - i;
}

// How many tokens from `i` on are the unit of `number`, which is set here.
std::size_t read_unit(const Tokens& tokens, std::size_t i, Token& number) {
  if (i >= tokens.size()) return 0;
  const Token& next = tokens[i];
  if (is_one_of(next, {"MM"})) {
    number.unit = 1;
    return 1;
  }
  // IN is a unit in ".25 IN" and "5IN", a preposition in "5 IN PLATE".
  const bool inch =
      is_one_of(next, {"INCH", "INCHES", "ZOLL", "PULGADAS", "PULG", "POUCE", "POUCES", "\""}) ||
      (next.is("IN") && (next.glued || next.dotted || number.fraction || number.decimals));
  const bool marks = next.is("'") && i + 1 < tokens.size() && tokens[i + 1].is("'");
  if (inch || marks) {
    number.unit = kMmPerInch;
    return marks ? 2 : 1;
  }
  if (is_one_of(next, {"DEG", "DEGREE", "DEGREES", "GRAD", "GRADOS", "GRADI", "DEGRES", "DEGR~S",
                       "STOPINJ", "STOPNI", "^"}) ||
      (next.is("ST") && number.value >= 30 && !number.decimals) ||
      is_degree_star(tokens, i, number)) {
    number.angle = true;
    return 1;
  }
  const std::size_t words = point_words(tokens, i, number);
  number.angle = words > 0;
  return words;
}

void join_units(Tokens& tokens) {
  Tokens out;
  bool quoted = false;  // T="CUTTER_10" is not in inches
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    out.push_back(tokens[i]);
    if (tokens[i].is("\"")) quoted = !quoted;
    const bool closes = quoted && i + 1 < tokens.size() && tokens[i + 1].is("\"");
    if (tokens[i].is_number() && !closes) i += read_unit(tokens, i + 1, out.back());
  }
  tokens = std::move(out);
}

struct ForeignWord {
  std::string_view written, english;
};

// Chinese words, and Russian ones without their endings; the longer of two comes first.
constexpr ForeignWord kForeignWords[] = {{"圆鼻刀", "BULLNOSE ENDMILL"},
                                         {"牛鼻刀", "BULLNOSE ENDMILL"},
                                         {"球头刀", "BALL ENDMILL"},
                                         {"球头铣刀", "BALL ENDMILL"},
                                         {"球刀", "BALL ENDMILL"},
                                         {"立铣刀", "ENDMILL"},
                                         {"平底刀", "FLAT ENDMILL"},
                                         {"平刀", "FLAT ENDMILL"},
                                         {"面铣刀", "FACE MILL"},
                                         {"盘铣刀", "FACE MILL"},
                                         {"铣刀", "ENDMILL"},
                                         {"中心钻", "CENTER DRILL"},
                                         {"点钻", "SPOT DRILL"},
                                         {"定点钻", "SPOT DRILL"},
                                         {"麻花钻", "DRILL BIT"},
                                         {"钻头", "DRILL BIT"},
                                         {"丝锥", "FORM TAP"},
                                         {"丝攻", "FORM TAP"},
                                         {"铰刀", "REAMER"},
                                         {"倒角刀", "CHAMFER MILL"},
                                         {"沉头刀", "COUNTERSINK"},
                                         {"沉头钻", "COUNTERSINK"},
                                         {"沉头", "COUNTERSINK"},
                                         {"锪钻", "COUNTERSINK"},
                                         {"镗刀", "BORING BAR"},
                                         {"直径", "DIA"},
                                         {"度", "DEG"},
                                         {"ラジアスエンドミル", "BULLNOSE ENDMILL"},
                                         {"ボールエンドミル", "BALL ENDMILL"},
                                         {"ボール エンドミル", "BALL ENDMILL"},
                                         {"テーパーエンドミル", "TAPER ENDMILL"},
                                         {"テーパエンドミル", "TAPER ENDMILL"},
                                         {"エンドミル", "ENDMILL"},
                                         {"正面フライス", "FACE MILL"},
                                         {"フェイスミル", "FACE MILL"},
                                         {"フェースミル", "FACE MILL"},
                                         {"センタードリル", "CENTER DRILL"},
                                         {"センタドリル", "CENTER DRILL"},
                                         {"ドリル", "DRILL BIT"},
                                         {"タップ", "FORM TAP"},
                                         {"リーマ", "REAMER"},
                                         {"面取り", "CHAMFER MILL"},
                                         {"ボーリング", "BORING BAR"},
                                         {"볼엔드밀", "BALL ENDMILL"},
                                         {"볼 엔드밀", "BALL ENDMILL"},
                                         {"엔드밀", "ENDMILL"},
                                         {"페이스밀", "FACE MILL"},
                                         {"페이스커터", "FACE MILL"},
                                         {"센터드릴", "CENTER DRILL"},
                                         {"센터 드릴", "CENTER DRILL"},
                                         {"드릴", "DRILL BIT"},
                                         {"탭", "FORM TAP"},
                                         {"리머", "REAMER"},
                                         {"ﾎﾞｰﾙｴﾝﾄﾞﾐﾙ", "BALL ENDMILL"},
                                         {"ｴﾝﾄﾞﾐﾙ", "ENDMILL"},
                                         {"ｾﾝﾀｰﾄﾞﾘﾙ", "CENTER DRILL"},
                                         {"ﾄﾞﾘﾙ", "DRILL BIT"},
                                         {"ﾀｯﾌﾟ", "FORM TAP"},
                                         {"ﾘｰﾏ", "REAMER"},
                                         {"内螺纹", "ID THREAD"},
                                         {"外螺纹", "OD THREAD"},
                                         {"内孔", "ID"},
                                         {"外圆", "OD"},
                                         {"切槽", "GROOVE"},
                                         {"切断", "CUT OFF"},
                                         {"粗车", "ROUGH TURN"},
                                         {"精车", "FINISH TURN"},
                                         {"镗", "BORE"},
                                         {"内径", "ID"},
                                         {"外径", "OD"},
                                         {"端面", "FACE"},
                                         {"溝入れ", "GROOVE"},
                                         {"溝", "GROOVE"},
                                         {"ネジ", "THREAD"},
                                         {"ねじ", "THREAD"},
                                         {"突切", "CUT OFF"},
                                         {"突っ切", "CUT OFF"},
                                         {"내경", "ID"},
                                         {"외경", "OD"},
                                         {"나사", "THREAD"},
                                         {"절단", "CUT OFF"},
                                         {"внутр", "INTERNAL"},
                                         {"наруж", "EXTERNAL"},
                                         {"расточ", "BORE"},
                                         {"концев", "ENDMILL"},
                                         {"сферич", "BALL ENDMILL"},
                                         {"торцев", "FACE MILL"},
                                         {"фреза", "ENDMILL"},
                                         {"сверло", "DRILL BIT"},
                                         {"метчик", "FORM TAP"},
                                         {"развертк", "REAMER"},
                                         {"зенковк", "COUNTERSINK"},
                                         {"центров", "CENTER DRILL"},
                                         {"отрезн", "PARTING TOOL"},
                                         {"канавочн", "GROOVING TOOL"},
                                         {"резьбов", "THREADING TOOL"},
                                         {"резьб", "THREAD"},
                                         {"резец", "TURNING TOOL"},
                                         {"мм", "MM"}};

bool is_cyrillic(std::string_view text) {
  return text.size() > 1 && (text[0] == '\xD0' || text[0] == '\xD1');
}

// Makes Russian capitals small letters.
std::string small_cyrillic(std::string_view utf8) {
  std::string out(utf8);
  for (std::size_t i = 0; i + 1 < out.size(); ++i) {
    const auto second = static_cast<unsigned char>(out[i + 1]);
    if (out[i] != '\xD0' || second < 0x90 || second > 0xAF) continue;
    if (second >= 0xA0) out[i] = '\xD1';
    out[i + 1] = static_cast<char>(second < 0xA0 ? second + 0x20 : second - 0x20);
    ++i;
  }
  return out;
}

// Appends the English of the word that begins `rest`, between blanks. Gives the length of the word
// with its ending, or 0 if the table does not have it.
std::size_t translate(std::string_view rest, std::string& out) {
  constexpr std::string_view kTool = "\u53f7\u5200";  // behind the number of the tool
  if (rest.starts_with(kTool)) {
    std::size_t first = out.size();
    while (first > 0 && is_digit(out[first - 1])) --first;
    out.insert(first, " TOOL ");
    out += ' ';
    return kTool.size();
  }
  for (const auto& [written, english] : kForeignWords) {
    if (!rest.starts_with(written)) continue;
    std::size_t end = written.size();
    if (is_cyrillic(written))
      while (is_cyrillic(rest.substr(end))) end += 2;
    out.append(" ").append(english).append(" ");
    return end;
  }
  return 0;
}

}  // namespace

std::string fold_comment(std::string_view written) {
  const std::string utf8 = small_cyrillic(written);
  std::string out;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = static_cast<unsigned char>(utf8[i]);
    if (byte < 0x80) out += upper(utf8[i]);
    if (byte < 0xC0) continue;
    const std::string_view rest = std::string_view(utf8).substr(i);
    if (const std::size_t end = translate(rest, out)) {
      i += end - 1;
      continue;
    }
    const bool degree = rest.starts_with("\xC2\xB0") || rest.starts_with("\xC2\xBA");
    const bool inch = rest.starts_with("\xE2\x80\x9C") || rest.starts_with("\xE2\x80\x9D") ||
                      rest.starts_with("\xE2\x80\xB3");
    const bool times = rest.starts_with("\xC3\x97");
    const bool preposition = rest.starts_with("\xC3\x80") || rest.starts_with("\xC3\xA0");
    out += degree ? '^' : inch ? '"' : times ? 'X' : preposition ? 'A' : '~';
  }
  return out;
}

std::vector<CommentToken> comment_tokens(std::string_view folded) {
  Tokens tokens = raw_tokens(folded);
  part_tool_number(tokens);
  join_fractions(tokens);
  join_units(tokens);
  return tokens;
}

}  // namespace mrsim
