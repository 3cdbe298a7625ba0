// Weighs the signs of the controls in a program's text.
#pragma once

#include "interp/text/line_scan.h"
#include <mrsim/types.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// Whether a file's name, or a line, is one of Okuma's OSP, whose dialect is FANUC's with its own
/// words.
bool names_okuma(const std::string& path);
bool is_okuma(const LineScan& scan);

/// The points of each dialect, and its strongest sign.
class DialectSigns {
 public:
  /// Weighs the name of the file.
  void name(const std::string& path);
  void line(const LineScan& scan, std::string_view raw, int number);
  /// Weighs a line of plain motion, as read_plain() has found it.
  void plain(const PlainLine& line, int number) {
    moved_ = true;
    if (line.arc) arcs_ = true;
    if (line.line) arcs_ = false;
    if (line.arc && line.radius) weigh_radius(number);
  }

  /// The dialect with the most points; ISO where there are no signs.
  Dialect best() const;
  const std::string& reason(Dialect d) const { return entries_[slot(d)].reason; }
  /// Whether no other dialect has nearly as many points, and G291 can not change that.
  bool certain() const;

 private:
  struct Entry {
    int points = 0, strongest = 0;
    std::string reason;
    std::vector<std::string> signs;
  };

  static std::size_t slot(Dialect d) { return static_cast<std::size_t>(d); }
  int points(Dialect d) const;
  /// Adds points for a sign. Each sign counts once, because a thousand comments prove no more than
  /// one.
  void add(Dialect dialect, int points, std::string_view sign, int line);
  void weigh_sinumerik(const LineScan& s, int line);
  void weigh_radius(int line);
  void weigh_fanuc(const LineScan& s, std::string_view raw, int line);
  void weigh_okuma(const std::string& c, int line);
  void weigh_fanuc_lathe(const std::string& c, int line);
  void weigh_codesys(const LineScan& s, int line);
  void weigh_ngc(const LineScan& s, std::string_view raw, int line);
  void weigh_iso(const LineScan& s, std::string_view raw, int line);
  void weigh_comment(const LineScan& s, int line);

  std::array<Entry, 6> entries_;
  bool moved_ = false;     ///< an axis word was seen
  bool cnc_name_ = false;  ///< the file's name ends in .CNC
  bool tools_ = false;     ///< words that CODESYS does not have were seen
  bool arcs_ = false;      ///< G2 or G3 is in force
  int center_mode_ = 0;    ///< the line above, if it is G98 or G99 alone
  bool o_word_ = false;    ///< the line is an O word of LinuxCNC
};

}  // namespace mrsim
