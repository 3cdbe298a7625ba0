// One block: its words by address, which of them were used, and what its function words ask for.
// All of it is forgotten at the next block. Does not know what the words mean. Private to
// src/interp.
#pragma once

#include "core/numbers/vec.h"
#include "interp/text/block.h"
#include "interp/text/codes.h"
#include <mrsim/events.h>
#include <mrsim/types.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace mrsim {

/// Where a block stands, and from where it was called.
struct BlockPlace {
  int file = 0, line = 0, call = -1;
};

class BlockWords : public Block {
 public:
  /// Begins a block: the one before is forgotten.
  void begin();
  /// Makes word `index` the one of its address. False: the address has one already.
  /// `used`: no part of the control has to take it.
  bool add(std::size_t index, bool used) {
    Slot& slot = slots_[static_cast<std::size_t>(words[index].address)];
    if (slot.epoch == epoch_) return false;
    slot = {epoch_, static_cast<std::uint16_t>(std::min<std::size_t>(index, 65535)), used};
    return true;
  }
  /// From here on find() gives no word, or not the one of this address.
  void forget_words();
  BlockPlace place() const { return {file, line_number, call}; }
  /// The place of a column of the block, 0-based, as Reporter::add_at wants it.
  Motion motion_at(int column) const;
  /// Makes the block at `place` the current one again, without its words.
  void put_back(const BlockPlace& place);
  void forget(Address a) { slots_[static_cast<std::size_t>(a)].epoch = 0; }
  /// Whether the program ends, returns or calls behind this block.
  bool leaves() const { return stop_after || return_after || m98 || call_word; }

  /// The first word of an address, or null.
  const Word* find(Address a) const {
    const Slot& slot = slots_[static_cast<std::size_t>(a)];
    return slot.epoch == epoch_ ? &words[slot.index] : nullptr;
  }
  /// Whether a word of the address, G or M, has a value from `least` to `most`.
  bool has_code(char address, double least, double most) const {
    return std::any_of(words.begin(), words.end(), [&](const Word& word) {
      return word.address == letter(address) && word.value >= least && word.value <= most;
    });
  }
  bool has_code(char address, double value) const { return has_code(address, value, value); }
  /// As find(), for the parts that change words before add() has been called for them.
  Word* search(char c) {
    const auto at = std::find_if(words.begin(), words.end(),
                                 [&](const Word& word) { return word.address == letter(c); });
    return at == words.end() ? nullptr : &*at;
  }
  /// As find(), and the word counts as used.
  const Word* take(Address a) {
    Slot& slot = slots_[static_cast<std::size_t>(a)];
    if (slot.epoch != epoch_) return nullptr;
    slot.used = true;
    return &words[slot.index];
  }
  /// Whether the block has a word of this address that is not used yet.
  bool unused(Address a) const {
    const Slot& slot = slots_[static_cast<std::size_t>(a)];
    return slot.epoch == epoch_ && !slot.used;
  }
  /// The word as it was written, shortened.
  std::string text_of(const Word& word) const {
    return std::string(line.substr(static_cast<std::size_t>(word.column),
                                   static_cast<std::size_t>(std::min(word.length, 40))));
  }

  /// Whether a word of this modal group stands in the block.
  bool has_group(Group group) const { return (groups_ & bit_of(group)) != 0; }
  void add_group(Group group) { groups_ |= bit_of(group); }
  /// Whether an N word stands behind `word`: it is an argument ("G25 N50"), not the block's number.
  bool number_behind(const Word& word) const { return number_after(word).has_value(); }
  /// The number of that N word, at most 999 999.
  std::optional<long> number_after(const Word& word) const;

  // Where the block stands.
  int file = 0;            ///< index into Program::files
  int call = -1;           ///< index into Program::calls
  std::size_t number = 0;  ///< running number of the blocks with words

  // What the function words of the block ask for.
  const Word* motion_code = nullptr;
  const Word* oneshot = nullptr;
  const Word* frame_code = nullptr;
  const Word* offset_number = nullptr;  ///< P of G54.1, where M98 of the block has a P of its own
  const Word* pause = nullptr;          ///< P of G4, where the block may also move (LinuxCNC)
  const Word* ends_cycle = nullptr;     ///< G80
  const Word* lap_begins = nullptr;     ///< G81 or G82 of Okuma's LAP: a contour up to G80
  Code motion{};                        ///< motion of this block alone, else Code::unknown
  Code oneshot_code{};                  ///< counts when `oneshot` is set
  Code frame_op{};                      ///< counts when `frame_code` is set
  bool ends_rotation = false;           ///< G69, beside which other words may stand
  bool ends_scaling = false;            ///< G50 of FANUC's mills, as G69
  bool suppress_frames = false;
  int turn_cycle = 0;               ///< G70 to G76 of a lathe; 0 = none
  const Word* comp_word = nullptr;  ///< G40 G41 G42
  bool comp_selected = false;       ///< comp_word changes the mode
  bool comp_moved = false;          ///< the block made a straight move in the plane
  Code comp_before{};               ///< compensation before this block
  bool length_changed = false;      ///< G43 G44 G49
  bool tool_change = false;         ///< M6, or T where T changes tools
  bool stop_after = false;          ///< M30
  bool return_after = false;        ///< M17, M99
  bool loops = false;               ///< M99
  const Word* call_word = nullptr;
  const Word* m98 = nullptr;
  const Word* set_tool = nullptr;     ///< Q of M61 (LinuxCNC): the tool in the spindle
  const Word* home = nullptr;         ///< M25 of Centroid: Z goes to its reference point
  bool home_guessed = false;          ///< ... unless M25 is meant for another control
  std::optional<PathMode> path_mode;  ///< G9 G60 G61 G64
  std::vector<Vec3> places;           ///< of Fagor's G60 to G64, in the frame in force

 private:
  static std::uint64_t bit_of(Group group) {
    return std::uint64_t(1) << static_cast<unsigned>(group);
  }

  // A slot counts only if it has the epoch of this block, so that begin() need not clear the slots.
  struct Slot {
    std::uint32_t epoch = 0;
    std::uint16_t index = 0;
    bool used = false;
  };
  std::array<Slot, static_cast<std::size_t>(Address::count)> slots_;
  std::uint32_t epoch_ = 0;
  std::uint64_t groups_ = 0;  ///< modal groups that have a word, a bit each
};

}  // namespace mrsim
