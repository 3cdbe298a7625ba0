#include "interp/milling/letter_cutter.h"

namespace mrsim {

void LetterCutter::begin(const Word& where) {
  where_ = where;
  mover_.begin(where);
}

void LetterCutter::cut(const std::vector<std::vector<Vec2>>& strokes, const Levels& levels) {
  mover_.rapid_height(levels.safe);
  for (const std::vector<Vec2>& stroke : strokes) {
    mover_.rapid(stroke.front());
    mover_.line_height(levels.depth, levels.plunge);
    for (const Vec2 point : stroke) mover_.line(point, levels.feed);
    mover_.rapid_height(levels.safe);
  }
  reporter_.once(Severity::warning, "engraving-font",
                 "the letters are those of a plain font: the control's own may be wider or "
                 "narrower; place, height, angle and depth are as programmed",
                 where_, "engraving-font");
}

}  // namespace mrsim
