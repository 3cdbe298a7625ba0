#include "interp/words/saved_modes.h"

#include "interp/frames/frame_words.h"

#include <utility>

#include <fmt/format.h>

namespace mrsim {

bool SavedModes::run(int m, std::size_t level, const Word& word) {
  if (m == 70 || m == 73) {
    saved_[level] = {modal_, frames_.work_name, m == 73};
    return true;
  }
  if (m == 71) {
    saved_.erase(level);
    return true;
  }
  const auto at = saved_.find(level);
  if (at == saved_.end())
    return error("saved-modes", "M72 restores what M70 or M73 of this subprogram has saved: none",
                 word);
  return restore(at->second, &word);
}

void SavedModes::leave(std::size_t level) {
  const auto at = saved_.find(level);
  if (at == saved_.end()) return;
  const Saved saved = std::move(at->second);
  saved_.erase(at);
  if (saved.automatic) restore(saved, nullptr);
}

// Restores all modes but the motion, its cycles, and the tool's edge.
bool SavedModes::restore(const Saved& saved, const Word* word) {
  const Modal now = modal_;
  if (now.comp != saved.modal.comp) {
    const std::string text =
        "the saved modes would begin or end radius compensation, which is not supported: write "
        "G40 before them";
    if (word) return error("not-supported", text, *word);
    reporter_.add(Severity::error, "not-supported", text, 0, 1);
    return false;
  }
  modal_ = saved.modal;
  modal_.motion = now.motion;
  modal_.lead = now.lead;
  modal_.drill = now.drill;
  modal_.edge = now.edge;
  modal_.edge_given = now.edge_given;
  modal_.edge_radius = now.edge_radius;
  modal_.comp_diameter = now.comp_diameter;
  modal_.comp_tip = now.comp_tip;
  if (frames_.work_name == saved.work) return true;
  FrameWords frames(control_);
  frames.save();
  frames_.work_name = saved.work;
  frames.renew_work();
  return true;
}

}  // namespace mrsim
