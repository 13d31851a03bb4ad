// A file that changes as a whole or not at all.
#include "output/committed_file.hpp"

#include "base/errors.hpp"
#include "output/checksum.hpp"
#include "output/files.hpp"
#include "output/samples.hpp"
#include "output/small_disk.hpp"

#include <chrono>
#include <filesystem>
#include <future>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

namespace terp {
namespace {

constexpr std::int64_t page = CommittedFile::page_size;

/// A file of n_bytes of 'a'.
std::string make_file(const test::ScratchFolder& scratch, std::int64_t n_bytes)
{
  const std::string path = scratch.path() + "/results";
  write_file_atomically(path, std::string(static_cast<std::size_t>(n_bytes), 'a'));
  return path;
}

void write(CommittedFile& file, std::int64_t at, const std::string& text)
{
  file.write(at, std::ssize(text), reinterpret_cast<const unsigned char*>(text.data()));
}

std::string read(const CommittedFile& file, std::int64_t at, std::int64_t n_bytes)
{
  std::string text(static_cast<std::size_t>(n_bytes), '?');
  file.read(at, n_bytes, reinterpret_cast<unsigned char*>(text.data()));
  return text;
}

std::string number(std::int64_t value) { return {reinterpret_cast<const char*>(&value), sizeof value}; }

/// What a process leaves that dies in the middle of a commit: page k becomes `content`, the file three pages long.
std::string journal(const std::string& head = std::string(64, 'a'), std::int64_t k = 1,
    const std::string& content = std::string(page, 'b'))
{
  std::string text = "terpjnl2" + number(3 * page) + head + number(k) + content;
  Fnv1a hash;
  hash.add(text.data(), text.size());
  return text + number(static_cast<std::int64_t>(hash.value()));
}

TEST(CommittedFile, KeepsItsContentUntilTheCommit)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 2 * page + 10), before = read_file(path);
  CommittedFile file(path);
  file.start_changes(2 * page + 10, 0);
  write(file, page - 2, "bbbb");      // across two pages
  write(file, 2 * page + 8, "cccc");  // across the end
  write(file, 3 * page + 5, "dddd");  // beyond the last page
  EXPECT_EQ(read_file(path).substr(0, before.size()), before);
  EXPECT_EQ(read(file, page - 3, 6), "abbbba");
  EXPECT_EQ(read(file, 2 * page + 7, 6), std::string("acccc\0", 6));
  EXPECT_EQ(read(file, 3 * page + 4, 5), std::string("\0dddd", 5));
  file.commit(3 * page + 9);
  std::string after = before + std::string(static_cast<std::size_t>(page - 1), '\0');
  after.replace(page - 2, 4, "bbbb").replace(2 * page + 8, 4, "cccc").replace(3 * page + 5, 4, "dddd");
  EXPECT_EQ(read_file(path), after);
  EXPECT_FALSE(std::filesystem::exists(journal_name(path)));
}

TEST(CommittedFile, WithoutACommitIsAsItWas)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 100), before = read_file(path);
  {
    CommittedFile file(path);
    file.start_changes(100, 2 * page);
    write(file, 0, "bbbb");
    write(file, 100, std::string(3 * page, 'c'));
  }
  EXPECT_EQ(read_file(path), before);
}

TEST(CommittedFile, DropsATailThatNothingRefersTo)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 3 * page);
  CommittedFile file(path);
  file.start_changes(100, 0);
  write(file, 200, "b");
  file.commit(201);
  EXPECT_EQ(read_file(path), std::string(100, 'a') + std::string(100, '\0') + "b");
}

TEST(CommittedFile, MayBecomeShorter)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 3 * page);
  CommittedFile file(path);
  file.start_changes(3 * page, 0);
  write(file, 10, "b");
  file.commit(20);
  EXPECT_EQ(read_file(path), "aaaaaaaaaabaaaaaaaaa");
}

TEST(CommittedFile, ACommitThatWasCutShortIsFinished)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 4 * page);
  write_file_atomically(journal_name(path), journal());
  finish_commit(path);
  EXPECT_EQ(read_file(path), std::string(page, 'a') + std::string(page, 'b') + std::string(page, 'a'));
  EXPECT_FALSE(std::filesystem::exists(journal_name(path)));
}

TEST(CommittedFile, AJournalOfAnotherFileIsRefusedAndNothingChanges)
{
  const test::ScratchFolder scratch;
  for (const std::int64_t size :
      {4 * page, 3 * page - 1, std::int64_t{0}}) {  // another content, what was new is missing, nothing there
    const std::string path = make_file(scratch, size), before = read_file(path);
    write_file_atomically(journal_name(path), journal(std::string(64, size == 4 * page ? 'z' : 'a')));
    EXPECT_THAT(
        test::file_error_of([&] { finish_commit(path); }), testing::HasSubstr("results.journal is of another " + path));
    EXPECT_EQ(read_file(path), before);
    EXPECT_TRUE(std::filesystem::exists(journal_name(path)));
  }
}

