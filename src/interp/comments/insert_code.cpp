#include "interp/comments/insert_code.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Shape letter of ISO 1832, the angle of its corner, the usual lead angle of its holder, and the
// edge's length in diameters of the inscribed circle.
struct Shape {
  char letter;
  double angle, lead, edge_per_circle;
};
constexpr Shape kShapes[] = {{'C', 80, 95, 1.0154}, {'D', 55, 93, 1.2208}, {'K', 55, 93, 1.6933},
                             {'R', 0, 0, 1},        {'S', 90, 75, 1},      {'T', 60, 91, 1.7321},
                             {'V', 35, 93, 1.7434}, {'W', 80, 95, 0.6847}};

constexpr std::string_view kUsual[] = {
    "CNMG", "CNMA", "CNMM", "CNGA", "DNMG", "DNMA", "DNGA", "VNMG", "VNGA", "WNMG", "WNMA",
    "TNMG", "TNMA", "SNMG", "SNMM", "CCMT", "CCGT", "CPMT", "DCMT", "DCGT", "VCMT", "VCGT",
    "VBMT", "VBGT", "TCMT", "TPMT", "SCMT", "RCMT", "RCMX", "RNMG", "KNUX"};

const Shape* find_shape(char letter) {
  for (const Shape& shape : kShapes)
    if (shape.letter == letter) return &shape;
  return nullptr;
}

// Reads "TPG" of ANSI B212.4: the insert has no hole and no chip groove, so no fourth letter.
const Shape* find_short_shape(std::string_view letters) {
  const bool usual =
      (letters[1] == 'N' || letters[1] == 'P') && (letters[2] == 'G' || letters[2] == 'U');
  return usual ? find_shape(letters[0]) : nullptr;
}

const Shape* find_shape(std::string_view letters) {
  if (letters.size() == 3) return find_short_shape(letters);
  if (letters.size() != 4) return nullptr;
  const bool clearance = std::string_view("ABCDEFGNOP").find(letters[1]) != letters.npos;
  const bool tolerance = std::string_view("ACEFGHJKLMNU").find(letters[2]) != letters.npos;
  const bool american = letters.substr(1, 2) == "NM" && (letters[3] == 'P' || letters[3] == 'S');
  const bool chipbreaker =
      american || std::string_view("ABCFGHJMNQRTUWX").find(letters[3]) != letters.npos;
  if (!clearance || !tolerance || !chipbreaker) return nullptr;
  return find_shape(letters[0]);
}

bool all_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

// Two digits of a round insert are its diameter in mm if that is one of these. Else they are of the
// inch code: "43" has a circle of 4/8 inch and is 3/16 thick.
constexpr int kRoundSizes[] = {5, 6, 8, 10, 12, 16, 20, 25};

// "120408": edge 12 mm, thickness 4, nose radius 0.8. "432": inscribed circle 4/8 inch, thickness
// 3/16, nose radius 2/64. "0803M0" is a round insert of 8 mm, and so is "08".
bool read_size(std::string_view digits, const Shape& shape, InsertCode& code) {
  const auto at = [&](std::size_t i) { return digits[i] - '0'; };
  if (!all_digits(digits)) return false;
  const bool round = shape.angle == 0;
  if (digits.size() == 6 || (round && digits.size() == 4)) {
    code.edge_length = 10 * at(0) + at(1);
    code.nose_radius = round ? code.edge_length / 2 : (10 * at(4) + at(5)) / 10.0;
  } else if (const int size = 10 * at(0) + (digits.size() > 1 ? at(1) : 0);
             round && digits.size() == 2 &&
             std::find(std::begin(kRoundSizes), std::end(kRoundSizes), size) !=
                 std::end(kRoundSizes)) {
    code.edge_length = size;
    code.nose_radius = code.edge_length / 2;
  } else if (digits.size() == 3 || (round && digits.size() == 2)) {
    const double circle = at(0) * kMmPerInch / 8;
    code.edge_length = circle * shape.edge_per_circle;
    code.nose_radius = round ? circle / 2 : at(2) * kMmPerInch / 64;
  } else {
    return false;
  }
  code.has_size = code.edge_length > 0;
  return code.has_size;
}

