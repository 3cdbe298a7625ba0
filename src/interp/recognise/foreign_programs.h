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
    z_ |= line.third;
    y_ |= line.second;
  }
  /// Whether it can no longer be a program of a laser.
  bool settled() const { return z_ || other_; }
  /// Throws for programs that only the whole text shows: of a laser or a pen plotter.
  void finish() const;

 private:
  [[noreturn]] void refuse(const std::string& what, int number, std::string_view raw) const;
  void weigh_printer(const std::string& code, int number, std::string_view raw);
  void weigh_plotter(const std::string& code, int number, std::string_view raw);
  void weigh_old_sinumerik(const LineScan& scan, int number, std::string_view raw);
  void weigh_num(const std::string& code, int number, std::string_view raw);
  void weigh_hnc(const std::string& code, int number, std::string_view raw);
  void weigh_sliding_head(const LineScan& scan, int number, std::string_view raw);
  void weigh_laser(const LineScan& scan, int number);

  const std::string& path_;
  bool numbered_ = false;       ///< "%12" alone heads the text
  bool old_sinumerik_ = false;  ///< "%MPF 90" does
  bool coded_ = false;          ///< a line has held more than a comment
  bool o_number_ = false;       ///< O and a number have headed a program
  bool heats_ = false, extrudes_ = false;
  bool z_ = false, y_ = false, other_ = false;
  bool on_ = false, power_ = false, laser_word_ = false;
  bool spindle_ = false;
  std::string pen_text_;
  int pen_moves_ = 0, pen_line_ = 0, powered_moves_ = 0, switches_ = 0, laser_line_ = 0;
};

}  // namespace mrsim
