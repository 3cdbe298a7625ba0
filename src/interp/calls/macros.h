// DEFINE NAME AS TEXT of SINUMERIK: names that are replaced by a piece of a block.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

class Macros {
 public:
  void define(const std::string& name, std::string_view text) { texts_[name] = text; }
  bool empty() const { return texts_.empty(); }
  /// The text of a name in upper case; null: there is none.
  const std::string* find(std::string_view name) const;

 private:
  std::map<std::string, std::string, std::less<>> texts_;
};

/// Replaces the names of `own`, else of `common`, in a line by their texts. Names in these texts,
/// in strings, in comments, and in a line that defines one are not replaced. False: the line has no
/// such name.
bool expand_macros(std::string_view line, const Macros& own, const Macros& common,
                   std::vector<char>& out);

}  // namespace mrsim
