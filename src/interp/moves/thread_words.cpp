#include "interp/moves/thread_words.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace mrsim {

bool ThreadWords::take_lead(const Target& to, const Vec3& from) {
  const Code code = current_motion();
  take(Address::sf);
  if (code == Code::tap_floating) {
    modal_.lead = modal_.speed > 0 ? modal_.feed / modal_.speed : 0;
    return true;
  }
  if (is(Dialect::sinumerik))
    read_lead_along(to.programmed - from);
  else
    read_lead_of_feed();
  if (modal_.lead == 0)
    return error("thread-lead", "a thread needs its lead",
                 block_.motion_code ? *block_.motion_code : *to.first);
  if (modal_.lead < 0 && code != Code::tap_in && code != Code::tap_out)
    return error("thread-lead", "the lead of a cut thread is above 0",
                 block_.motion_code ? *block_.motion_code : *to.first);
  return true;
}

// SINUMERIK: I, J and K are the leads along X, Y and Z; the axis with the longest way counts.
void ThreadWords::read_lead_along(const Vec3& way) {
  const double along[] = {std::abs(way.x), std::abs(way.y), std::abs(way.z)};
  double longest = -1;
  const Word* used = nullptr;
  for (int i = 0; i < 3; ++i) {
    const Word* lead = take("IJK"[i]);
    if (!lead || along[i] <= longest) continue;
    longest = along[i];
    used = lead;
    modal_.lead = lead->value * scale();
  }
  if (used && longest < *std::max_element(std::begin(along), std::end(along)))
    warning("thread-lead", "the lead belongs to the axis of the longer path, and this is another",
            *used);
}

// The other controls: F is the lead, or K, or L on Fagor's lathes.
void ThreadWords::read_lead_of_feed() {
  if (is(Dialect::fanuc)) take('Q');  // the spindle's angle at the start
  const Word* other = take('K');
  std::optional<double> lead = thread_lead();
  if (is(Dialect::iso) && lathe()) {
    if (const Word* l = take('L')) lead = l->value * feed_scale();
    take('Q');
  }
  if (other && !lead) {
    lead = other->value * feed_scale();
    modal_.lead_apart = true;
  }
  if (lead)
    modal_.lead = *lead;
  else if (feed_as_lead() > 0)
    modal_.lead = feed_as_lead();
}

}  // namespace mrsim
