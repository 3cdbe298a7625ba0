// Finds subprograms: in the file of the main program, beside it, or in the search path.
#pragma once

#include <mrsim/types.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// A subprogram by number (O2, P2) or by name.
struct SubprogramName {
  long number = -1;
  std::string text;       ///< the name as written, or the number as it is shown
  bool own_file = false;  ///< the main program's file is not searched for it
  bool not_main = false;  ///< the main program does not count, whatever its name
};

struct SubprogramPlace {
  std::string file;
  std::uint64_t offset = 0;  ///< offset of its header line
  int line = 0;              ///< number of the line before `offset`
  int again = 0;             ///< line of a second program of that name in the file, 0 if none
  bool is_main = false;      ///< its header is that of a main program, "%_N_PART_MPF"
};

class SubprogramIndex {
 public:
  SubprogramIndex(std::string main_file, std::vector<std::string> search_path, Dialect dialect);

  /// The place of a subprogram; nothing: it is in none of the places. Throws Error
  /// "subprogram-outside" if a link leads out of them.
  std::optional<SubprogramPlace> find(const SubprogramName& name);

 private:
  void scan(const std::string& file);
  std::optional<std::string> find_file(const std::string& folder,
                                       const std::vector<std::string>& stems, bool not_main) const;
  void stays_inside(const std::filesystem::path& file) const;

  std::string main_file_;
  std::vector<std::string> folders_;
  Dialect dialect_;
  bool scanned_ = false;
  std::map<std::string, SubprogramPlace> inside_;  ///< sections of the main file, "O2" or NAME
  std::map<std::string, std::optional<SubprogramPlace>> found_;
};

/// The name in a header line ("O0002", "%_N_POCKET_SPF", "SUBPROGRAM Name{...}"), upper case; empty
/// if the line is no header.
std::string section_name(std::string_view line, Dialect dialect);

/// Whether the line is "%_N_PART_MPF", the header of a main program of SINUMERIK.
bool names_main_program(std::string_view line);

}  // namespace mrsim
