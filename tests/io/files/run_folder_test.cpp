#include "io/files/run_folder.hpp"
#include "io/files/files.hpp"
#include "io/files/samples.hpp"
#include "support/process.hpp"
#include "support/scratch.hpp"

namespace run_folder_test {

using RunFolder = ScratchTest;

TEST_F(RunFolder, IsMadeWithTheFoldersAboveIt)
{
  prepare_run_folder(folder + "/runs/model_2", false);
  EXPECT_TRUE(std::filesystem::is_directory(folder + "/runs/model_2"));
}

TEST_F(RunFolder, ForceRemovesTheFilesOfARunAndNoOthers)
{
  std::filesystem::create_directory(folder + "/frames");
  for (const char* name : {"case.toml", "results.vtkhdf.series", "mesh.vtkhdf", "history.csv", "ledger.csv",
           "summary.json", "summary.json.tmp", "checkpoint_000000100.h5", "checkpoint_1234567890.h5",
           "failed_000000200.h5", "mesh.msh", "points_12.csv", "values_3.csv", "imported.toml",
           "frames/points_00000.vtkhdf", "frames/mesh_00001.vtkhdf.tmp"}) {
    write_file_atomically(path_in(folder, name), "old");
  }
  const std::vector<std::string> foreign = {"notes.txt", "checkpoint_mine.h5", "checkpoint_.h5", "points_.csv",
      "points_a.csv", "values_a.csv", "my_history.csv"};
  for (const auto& name : foreign) write_file_atomically(path_in(folder, name), "mine");
  std::filesystem::create_directory(folder + "/case.toml.d");
  prepare_run_folder(folder, true);
  auto left = foreign;
  left.push_back("case.toml.d");
  EXPECT_THAT(names_in(folder), testing::UnorderedElementsAreArray(left));
}

TEST_F(RunFolder, ForceKeepsAFolderOfFramesThatHoldsAnythingElse)
{
  std::filesystem::create_directory(folder + "/frames");
  for (const char* name : {"frames/points_00000.vtkhdf", "frames/notes.txt"})
    write_file_atomically(path_in(folder, name), "");
  prepare_run_folder(folder, true);
  EXPECT_THAT(names_in(folder + "/frames"), ElementsAre("notes.txt"));
}

TEST_F(RunFolder, HoldsCopiesOfTheFilesThatTheCaseNamesEvenIfTheyAreThoseOfTheRunBefore)
{
  write_file_atomically(folder + "/mesh.msh", "nodes");
  prepare_run_folder(folder, true, {{folder + "/mesh.msh", "mesh.msh"}});
  EXPECT_EQ(read_file(folder + "/mesh.msh"), "nodes");
  const std::string missing = folder + "/none.csv";
  EXPECT_THAT(file_error_of([&] {
    prepare_run_folder(folder, true, {{missing, "points_1.csv"}});
  }),
      HasSubstr("cannot read " + missing));
  EXPECT_EQ(read_file(folder + "/mesh.msh"), "nodes");
}

TEST_F(RunFolder, ForceFollowsNoLinkAndEntersNoFolder)
{
  const ScratchFolder elsewhere;
  write_file_atomically(elsewhere.path() + "/precious.csv", "mine");
  std::filesystem::create_symlink(elsewhere.path() + "/precious.csv", folder + "/history.csv");
  std::filesystem::create_directory(folder + "/summary.json");
  write_file_atomically(folder + "/summary.json/case.toml", "mine");
  prepare_run_folder(folder, true);
  EXPECT_TRUE(std::filesystem::exists(elsewhere.path() + "/precious.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/summary.json/case.toml"));
}

TEST_F(RunFolder, BelowAFileIsRefusedWithTheReason)
{
  write_file_atomically(folder + "/file", "");
  EXPECT_EQ(file_error_of([&] { prepare_run_folder(folder + "/file/sub", true); }),
      "cannot make the run folder " + folder + "/file/sub: Not a directory");
}

TEST_F(RunFolder, InUseByAnotherTerpIsNotTouched)
{
  write_file_atomically(folder + "/ledger.csv", "rows");
  const FolderLock other(folder);
  EXPECT_EQ(
      file_error_of([&] { prepare_run_folder(folder, true); }), "another terp is writing to the run folder " + folder);
  EXPECT_TRUE(std::filesystem::exists(folder + "/ledger.csv"));
}

TEST_F(RunFolder, KnowsTheStepInACheckpointsName)
{
  EXPECT_EQ(checkpoint_file(123), "checkpoint_000000123.h5");
  EXPECT_EQ(step_of_checkpoint(checkpoint_file(12345678901)), 12345678901);
  EXPECT_EQ(step_of_checkpoint("checkpoint_000000123.h5.tmp"), -1);
  EXPECT_EQ(step_of_checkpoint("failed_000000123.h5"), -1);
  EXPECT_EQ(step_of_checkpoint("checkpoint_-1.h5"), -1);
}

}  // namespace run_folder_test
