#include "interp/cycles/iso_pitch.h"

#include <array>
#include <utility>

namespace mrsim {

double iso_pitch(double thread) {
  static constexpr std::array<std::pair<double, double>, 24> kPitches = {
      {{3, 0.5}, {4, 0.7},  {5, 0.8},  {6, 1},    {8, 1.25}, {10, 1.5}, {12, 1.75}, {14, 2},
       {16, 2},  {18, 2.5}, {20, 2.5}, {22, 2.5}, {24, 3},   {27, 3},   {30, 3.5},  {33, 3.5},
       {36, 4},  {39, 4},   {42, 4.5}, {45, 4.5}, {48, 5},   {52, 5},   {56, 5.5},  {60, 5.5}}};
  for (const auto& [size, pitch] : kPitches)
    if (thread == size) return pitch;
  return 0;
}

}  // namespace mrsim
