// Finds places of programs: block numbers, labels, sections, and the outline of each file. They are
// those of the program that is being read, unless a file is named. Private to src/interp.
#pragma once

#include "interp/calls/block_reader.h"
#include "interp/language/program_outline.h"

#include <map>
#include <memory>
#include <string>
#include <utility>

namespace mrsim {

class ProgramPlaces {
 public:
  ProgramPlaces(BlockReader& reader, OutlineForm form) : reader_(reader), form_(form) {}

  /// The outline of the file that is being read, or of another one. Throws Error "file-...".
  ProgramOutline& outline();
  ProgramOutline& outline(const std::string& file);

  /// Finds blocks N`first` to N`last` of the program that is being read. False: one is missing.
  bool find_blocks(long first, long last, Place& begin, Place& end);
  /// find_blocks() in another program.
  bool find_blocks(const SubprogramPlace& program, long first, long last, Place& begin, Place& end);
  /// As find_blocks(): the last such blocks before the place that is being read.
  bool find_blocks_before(long first, long last, Place& begin, Place& end);
  /// Beginning and end of the program that is being read.
  std::pair<Place, Place> section();
  /// Finds the part from label `first` to behind the line of label `last` (upper case). False: one
  /// is missing.
  bool find_labels(const std::string& first, const std::string& last, Place& begin, Place& end);

  /// Whether two blocks of the program that is being read have this number.
  bool find_number_twice(long number);
  /// The beginning of the next line.
  Place behind_line(Place at) const { return behind_line(reader_.file(), at); }
  Place behind_line(const std::string& file, Place at) const;
  /// Searches for block `number` forward from here and then from the top, or only one of these.
  bool find_number(long number, bool forward, bool backward, Place& out);

 private:
  /// Finds the end of the next block N`last` from `begin` on.
  bool find_end(long last, const Place& begin, Place& end);
  bool scan_number(const std::string& file, long number, const Place& from, const Place& to,
                   bool last, Place& out) const;

  BlockReader& reader_;
  OutlineForm form_;
  std::map<std::string, std::unique_ptr<ProgramOutline>> outlines_;
  std::map<std::pair<std::uint64_t, long>, std::pair<bool, Place>>
      numbers_;  ///< numbers that were looked up before
  std::string numbers_file_;
};

}  // namespace mrsim