// The place behind the dash at i, or i if no dash stands there.
std::size_t past_dash(const std::vector<CommentToken>& tokens, std::size_t i) {
  return i < tokens.size() && tokens[i].is("-") ? i + 1 : i;
}

// Reads "09T304", "09 T3 04", "09-T3-04", which the letter cuts into tokens. T3 is the thickness,
// 3.97 mm.
bool read_t_size(const std::vector<CommentToken>& tokens, std::size_t i, const Shape& shape,
                 InsertCode& code) {
  const std::size_t t = past_dash(tokens, i + 1);
  if (t + 1 >= tokens.size() || !tokens[t].is("T") || !tokens[t + 1].glued) return false;
  std::string rest(tokens[t + 1].text);
  code.end = t + 2;
  if (shape.angle == 0 && rest.size() == 1)  // "RCMT 10T3 MO"
    return read_size(std::string(tokens[i].text) + "0" + rest, shape, code);
  const std::size_t nose = past_dash(tokens, t + 2);
  if (rest.size() == 1 && nose < tokens.size() && tokens[nose].text.size() == 2) {
    rest += tokens[nose].text;
    code.end = nose + 1;
  }
  if (tokens[i].text.size() != 2 || rest.size() != 3) return false;
  return read_size(std::string(tokens[i].text) + "0" + rest, shape, code);
}

// Reads "12 04 08", "12-04-08", and "3-2.5-1": circle, thickness and nose of the inch code.
bool read_spaced_size(const std::vector<CommentToken>& tokens, std::size_t i, const Shape& shape,
                      InsertCode& code) {
  std::string_view parts[3];
  for (std::string_view& part : parts) {
    if (&part != parts) i = past_dash(tokens, i);
    if (i >= tokens.size() || !tokens[i].is_number()) return false;
    part = tokens[i++].text;
  }
  code.end = i;
  const auto have = [&](std::size_t first, std::size_t last) {
    return parts[0].size() == first && parts[2].size() == last;
  };
  if (have(2, 2) && parts[1].size() == 2)
    return read_size(fmt::format("{}{}{}", parts[0], parts[1], parts[2]), shape, code);
  if (!have(1, 1) || parts[1].empty() || !tokens[i - 2].is("-")) return false;
  return read_size(fmt::format("{}{}{}", parts[0], parts[1][0], parts[2]), shape, code);
}

// Reads "32.51": circle 3/8 inch, thickness 2.5/16, nose radius 1/64.
bool read_half_size(std::string_view text, const Shape& shape, InsertCode& code) {
  if (text.size() == 7 && text[4] == '.')  // "CNMG1204.08"
    return read_size(fmt::format("{}{}", text.substr(0, 4), text.substr(5)), shape, code);
  if (text.size() != 5 || text[2] != '.' || text[3] != '5') return false;
  return read_size(std::string({text[0], text[1], text[4]}), shape, code);
}

bool is_any_of(char c, std::string_view letters) { return letters.find(c) != letters.npos; }

// The lead angle by the letter of a holder's style, ISO 5608. Of styles whose edge stands across
// the holder the insert's shape gives it, `usual`. N and V stand upright: "SVVCN", "SDNCN".
double lead_of_style(char style, double usual) {
  switch (style) {
    case 'A':
      return 90;
    case 'B':
    case 'R':
      return 75;
    case 'D':
    case 'S':
      return 45;
    case 'E':
    case 'T':
      return 60;
    case 'G':
      return 91;
    case 'H':
    case 'Q':
      return 107.5;
    case 'J':
      return 93;
    case 'L':
      return 95;
    case 'N':
      return 62.5;
    case 'V':
      return 72.5;
    default:
      return usual;
  }
}

