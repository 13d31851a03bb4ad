#include "os/files.hpp"
#include "support/environment.hpp"
#include "support/process.hpp"

#include <cerrno>

namespace files_test {

TEST(OpenToWrite, ReplacesOrContinuesOrFindsAFile)
{
  const ScratchFolder scratch;
  const std::string path = scratch.path() + "/a";
  EXPECT_EQ(open_to_write(path, OpenAs::there_already), -1);
  EXPECT_EQ(errno, ENOENT);
  int file = open_to_write(path, OpenAs::new_file);
  EXPECT_EQ(write_all(file, "one"), 0);
  EXPECT_EQ(close_file(file), 0);
  file = open_to_write(path, OpenAs::end_of_file);
  EXPECT_EQ(write_all(file, "two"), 0);
  EXPECT_EQ(size_of(file), 6);
  EXPECT_EQ(close_file(file), 0);
  EXPECT_EQ(text_of(path), "onetwo");
  EXPECT_EQ(close_file(open_to_write(path, OpenAs::new_file)), 0);
  EXPECT_EQ(text_of(path), "");
}

TEST(Resize, AndReserveMakeAFileLongerAndShorter)
{
  const ScratchFolder scratch;
  const int file = open_to_write(scratch.path() + "/a", OpenAs::new_file);
  EXPECT_EQ(write_all(file, "abc"), 0);
  EXPECT_EQ(reserve(file, 10), 0);
  EXPECT_EQ(size_of(file), 13);
  EXPECT_EQ(resize(file, 2), 0);
  EXPECT_EQ(size_of(file), 2);
  EXPECT_EQ(close_file(file), 0);
  EXPECT_EQ(text_of(scratch.path() + "/a"), "ab");
}

TEST(CacheFolder, LiesWhereTheVariablesSay)
{
  const Variable cache("XDG_CACHE_HOME", "/somewhere/cache"), home("HOME", "/home/someone");
  EXPECT_EQ(cache_folder(), "/somewhere/cache");
  const Variable relative("XDG_CACHE_HOME", "not/absolute");
  EXPECT_EQ(cache_folder(), "/home/someone/.cache");
  const Variable nowhere("HOME", "");
  EXPECT_EQ(cache_folder(), "");
}

TEST(ReplaceFile, TakesThePlaceOfAnotherFile)
{
  const ScratchFolder scratch;
  const std::string a = scratch.path() + "/a", b = scratch.path() + "/b";
  std::ofstream(a) << "new";
  std::ofstream(b) << "old";
  EXPECT_EQ(wait_for_disk(a), 0);
  EXPECT_EQ(replace_file(a, b), 0);
  EXPECT_EQ(text_of(b), "new");
  EXPECT_FALSE(std::filesystem::exists(a));
  EXPECT_EQ(replace_file(a, b), ENOENT);
}

TEST(IsAbsolute, SaysWhetherAPathLeadsThereFromAnyFolder)
{
  EXPECT_TRUE(is_absolute("/a/b"));
  EXPECT_FALSE(is_absolute("a/b"));
  EXPECT_FALSE(is_absolute("../a"));
  EXPECT_FALSE(is_absolute(""));
}

TEST(MakeUniqueFolder, MakesAnotherEachTime)
{
  const ScratchFolder scratch;
  const std::string first = make_unique_folder(scratch.path() + "/x-"),
                    second = make_unique_folder(scratch.path() + "/x-");
  EXPECT_NE(first, second);
  EXPECT_THAT(first, testing::StartsWith(scratch.path() + "/x-"));
  EXPECT_TRUE(std::filesystem::is_directory(first) && std::filesystem::is_directory(second));
  EXPECT_EQ(make_unique_folder(scratch.path() + "/none/x-"), "");
}

}  // namespace files_test
