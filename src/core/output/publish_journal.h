// The journal of a set of files that is being published: what to undo if the program dies before
// the set is complete.
//
// Meanwhile these lie in the folders of the files, where TOKEN is 16 random digits:
//   .mrsim-TOKEN-I.new     file I, complete, until it takes its place
//   .mrsim-TOKEN-I.old     the file that stood in its place
//   .mrsim-TOKEN.journal   in the first folder: the set is to be undone
//   .mrsim-TOKEN.done      the same file once all are in place: only the rest is to be removed
//   .mrsim-TOKEN.folder    in the other folders: where the journal is
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// One file of a set that is published.
struct JournalEntry {
  std::string path;         ///< its place, absolute
  std::uint64_t inode = 0;  ///< of the new file
  bool had_old = false;     ///< a file stood there before
};

/// The names of one set and what to do with them. Its folders are to be locked meanwhile
/// (FolderLocks in publish.cpp).
class PublishJournal {
 public:
  /// A set of files of this process. Requires: not empty.
  static PublishJournal begun(std::vector<std::string> paths);

  /// Where file i stands before it is put in place, and where the one that it replaces is kept.
  std::string new_name(std::size_t i) const;
  std::string old_name(std::size_t i) const;
  std::vector<JournalEntry>& entries() { return entries_; }
  /// The folders of all its files.
  std::set<std::string> folders() const;

  /// Writes into the other folders where the journal will be: before files of the set get names
  /// there.
  void announce() const;
  /// From now on a crash is undone. Requires: the new files have their names. On the disk when it
  /// returns.
  void open() const;
  /// From now on the set is complete: what a crash leaves is removed. On the disk when it returns.
  void close() const;
  /// Puts back what stood there before; true when all of it is back.
  bool undo() const;
  /// Removes all names of the set but those of the files themselves.
  void clean() const;

 private:
  friend void recover_folder(const std::string& folder, std::set<std::string>& missing,
                             const std::set<std::string>& locked);
  std::string name(std::string_view kind) const;
  std::string text() const;
  static bool parse(const std::string& file, PublishJournal& out);

  std::string token_, home_;  ///< home_: the folder of the journal
  std::vector<JournalEntry> entries_;
};

/// Undoes or completes what dead processes of the same user left in a folder, as far as its other
/// folders are `locked`; adds those that are not to `missing`.
void recover_folder(const std::string& folder, std::set<std::string>& missing,
                    const std::set<std::string>& locked);

/// Best effort: some file systems refuse to sync a folder.
void sync_folder(const std::string& folder);

}  // namespace mrsim
