// Puts finished drafts in their places: all of them or none, whatever fails and whenever the
// program dies.
#pragma once

#include <span>
#include <string>

namespace mrsim {

class DraftFile;

/// Devices, FIFOs and sockets are written first; then the files take their places. Where one
/// cannot, those before it are put back and the Error is thrown. A journal beside the files
/// (publish_journal.h) lets the next run undo what a dead one began; a lock keeps two runs
/// apart. Requires: finish() was called for each.
void publish(std::span<DraftFile* const> drafts);

/// Undoes or completes what dead runs left in the folders of these outputs.
void recover_outputs(std::span<const std::string> paths);

}  // namespace mrsim
