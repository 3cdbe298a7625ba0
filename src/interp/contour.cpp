#include "interp/contour.h"
namespace mrsim {
void CornerStage::push(const PathMove& move) { next_(move); }
void CornerStage::flush() {}
void CompensationStage::push(const PathMove& move) { next_(move); }
void CompensationStage::flush() {}
}  // namespace mrsim
