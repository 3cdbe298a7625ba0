#include "core/output/publish.h"

#include "core/output/draft_file.h"
#include "core/output/publish_journal.h"
#include "core/process/error.h"

#include <cerrno>
#include <chrono>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mrsim {
namespace {

// How long a run waits for the end of another one, and between two looks.
constexpr auto kPatience = std::chrono::seconds(60);
constexpr auto kPause = std::chrono::milliseconds(5);

/// Holds all folders of a set, until it goes away or the process ends. Leaves no file behind: the
/// lock is on the folder itself. A file system without such locks (NFS) holds nobody off.
class FolderLocks {
 public:
  /// Requires: absolute names without links. Throws Error "output-busy" when another process holds
  /// one for a minute.
  explicit FolderLocks(const std::set<std::string>& folders);
  FolderLocks(const FolderLocks&) = delete;
  FolderLocks& operator=(const FolderLocks&) = delete;
  ~FolderLocks();

 private:
  void take(const std::string& folder);
  std::vector<int> held_;
};

// In the order of their names, so that two processes never wait for each other.
FolderLocks::FolderLocks(const std::set<std::string>& folders) {
  try {
    for (const std::string& folder : folders) take(folder);
  } catch (...) {
    for (const int fd : held_) ::close(fd);
    throw;
  }
}

FolderLocks::~FolderLocks() {
  for (const int fd : held_) ::close(fd);
}

void FolderLocks::take(const std::string& folder) {
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;  // writable but not readable: nothing can be locked there
  held_.push_back(fd);
  const auto begin = std::chrono::steady_clock::now();
  while (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) return;  // no locks on this file system
    if (std::chrono::steady_clock::now() - begin > kPatience)
      throw Error("output-busy",
                  fmt::format("another run is writing into {}: wait for its end", folder));
    std::this_thread::sleep_for(kPause);
  }
}

// Locks the folders and settles what dead runs left there, and in the folders of those runs.
std::unique_ptr<FolderLocks> lock_and_recover(std::set<std::string> folders) {
  constexpr int kRounds = 4;  // sets of dead runs that are chained by their folders
  std::unique_ptr<FolderLocks> locks;
  for (int round = 0; round < kRounds; ++round) {
    locks.reset();  // before more are locked: the order of names keeps runs from waiting in a ring
    locks = std::make_unique<FolderLocks>(folders);
    std::set<std::string> missing;
    for (const std::string& folder : folders) recover_folder(folder, missing, folders);
    if (missing.empty()) break;
    folders.merge(missing);
  }
  return locks;
}

// Keeps the file that stands in the place, under both names where the file system can.
void set_aside(const std::string& path, const std::string& old, const std::string& given) {
  struct stat info {};
  if (::lstat(path.c_str(), &info) != 0) return;
  if (S_ISDIR(info.st_mode)) fail_output(given, EISDIR);
  if (::link(path.c_str(), old.c_str()) != 0 && ::rename(path.c_str(), old.c_str()) != 0)
    fail_output(given, errno);
}

class Publication {
 public:
  explicit Publication(std::vector<DraftFile*> files)
      : files_(std::move(files)), journal_(PublishJournal::begun(paths())) {}

  void run() {
    try {
      if (files_.size() == 1) return replace_one();
      begin_and_replace();
    } catch (...) {
      // Where not all can be put back, the journal stays: the next run tries again.
      if (journal_.undo()) journal_.clean();
      throw;
    }
    journal_.clean();
  }

 private:
  std::vector<std::string> paths() const {
    std::vector<std::string> out;
    for (const DraftFile* file : files_) out.push_back(file->place().path);
    return out;
  }
  // A rename alone is whole or not at all.
  void replace_one() {
    name(0);
    if (::rename(journal_.new_name(0).c_str(), files_[0]->place().path.c_str()) != 0)
      fail_output(files_[0]->path(), errno);
    sync_folder(files_[0]->place().folder);
  }
  void begin_and_replace() {
    journal_.announce();
    for (std::size_t i = 0; i < files_.size(); ++i) name(i);
    journal_.open();
    for (std::size_t i = 0; i < files_.size(); ++i) replace(i);
    journal_.close();
  }
  void name(std::size_t i) {
    JournalEntry& entry = journal_.entries()[i];
    files_[i]->name_as(journal_.new_name(i));
    struct stat info {};
    if (::lstat(journal_.new_name(i).c_str(), &info) != 0) fail_output(files_[i]->path(), errno);
    entry.inode = info.st_ino;
    entry.had_old = ::lstat(entry.path.c_str(), &info) == 0;
  }
  void replace(std::size_t i) {
    const std::string& path = journal_.entries()[i].path;
    set_aside(path, journal_.old_name(i), files_[i]->path());
    if (::rename(journal_.new_name(i).c_str(), path.c_str()) != 0)
      fail_output(files_[i]->path(), errno);
  }

  std::vector<DraftFile*> files_;
  PublishJournal journal_;
};

}  // namespace

void publish(std::span<DraftFile* const> drafts) {
  std::vector<DraftFile*> files;
  std::set<std::string> folders;
  for (DraftFile* draft : drafts) {
    if (draft->place().kind == OutputPlace::Kind::stream) {
      draft->pour();
      continue;
    }
    files.push_back(draft);
    folders.insert(draft->place().folder);
  }
  if (files.empty()) return;
  const auto locks = lock_and_recover(folders);
  Publication(files).run();
}

void prepare_outputs(std::span<const NamedPath> outputs, std::span<const NamedPath> inputs) {
  for (const NamedPath& output : outputs) check_writable(output.path);
  refuse_overwrites(outputs, inputs);
  std::set<std::string> folders;
  for (const NamedPath& output : outputs) {
    const OutputPlace place = output_place(output.path);
    if (place.kind == OutputPlace::Kind::file) folders.insert(place.folder);
  }
  if (!folders.empty()) lock_and_recover(folders);
}

}  // namespace mrsim
