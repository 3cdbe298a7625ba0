// Bytes as choices among the statements that all controls have; a control adds its own.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>

#include <fmt/format.h>

namespace mrsim::fuzz {

constexpr int kDeepest = 4;               // statements inside one another
constexpr std::size_t kLongest = 40'000;  // characters

class Grammar {
 public:
  Grammar(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  virtual ~Grammar() = default;

  std::string program() {
    head();
    while (at_ < size_ && out_.size() < kLongest) statement(0);
    subprograms();
    return out_;
  }

 protected:
  virtual void head() = 0;
  virtual void subprograms() = 0;
  virtual void special(int depth) = 0;
  virtual std::string variable() = 0;
  virtual std::string bracket(const std::string& text) = 0;

  unsigned pick(unsigned n) { return at_ < size_ ? data_[at_++] % n : 0; }
  std::string one_of(std::initializer_list<const char*> list) {
    return list.begin()[pick(static_cast<unsigned>(list.size()))];
  }
  void line(const std::string& text) { out_ += text + "\n"; }
  std::string number() {
    return fmt::format("{:.4g}", (static_cast<int>(pick(201)) - 100) / (1.0 + pick(8)));
  }
  std::string expression(int depth) {
    const unsigned form = depth > 3 ? pick(2) : pick(6);
    if (form == 0) return number();
    if (form == 1) return variable();
    if (form == 2) return one_of({"SIN", "COS", "ABS", "SQRT"}) + bracket(expression(depth + 1));
    const std::string a = expression(depth + 1), b = expression(depth + 1);
    return bracket(a + one_of({"+", "-", "*", "/"}) + b);
  }
  virtual std::string value() { return pick(4) == 0 ? bracket(expression(0)) : number(); }
  std::string words(std::initializer_list<const char*> letters) {
    std::string text;
    for (const char* letter : letters)
      if (pick(2) == 0) text += " " + (letter + value());
    return text;
  }
  void statements(int depth) {
    for (unsigned n = pick(4); n > 0 && out_.size() < kLongest; --n) statement(depth + 1);
  }
  void statement(int depth) {
    switch (depth >= kDeepest ? pick(4) : pick(7)) {
      case 0:
        return line(one_of({"G0", "G1", "G1", ""}) + words({"X", "Y", "Z", "F"}));
      case 1:
        return line(one_of({"G2", "G3"}) + words({"X", "Y", "I", "J", "Z"}));
      case 2:
        return line(one_of({"G90", "G91", "G17", "G18", "G19", "G40", "G41 D1", "G42 D1", "G54",
                            "G55", "G20", "G21", "G94", "G95"}));
      case 3:
        return cycle();
      default:
        return special(depth);
    }
  }
  virtual void cycle() {
    line(one_of({"G73", "G81", "G82", "G83", "G84", "G85", "G86", "G89", "G80", "G98", "G99"}) +
         words({"X", "Y", "Z", "R", "Q", "P", "F"}));
  }

  std::string out_;

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

}  // namespace mrsim::fuzz
