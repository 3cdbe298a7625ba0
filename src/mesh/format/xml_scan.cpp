#include "mesh/format/xml_scan.h"

#include "core/process/error.h"
#include "mesh/format/text_scan.h"

#include <fmt/format.h>

namespace mrsim::detail {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

bool ends_name(char c) { return is_space(c) || c == '=' || c == '/' || c == '>' || c == '<'; }

char entity(std::string_view name) {
  constexpr std::pair<std::string_view, char> kNames[] = {
      {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};
  for (const auto& [known, c] : kNames)
    if (known == name) return c;
  if (!name.starts_with("#")) return '?';
  const std::int64_t code = to_integer(name.substr(1)).value_or(0);
  return code >= 32 && code < 127 ? char(code) : '?';
}

std::string_view without_prefix(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

}  // namespace

void XmlScan::fail(const std::string& what) const {
  throw Error("3mf-xml",
              fmt::format("{}: {} (byte {} of the model); export it again", where_, what, at_));
}

void XmlScan::skip_blanks() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
}

std::string_view XmlScan::read_name() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && !ends_name(text_[at_])) ++at_;
  if (at_ == begin) fail("a name is missing");
  return text_.substr(begin, at_ - begin);
}

void XmlScan::read_attributes() {
  attributes_.clear();
  for (;;) {
    skip_blanks();
    if (at_ >= text_.size()) fail("it is cut short");
    if (text_[at_] == '>' || text_[at_] == '/') return;
    const std::string_view name = read_name();
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != '=') fail("an attribute has no value");
    ++at_;
    skip_blanks();
    if (at_ >= text_.size() || (text_[at_] != '"' && text_[at_] != '\''))
      fail("an attribute's value is not quoted");
    const std::size_t end = text_.find(text_[at_], at_ + 1);
    if (end == text_.npos) fail("it is cut short");
    if (attributes_.size() >= 64) fail("a tag has too many attributes");
    attributes_.emplace_back(name, text_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
  }
}

XmlScan::Event XmlScan::next() {
  if (pending_close_) {
    pending_close_ = false;
    between_ = {};
    return Event::close;
  }
  for (;;) {
    const std::size_t open = text_.find('<', at_);
    if (open == text_.npos) return Event::end;
    between_ = text_.substr(at_, open - at_);
    at_ = open + 1;
    const std::string_view rest = text_.substr(at_);
    const auto skip_past = [&](std::string_view mark) {
      const std::size_t end = text_.find(mark, at_);
      if (end == text_.npos) fail("it is cut short");
      at_ = end + mark.size();
    };
    if (rest.starts_with("!--")) {
      skip_past("-->");
    } else if (rest.starts_with("![CDATA[")) {
      skip_past("]]>");
    } else if (rest.starts_with("?")) {
      skip_past("?>");
    } else if (rest.starts_with("!")) {
      fail("document types are not allowed in a 3MF model");
    } else if (rest.starts_with("/")) {
      ++at_;
      name_ = without_prefix(read_name());
      skip_past(">");
      return Event::close;
    } else {
      name_ = without_prefix(read_name());
      read_attributes();
      pending_close_ = text_[at_] == '/';
      skip_past(">");
      return Event::open;
    }
  }
}

std::optional<std::string_view> XmlScan::attribute(std::string_view name) const {
  for (const auto& [key, value] : attributes_)
    if (key == name) return value;
  return {};
}

std::string xml_unescaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t end = text[i] == '&' ? text.find(';', i) : text.npos;
    if (end == text.npos) {
      out += text[i];
      continue;
    }
    out += entity(text.substr(i + 1, end - i - 1));
    i = end;
  }
  return out;
}

}  // namespace mrsim::detail
