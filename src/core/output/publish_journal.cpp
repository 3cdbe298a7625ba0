#include "core/output/publish_journal.h"

#include "core/output/output_place.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <random>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mrsim {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHead = "mrsim-journal 1";
constexpr std::string_view kPrefix = ".mrsim-";
constexpr std::size_t kTokenDigits = 16;
constexpr std::size_t kLargest = std::size_t(16) << 20;  // bytes of a journal that is read

std::string new_token() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

void write_synced(const std::string& path, const std::string& text) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (fd < 0) fail_output(path, errno);
  std::size_t done = 0;
  int error = 0;
  while (done < text.size() && error == 0) {
    const ssize_t n = ::write(fd, text.data() + done, text.size() - done);
    if (n > 0) done += static_cast<std::size_t>(n);
    if (n < 0 && errno != EINTR) error = errno;
  }
  if (error == 0 && ::fsync(fd) != 0) error = errno;
  ::close(fd);
  if (error == 0) return;
  ::unlink(path.c_str());
  fail_output(path, error);
}

// The text of a file that this user alone can have written; nothing else is believed.
std::optional<std::string> read_own(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (fd < 0) return std::nullopt;
  struct stat info {};
  std::optional<std::string> out;
  if (::fstat(fd, &info) == 0 && S_ISREG(info.st_mode) && info.st_uid == ::geteuid() &&
      (info.st_mode & 022) == 0 && static_cast<std::size_t>(info.st_size) <= kLargest) {
    out.emplace(static_cast<std::size_t>(info.st_size), '\0');
    if (::read(fd, out->data(), out->size()) != info.st_size) out.reset();
  }
  ::close(fd);
  return out;
}

bool is_own(const std::string& path) {
  struct stat info {};
  return ::lstat(path.c_str(), &info) == 0 && S_ISREG(info.st_mode) && info.st_uid == ::geteuid();
}

// A draft whose process lives is locked by it.
bool is_dead_draft(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (fd < 0) return false;
  const bool dead = ::flock(fd, LOCK_EX | LOCK_NB) == 0;
  ::close(fd);
  return dead;
}

// Takes a line, or `size` bytes and their line end, off the front.
std::optional<std::string> take(std::string_view& rest,
                                std::optional<std::size_t> size = std::nullopt) {
  const std::size_t end = size ? *size : rest.find('\n');
  if (end >= rest.size() || rest[end] != '\n') return std::nullopt;
  std::string out(rest.substr(0, end));
  rest.remove_prefix(end + 1);
  return out;
}

// "1 4711 12": whether there was an old file, the inode, the bytes of the path.
bool parse_entry_line(const std::string& line, JournalEntry& entry, std::size_t& size) {
  unsigned long long inode = 0, length = 0;
  int had_old = 0, used = 0;
  if (std::sscanf(line.c_str(), "%d %llu %llu%n", &had_old, &inode, &length, &used) != 3 ||
      static_cast<std::size_t>(used) != line.size())
    return false;
  entry.had_old = had_old != 0;
  entry.inode = inode;
  size = length;
  return true;
}

}  // namespace

void sync_folder(const std::string& folder) {
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;
  ::fsync(fd);
  ::close(fd);
}

PublishJournal PublishJournal::begun(std::vector<std::string> paths) {
  PublishJournal out;
  out.token_ = new_token();
  out.home_ = folder_of(paths.front());
  for (std::string& path : paths) out.entries_.push_back({std::move(path), 0, false});
  return out;
}

std::string PublishJournal::name(std::string_view kind) const {
  return fmt::format("{}/{}{}{}", home_, kPrefix, token_, kind);
}

std::string PublishJournal::new_name(std::size_t i) const {
  return fmt::format("{}/{}{}-{}.new", folder_of(entries_[i].path), kPrefix, token_, i);
}

std::string PublishJournal::old_name(std::size_t i) const {
  return fmt::format("{}/{}{}-{}.old", folder_of(entries_[i].path), kPrefix, token_, i);
}

std::set<std::string> PublishJournal::folders() const {
  std::set<std::string> out;
  for (const JournalEntry& entry : entries_) out.insert(folder_of(entry.path));
  return out;
}

std::string PublishJournal::text() const {
  std::string out = fmt::format("{}\n{}\n", kHead, entries_.size());
  for (const JournalEntry& e : entries_)
    out += fmt::format("{} {} {}\n{}\n", int(e.had_old), e.inode, e.path.size(), e.path);
  return out;
}

