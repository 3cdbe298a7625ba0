#include "interp/text/tool_comment.h"

#include "core/text_io.h"
#include "core/units.h"
#include "interp/text/characters.h"
#include "interp/text/comment_tokens.h"
#include "interp/text/insert_code.h"
#include "interp/text/tool_kind.h"
#include "interp/text/tool_listing.h"

#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>

namespace mrsim {
namespace {

using Token = CommentToken;
using Words = std::initializer_list<std::string_view>;

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

bool one_of(const Token& token, Words words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return token.is(w); });
}

// Words that may stand between a size and the kind of tool: "10 MM CARBIDE LONG ENDMILL".
bool is_adjective(const Token& token) {
  return one_of(token, {"DIA",       "DIAM",     "DIAMETER", "ROUGH", "ROUGHING", "FINISH",
                        "FINISHING", "SOLID",    "CARBIDE",  "HSS",   "HSSE",     "COBALT",
                        "VHM",       "HM",       "LONG",     "SHORT", "STUB",     "EXTENDED",
                        "CENTER",    "CUTTING",  "SQUARE",   "UPCUT", "DOWNCUT",  "SPIRAL",
                        "STRAIGHT",  "SINGLE",   "COATED",   "TIALN", "FLAT",     "JOBBER",
                        "TWIST",     "STANDARD", "FLUTE",    "TWO",   "THREE",    "FOUR"});
}

bool is_flute_word(const Token& token) {
  return one_of(token, {"FLUTE", "FLUTES", "FLUTED", "FL", "FLT", "F", "Z", "TOOTH", "TEETH",
                        "SCHNEIDER", "SCHNEIDIG"});
}

bool is_separator(const Token& token) {
  return one_of(token, {"|", ",", ";", ":", "-", "(", ")", "[", "]", "{", "}"});
}

/// Reads one comment.
class CommentReader {
 public:
  CommentReader(std::vector<Token> tokens, ToolHint& hint)
      : tokens_(std::move(tokens)), hint_(hint), taken_(tokens_.size(), false) {}

  void read() {
    read_id();
    kind_ = find_tool_kind(tokens_);
    insert_ = find_insert_code(tokens_);
    if (kind_)
      std::fill(taken_.begin() + long(kind_->first), taken_.begin() + long(kind_->end), true);
    if (insert_)
      std::fill(taken_.begin() + long(insert_->first), taken_.begin() + long(insert_->end), true);
    read_radii();
    read_named_diameters();
    read_register_like();
    read_sizes_about_kind();
    read_angles();
    if (hint_.diameters.empty()) read_other_sizes();
    settle();
  }

 private:
  bool has(std::size_t i) const { return i < tokens_.size(); }
  bool number(std::size_t i) const { return has(i) && tokens_[i].is_number() && !taken_[i]; }
  bool word(std::size_t i) const { return has(i) && tokens_[i].kind == Token::Kind::word; }
  static ToolLength length(const Token& t) { return {t.value, t.unit, t.fraction}; }

  void set_id(std::size_t i);
  void read_id();
  bool is_size(std::size_t i) const;
  std::size_t value_behind(std::size_t i) const;
  void read_radii();
  void read_named_diameters();
  void read_register_like();
  void read_sizes_about_kind();
  void read_other_sizes();
  void read_angles();
  void read_insert();
  void settle();
  void settle_turning();
  bool is_corner_line() const;
  void add_diameter(std::size_t i) {
    hint_.diameters.push_back(length(tokens_[i]));
    taken_[i] = true;
  }

  std::vector<Token> tokens_;
  ToolHint& hint_;
  std::vector<bool> taken_;  ///< tokens that have been understood
  std::optional<ToolKind> kind_;
  std::optional<InsertCode> insert_;
  std::vector<double> angles_;  ///< degrees
  double taper_ = 0;            ///< degrees, of TAPER=
};

