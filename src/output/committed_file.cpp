// A file that changes as a whole: see committed_file.hpp.
#include "output/committed_file.hpp"

#include "base/errors.hpp"
#include "output/checksum.hpp"
#include "output/files.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace terp {
namespace {

constexpr std::string_view magic = "terpjnl2";
constexpr std::size_t head_size = 64;    // of the file, by which a journal knows it: HDF5 keeps its size there
constexpr useconds_t a_moment = 10'000;  // before a reading is repeated [us]
constexpr std::chrono::milliseconds patience{
    1000};  // with a commit in its middle, which takes 0.2 ms unless its writer was killed

/// The bytes of a number, little-endian as in memory.
std::string_view bytes_of(const std::int64_t& value) { return {reinterpret_cast<const char*>(&value), sizeof value}; }

void write_at(int descriptor, const std::string& path, std::int64_t at, std::string_view bytes)
{
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(descriptor, bytes.data(), bytes.size(), at);
    if (n < 0 && errno != EINTR) throw_file_error("write", path, errno);
    if (n <= 0) continue;
    bytes.remove_prefix(static_cast<std::size_t>(n));
    at += n;
  }
}

void set_size(int descriptor, const std::string& path, std::int64_t size)
{
  if (::ftruncate(descriptor, size) != 0) throw_file_error("write", path, errno);
}

int open_for_change(const std::string& path)
{
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) throw_file_error("change", path, errno);
  return descriptor;
}

void sync(int descriptor, const std::string& path)
{
  if (::fsync(descriptor) != 0 && errno != EINVAL)
    throw_file_error("write", path, errno);  // EINVAL: not a thing to sync
}

std::uint64_t checksum(std::string_view bytes)
{
  Fnv1a hash;
  hash.add(bytes);
  return hash.value();
}

/// Reads numbers and bytes one after the other.
struct Cursor {
  std::string_view rest;
  std::string_view take(std::size_t n)
  {
    const std::string_view taken = rest.substr(0, n);
    rest.remove_prefix(taken.size());
    return taken;
  }
  std::int64_t number()
  {
    std::int64_t value = 0;
    const std::string_view bytes = take(sizeof value);
    std::memcpy(&value, bytes.data(), bytes.size());
    return value;
  }
};

/// True if every byte of the journal was written.
bool is_whole(std::string_view journal)
{
  if (journal.size() < magic.size() + head_size + 2 * sizeof(std::int64_t) || !journal.starts_with(magic)) return false;
  const std::string_view content = journal.substr(0, journal.size() - sizeof(std::int64_t));
  return Cursor{journal.substr(content.size())}.number() == static_cast<std::int64_t>(checksum(content));
}

/// What a file begins with; zeros where it is shorter.
std::string head_of(int descriptor, const std::string& path)
{
  std::string head(head_size, '\0');
  if (::pread(descriptor, head.data(), head.size(), 0) < 0) throw_file_error("read", path, errno);
  return head;
}

/// A whole journal.
struct Journal {
  std::int64_t size = 0;  ///< of the file afterwards
  std::string_view head;  ///< of the file before
  std::vector<std::pair<std::int64_t, std::string_view>> pages;

  /// Empty if the first page stays as it is.
  std::string_view head_after() const
  {
    return pages.empty() || pages[0].first != 0 ? std::string_view() : pages[0].second.substr(0, head_size);
  }
};

Journal read_journal(std::string_view text, std::size_t page_size)
{
  Cursor at{text.substr(0, text.size() - sizeof(std::int64_t))};
  at.take(magic.size());
  Journal journal;
  journal.size = at.number();
  journal.head = at.take(head_size);
  while (!at.rest.empty()) {
    const std::int64_t number = at.number();
    journal.pages.emplace_back(number, at.take(page_size));
  }
  return journal;
}

/// True if the file is the one that the journal was written for, as it was before, or with some or all of the pages in
/// it. What is new lies in the file before the journal is written.
bool belongs_to(const Journal& journal, int descriptor, const std::string& path)
{
  struct stat file = {};
  if (::fstat(descriptor, &file) != 0 || journal.size <= 0 || file.st_size < journal.size) return false;
  const std::string head = head_of(descriptor, path);
  return head == journal.head || head == journal.head_after();
}

/// Step 3 of a commit.
void apply(const Journal& journal, int descriptor, const std::string& path)
{
  for (const auto& [number, page] : journal.pages)
    write_at(descriptor, path, number * static_cast<std::int64_t>(CommittedFile::page_size), page);
  set_size(descriptor, path, journal.size);
  sync(descriptor, path);
}

void remove_journal(const std::string& path)
{
  if (::unlink(journal_name(path).c_str()) != 0) throw_file_error("remove", journal_name(path), errno);
}

/// To read, by one who writes nothing; what is no file, or not there, is empty.
std::ifstream open_to_read(const std::string& path)
{
  std::error_code none;
  return std::filesystem::is_regular_file(path, none) ? std::ifstream(path, std::ios::binary) : std::ifstream();
}

/// Up to n_bytes from `at` on, as far as the file goes.
std::string bytes_at(const std::string& path, std::int64_t at, std::size_t n_bytes)
{
  std::string bytes(n_bytes, '\0');
  std::ifstream file = open_to_read(path);
  file.seekg(at).read(bytes.data(), static_cast<std::streamsize>(n_bytes));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

/// True between the first page of a commit, which is the head's, and the last: a file with this head is neither what it
/// was nor what it becomes.
bool is_half_changed(const std::string& path, const std::string& head)
{
  const std::string name = journal_name(path);
  if (bytes_at(name, 0, magic.size()) != magic) return false;
  std::ifstream file = open_to_read(name);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!is_whole(text)) return false;
  const Journal journal = read_journal(text, CommittedFile::page_size);
  if (head == journal.head || head != journal.head_after())
    return false;  // nothing is written yet, or it is of another file
  return std::any_of(journal.pages.begin(), journal.pages.end(), [&](const auto& page) {
    return !page.second.starts_with(bytes_at(path, page.first * CommittedFile::page_size, page.second.size()));
  });
}

}  // namespace

