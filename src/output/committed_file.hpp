// A file that changes as a whole or not at all, whenever the process is killed or the power fails: what results.vtkhdf
// relies on. Not for: files that are written anew (files.hpp), nor what stands in them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace terp {

/// Changes to an existing file. What is written beyond its end goes to the disk at once, where nothing refers to it
/// yet. Changes before the end are kept in memory, in pages, until `commit`:
///
///   1. what was added is brought to the disk
///   2. the changed pages and the new size are written to <path>.journal, with a checksum, and brought to the disk
///   3. the pages are written into the file, its size is set
///   4. the journal is removed
///
/// A process that dies before the end of 2 leaves the old content (and a tail that nothing refers to), one that dies
/// later leaves a journal, from which `finish_commit` repeats 3 and 4. Without `commit` the file stays as it was.
class CommittedFile {
 public:
  static constexpr std::int64_t page_size = 4096;  ///< of what is kept in memory and in the journal [bytes]

  explicit CommittedFile(std::string path);
  ~CommittedFile();
  CommittedFile(const CommittedFile&) = delete;
  CommittedFile& operator=(const CommittedFile&) = delete;

  /// From here on the first `size` bytes are what must not be lost; a tail behind them is dropped. n_reserved: see
  /// reserve_space.
  void start_changes(std::int64_t size, std::int64_t n_reserved);

  /// Bytes beyond the end read as zero.
  void read(std::int64_t at, std::int64_t n_bytes, unsigned char* to) const;
  void write(std::int64_t at, std::int64_t n_bytes, const unsigned char* from);
  std::int64_t size() const { return size_; }

  /// size: of the file after its changes.
  void commit(std::int64_t size);

 private:
  using Page = std::array<unsigned char, page_size>;

  Page& changed_page(std::int64_t number);

  std::string path_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;       ///< of what is there, changes included
  std::int64_t kept_ = 0;       ///< bytes that only commit may change, whole pages
  std::int64_t kept_size_ = 0;  ///< bytes of the file before its changes
  bool changing_ = false;
  std::map<std::int64_t, Page> pages_;  ///< changed, by number
};

/// The name of the journal of a file.
std::string journal_name(const std::string& path);

/// Ends the commit that a process left unfinished; a journal that was not whole yet is removed. Without a journal
/// nothing is done.
void finish_commit(const std::string& path);

/// Calls `read`, which opens the file, until no commit of another process came into it: only then what it read, or the
/// FileError that it threw, is of one content. Throws FileError if a commit stands still in its middle.
void read_between_commits(const std::string& path, const std::function<void()>& read);

}  // namespace terp
