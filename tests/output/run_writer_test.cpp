// The files of a whole run, and of one that was resumed.
#include "output/run_writer.hpp"
#include "output/checkpoint.hpp"
#include "output/mesh_file.hpp"
#include "output/samples.hpp"
#include "output/small_disk.hpp"
#include "output/table_csv.hpp"
#include "followers/followers.hpp"
#include "support/process.hpp"
#include "support/paths.hpp"
#include "support/test.hpp"

namespace run_writer_test {

RunWriterSettings settings_for(const std::string& folder)
{
  return {folder, {"model_2", "title = \"column\"\n"}, 2, "material.clay.eta = 50\n", {}, all_tables()};
}

/// A run in a folder that goes on from a step of its files.
std::unique_ptr<RunWriter> resume_in(const std::string& folder, const ResumePoint& from)
{
  return RunWriter::resume(settings_for(folder), FolderLock(folder), from);
}

/// Names and bytes of all files below a folder.
std::map<std::string, std::string> all_files_in(const std::string& folder)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).string()] = read_file(entry.path().string());
  return files;
}

/// What a run shows at output k: rows, frame, then the checkpoint of step 100 k at time 0.1 k.
void write_outputs(RunWriter& writer, int first, int last)
{
  for (int k = first; k <= last; ++k) {
    StateImage image = sample_image(100 * k);
    image.time = 0.1 * k;
    writer.rows(sample_history(0.1 * k));
    writer.rows(sample_ledger(0.1 * k));
    writer.frame(std::make_shared<const Frame>(sample_frame(k)));
    writer.checkpoint(std::make_shared<const StateImage>(image));
  }
  writer.finish();
}

/// Where the checkpoint of step 200 has a run go on.
ResumePoint point_200(const std::string& folder)
{
  return {.step = 200,
      .time = 0.2,
      .n_frames = 3,
      .n_rows = {{"history", 6}, {"ledger", 3}},
      .tables = read_checkpoint(path_in(folder, checkpoint_file(200))).tables};
}

TEST(RunWriter, ANewRunHasItsCaseAndTheHeadersOfItsTables)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/runs/model_2";
  RunWriter::start(settings_for(folder), false);
  EXPECT_EQ(read_file(folder + "/case.toml"), "title = \"column\"\n");
  EXPECT_EQ(read_file(folder + "/history.csv"), header_of(*history_table()) + "\n");
  EXPECT_EQ(read_file(folder + "/ledger.csv"), header_of(*sample_ledger_table()) + "\n");
}

TEST(RunWriter, ARowIsInTheFileOnceTheWriterHasFinished)
{
  const ScratchFolder scratch;
  const auto writer = RunWriter::start(settings_for(scratch.path()), false);
  writer->rows(sample_ledger(0.5));
  writer->finish();
  EXPECT_THAT(read_file(scratch.path() + "/ledger.csv"), EndsWith(csv_lines(sample_ledger(0.5))));
}

TEST(RunWriter, KeepsAsManyCheckpointsAsAsked)
{
  const ScratchFolder scratch;
  write_outputs(*RunWriter::start(settings_for(scratch.path()), false), 0, 3);
  EXPECT_FALSE(std::filesystem::exists(path_in(scratch.path(), checkpoint_file(100))));
  EXPECT_TRUE(std::filesystem::exists(path_in(scratch.path(), checkpoint_file(200))));
  EXPECT_TRUE(std::filesystem::exists(path_in(scratch.path(), checkpoint_file(300))));
}

TEST(RunWriter, AResumedRunEndsInTheSameTablesAsOneInOneGo)
{
  const ScratchFolder one_go, resumed;
  write_outputs(*RunWriter::start(settings_for(one_go.path()), false), 0, 5);
  write_outputs(*RunWriter::start(settings_for(resumed.path()), false), 0, 4);
  std::filesystem::remove(path_in(resumed.path(), checkpoint_file(400)));
  const StateImage image = newest_good_checkpoint(resumed.path()).image.value();
  write_outputs(
      *resume_in(resumed.path(), {.step = image.step, .time = image.time, .n_frames = 4, .tables = image.tables}), 4,
      5);
  EXPECT_EQ(all_files_in(resumed.path()), all_files_in(one_go.path()));
}

TEST(RunWriter, ResumingDropsTheCheckpointsOfTheAbandonedSteps)
{
  const ScratchFolder scratch;
  write_outputs(*RunWriter::start(settings_for(scratch.path()), false), 0, 3);
  resume_in(scratch.path(), point_200(scratch.path()));
  EXPECT_EQ(newest_good_checkpoint(scratch.path()).image->step, 200);
}