TEST(CommittedFile, AJournalThatIsNotWholeIsRemovedAndNothingElse)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 4 * page), whole = journal();
  for (std::size_t n = 0; n < whole.size(); n += n < 40 || n + 40 > whole.size() ? 1 : 100) {
    write_file_atomically(journal_name(path), whole.substr(0, n));
    finish_commit(path);
    EXPECT_EQ(read_file(path), std::string(4 * page, 'a')) << n;
    EXPECT_FALSE(std::filesystem::exists(journal_name(path))) << n;
  }
  std::string altered = whole;
  altered[50] ^= 1;
  write_file_atomically(journal_name(path), altered);
  finish_commit(path);
  EXPECT_EQ(read_file(path), std::string(4 * page, 'a'));
}

/// Another process adds to a file and changes its first byte.
void commit(const std::string& path, char first)
{
  CommittedFile file(path);
  const std::int64_t size = file.size();
  file.start_changes(size, 0);
  write(file, 0, std::string(1, first));
  write(file, size, "new");
  file.commit(size + 3);
}

TEST(ReadingBetweenCommits, IsRepeatedIfOneCameIntoIt)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 2 * page);
  std::vector<std::size_t> sizes;
  read_between_commits(path, [&] {
    const std::string before = read_file(path);
    if (sizes.size() < 2) commit(path, sizes.empty() ? 'b' : 'c');
    sizes.push_back(before.size());
  });
  EXPECT_THAT(sizes, testing::ElementsAre(2 * page, 2 * page + 3, 2 * page + 6));
}

TEST(ReadingBetweenCommits, AnErrorCountsIfNoCommitCameIntoIt)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 2 * page);
  int n = 0;
  const auto fail = [&] {
    if (++n == 1) commit(path, 'b');
    throw FileError("reading " + std::to_string(n));
  };
  EXPECT_EQ(test::file_error_of([&] { read_between_commits(path, fail); }), "reading 2");
  EXPECT_EQ(test::file_error_of([&] { read_between_commits(path, fail); }), "reading 3");
  EXPECT_EQ(test::file_error_of([&] { read_between_commits(scratch.path() + "/none", fail); }), "reading 4");
}

/// The journal of a commit that has written the first page, with its head of 'a', and not the rest.
std::string half_written()
{
  return journal(std::string(64, 'z'), 0, std::string(64, 'a') + std::string(page - 64, 'b'));
}

TEST(ReadingBetweenCommits, WaitsWhileThePagesAreWritten)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 4 * page);
  write_file_atomically(journal_name(path), half_written());
  const auto writer = std::async(std::launch::async, [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    finish_commit(path);
  });
  std::string text;
  read_between_commits(path, [&] { text = read_file(path); });
  EXPECT_EQ(text, std::string(64, 'a') + std::string(page - 64, 'b') + std::string(2 * page, 'a'));
}

TEST(ReadingBetweenCommits, WaitsHoweverLongItHasReadBefore)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 4 * page);
  commit(path, 'b');
  std::future<void> writer;
  int n = 0;
  read_between_commits(path, [&] {
    if (++n > 1) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    write_file_atomically(path, std::string(4 * page, 'a'));
    write_file_atomically(journal_name(path), half_written());
    writer = std::async(std::launch::async, [&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      finish_commit(path);
    });
  });
  EXPECT_EQ(n, 2);
}

TEST(ReadingBetweenCommits, AWriterThatWasKilledHalfWayIsAnError)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 4 * page);
  write_file_atomically(journal_name(path), half_written());
  EXPECT_EQ(test::file_error_of([&] { read_between_commits(path, [] {}); }),
      "cannot read " + path + ": its run was killed while it added a frame\n  `terp resume` ends that, and goes on.");
}

TEST(ReadingBetweenCommits, DoesNotWaitForAJournalThatChangesNothing)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch, 4 * page), not_whole = half_written().substr(0, 200);
  const std::string not_begun = journal(), of_another_file = journal(std::string(64, 'z')),
                    all_written = journal(std::string(64, 'z'), 0, std::string(page, 'a'));
  for (const std::string& left : {not_whole, not_begun, of_another_file, all_written}) {
    write_file_atomically(journal_name(path), left);
    int n = 0;
    read_between_commits(path, [&] { ++n; });
    EXPECT_EQ(n, 1);
  }
}

TEST(CommittedFile, OnAFullDiskStaysAsItWas)
{
  const test::SmallDisk disk(64 << 10);
  if (!disk.is_there()) GTEST_SKIP() << "cannot mount a small disk";
  const std::string path = disk.path() + "/results";
  write_file_atomically(path, std::string(3 * page, 'a'));
  CommittedFile file(path);
  file.start_changes(3 * page, 0);
  write(file, 10, "b");
  disk.fill();
  EXPECT_THAT(test::file_error_of([&] { file.commit(3 * page); }),
      testing::HasSubstr("results.journal: No space left on device"));
  EXPECT_EQ(read_file(path), std::string(3 * page, 'a'));
  EXPECT_FALSE(std::filesystem::exists(journal_name(path)));
}

}  // namespace
}  // namespace terp
