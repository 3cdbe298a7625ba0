#include "interp/calls/subprogram.h"

#include "core/output/real_path.h"
#include "interp/text/characters.h"
#include "interp/text/line_scan.h"
#include "interp/text/source.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace mrsim {
namespace {

namespace fs = std::filesystem;

std::string number_key(std::string_view digits) {
  std::size_t i = 0;
  while (i + 1 < digits.size() && digits[i] == '0') ++i;
  return fmt::format("O{}", digits.substr(i));
}

std::string_view trimmed(std::string_view line) {
  const std::size_t i = line.find_first_not_of(" \t");
  return i == std::string_view::npos ? std::string_view() : line.substr(i);
}

std::string_view name_at(std::string_view text) {
  std::size_t n = 0;
  while (n < text.size() && is_name(text[n])) ++n;
  return text.substr(0, n);
}

std::string codesys_section(std::string_view line) {
  if (!line.empty() && upper(line[0]) == 'N') {
    std::size_t i = 1;
    while (i < line.size() && is_digit(line[i])) ++i;
    if (i > 1) line = trimmed(line.substr(i));
  }
  constexpr std::string_view kWord = "SUBPROGRAM";
  if (upper_case(line.substr(0, kWord.size())) != kWord) return {};
  const std::string_view rest = line.substr(kWord.size());
  if (rest.empty() || (rest[0] != ' ' && rest[0] != '\t')) return {};
  return upper_case(name_at(trimmed(rest)));
}

// "_N_POCKET_SPF" of SINUMERIK's file system is POCKET.
std::string_view plain_name(std::string_view name) {
  if (!name.starts_with("_N_") || !(name.ends_with("_SPF") || name.ends_with("_MPF"))) return name;
  return name.substr(3, name.size() - 7);
}

// "%_N_POCKET_SPF" is POCKET.
std::string sinumerik_section(std::string_view line) {
  if (upper_case(line.substr(0, 4)) != "%_N_") return {};
  std::string name = upper_case(name_at(line.substr(4)));
  if (name.ends_with("_SPF") || name.ends_with("_MPF")) name.resize(name.size() - 4);
  return name;
}

}  // namespace

std::string section_name(std::string_view line, Dialect dialect) {
  line = trimmed(line);
  if (dialect == Dialect::codesys) return codesys_section(line);
  if (dialect == Dialect::sinumerik) return sinumerik_section(line);
  if (dialect == Dialect::fanuc && line.starts_with('<'))
    return upper_case(bracketed_name(line, 0));
  if (line.size() < 2 || (upper(line[0]) != 'O' && !(line[0] == ':' && names_program(line, 0))))
    return {};
  if (dialect == Dialect::fanuc && names_okuma_program(line, 0)) return upper_case(name_at(line));
  const std::string_view rest = trimmed(line.substr(1));
  std::size_t n = 0;
  while (n < rest.size() && is_digit(rest[n])) ++n;
  return n == 0 || n > 9 ? std::string() : number_key(rest.substr(0, n));
}

bool names_main_program(std::string_view line) {
  line = trimmed(line);
  return upper_case(line.substr(0, 4)) == "%_N_" &&
         upper_case(name_at(line.substr(4))).ends_with("_MPF");
}

SubprogramIndex::SubprogramIndex(std::string main_file, std::vector<std::string> search_path,
                                 Dialect dialect)
    : main_file_(std::move(main_file)), dialect_(dialect) {
  const fs::path own = fs::path(main_file_).parent_path();
  folders_.push_back(own.empty() ? std::string(1, '.') : own.string());
  folders_.insert(folders_.end(), search_path.begin(), search_path.end());
}

void SubprogramIndex::scan(const std::string& file) {
  LineSource source(file);
  std::string_view line;
  for (std::uint64_t offset = 0; source.next(line); offset = source.next_offset()) {
    std::string name = section_name(line, dialect_);
    // The header line is read again, because blocks may follow in it ("O0002; G91 ...").
    if (name.empty()) continue;
    const auto [place, fresh] = inside_.emplace(
        std::move(name),
        SubprogramPlace{file, offset, source.line_number() - 1, 0, names_main_program(line)});
    if (!fresh && place->second.again == 0) place->second.again = source.line_number();
  }
}