TEST(RunWriter, DoesNotResumeWhereAFileIsMissingOrTooShort)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path();
  write_outputs(*RunWriter::start(settings_for(folder), false), 0, 3);
  const ResumePoint from = point_200(folder);
  const std::string ledger = read_file(folder + "/ledger.csv"),
                    head = "cannot resume from step 200, t = 0.2 s, without all of " + folder;
  const std::string advice =
      "\n  Put the file back, resume from an earlier checkpoint, or start the case anew: terp run " + folder +
      "/case.toml -o NEW_FOLDER";

  ResumePoint more = from;
  more.n_rows["history"] = 7;
  EXPECT_EQ(file_error_of([&] { resume_in(folder, more); }),
      head + "/history.csv: it holds 6 rows up to there, 7 are due" + advice);
  more = from;
  more.n_rows["left_the_mesh"] = 1;
  EXPECT_EQ(file_error_of([&] { resume_in(folder, more); }), head + "/left_the_mesh.csv: it is missing" + advice);
  std::filesystem::remove(folder + "/history.csv");
  EXPECT_EQ(file_error_of([&] { resume_in(folder, from); }), head + "/history.csv: it is missing" + advice);
  EXPECT_EQ(read_file(folder + "/ledger.csv"), ledger);
  EXPECT_EQ(newest_good_checkpoint(folder).image->step, 300);
}

TEST(RunWriter, FilesOfAnotherRunAreRefusedAndNothingChanges)
{
  const ScratchFolder scratch;
  const std::string ours = scratch.path() + "/ours", theirs = scratch.path() + "/theirs";
  RunWriterSettings other = settings_for(theirs);
  other.case_record = "material.clay.eta = 60\n";
  write_outputs(*RunWriter::start(settings_for(ours), false), 0, 3);
  write_outputs(*RunWriter::start(std::move(other), false), 0, 3);
  write_file_atomically(theirs + "/ledger.csv", header_of(*sample_ledger_table()) + '\n' +
                                                    csv_lines(sample_ledger(0.0)) + csv_lines(sample_ledger(0.05)) +
                                                    csv_lines(sample_ledger(0.2)));
  write_file_atomically(theirs + "/history.csv", header_of(*history_table()) + '\n' + csv_lines(sample_history(0.0)) +
                                                     csv_lines(sample_history(0.05)) + csv_lines(sample_history(0.2)));
  const ResumePoint from = point_200(ours);
  for (const std::string name : {"frames/points_00001.vtkhdf", "ledger.csv", "history.csv"}) {
    const std::string aside = scratch.path() + "/aside", path = path_in(ours, name);
    std::filesystem::copy_file(path, aside);
    std::filesystem::copy_file(path_in(theirs, name), path, std::filesystem::copy_options::overwrite_existing);
    const auto before = all_files_in(ours);
    EXPECT_THAT(file_error_of([&] { resume_in(ours, from); }),
        AllOf(StartsWith("cannot resume from step 200, t = 0.2 s: " + path + " is "), HasSubstr("of another "),
            HasSubstr("\n  Put a copy of it back, or start the case anew: terp run " + ours +
                      "/case.toml -o NEW_FOLDER\n  Nothing was changed")));
    EXPECT_EQ(all_files_in(ours), before) << name;
    std::filesystem::rename(aside, path);
  }
  write_file_atomically(ours + "/left_the_mesh.csv", header_of(*table_named("left_the_mesh")) + "\n0.05,3,1,2,3,4,5\n");
  EXPECT_THAT(file_error_of([&] { resume_in(ours, from); }), HasSubstr("left_the_mesh.csv is not what this run wrote"));
  std::filesystem::remove(ours + "/left_the_mesh.csv");
  EXPECT_TRUE(resume_in(ours, from)->warnings().empty());
}

TEST(RunWriter, GoesOnWithoutFramesThatAreMissingOrDamagedAndNamesThem)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path(), mesh = folder + "/mesh.vtkhdf";
  write_outputs(*RunWriter::start(settings_for(folder), false), 0, 3);
  write_mesh(mesh, make_rectangle({0.0, 0.0}, {4.0, 1.0}, {2, 1}), digits_of(settings_for(folder).case_record));
  std::filesystem::remove(folder + "/frames/points_00000.vtkhdf");
  for (const std::string& path : {folder + "/frames/points_00001.vtkhdf", mesh}) {
    std::string bytes = read_file(path);
    bytes.resize(bytes.size() / 2);
    write_file_atomically(path, bytes);
  }
  const auto writer = resume_in(folder, point_200(folder));
  EXPECT_THAT(writer->warnings(),
      ElementsAre(HasSubstr("points_00000.vtkhdf is missing"), HasSubstr("points_00001.vtkhdf is damaged"),
          HasSubstr("mesh.vtkhdf is damaged; it is written again")));
  EXPECT_FALSE(std::filesystem::exists(mesh));
  EXPECT_FALSE(std::filesystem::exists(folder + "/frames/points_00003.vtkhdf"));
  write_outputs(*writer, 3, 3);
  EXPECT_EQ(read_head(Hdf5File(folder + "/frames/points_00003.vtkhdf", Hdf5File::Mode::read)).step, 300);
}

