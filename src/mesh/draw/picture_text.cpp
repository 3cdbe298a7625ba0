#include "mesh/draw/picture_text.h"

namespace mrsim {
namespace {

struct Glyph {
  char letter;
  int width;            // grid units; the gap is added
  const char* strokes;  // points "xy", y = a is -1 and b is -2; a blank lifts the pen
};

constexpr Glyph kGlyphs[] = {
    {'0', 4, "103041453616050110"},
    {'1', 2, "042620"},
    {'2', 4, "05163645440040"},
    {'3', 4, "05163645443313 334241301001"},
    {'4', 4, "30360242"},
    {'5', 4, "460603334241301001"},
    {'6', 4, "453616050110304142331302"},
    {'7', 4, "064610"},
    {'8', 4, "13040516364544331302011030414233"},
    {'9', 4, "011030414536160504133344"},
    {'A', 4, "002640 1232"},
    {'B', 4, "00063645443303 3342413000"},
    {'C', 4, "4536160501103041"},
    {'D', 4, "00062644422000"},
    {'E', 4, "46060040 0333"},
    {'F', 4, "460600 0333"},
    {'G', 4, "45361605011030414323"},
    {'H', 4, "0006 4046 0343"},
    {'I', 0, "0006"},
    {'J', 3, "3631201001"},
    {'K', 4, "0006 4602 1340"},
    {'L', 4, "060040"},
    {'M', 4, "0006234640"},
    {'N', 4, "00064046"},
    {'O', 4, "103041453616050110"},
    {'P', 4, "00063645443303"},
    {'Q', 4, "103041453616050110 2240"},
    {'R', 4, "00063645443303 2340"},
    {'S', 4, "453616050413334241301001"},
    {'T', 4, "0646 2620"},
    {'U', 4, "060110304146"},
    {'V', 4, "062046"},
    {'W', 4, "0610243046"},
    {'X', 4, "0046 0640"},
    {'Y', 4, "062346 2320"},
    {'Z', 4, "06460040"},
    {'a', 3, "3324140301102031 3430"},
    {'b', 3, "0600 0314243331201001"},
    {'c', 3, "3324140301102031"},
    {'d', 3, "3630 3324140301102031"},
    {'e', 3, "023233241403011030"},
    {'f', 2, "261510 0424"},
    {'g', 3, "3324140301102031 343a2b1b"},
    {'h', 3, "0600 0314243330"},
    {'i', 0, "0400 0606"},
    {'j', 1, "141a0b 1616"},
    {'k', 3, "0600 3401 1230"},
    {'l', 0, "0600"},
    {'m', 4, "0400 03142320 23344340"},
    {'n', 3, "0400 0314243330"},
    {'o', 3, "102031332414030110"},
    {'p', 3, "040b 0314243331201001"},
    {'q', 3, "343b 3324140301102031"},
    {'r', 2, "0400 031424"},
    {'s', 3, "3414031222312000"},
    {'t', 2, "161120 0424"},
    {'u', 3, "0401102031 3430"},
    {'v', 4, "042044"},
    {'w', 4, "0410233044"},
    {'x', 3, "0034 0430"},
    {'y', 3, "0401102031 343a2b1b"},
    {'z', 3, "04340030"},
    {'.', 0, "0000"},
    {',', 0, "000a"},
    {':', 0, "0000 0303"},
    {';', 0, "000a 0303"},
    {'-', 3, "0333"},
    {'+', 4, "0343 2125"},
    {'_', 4, "0a4a"},
    {'/', 3, "0036"},
    {'\\', 3, "0630"},
    {'(', 1, "16050110"},
    {')', 1, "06151100"},
    {'[', 1, "16060010"},
    {']', 1, "06161000"},
    {'=', 4, "0242 0444"},
    {'%', 4, "0046 0606 4040"},
    {'#', 4, "1016 3036 0242 0444"},
    {'*', 4, "2125 0244 0442"},
    {'<', 3, "350331"},
    {'>', 3, "053301"},
    {'!', 0, "0602 0000"},
    {'?', 4, "05163645442322 2020"},
    {'\'', 0, "0605"},
    {'"', 1, "0605 1615"},
    {'|', 0, "060b"},
    {'^', 2, "041624"},
    {' ', 1, ""},
};
constexpr Glyph kUnknownGlyph = {'\0', 4, "0046064600064640"};
constexpr double kGap = 1.7, kHeight = 6;

const Glyph& glyph_of(char letter) {
  for (const Glyph& glyph : kGlyphs)
    if (glyph.letter == letter) return glyph;
  return kUnknownGlyph;
}

double row_of(char y) { return y == 'a' ? -1 : y == 'b' ? -2 : y - '0'; }

void draw_glyph(Picture& picture, Vec2 at, double scale, const Glyph& glyph, const Color& color) {
  const auto point = [&](const char* s) {
    return Vec2{at.x + scale * (s[0] - '0'), at.y - scale * row_of(s[1])};
  };
  bool pen_down = false;
  Vec2 last;
  for (const char* s = glyph.strokes; *s != '\0';) {
    if (*s == ' ') {
      pen_down = false;
      ++s;
      continue;
    }
    const Vec2 here = point(s);
    const bool dot = !pen_down && s[2] == s[0] && s[3] == s[1];
    if (pen_down || dot) picture.stroke(pen_down ? last : here, here, 0.85 * scale, color);
    last = here;
    pen_down = true;
    s += 2;
  }
}

}  // namespace

double draw_text(Picture& picture, Vec2 at, double height, std::string_view text,
                 const Color& color) {
  const double scale = height / kHeight, start = at.x;
  for (const char letter : text) {
    const Glyph& glyph = glyph_of(letter);
    draw_glyph(picture, at, scale, glyph, color);
    at.x += scale * (glyph.width + kGap);
  }
  return at.x - start;
}

double text_width(std::string_view text, double height) {
  double width = 0;
  for (const char letter : text) width += glyph_of(letter).width + kGap;
  return width * height / kHeight;
}

}  // namespace mrsim