// Finds "PCLNR 2525 M12", "SDJCL-1212": clamp, shape, style, clearance, hand. The hand is not used,
// since which way the tool cuts depends on how it stands in its turret.
std::optional<InsertCode> find_holder_code(const std::vector<CommentToken>& tokens) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const std::string_view text = tokens[i].text;
    const std::size_t number = i + (tokens[i + 1].is("-") ? 2 : 1);
    if (tokens[i].kind != CommentToken::Kind::word || text.size() != 5 || number >= tokens.size() ||
        !tokens[number].is_number())
      continue;
    if (!is_any_of(text[0], "CDMPSW") || !is_any_of(text[2], "BCDFGHJKLMNPQRSTUVWXY") ||
        !is_any_of(text[3], "ABCDEFGNOP") || !is_any_of(text[4], "RLN"))
      continue;  // no style has the E of "STEEL 1018"
    for (const Shape& shape : kShapes)
      if (shape.letter == text[1]) {
        InsertCode code;
        code.shape = std::string(1, shape.letter);
        code.angle = shape.angle;
        code.lead_angle = shape.angle > 0 ? lead_of_style(text[2], shape.lead) : shape.lead;
        code.first = i;
        code.end = number + 1;
        return code;
      }
  }
  return std::nullopt;
}

// The code that begins at token i.
std::optional<InsertCode> read_code(const std::vector<CommentToken>& tokens, std::size_t i) {
  const Shape* shape =
      tokens[i].kind == CommentToken::Kind::word ? find_shape(tokens[i].text) : nullptr;
  if (shape == nullptr) return std::nullopt;
  InsertCode code;
  code.shape = std::string(tokens[i].text);
  code.angle = shape->angle;
  code.lead_angle = shape->lead;
  code.first = i;
  const bool dash = i + 2 < tokens.size() && tokens[i + 1].is("-");
  const std::size_t size = i + (dash ? 2 : 1);
  const bool number = size < tokens.size() && tokens[size].is_number();
  if (!number ||
      (!read_spaced_size(tokens, size, *shape, code) && !read_t_size(tokens, size, *shape, code))) {
    const bool read = number && (read_size(tokens[size].text, *shape, code) ||
                                 read_half_size(tokens[size].text, *shape, code));
    code.end = read ? size + 1 : i + 1;
  }
  const bool usual =
      std::find(std::begin(kUsual), std::end(kUsual), code.shape) != std::end(kUsual);
  const bool short_size = number && tokens[size].text.size() == 2;  // "REAM 10H7"
  if (!usual && (!code.has_size || short_size)) return std::nullopt;
  return code;
}

}  // namespace

std::optional<InsertCode> find_insert_code(const std::vector<CommentToken>& tokens) {
  std::optional<InsertCode> first;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::optional<InsertCode> code = read_code(tokens, i);
    if (!code) continue;
    if (!first) {
      first = code;
      continue;
    }
    const bool sizes = code->has_size && first->has_size;
    if (code->angle != first->angle || (sizes && code->nose_radius != first->nose_radius))
      first->other = code->shape;
  }
  std::optional<InsertCode> holder = find_holder_code(tokens);
  if (!first) return holder;
  if (holder && holder->shape[0] == first->shape[0]) first->lead_angle = holder->lead_angle;
  return first;
}

double usual_nose_unit(double value) {
  constexpr double kMm[] = {0.2, 0.4, 0.8, 1.2, 1.6};
  constexpr double kInches[] = {1 / 128.0, 1 / 64.0, 1 / 32.0, 3 / 64.0, 1 / 16.0};
  const auto is_any = [&](auto& usual, double tolerance) {
    return std::any_of(std::begin(usual), std::end(usual),
                       [&](double u) { return std::abs(value - u) < tolerance; });
  };
  if (is_any(kInches, 0.0013)) return kMmPerInch;
  return is_any(kMm, kRounding) ? 1 : 0;
}

}  // namespace mrsim