TEST(RunWriter, ForceReplacesTheEarlierRun)
{
  const ScratchFolder scratch;
  write_outputs(*RunWriter::start(settings_for(scratch.path()), false), 0, 2);
  EXPECT_THAT(file_error_of([&] { RunWriter::start(settings_for(scratch.path()), false); }), HasSubstr("--force"));
  write_outputs(*RunWriter::start(settings_for(scratch.path()), true), 0, 0);
  EXPECT_THAT(list_frames(scratch.path(), point_frames), ElementsAre(0));
  EXPECT_EQ(newest_good_checkpoint(scratch.path()).image->step, 0);
}

TEST(RunWriter, TwoAtOnceInOneFolderAreRefused)
{
  const ScratchFolder scratch;
  const auto writer = RunWriter::start(settings_for(scratch.path()), false);
  EXPECT_THAT(file_error_of([&] { RunWriter::start(settings_for(scratch.path()), true); }), HasSubstr("another terp"));
  EXPECT_THAT(file_error_of([&] { resume_in(scratch.path(), {}); }), HasSubstr("another terp"));
}

TEST(RunWriter, AFailedStateIsKeptBesideTheCheckpoints)
{
  const ScratchFolder scratch;
  const auto writer = RunWriter::start(settings_for(scratch.path()), false);
  const std::string path = writer->write_failed(sample_image(104));
  EXPECT_EQ(path, scratch.path() + "/failed_000000104.h5");
  EXPECT_EQ(read_checkpoint(path).step, 104);
  EXPECT_FALSE(newest_good_checkpoint(scratch.path()).image);
}

TEST(RunWriter, AFailedStateThatCannotBeKeptSaysWhy)
{
  const ScratchFolder scratch;
  const auto writer = RunWriter::start(settings_for(scratch.path() + "/run"), false);
  EXPECT_EQ(writer->save_failed(sample_image(104)), scratch.path() + "/run/failed_000000104.h5");
  std::filesystem::remove_all(scratch.path() + "/run");
  EXPECT_THAT(writer->save_failed(sample_image(105)), StartsWith("nothing: cannot write " + scratch.path()));
}

TEST(RunWriter, ARunResumedAtItsStartShowsTheStartOnce)
{
  const ScratchFolder scratch;
  write_outputs(*RunWriter::start(settings_for(scratch.path()), false), 0, 0);
  write_outputs(*resume_in(scratch.path(), {}), 0, 0);
  EXPECT_EQ(read_file(scratch.path() + "/ledger.csv"),
      header_of(*sample_ledger_table()) + "\n" + csv_lines(sample_ledger(0.0)));
  EXPECT_THAT(list_frames(scratch.path(), point_frames), ElementsAre(0));
}

TEST(RunWriter, TheSummaryNamesTheCase)
{
  const ScratchFolder scratch;
  RunWriter::start(settings_for(scratch.path()), false)->summary(Summary{}, true);
  EXPECT_THAT(read_file(scratch.path() + "/summary.json"), HasSubstr("\"case_name\": \"model_2\""));
}

TEST(RunWriter, AFolderBelowAFileIsRefusedBeforeAnythingRuns)
{
  const ScratchFolder scratch;
  write_file_atomically(scratch.path() + "/file", "");
  EXPECT_THAT(file_error_of([&] { RunWriter::start(settings_for(scratch.path() + "/file/sub"), false); }),
      AllOf(HasSubstr(scratch.path() + "/file/sub"), HasSubstr("Not a directory")));
}

TEST(RunWriter, OnAFullDiskEveryWriteFailsAndNothingEarlierIsHarmed)
{
  const SmallDisk disk(2 << 20);
  if (!disk.is_there()) GTEST_SKIP() << "cannot mount a small disk";
  const std::string folder = disk.path() + "/run";
  const auto writer = RunWriter::start(settings_for(folder), false);
  write_outputs(*writer, 0, 1);
  disk.fill();
  const std::vector<TableRow> many(1000, sample_history(0.2)[0]);
  const char* full = "No space left on device";
  EXPECT_THAT(file_error_of([&] { writer->frame(std::make_shared<const Frame>(sample_frame(2))), writer->finish(); }),
      HasSubstr(full));
  EXPECT_THAT(file_error_of([&] { writer->rows(many), writer->finish(); }), HasSubstr(full));
  EXPECT_THAT(file_error_of(
                  [&] { writer->checkpoint(std::make_shared<const StateImage>(sample_image(200))), writer->finish(); }),
      HasSubstr(full));
  EXPECT_THAT(file_error_of([&] { writer->summary(Summary{}, false); }), HasSubstr(full));
  EXPECT_THAT(read_file(folder + "/history.csv"), EndsWith(csv_lines(sample_history(0.1))));
  EXPECT_EQ(newest_good_checkpoint(folder).image->step, 100);
  EXPECT_TRUE(newest_good_checkpoint(folder).skipped.empty());
  EXPECT_THAT(list_frames(folder, point_frames), ElementsAre(0, 1));
}

}  // namespace run_writer_test
