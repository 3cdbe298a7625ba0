// The box of stock that CAM programs describe in comments before the first cut.
//
//   Carbide Create, CutViewer  (stockMin:0.00mm, 0.00mm, -12.00mm) (stockMax:...)
//                              (STOCK/BLOCK, size X, Y, Z, zero's place in it X, Y, Z)
//   Vectric                    ( Material Size) ( X= 300.0, Y= 200.0, Z= 18.0)
//                              ( Z Origin for Material = Machine Bed)
//                              ( XY Origin for Material = Bottom Left Corner)
#pragma once

#include <mrsim/types.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace mrsim {

class StockComments {
 public:
  /// Reads a comment in whatever encoding it came; `line`: where it stands.
  void read(std::string_view bytes, int line);
  /// The stock in mm about the program's zero, in a program whose unit is `unit` mm; none: size or
  /// place are missing.
  std::optional<Box3> box(double unit) const;
  /// Where the comment stands that gave the size.
  int line() const { return line_; }

 private:
  /// A number and its unit in mm, 0 = the program's.
  struct Length {
    double value = 0, unit = 0;
  };
  using Lengths = std::array<Length, 3>;

  static std::size_t read_lengths(std::string_view text, Length* out, std::size_t most);
  bool read_limits(std::string_view text);
  bool read_block(std::string_view text);
  void read_size(std::string_view text);
  void read_origin(std::string_view text);

  std::optional<Lengths> low_, high_;     ///< corners
  std::optional<Lengths> size_, inside_;  ///< size, and the zero's place from the lowest corner
  Vec3 share_;                            ///< the zero's place as a share of the size
  bool has_share_xy_ = false, has_share_z_ = false;
  bool is_moved_ = false;      ///< the zero is elsewhere, by a rule that is not known
  bool size_follows_ = false;  ///< the next comment has the size
  int line_ = 0;
};

}  // namespace mrsim
