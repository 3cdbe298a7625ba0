// A scanner for XML without DTDs: tags and their attributes, one after another. It builds no tree
// and does not recurse, so a hostile file costs no more than its length.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim::detail {

class XmlScan {
 public:
  enum class Event { open, close, end };  ///< <a ..>, </a>, end of the text

  /// `where` is the file's name for messages.
  XmlScan(std::string_view text, std::string where) : text_(text), where_(std::move(where)) {}

  /// Goes to the next tag; text between tags is kept for text(). An empty element is an open and a
  /// close. Throws Error "3mf-xml".
  Event next();
  /// Name of the tag without its namespace prefix.
  std::string_view name() const { return name_; }
  /// Raw value of an attribute ("pid", "p:path"); nothing when it is not given.
  std::optional<std::string_view> attribute(std::string_view name) const;
  /// What stood between the last two tags.
  std::string_view text() const { return between_; }

  [[noreturn]] void fail(const std::string& what) const;

 private:
  void read_attributes();
  void skip_blanks();
  std::string_view read_name();

  std::string_view text_, name_, between_;
  std::string where_;
  std::size_t at_ = 0;
  bool pending_close_ = false;
  std::vector<std::pair<std::string_view, std::string_view>> attributes_;
};

/// &amp; &lt; &gt; &quot; &apos; and &#n; (ASCII) resolved.
std::string xml_unescaped(std::string_view text);

}  // namespace mrsim::detail
