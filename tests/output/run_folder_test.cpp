// The folder of a run, and what becomes of what is already in it.
#include "output/run_folder.hpp"
#include "output/files.hpp"
#include "output/samples.hpp"
#include "support/paths.hpp"
#include "support/test.hpp"

namespace run_folder_test {

std::vector<std::string> files_in(const std::string& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  return names;
}

TEST(RunFolder, IsMadeWithTheFoldersAboveIt)
{
  const ScratchFolder scratch;
  prepare_run_folder(scratch.path() + "/runs/model_2", false);
  EXPECT_TRUE(std::filesystem::is_directory(scratch.path() + "/runs/model_2"));
}

TEST(RunFolder, ThatHoldsAnythingIsRefusedWithThreeWaysOut)
{
  const ScratchFolder scratch;
  write_file_atomically(scratch.path() + "/notes.txt", "mine");
  EXPECT_THAT(file_error_of([&] { prepare_run_folder(scratch.path(), false); }),
      AllOf(HasSubstr("the run folder " + scratch.path() + " is not empty"), HasSubstr("--force"), HasSubstr("-o DIR"),
          HasSubstr("`terp resume " + scratch.path() + "`")));
}

TEST(RunFolder, ForceRemovesTheFilesOfARunAndNoOthers)
{
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch.path() + "/frames");
  for (const char* name : {"case.toml", "results.vtkhdf.series", "mesh.vtkhdf", "history.csv", "ledger.csv",
           "summary.json", "summary.json.tmp", "checkpoint_000000100.h5", "checkpoint_1234567890.h5",
           "failed_000000200.h5", "mesh.msh", "points_12.csv", "values_3.csv", "imported.toml",
           "frames/points_00000.vtkhdf", "frames/mesh_00001.vtkhdf.tmp"}) {
    write_file_atomically(path_in(scratch.path(), name), "old");
  }
  const std::vector<std::string> foreign = {"notes.txt", "checkpoint_mine.h5", "checkpoint_.h5", "points_.csv",
      "points_a.csv", "values_a.csv", "my_history.csv"};
  for (const auto& name : foreign) write_file_atomically(path_in(scratch.path(), name), "mine");
  std::filesystem::create_directory(scratch.path() + "/case.toml.d");
  prepare_run_folder(scratch.path(), true);
  auto left = foreign;
  left.push_back("case.toml.d");
  EXPECT_THAT(files_in(scratch.path()), testing::UnorderedElementsAreArray(left));
}

TEST(RunFolder, ForceKeepsAFolderOfFramesThatHoldsAnythingElse)
{
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch.path() + "/frames");
  for (const char* name : {"frames/points_00000.vtkhdf", "frames/notes.txt"})
    write_file_atomically(path_in(scratch.path(), name), "");
  prepare_run_folder(scratch.path(), true);
  EXPECT_THAT(files_in(scratch.path() + "/frames"), ElementsAre("notes.txt"));
}

TEST(RunFolder, HoldsCopiesOfTheFilesThatTheCaseNamesEvenIfTheyAreThoseOfTheRunBefore)
{
  const ScratchFolder scratch;
  write_file_atomically(scratch.path() + "/mesh.msh", "nodes");
  prepare_run_folder(scratch.path(), true, {{scratch.path() + "/mesh.msh", "mesh.msh"}});
  EXPECT_EQ(read_file(scratch.path() + "/mesh.msh"), "nodes");
  const std::string missing = scratch.path() + "/none.csv";
  EXPECT_THAT(file_error_of([&] {
    prepare_run_folder(scratch.path(), true, {{missing, "points_1.csv"}});
  }),
      HasSubstr("cannot read " + missing));
  EXPECT_EQ(read_file(scratch.path() + "/mesh.msh"), "nodes");
}

TEST(RunFolder, ForceFollowsNoLinkAndEntersNoFolder)
{
  const ScratchFolder scratch, elsewhere;
  write_file_atomically(elsewhere.path() + "/precious.csv", "mine");
  std::filesystem::create_symlink(elsewhere.path() + "/precious.csv", scratch.path() + "/history.csv");
  std::filesystem::create_directory(scratch.path() + "/summary.json");
  write_file_atomically(scratch.path() + "/summary.json/case.toml", "mine");
  prepare_run_folder(scratch.path(), true);
  EXPECT_TRUE(std::filesystem::exists(elsewhere.path() + "/precious.csv"));
  EXPECT_TRUE(std::filesystem::exists(scratch.path() + "/summary.json/case.toml"));
}

TEST(RunFolder, BelowAFileIsRefusedWithTheReason)
{
  const ScratchFolder scratch;
  write_file_atomically(scratch.path() + "/file", "");
  const std::string folder = scratch.path() + "/file/sub";
  EXPECT_EQ(file_error_of([&] { prepare_run_folder(folder, true); }),
      "cannot make the run folder " + folder + ": Not a directory");
}

TEST(RunFolder, InUseByAnotherTerpIsNotTouched)
{
  const ScratchFolder scratch;
  write_file_atomically(scratch.path() + "/ledger.csv", "rows");
  const FolderLock other(scratch.path());
  EXPECT_EQ(file_error_of([&] { prepare_run_folder(scratch.path(), true); }),
      "another terp is writing to the run folder " + scratch.path());
  EXPECT_TRUE(std::filesystem::exists(scratch.path() + "/ledger.csv"));
}

TEST(RunFolder, KnowsTheStepInACheckpointsName)
{
  EXPECT_EQ(checkpoint_file(123), "checkpoint_000000123.h5");
  EXPECT_EQ(step_of_checkpoint(checkpoint_file(12345678901)), 12345678901);
  EXPECT_EQ(step_of_checkpoint("checkpoint_000000123.h5.tmp"), -1);
  EXPECT_EQ(step_of_checkpoint("failed_000000123.h5"), -1);
  EXPECT_EQ(step_of_checkpoint("checkpoint_-1.h5"), -1);
}

}  // namespace run_folder_test
