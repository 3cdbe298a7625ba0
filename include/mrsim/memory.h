/// mrsim: how much memory calls may take. Standard library types only.
#pragma once

#include <mrsim/types.h>

#include <cstddef>

namespace mrsim {

/// What the calls of this thread may bring the memory of the whole process to, in bytes; 0 = what
/// is in use now and what the machine has free. Reading and writing files, comparisons and reports
/// throw Error "memory" where they would need more (docs/limits.md). Default: no limit, but
/// Job::carve.max_memory holds for simulate() whatever was set here.
MRSIM_API void set_memory_limit(std::size_t bytes);

}  // namespace mrsim
