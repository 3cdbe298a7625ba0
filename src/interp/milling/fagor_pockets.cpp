#include "interp/milling/fagor_pockets.h"

#include <cmath>

namespace mrsim {

bool FagorPockets::wants_block() const {
  const FagorPocket& pocket = modal_.pocket;
  if (pocket.number == 0 || pocket.number != modal_.drill.number) return false;
  if (block_.oneshot || block_.frame_code) return false;
  if (!pocket.begun) return true;
  for (const char c : {'X', 'Y', 'Z'})
    if (block_.unused(letter(c))) return true;
  return block_.unused(Address::ap);
}

// Goes to the place at the current level, then cuts the pocket.
bool FagorPockets::run() {
  FagorPocket& pocket = modal_.pocket;
  Target to;
  if (!axes_.target(to, position_.programmed)) return false;
  if (!pocket.begun) pocket.initial = mover_.height();
  pocket.begun = true;
  const Word where = block_.motion_code ? *block_.motion_code : block_.words.front();
  mover_.begin(where);
  mover_.rapid(in_plane(basis(), to.programmed));
  return mills_.run(call(pocket), where, true);
}

// In G91 Z counts from the level before the cycle. I counts from Z; D is the height of Z over the
// part.
CycleCall FagorPockets::call(const FagorPocket& pocket) const {
  const auto level = [](const CycleLevel& from, double base) {
    return !from.given ? base : from.incremental ? base + from.value : from.value;
  };
  const double reference = level(pocket.reference, pocket.initial);
  const double bottom =
      pocket.depth.incremental ? reference + pocket.depth.value : pocket.depth.value;
  const double surface = reference + (bottom < reference ? -pocket.above : pocket.above);
  const double top = modal_.hole_return == HoleReturn::safe ? reference : pocket.initial;
  const bool round = pocket.number == 88;
  CycleCall call;
  call.name = round ? "POCKET4" : "POCKET3";
  call.written = round ? "G88" : "G87";
  const double unit = scale();
  call.set("RTP", top / unit);
  call.set("RFP", surface / unit);
  call.set("SDIS", pocket.above / unit);
  call.set("DP", bottom / unit);
  if (round) call.set("PRAD", pocket.half_length / unit);
  if (!round) call.set("LENG", 2 * pocket.half_length / unit);
  if (!round) call.set("WID", 2 * pocket.half_width / unit);
  call.set("MID", pocket.infeed / unit);
  call.set("CDIR", pocket.clockwise ? 1 : 0);
  call.set("VARI", 11);  // the tool goes down with the feed
  call.set("MIDA", pocket.width / unit);
  return call;
}

}  // namespace mrsim
