#include "core/text/printable.h"

#include <algorithm>

namespace mrsim {
namespace {

unsigned char byte_at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0xFF;
}

// Bytes of the control character with which `text` begins; 0: it begins with none.
std::size_t control_length(std::string_view text) {
  const unsigned char first = byte_at(text, 0);
  if ((first < 0x20 && first != '\t') || first == 0x7F) return 1;
  if (first == 0xC2 && byte_at(text, 1) < 0xA0) return 2;  // U+0080 to U+009F
  return turns_text(text) ? 3 : 0;
}

}  // namespace

bool turns_text(std::string_view text) {
  const unsigned char second = byte_at(text, 1), third = byte_at(text, 2);
  return byte_at(text, 0) == 0xE2 && ((second == 0x80 && third >= 0xAA && third <= 0xAE) ||
                                      (second == 0x81 && third >= 0xA6 && third <= 0xA9));
}

std::string printable(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t control = control_length(text.substr(i));
    out += control > 0 ? '?' : text[i];
    i += std::max<std::size_t>(control, 1);
  }
  return out;
}

}  // namespace mrsim
