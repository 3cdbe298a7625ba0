// One NC block as words: addresses, values and places. What they mean is decided later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace mrsim {

/// The address of a word. A letter has its ASCII code; the others are addresses of several
/// characters.
enum class Address : std::uint8_t {
  none = 0,
  A = 'A',
  Z = 'Z',
  function = 96,  ///< a G-like word without value (TRANS, CIP, SUPA); Word::code says which
  i1,
  j1,
  k1,
  cr,
  ar,
  ap,
  rp,
  turn,
  rnd,
  rndm,
  chf,
  chr,
  ang,
  frc,
  frcm,
  rpl,
  lims,
  sf,
  disc,
  offn,
  fz,    ///< feed per tooth
  meas,  ///< MEAS=1: the move is that of a probe
  ff,
  ef,
  data,  ///< accepted, has no effect on geometry (SPOS=, ADIS=, S2=)
  call,  ///< name of a subprogram, in Word::text
  count,
};

constexpr Address letter(char c) { return static_cast<Address>(c); }

/// How the value was written: plain, or AC() IC() DAC() DIC() RAC() RIC().
enum class Form : std::uint8_t { plain, ac, ic, dac, dic, rac, ric };

enum class Code : std::uint8_t;

struct Word {
  Address address = Address::none;
  Form form = Form::plain;
  bool point = false;   ///< a decimal point was written
  bool string = false;  ///< the value is `text` (T="NAME")
  bool own = false;     ///< HA, DA of Okuma: the value is the spindle tool's register
  Code code{};
  int column = 0;  ///< 0-based, bytes from the start of the line
  int length = 0;
  double value = 0;
  std::string_view text;  ///< the string, the name; else empty
};

/// Whether block skip leaves out blocks of this level: `levels` has a bit for each one that is in
/// force. -1 is the level of a block without "/".
inline bool skips_level(unsigned levels, int level) {
  return level >= 0 && (levels >> level & 1U) != 0;
}

struct Block {
  std::vector<Word> words;                 ///< in program order; capacity is reused
  std::vector<std::string_view> comments;  ///< without their brackets
  std::string_view line;                   ///< the whole line
  std::string_view argument;       ///< text between the brackets of MSG(...), WORKPIECE(...)
  std::string_view function_name;  ///< name before `argument`
  bool modal_call = false;         ///< MCALL stands in the block, with or without a function
  int line_number = 0;
  static constexpr std::size_t kNoStatement = static_cast<std::size_t>(-1);
  std::size_t statement = kNoStatement;  ///< where a statement of the control's language begins
  int skip_level = -1;                   ///< -1 = no "/"
  int inner_skip = -1;                   ///< of a "/" behind words; -1 = none
  bool bad = false;                      ///< the parser reported an error
  bool has_number = false;
  std::string_view name;     ///< the block's name, where it has no number
  std::string_view contour;  ///< NLAP1 behind G85 to G88 of Okuma
  bool no_hole = false;      ///< NCYL of Okuma: the cycle in force makes no hole here
};

}  // namespace mrsim