// A whole number without a point or a unit.
void CommentReader::set_id(std::size_t i) {
  const Token& t = tokens_[i];
  if (t.decimals || t.fraction || t.unit > 0 || t.angle || t.text.size() > 8) return;
  std::string id(t.text);
  id.erase(0, std::min(id.find_first_not_of('0'), id.size() - 1));
  taken_[i] = hint_.names_tool = true;
  if (!hint_.id.empty() && hint_.id != id) hint_.doubt = "names several tools";
  hint_.id = id;
  hint_.id_digits = t.text.size();
}

// "T12", "TOOL 12", "TOOL NO. 12", "TOOL -5-", "TOOL #1", "NO. 1:".
void CommentReader::read_id() {
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    const Token& t = tokens_[i];
    const bool inside = i > 0 && t.glued && tokens_[i - 1].is_number();  // "CCMT 09T304"
    if (t.is("T") && !inside && number(i + 1) && tokens_[i + 1].glued) set_id(i + 1);
    const bool tool = one_of(t, {"TOOL", "WERKZEUG", "WKZ", "HERRAMIENTA", "ORODJE"});
    if (one_of(t, {"TC", "TOOL", "WERKZEUG", "HERRAMIENTA", "ORODJE"})) hint_.names_tool = true;
    const bool head = i == 0 && one_of(t, {"NO", "NR"}) && has(i + 2) && tokens_[i + 2].is(":");
    if (!tool && !head) continue;
    std::size_t at = i + 1;
    while (has(at) &&
           one_of(tokens_[at], {"NO", "NR", "NUMBER", "NUMMER", "#", "-", ":", "=", "T"}))
      ++at;
    const bool diameter = has(at + 1) && one_of(tokens_[at + 1], {"DIA", "DIAM", "DIAMETER"}) &&
                          !(has(at + 2) && tokens_[at + 2].is("OFF")) &&
                          value_behind(at + 1) == kNone;  // "TOOL 10 DIA"
    if (number(at) && !diameter)
      set_id(at);
    else if (has(at) && one_of(tokens_[at], {"CHANGE", "PATH"}))
      hint_.names_tool = false;
  }
}

// A number that may be a size: not behind a letter, a "#", an "=" or a sign of its own.
bool CommentReader::is_size(std::size_t i) const {
  if (!number(i) || tokens_[i].angle || !(tokens_[i].value > 0)) return false;
  if (has(i + 1) && tokens_[i + 1].glued && tokens_[i + 1].is("-") && number(i + 2) &&
      tokens_[i + 2].glued)
    return tokens_[i].fraction || tokens_[i].unit > 0;  // "1/4-20" is a thread
  if (i == 0) return true;
  const Token& before = tokens_[i - 1];
  const bool named = before.is("=") && i > 1 && tokens_[i - 2].is_number() && taken_[i - 2];
  if (named) return true;  // "T1 = 6mm endmill"
  if (before.is("#") || before.is("=") || one_of(before, {"NO", "NR", "NUMBER"})) return false;
  if (before.is("-") && tokens_[i].glued) return false;
  return !(before.kind == Token::Kind::word && tokens_[i].glued);
}

// The number behind a name, over "=", ":", "-": "DIA. - 10.", "D=6".
std::size_t CommentReader::value_behind(std::size_t i) const {
  std::size_t at = i + 1;
  while (has(at) && one_of(tokens_[at], {"=", ":", "-"})) ++at;
  return number(at) && !tokens_[at].angle ? at : kNone;
}

