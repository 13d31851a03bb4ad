#include "io/files/files.hpp"
#include "io/files/samples.hpp"
#include "io/files/small_disk.hpp"
#include "support/scratch.hpp"

namespace files_test {

using Files = ScratchTest;

TEST_F(Files, AnAtomicWriteReplacesTheContentAndLeavesNoTemporaryFile)
{
  const std::string path = folder + "/a.txt";
  write_file_atomically(path, "old and long");
  write_file_atomically(path, "new");
  EXPECT_EQ(read_file(path), "new");
  EXPECT_FALSE(std::filesystem::exists(temporary_name(path)));
}

TEST_F(Files, AFolderThatIsAFileIsNamedWithTheReason)
{
  const std::string path = folder + "/file/a.txt";
  write_file_atomically(folder + "/file", "");
  EXPECT_EQ(file_error_of([&] { write_file_atomically(path, "x"); }), "cannot write " + path + ": Not a directory");
}

TEST_F(Files, AppendingToAFullDeviceSaysSo)
{
  AppendFile file("/dev/full");
  EXPECT_EQ(file_error_of([&] { file.append("x\n"); }), "cannot write /dev/full: No space left on device");
}

TEST_F(Files, AFullDiskLeavesTheOldContentWhole)
{
  const SmallDisk disk(64 << 10);
  if (!disk.is_there()) GTEST_SKIP() << "cannot mount a small disk";
  AppendFile file(disk.path() + "/rows.csv");
  file.append("first\n");
  write_file_atomically(disk.path() + "/summary.json", "{}\n");
  disk.fill();
  const std::string long_text(100000, 'y');
  EXPECT_THAT(file_error_of([&] { file.append(long_text); }), HasSubstr("No space left on device"));
  EXPECT_THAT(file_error_of([&] { write_file_atomically(disk.path() + "/summary.json", long_text); }),
      HasSubstr("No space left on device"));
  EXPECT_EQ(read_file(disk.path() + "/rows.csv"), "first\n");
  EXPECT_EQ(read_file(disk.path() + "/summary.json"), "{}\n");
  EXPECT_FALSE(std::filesystem::exists(disk.path() + "/summary.json.tmp"));
}

TEST_F(Files, ReservedSpaceMakesTheFileLongerAndKeepsItsContent)
{
  const std::string path = folder + "/a";
  write_file_atomically(path, "abc");
  reserve_space(path, 10000);
  EXPECT_EQ(std::filesystem::file_size(path), 10003u);
  EXPECT_EQ(read_file(path).substr(0, 3), "abc");
}

TEST_F(Files, ReservingMoreThanThereIsLeavesTheFileAsItWas)
{
  const SmallDisk disk(64 << 10);
  if (!disk.is_there()) GTEST_SKIP() << "cannot mount a small disk";
  const std::string path = disk.path() + "/a";
  write_file_atomically(path, "abc");
  EXPECT_EQ(file_error_of([&] { reserve_space(path, 1 << 20); }), "cannot write " + path + ": No space left on device");
  EXPECT_EQ(read_file(path), "abc");
}

TEST_F(Files, ATemporaryFileThatIsNotMovedLeavesNothingBehind)
{
  {
    const TemporaryFile file(folder + "/a");
    write_file_atomically(file.name(), "half");
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace files_test
