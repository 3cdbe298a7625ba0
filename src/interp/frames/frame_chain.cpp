#include "interp/frames/frame_chain.h"

namespace mrsim {

// Composes the frames in the order in which the control applies them, the innermost last.
void FrameChain::rebuild() {
  Frame total = shift_frame(frames_.work + frames_.position_shift + frames_.local);
  if (frames_.work_turn != 0)
    total = compose(compose(shift_frame(frames_.work), rotation_frame(2, frames_.work_turn)),
                    shift_frame(frames_.position_shift + frames_.local));
  total = compose(total, frames_.swivel);
  total = compose(total, frames_.program);
  total = compose(total, frames_.rotation);
  total = compose(total, frames_.scaling);
  total = compose(total, frames_.mirror);
  if (total == frames_.total) return;
  frames_.total = total;
  const Vec3 old = position_.programmed;
  position_.programmed = apply_inverse(total, position_.physical);
  for (int i = 0; i < 3; ++i) {
    if (!position_.moved_frame.has(i)) component(position_.retained, i) = component(old, i);
  }
  position_.moved_frame = kAllAxes;
}

void FrameChain::save() {
  if (!control_.saved_frames) control_.saved_frames = frames_;
}

void FrameChain::arguments(Vec3& values, AxisSet& named, bool lengths) {
  for (int i = 0; i < 3; ++i) {
    const Word* word = take("XYZ"[i]);
    if (!word) continue;
    named.add(i);
    component(values, i) = lengths ? word->value * length_unit(*word) : word->value;
  }
}

}  // namespace mrsim