// "CR=2", "CORNER RADIUS 2", "R2", "2. RAD", ".030R"; "TAPER=118DEG"; widths of blades.
void CommentReader::read_radii() {
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    const Token& t = tokens_[i];
    if (!word(i)) continue;
    std::size_t at = i;
    const bool nose = one_of(t, {"NOSE", "TNR", "RE", "NR"});
    if (one_of(t, {"CORNER", "NOSE", "TIP", "ECKEN"}))
      while (has(at + 1) && one_of(tokens_[at + 1], {"RADIUS", "RAD", "R"})) ++at;
    const bool corner = at > i || one_of(t, {"CR", "RAD", "RADIUS"}) || nose;
    const std::size_t value = value_behind(at);
    const bool behind = t.is("R") && t.glued && i > 0 && tokens_[i - 1].decimals &&
                        !(has(i + 1) && tokens_[i + 1].glued);
    if (t.is("TAPER") || t.is("ANGLE") || t.is("WINKEL")) {
      std::size_t angle = i + 1;
      while (has(angle) && one_of(tokens_[angle], {"=", ":", "-"})) ++angle;
      if (!number(angle)) continue;
      taken_[angle] = true;
      if (t.is("TAPER"))
        taper_ = tokens_[angle].value;
      else
        angles_.push_back(tokens_[angle].value);
    } else if (one_of(t, {"WIDTH", "BREITE", "W"}) && value != kNone) {
      hint_.width = length(tokens_[value]);
      taken_[value] = true;
    } else if (value != kNone && (corner || (t.is("R") && (tokens_[i + 1].glued)))) {
      (nose ? hint_.nose : hint_.corner) = length(tokens_[value]);
      taken_[value] = true;
    } else if ((corner || behind) && i > 0 && is_size(i - 1)) {  // "2. RAD", "1MM CORNER R"
      hint_.corner = length(tokens_[i - 1]);
      taken_[i - 1] = true;
    }
  }
}

// "DIA. - 10.", "Ø5", "D=6.", ".5 DIA"; "DIA. OFF. - 41" is a register.
void CommentReader::read_named_diameters() {
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    if (!one_of(tokens_[i], {"DIA", "DIAM", "DIAMETER", "DURCHMESSER", "DIAMETRO", "DI~METRO",
                             "DIAMETRE", "DIAM~TRE", "PREMER", "DMR"}))
      continue;
    if (has(i + 1) && one_of(tokens_[i + 1], {"OFF", "OFFSET", "COMP", "REG", "REGISTER"}))
      continue;
    hint_.names_tool |= i > 0 && tokens_[i - 1].is("TOOL");
    hint_.names_tool |= i > 0 && kind_ && kind_->firm && kind_->first == 0 && kind_->end == i;
    const std::size_t value = value_behind(i);
    if (value != kNone && tokens_[value].value > 0)
      add_diameter(value);
    else if (i > 0 && is_size(i - 1))
      add_diameter(i - 1);
  }
  for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
    if (tokens_[i].is("~") && !(i > 0 && tokens_[i].glued)) {
      const std::size_t value = value_behind(i);
      if (value != kNone && tokens_[value].value > 0) add_diameter(value);
    }
    if (tokens_[i].is("D") && tokens_[i + 1].is("=") && number(i + 2) && tokens_[i + 2].value > 0) {
      hint_.names_tool = true;
      add_diameter(i + 2);
    }
  }
}

// "END MILL D5", "D10R1"; beside an H it is the number of a register.
void CommentReader::read_register_like() {
  bool length_register = false;
  for (std::size_t i = 0; i + 1 < tokens_.size(); ++i)
    if (tokens_[i].is("H") && number(i + 1) && tokens_[i + 1].glued) length_register = true;
  for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
    if (!tokens_[i].is("D") || !number(i + 1) || !tokens_[i + 1].glued) continue;
    const Token& value = tokens_[i + 1];
    taken_[i + 1] = true;
    if (length_register || !hint_.diameters.empty() || !(value.value > 0)) continue;
    if (!value.decimals && !hint_.id.empty() && value.text == hint_.id) continue;  // "T5 D5"
    if (kind_ || hint_.corner || hint_.names_tool) add_diameter(i + 1);
  }
}

