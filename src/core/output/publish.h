// Puts finished drafts in their places: all of them or none, whatever fails and whenever the
// program dies.
#pragma once

#include <mrsim/files.h>

#include <span>

namespace mrsim {

class DraftFile;

/// Devices, FIFOs and sockets are written first; then the files take their places. Where one
/// cannot, those before it are put back and the Error is thrown. A journal beside the files
/// (publish_journal.h) lets the next run undo what a dead one began; a lock keeps two runs
/// apart. Requires: finish() was called for each.
void publish(std::span<DraftFile* const> drafts);

/// Before any work: check_writable() of each output, refuse_overwrites() of all, and then what dead
/// runs left in their folders is undone or completed.
void prepare_outputs(std::span<const NamedPath> outputs, std::span<const NamedPath> inputs);

}  // namespace mrsim
