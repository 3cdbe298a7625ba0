// The fewest points of an outline that keep its corners and a tolerance.
#pragma once

#include "mesh/turned/turned_outline.h"

#include <vector>

namespace mrsim::detail {

/// The outline without points amid straight stretches of one face.
Outline straightened(const Outline& outline);

/// How chords are chosen, mm.
struct ChordLimits {
  double height = 0;   ///< from what they stand for
  double shallow = 0;  ///< corners stay where cutting them off moves more
  double border = 0;   ///< how far the border between two owners may move
};

/// The points of the outline that are needed to stay within the limits. Each chord has the face
/// that most of it belongs to, and its distance from the part. No excess is given.
Outline fewest_chords(const Outline& outline, const ChordLimits& limits);

/// Does what fewest_chords() does, with the chords of a curve about equally high.
Outline even_chords(const Outline& outline, const ChordLimits& limits);

}  // namespace mrsim::detail
