// Coarse metric threads (ISO 261).
#pragma once

namespace mrsim {

/// The pitch of the metric thread of a size (M10: 1.5), mm; 0: the table does not have the size.
double iso_pitch(double thread);

}  // namespace mrsim