std::string journal_name(const std::string& path) { return path + ".journal"; }

CommittedFile::CommittedFile(std::string path) : path_(std::move(path)), descriptor_(open_for_change(path_))
{
  struct stat file = {};
  if (::fstat(descriptor_, &file) == 0) size_ = file.st_size;
}

CommittedFile::~CommittedFile()
{
  // Best effort: nothing refers to a tail that stays.
  if (changing_) [[maybe_unused]]
    const int tail_stays = ::ftruncate(descriptor_, kept_size_);
  ::close(descriptor_);
}

void CommittedFile::start_changes(std::int64_t size, std::int64_t n_reserved)
{
  if (size < size_) set_size(descriptor_, path_, size);
  if (n_reserved > 0) reserve_space(path_, n_reserved);
  size_ = kept_size_ = size;
  kept_ = (size + page_size - 1) / page_size * page_size;
  changing_ = true;
}

void CommittedFile::read(std::int64_t at, std::int64_t n_bytes, unsigned char* to) const
{
  std::fill_n(to, n_bytes, static_cast<unsigned char>(0));
  for (std::int64_t done = 0; done < n_bytes;) {
    const ssize_t n = ::pread(descriptor_, to + done, static_cast<std::size_t>(n_bytes - done), at + done);
    if (n < 0 && errno != EINTR) throw_file_error("read", path_, errno);
    if (n == 0) break;
    done += std::max<ssize_t>(n, 0);
  }
  const auto end = at + n_bytes;
  for (auto page = pages_.lower_bound(at / page_size); page != pages_.end() && page->first * page_size < end; ++page) {
    const std::int64_t start = page->first * page_size, from = std::max(at, start),
                       until = std::min(end, start + page_size);
    std::copy(page->second.begin() + (from - start), page->second.begin() + (until - start), to + (from - at));
  }
}

CommittedFile::Page& CommittedFile::changed_page(std::int64_t number)
{
  const auto [page, is_new] = pages_.try_emplace(number);
  if (is_new) {
    Page before;
    page->second.fill(0);
    const std::int64_t start = number * page_size;
    const auto n = std::min(page_size, kept_size_ - start);
    const ssize_t got = ::pread(descriptor_, before.data(), static_cast<std::size_t>(n), start);
    if (got != n) throw_file_error("read", path_, got < 0 ? errno : EIO);
    std::copy_n(before.begin(), n, page->second.begin());
  }
  return page->second;
}

void CommittedFile::write(std::int64_t at, std::int64_t n_bytes, const unsigned char* from)
{
  size_ = std::max(size_, at + n_bytes);
  while (n_bytes > 0 && at < kept_) {
    const std::int64_t number = at / page_size, offset = at - number * page_size,
                       n = std::min(n_bytes, page_size - offset);
    std::copy_n(from, n, changed_page(number).begin() + offset);
    at += n;
    from += n;
    n_bytes -= n;
  }
  write_at(descriptor_, path_, at, {reinterpret_cast<const char*>(from), static_cast<std::size_t>(n_bytes)});
}

void CommittedFile::commit(std::int64_t size)
{
  sync(descriptor_, path_);
  std::string journal(magic);
  journal += bytes_of(size);
  journal += head_of(descriptor_, path_);
  for (const auto& [number, page] : pages_) {
    journal += bytes_of(number);
    journal.append(reinterpret_cast<const char*>(page.data()), page.size());
  }
  journal += bytes_of(static_cast<std::int64_t>(checksum(journal)));
  write_file_atomically(journal_name(path_), journal);
  changing_ = false;  // from here on there is no way back
  apply(read_journal(journal, page_size), descriptor_, path_);
  remove_journal(path_);
}

void finish_commit(const std::string& path)
{
  const std::string name = journal_name(path);
  if (!std::filesystem::exists(name)) return;
  const std::string journal = read_file(name);
  if (is_whole(journal)) {
    const int descriptor = open_for_change(path);
    try {
      const Journal changes = read_journal(journal, CommittedFile::page_size);
      if (!belongs_to(changes, descriptor, path))
        throw FileError(fmt::format(
            "{} is of another {}: it was left by a run that was killed, and the file is not what it was then\n"
            "  If the file is whole, remove the journal.",
            name, path));
      apply(changes, descriptor, path);
    } catch (...) {
      ::close(descriptor);
      throw;
    }
    ::close(descriptor);
  }
  remove_journal(path);
}

void read_between_commits(const std::string& path, const std::function<void()>& read)
{
  std::string half_head;  // of the commit that stands in its middle
  auto half_since = std::chrono::steady_clock::now();
  for (;; ::usleep(a_moment)) {
    const std::string head = bytes_at(path, 0, head_size);
    if (is_half_changed(path, head)) {
      if (half_head != head) half_head = head, half_since = std::chrono::steady_clock::now();
      if (std::chrono::steady_clock::now() - half_since < patience) continue;
      throw FileError(fmt::format(
          "cannot read {}: its run was killed while it added a frame\n  `terp resume` ends that, and goes on.", path));
    }
    try {
      read();
      if (bytes_at(path, 0, head_size) == head) return;
    } catch (const FileError&) {
      if (bytes_at(path, 0, head_size) == head) throw;
    }
  }
}

}  // namespace terp
