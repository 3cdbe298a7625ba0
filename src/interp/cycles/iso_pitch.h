// Coarse metric threads (ISO 261).
#pragma once

namespace mrsim {

/// Pitch of the metric thread of a size (M10: 1.5), mm; 0: not a size of the table.
double iso_pitch(double thread);

}  // namespace mrsim