// "10 FLAT", "1/4 IN. 2 FLUTE ENDMILL" and "End Mill 6 mm": numbers beside the kind's name.
void CommentReader::read_sizes_about_kind() {
  if (!kind_) return;
  for (std::size_t i = 0; i < kind_->first; ++i) {
    if (!is_size(i)) continue;
    if (has(i + 1) && is_flute_word(tokens_[i + 1]) && tokens_[i].unit == 0) continue;
    std::size_t at = i + 1;
    while (at < kind_->first) {
      if (number(at) && has(at + 1) && is_flute_word(tokens_[at + 1]))
        at += 2;
      else if (is_adjective(tokens_[at]) || (tokens_[at].is("-") && tokens_[at].glued) ||
               tokens_[at].angle)
        ++at;
      else
        break;
    }
    if (at != kind_->first) continue;
    const bool holes = has(kind_->end) && one_of(tokens_[kind_->end], {"HOLES", "HOLE"});
    if (!holes || tokens_[i].unit > 0) add_diameter(i);
  }
  std::size_t at = kind_->end;
  while (has(at) && one_of(tokens_[at], {"{", "(", "[", ":", "-", "="})) ++at;
  if (has(at) && tokens_[at].is("D") && has(at + 1) && !tokens_[at + 1].glued) ++at;  // "D 10"
  if (!is_size(at)) return;
  const bool ends = !has(at + 1) || is_separator(tokens_[at + 1]) || tokens_[at + 1].is("R");
  if (tokens_[at].unit > 0 || tokens_[at].fraction || (ends && hint_.diameters.empty()))
    add_diameter(at);
}

// Sizes with a unit anywhere, and "M6" of a tap.
void CommentReader::read_other_sizes() {
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    if (kind_ && tokens_[i].is("M") && number(i + 1) && tokens_[i + 1].glued) {
      const std::string_view name = tokens_[kind_->first].text;
      if (name != "TAP" && name != "TAPPING" && name != "GEWINDEBOHRER") continue;
      add_diameter(i + 1);
      hint_.diameters.back().unit = 1;
    }
    if (!kind_ && !hint_.names_tool) continue;
    if (is_size(i) && (tokens_[i].unit > 0 || tokens_[i].fraction)) add_diameter(i);
  }
}

void CommentReader::read_angles() {
  for (std::size_t i = 0; i < tokens_.size(); ++i)
    if (number(i) && tokens_[i].angle) angles_.push_back(tokens_[i].value);
  if (!kind_ || is_turning(kind_->type)) return;
  const bool pointed = kind_->type == ToolType::drill || kind_->type == ToolType::chamfer;
  const bool included =
      kind_->type == ToolType::drill || tokens_[kind_->first].text.starts_with("COUNTER");
  const double angle = angles_.empty() ? 0 : angles_.front();
  if (kind_->type == ToolType::taper) {
    hint_.taper_angle = radians(taper_ > 0 ? taper_ : angle);
  } else if (pointed && taper_ > 0) {
    (included ? hint_.tip_angle : hint_.taper_angle) = radians(taper_);
  } else if (pointed && angle > 0 && angle < 180) {
    // "45 DEG CHAMFER MILL" is named by its side, "90 DEG" by the whole.
    const bool side = tokens_[kind_->first].is("CHAMFER") && angle <= 60;
    (side ? hint_.taper_angle : hint_.tip_angle) = radians(angle);
  } else if (pointed && kind_->tip_angle > 0) {
    hint_.tip_angle = radians(kind_->tip_angle);
    hint_.assumed_angle = true;
  }
  if (kind_->needs_angle && hint_.tip_angle == 0 && hint_.taper_angle == 0)
    hint_.doubt = "gives no angle";
}

