// The words of SINUMERIK: addresses with "=" and numbers, names, labels, calls.
// Private to src/interp.
#pragma once

#include "interp/text/sinumerik_arrays.h"

#include <string>
#include <string_view>

namespace mrsim {

class SinumerikWords : public SinumerikValues {
 public:
  explicit SinumerikWords(ParsedLine& line) : SinumerikValues(line), arrays_(line) {}

  /// The word that begins with the letter or underscore at the place.
  void read(Block& block);

 private:
  void name(Block& block);
  void label(Block& block, std::size_t from, std::size_t end);
  void short_label(Block& block, std::size_t from);
  void program_name(Block& block, std::size_t from, std::string_view name);
  bool calls_number() const;
  bool lacks_equal_sign(Block& block, std::size_t from);
  void numbered_address(Block& block, Word& word, std::size_t from, char c);
  bool skip_brackets(Block& block);
  void call(Block& block, std::size_t from, std::string_view name);
  bool zero_follows();

  SinumerikArrays arrays_;
};

/// "; is CR=5 meant?" for a name that is an address of SINUMERIK and digits; else empty.
std::string missing_equal_sign(std::string_view name);

}  // namespace mrsim
