// Writes words of the ISO dialect anew, as its family (Fagor 8055) means them, in the addresses
// that other parts know: G36 R becomes RND, G39 R CHR, G8 CT and G9 CIP; G6 makes I J K absolute. A
// word that moves the machine and is not read is an error by name. Private to src/interp.
#pragma once

#include "interp/control/control.h"

#include <optional>

namespace mrsim {

class IsoWords : public ControlPart {
 public:
  explicit IsoWords(Control& control) : ControlPart(control) {}

  /// Called before the words are indexed. Changes addresses and removes G words. False: reported.
  bool rewrite();
  /// Called after the block: R and Q that no part has taken are polar coordinates. False: reported.
  bool check_polar();

 private:
  bool rewrite_word(std::size_t at, bool& gone);
  std::optional<bool> absorb(const Word& word, int code, bool& gone);
  bool read_places(Word& word, int code);
  void to_frame(Code code, Word& word);
  bool to_corner(Address corner, const Word& word);
  bool to_point_arc(Word& word);
  bool to_pocket(Word& word);
  bool to_polar_origin(Word& word);
  bool rewrite_polar();
  void to_end_of_angle(Word& angle, bool incremental);
  void split_tool();
  bool absolute_center(const Word& word);
  bool has_any(std::string_view letters);
  bool has_motion() const;
};

}  // namespace mrsim