void CommentReader::settle_turning() {
  if (insert_) {
    hint_.insert = insert_->shape;
    hint_.insert_angle = radians(insert_->angle);
    hint_.lead_angle = radians(insert_->lead_angle);
    hint_.edge_length = insert_->has_size ? insert_->edge_length : 0;
    if (!hint_.type) hint_.type = ToolType::turning;
  } else if (!angles_.empty() && angles_.front() < 180) {
    hint_.insert_angle = radians(angles_.front());
  }
  if (insert_ && insert_->angle > 0 && !angles_.empty() &&
      std::find(angles_.begin(), angles_.end(), insert_->angle) == angles_.end())
    hint_.doubt = fmt::format("says {:g} degrees, but {} has {:g}", angles_.front(), insert_->shape,
                              insert_->angle);
  if (!hint_.nose) hint_.nose = hint_.corner;
  hint_.corner = {};
  if (insert_ && insert_->has_size) {
    const ToolLength coded{insert_->nose_radius, 1, false};
    const double said = hint_.nose.value * (hint_.nose.unit > 0 ? hint_.nose.unit : 1);
    const bool same =
        std::abs(said - coded.value) < 0.05 || std::abs(said * kMmPerInch - coded.value) < 0.05;
    if (hint_.nose && !same)
      hint_.doubt = fmt::format("says nose radius {:g}, but the code of the insert {:.3g} mm", said,
                                coded.value);
    hint_.nose = coded;
  }
  if (hint_.type == ToolType::grooving && !hint_.width && !hint_.diameters.empty())
    hint_.width = hint_.diameters.front();
  for (std::size_t i = 0; i < tokens_.size(); ++i)
    if (one_of(tokens_[i], {"LEFT", "LH", "LINKS"})) hint_.left_hand = true;
  if (hint_.type != ToolType::boring) hint_.diameters.clear();  // on a mill it is the bore's
}

// "TIP RADIUS: 1.0" and nothing else: a line of several about one tool.
bool CommentReader::is_corner_line() const {
  std::size_t i = has(0) && one_of(tokens_[0], {"TOOL", "CUTTER"}) ? 1 : 0;
  if (!has(i + 1) || !one_of(tokens_[i], {"TIP", "CORNER"}) ||
      !one_of(tokens_[i + 1], {"RADIUS", "RAD"}))
    return false;
  const std::size_t value = i + 2;
  i = value;
  while (has(i) && one_of(tokens_[i], {"=", ":", "-"})) ++i;
  return has(i) && tokens_[i].is_number() && i + 1 == tokens_.size();
}

void CommentReader::settle() {
  const bool data = !hint_.diameters.empty() || hint_.width || hint_.nose || hint_.corner;
  if (kind_ && (kind_->firm || hint_.names_tool || (data && !is_turning(kind_->type)))) {
    hint_.type = kind_->type;
    hint_.plain_teeth = kind_->plain_teeth;
    if (kind_->indescribable) hint_.doubt = "names a kind of tool that needs more data";
  }
  if (kind_ && !hint_.type && is_turning(kind_->type)) {
    hint_.operation = kind_->type;
    if (!hint_.width && !hint_.diameters.empty() && hint_.diameters.front().unit > 0)
      hint_.width = hint_.diameters.front();
  }
  if (insert_ || (hint_.type && is_turning(*hint_.type))) settle_turning();
  if (!hint_.type && !hint_.names_tool) hint_.diameters.clear();
  if (!hint_.type && !is_corner_line()) hint_.corner = {};
  if (hint_.type == ToolType::endmill && hint_.corner) hint_.type = ToolType::bullmill;
}

void set_values(ToolHint& hint) {
  hint.diameter = hint.diameters.empty() ? 0 : hint.diameters.front().value;
  hint.corner_radius = hint.corner.value;
  hint.nose_radius = hint.nose.value;
}

}  // namespace

ToolHint read_tool_comment(std::string_view bytes) {
  ToolHint hint;
  if (bytes.size() > 400) bytes = bytes.substr(0, 400);
  hint.text = to_utf8(bytes);
  while (!hint.text.empty() && hint.text.front() == ' ') hint.text.erase(0, 1);
  while (!hint.text.empty() && hint.text.back() == ' ') hint.text.pop_back();
  const std::string text = fold_comment(hint.text);
  if (!read_listed_tool(text, hint)) CommentReader(comment_tokens(text), hint).read();
  set_values(hint);
  return hint;
}

}  // namespace mrsim
