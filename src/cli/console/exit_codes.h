// The exit codes of the program.
#pragma once

namespace mrsim::cli {

/// Exit codes: docs/reliability.md, table 1.
inline constexpr int kDone = 0, kFailed = 1, kUsage = 2, kInternal = 3, kRejected = 4,
                     kCollision = 5;

}  // namespace mrsim::cli
