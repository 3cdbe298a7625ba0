#include "interp/cycles/captured_contour.h"

#include <fmt/format.h>

namespace mrsim {

void CapturedContour::keep_state(const BlockPlace& cycle) {
  place_ = cycle;
  position_before_ = position_;
  modal_before_ = modal_;
}

void CapturedContour::begin() {
  motions_.clear();
  errors_before_ = reporter_.errors();
  out_.capture(&motions_);
}

bool CapturedContour::end() {
  out_.capture(nullptr);
  modal_ = modal_before_;
  position_ = position_before_;
  put_back_block(place_);
  return reporter_.errors() == errors_before_;
}

bool CapturedContour::has_usual_size(const Word& cycle) {
  return (motions_.size() >= 2 && motions_.size() < MotionEmitter::kMostCaptured) ||
         error("value-range", fmt::format("the contour has {} motions", motions_.size()), cycle);
}

void CapturedContour::end_program(const Word& cycle, const char* name) {
  if (!out_.captures()) return;
  out_.capture(nullptr);
  reporter_.set_place(place_.file, place_.line, place_.call, {});
  error("program-end-missing", fmt::format("the program ends inside the contour of {}", name),
        cycle);
}

}  // namespace mrsim
