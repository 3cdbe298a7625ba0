#include "interp/statements/program_places.h"

#include "interp/language/flow_scan.h"

#include <limits>

namespace mrsim {
namespace {

constexpr std::size_t kMostNumbers = 10000;  // how many places of block numbers are kept

}  // namespace

ProgramOutline& ProgramPlaces::outline() { return outline(reader_.file()); }

ProgramOutline& ProgramPlaces::outline(const std::string& file) {
  std::unique_ptr<ProgramOutline>& found = outlines_[file];
  if (!found) found = std::make_unique<ProgramOutline>(file, form_);
  return *found;
}

bool ProgramPlaces::find_number_twice(long number) {
  const ProgramOutline& all = outline();
  const int section = all.section_at(reader_.place_at(0));
  const Place from = all.section_begin(section), to = all.section_end(section);
  Place first, last;
  const std::string& file = reader_.file();
  return scan_number(file, number, from, to, false, first) &&
         scan_number(file, number, from, to, true, last) && first != last;
}

bool ProgramPlaces::scan_number(const std::string& file, long wanted, const Place& from,
                                const Place& to, bool last, Place& out) const {
  LineSource source(file, std::size_t(1) << 16);
  source.seek(from.offset, from.line);
  std::string_view line;
  bool found = false;
  for (std::uint64_t offset = from.offset; offset < to.offset && source.next(line);
       offset = source.next_offset()) {
    for (std::size_t p = 0; p < line.size();) {
      long n = -1;
      if (behind_number(line, p, n) > p && n == wanted) {
        out = {offset, source.line_number() - 1, p};
        found = true;
        if (!last) return true;
      }
      p = form_ == OutlineForm::macro ? end_of_block(line, p) : line.size();
      if (p < line.size()) ++p;
    }
  }
  return found;
}

bool ProgramPlaces::find_number(long wanted, bool forward, bool backward, Place& out) {
  const ProgramOutline& all = outline();
  const Place here = reader_.place_at(0);
  const int section = all.section_at(reader_.place_at(0));
  if (numbers_file_ != reader_.file() || numbers_.size() > kMostNumbers) numbers_.clear();
  numbers_file_ = reader_.file();
  const long mode = forward && backward ? 0 : forward ? 1 : 2;
  const auto [known, fresh] = numbers_.try_emplace({here.offset, wanted * 4 + mode});
  if (fresh) {
    bool& found = known->second.first;
    Place& place = known->second.second;
    if (forward)
      found = scan_number(reader_.file(), wanted, here, all.section_end(section), false, place);
    if (!found && backward)
      found =
          scan_number(reader_.file(), wanted, all.section_begin(section), here, !forward, place);
  }
  out = known->second.second;
  return known->second.first;
}

Place ProgramPlaces::behind_line(const std::string& file, Place at) const {
  LineSource source(file, std::size_t(1) << 16);
  source.seek(at.offset, at.line);
  std::string_view line;
  source.next(line);
  return {source.next_offset(), source.line_number(), 0};
}

bool ProgramPlaces::find_end(long last, const Place& begin, Place& end) {
  const ProgramOutline& all = outline();
  const Place bottom = all.section_end(all.section_at(begin));
  if (!scan_number(reader_.file(), last, begin, bottom, false, end)) return false;
  end = behind_line(end);
  return true;
}

bool ProgramPlaces::find_blocks(long first, long last, Place& begin, Place& end) {
  return find_number(first, true, true, begin) && find_end(last, begin, end);
}

bool ProgramPlaces::find_blocks_before(long first, long last, Place& begin, Place& end) {
  return find_number(first, false, true, begin) && find_end(last, begin, end);
}

bool ProgramPlaces::find_blocks(const SubprogramPlace& program, long first, long last, Place& begin,
                                Place& end) {
  const ProgramOutline& all = outline();
  const Place top{program.offset, program.line, 0};
  Place bottom = {std::numeric_limits<std::uint64_t>::max(), 0, 0};
  if (program.file == reader_.file()) bottom = all.section_end(all.section_at(top));
  if (!scan_number(program.file, first, top, bottom, false, begin) ||
      !scan_number(program.file, last, begin, bottom, false, end))
    return false;
  end = behind_line(program.file, end);
  return true;
}

std::pair<Place, Place> ProgramPlaces::section() {
  const ProgramOutline& all = outline();
  const int here = all.section_at(reader_.place_at(0));
  return {all.section_begin(here), all.section_end(here)};
}

bool ProgramPlaces::find_labels(const std::string& first, const std::string& last, Place& begin,
                                Place& end) {
  const ProgramOutline& all = outline();
  const int section = all.section_at(reader_.place_at(0));
  const Place bottom = all.section_end(section);
  const int from = all.find_label(first, all.section_begin(section), bottom, false);
  const int to = from < 0 ? -1 : all.find_label(last, all.entry(from).at, bottom, false);
  if (to < 0) return false;
  begin = all.entry(from).at;
  end = behind_line(all.entry(to).at);
  return true;
}

}  // namespace mrsim