bool PublishJournal::parse(const std::string& file, PublishJournal& out) {
  const std::optional<std::string> text = read_own(file);
  if (!text) return false;
  std::string_view rest = *text;
  const auto head = take(rest), count = take(rest);
  if (head != kHead || !count) return false;
  out.home_ = folder_of(file);
  out.token_ = fs::path(file).filename().string().substr(kPrefix.size(), kTokenDigits);
  while (!rest.empty()) {
    JournalEntry entry;
    std::size_t size = 0;
    const auto line = take(rest);
    if (!line || !parse_entry_line(*line, entry, size)) return false;
    const auto path = take(rest, size);
    if (!path) return false;
    entry.path = *path;
    out.entries_.push_back(std::move(entry));
  }
  return std::to_string(out.entries_.size()) == *count;
}

void PublishJournal::announce() const {
  for (const std::string& folder : folders())
    if (folder != home_)
      write_synced(fmt::format("{}/{}{}.folder", folder, kPrefix, token_), home_);
}

void PublishJournal::open() const {
  const std::string draft = name("-0.new.journal");
  write_synced(draft, text());
  if (::rename(draft.c_str(), name(".journal").c_str()) != 0) {
    const int error = errno;
    ::unlink(draft.c_str());
    fail_output(name(".journal"), error);
  }
  for (const std::string& folder : folders()) sync_folder(folder);
}

void PublishJournal::close() const {
  for (const std::string& folder : folders()) sync_folder(folder);
  if (::rename(name(".journal").c_str(), name(".done").c_str()) != 0)
    fail_output(name(".done"), errno);
  sync_folder(home_);
}

bool PublishJournal::undo() const {
  bool all = true;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const JournalEntry& entry = entries_[i];
    const std::string& old = old_name(i);
    struct stat info {};
    if (::lstat(old.c_str(), &info) == 0)
      all = ::rename(old.c_str(), entry.path.c_str()) == 0 && all;
    else if (!entry.had_old && ::lstat(entry.path.c_str(), &info) == 0 &&
             info.st_ino == entry.inode)
      all = ::unlink(entry.path.c_str()) == 0 && all;
  }
  return all;
}

void PublishJournal::clean() const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    ::unlink(new_name(i).c_str());
    ::unlink(old_name(i).c_str());
  }
  for (const std::string& folder : folders())
    ::unlink(fmt::format("{}/{}{}.folder", folder, kPrefix, token_).c_str());
  ::unlink(name(".journal").c_str());
  ::unlink(name(".done").c_str());
}

namespace {

struct Leftovers {
  std::vector<std::string> journals, pointers, files, drafts;
};

bool is_token(std::string_view text) {
  return text.size() >= kTokenDigits && text.find_first_not_of("0123456789abcdef") >= kTokenDigits;
}

Leftovers leftovers_in(const std::string& folder) {
  Leftovers out;
  std::error_code none;
  for (fs::directory_iterator at(folder, none), end; !none && at != end; at.increment(none)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(kPrefix)) continue;
    const std::string rest = name.substr(kPrefix.size());
    std::string path = folder;
    path.append("/").append(name);
    if (rest.size() == 6)
      out.drafts.push_back(path);
    else if (!is_token(rest))
      continue;
    else if (rest.substr(kTokenDigits) == ".journal" || rest.substr(kTokenDigits) == ".done")
      out.journals.push_back(path);
    else if (rest.substr(kTokenDigits) == ".folder")
      out.pointers.push_back(path);
    else if (rest[kTokenDigits] == '-')
      out.files.push_back(path);
  }
  return out;
}

std::string token_of(const std::string& path) {
  return fs::path(path).filename().string().substr(kPrefix.size(), kTokenDigits);
}

bool is_there(const std::string& path) {
  struct stat info {};
  return ::lstat(path.c_str(), &info) == 0;
}

}  // namespace

void recover_folder(const std::string& folder, std::set<std::string>& missing,
                    const std::set<std::string>& locked) {
  Leftovers left = leftovers_in(folder);
  std::set<std::string> pending;  // tokens whose files must stay
  for (const std::string& file : left.journals) {
    PublishJournal journal;
    const bool known = PublishJournal::parse(file, journal);
    bool free = known;
    if (known)
      for (const std::string& other : journal.folders())
        if (!locked.contains(other)) missing.insert(other), free = false;
    if (free && (file.ends_with(".done") || journal.undo()))
      journal.clean();
    else
      pending.insert(token_of(file));
  }
  for (const std::string& file : left.pointers) {
    const std::optional<std::string> home = read_own(file);
    const std::string stem = fmt::format("{}/{}{}", home.value_or(""), kPrefix, token_of(file));
    const bool used = home && (is_there(stem + ".journal") || is_there(stem + ".done"));
    if (used && !locked.contains(*home)) missing.insert(*home);
    if (used || !home)
      pending.insert(token_of(file));
    else
      ::unlink(file.c_str());
  }
  for (const std::string& file : left.files)
    if (!pending.contains(token_of(file)) && is_own(file)) ::unlink(file.c_str());
  for (const std::string& file : left.drafts)
    if (is_own(file) && is_dead_draft(file)) ::unlink(file.c_str());
}

}  // namespace mrsim
