// Which kinds of cuts a list has: a mesh's default voxel, tolerance and budget go by them.
#pragma once

#include "run/cuts/cuts.h"

#include <span>

namespace mrsim {

/// Mills along Z are meant where depths count; other tools reach any depth.
struct CutKinds {
  double radius = 0;   ///< mm: the smallest with which a tool cuts, 0 = none has one
  double depth = 0;    ///< mm: below the stock's top, of the mill that goes least deep; infinite
                       ///< without one
  double grooves = 0;  ///< sum of length / width of all grooves of pointed tools that are narrower
                       ///< than half of the tool
  bool are_level = false;    ///< most keep their height, by flat mills
  bool are_pointed = false;  ///< most are made along the surface by mills that are no end mills
  bool are_slanted = false;  ///< most rise or fall on their way, or half of them on lines
  bool search_arcs = false;  ///< one is a helix or upright arc whose distance has no closed form
  bool have_many_helices = false;       ///< more than a quarter
  bool have_many_upright_arcs = false;  ///< more than a quarter, by tools that are no balls
  bool have_winding_helix = false;      ///< one of several turns leaves crests between them
};

/// A pass of a thread by a turning tool, which is not cut into the part.
bool is_thread_pass(const Motion& motion, std::span<const Tool> tools);

/// `stock_top`: mm. Cost: each cut is looked at some times.
CutKinds kinds_of(const CutList& cuts, double stock_top);

}  // namespace mrsim
