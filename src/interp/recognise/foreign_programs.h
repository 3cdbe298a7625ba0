// Programs of controls that mrsim does not read: conversational ones, 3-D printers, lasers. Such a
// program is named and refused with one error, instead of one for each line.
#pragma once

#include "interp/text/line_scan.h"

#include <string>
#include <string_view>

namespace mrsim {

class ForeignPrograms {
 public:
  explicit ForeignPrograms(const std::string& path) : path_(path) {}

  /// Looks at a line of the text. Throws PlacedError "control-unsupported" at the first sure sign.
  void line(std::string_view raw, const LineScan& scan, int number);
  /// Looks at a line of plain motion, which needs no scan.
  void plain(const PlainLine& line) {
    has_z_ |= line.third;
    has_y_ |= line.second;
  }
  /// Whether it can no longer be a program of a laser.
  bool settled() const { return has_z_ || no_laser_; }
  /// Throws for programs that only the whole text shows: of a laser or a pen plotter.
  void finish() const;

 private:
  [[noreturn]] void refuse(const std::string& what, int number, std::string_view raw) const;
  void weigh_printer(const std::string& code, int number, std::string_view raw);
  void weigh_plotter(const std::string& code, int number, std::string_view raw);
  void weigh_heidenhain(const LineScan& scan, int number, std::string_view raw);
  void weigh_old_sinumerik(const LineScan& scan, int number, std::string_view raw);
  void weigh_num(const std::string& code, int number, std::string_view raw);
  void weigh_hnc(const std::string& code, int number, std::string_view raw);
  void weigh_sliding_head(const LineScan& scan, int number, std::string_view raw);
  void weigh_laser(const LineScan& scan, int number);

  const std::string& path_;
  bool numbered_ = false;       ///< "%12" alone heads the text
  bool old_sinumerik_ = false;  ///< "%MPF 90" does
  bool unit_in_head_ = false;   ///< "%NAME G71" does
  bool coded_ = false;          ///< a line has held more than a comment
  bool o_number_ = false;       ///< O and a number have headed a program
  // A 3-D printer does both.
  bool heats_ = false, extrudes_ = false;
  // Signs of a laser or a pen plotter, and against them.
  bool has_z_ = false;          ///< a Z, or a K beside an arc
  bool has_y_ = false;          ///< a move in Y
  bool turns_spindle_ = false;  ///< M3 or M4 in the first lines
  bool no_laser_ = false;       ///< a word that no laser's program has: a tool, a call, a length
  bool beam_on_ = false;        ///< M3 or M4 without an M5 behind it
  bool has_power_ = false;      ///< an S
  bool named_laser_ = false;    ///< a comment names a laser
  std::string pen_text_;
  int pen_moves_ = 0, pen_line_ = 0;   ///< M300 S: how many, and the second one's line
  int powered_moves_ = 0;              ///< in X or Y, with an S
  int switches_ = 0, laser_line_ = 0;  ///< how often the beam is switched on, and first where
};

}  // namespace mrsim