std::optional<std::string> SubprogramIndex::find_file(const std::string& folder,
                                                      const std::vector<std::string>& stems,
                                                      bool not_main) const {
  static constexpr std::string_view kExtensions[] = {
      ".MPF", ".SPF", "",     ".NC",    ".CNC", ".TAP", ".TXT", ".NGC",
      ".ISO", ".EIA", ".DIN", ".GCODE", ".MIN", ".SSB", ".SUB", ".LIB"};
  std::vector<std::string> wanted;
  for (const std::string_view extension : kExtensions)
    for (const std::string& stem : stems)
      wanted.push_back(fmt::format("{}{}", upper_case(stem), extension));
  std::size_t best = wanted.size();
  std::string found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const auto at = std::find(wanted.begin(), wanted.end(), upper_case(name));
    const auto rank = static_cast<std::size_t>(at - wanted.begin());
    std::error_code ignored;
    if (rank > best || at == wanted.end() || !entry.is_regular_file(ignored)) continue;
    if (not_main && fs::equivalent(entry.path(), main_file_, ignored)) continue;
    if (rank == best && name >= found)
      continue;  // the answer must not depend on the order of the folder
    best = rank;
    found = name;
  }
  if (best == wanted.size()) return std::nullopt;
  const fs::path path = folder == "." ? fs::path(found) : fs::path(folder) / found;
  stays_inside(path);
  return path.string();
}

// A link in a folder of someone else may lead to any file of the machine.
void SubprogramIndex::stays_inside(const fs::path& file) const {
  const fs::path real = real_path(file);
  for (const std::string& folder : folders_)
    if (lies_in(real, real_path(folder))) return;
  throw Error("subprogram-outside",
              fmt::format("{} is a link to {}, outside of the program's folder: say --path {}, if "
                          "that is wanted",
                          file.string(), real.string(), real.parent_path().string()));
}

std::optional<SubprogramPlace> SubprogramIndex::find(const SubprogramName& name) {
  const std::string key =
      name.number >= 0 ? fmt::format("O{}", name.number) : upper_case(name.text);
  if (!scanned_ && !name.own_file) {
    scanned_ = true;
    scan(main_file_);
  }
  if (const auto at = inside_.find(key);
      at != inside_.end() && !name.own_file && !(name.not_main && at->second.is_main))
    return at->second;
  const std::string search = name.not_main ? key + " but the main program" : key;
  if (const auto at = found_.find(search); at != found_.end()) return at->second;
  std::vector<std::string> stems{key};
  if (name.number >= 0) {
    stems = {fmt::format("O{:04}", name.number), key, fmt::format("{:04}", name.number),
             fmt::format("{}", name.number)};
  } else if (const std::size_t dot = key.find_last_of('.'); dot != std::string::npos) {
    stems.push_back(key.substr(0, dot));
  } else if (key.ends_with("_SPF") || key.ends_with("_MPF")) {
    stems.push_back(key.substr(0, key.size() - 4));
  }
  if (dialect_ == Dialect::sinumerik &&
      !key.starts_with("_N_"))  // files of archives have such names
    for (const char* kind : {"SPF", "MPF"}) stems.push_back(fmt::format("_N_{}_{}", key, kind));
  std::optional<SubprogramPlace> place;
  const bool escapes = key.find('/') != std::string::npos || key.find('\\') != std::string::npos;
  for (const std::string& folder : folders_) {
    if (place || escapes) break;
    if (const auto file = find_file(folder, stems, name.not_main)) place = SubprogramPlace{*file};
  }
  const std::string_view plain = plain_name(key);
  if (!place && plain.size() < key.size())
    place = find({-1, std::string(plain), name.own_file, name.not_main});
  found_[search] = place;
  return place;
}

}  // namespace mrsim
