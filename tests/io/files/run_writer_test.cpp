#include "io/files/run_writer.hpp"
#include "io/files/samples.hpp"
#include "io/files/small_disk.hpp"
#include "io/files/summary_json.hpp"
#include "support/process.hpp"
#include "support/scratch.hpp"

namespace run_writer_test {

RunWriterSettings settings_for(const std::string& folder)
{
  return {folder, {"model_2", "title = \"column\"\n"}, 2, "material.clay.eta = 50\n", {}, all_tables()};
}

std::unique_ptr<RunWriter> resume_in(const std::string& folder, const ResumePoint& from)
{
  return RunWriter::resume(settings_for(folder), FolderLock(folder), from);
}

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

ResumePoint point_200(const std::string& folder)
{
  return {.step = 200,
      .time = 0.2,
      .n_frames = 3,
      .n_rows = {{"history", 6}, {"ledger", 3}},
      .tables = read_checkpoint(path_in(folder, checkpoint_file(200))).tables};
}

using RunWriterTest = ScratchTest;

TEST_F(RunWriterTest, ANewRunHasItsCaseAndTheHeadersOfItsTables)
{
  const std::string run = folder + "/runs/model_2";
  RunWriter::start(settings_for(run), false);
  EXPECT_EQ(read_file(run + "/case.toml"), "title = \"column\"\n");
  EXPECT_EQ(read_file(run + "/history.csv"), header_of(*history_table()) + "\n");
  EXPECT_EQ(read_file(run + "/ledger.csv"), header_of(*sample_ledger_table()) + "\n");
}

TEST_F(RunWriterTest, ARowIsInTheFileOnceTheWriterHasFinished)
{
  const auto writer = RunWriter::start(settings_for(folder), false);
  writer->rows(sample_ledger(0.5));
  writer->finish();
  EXPECT_THAT(read_file(folder + "/ledger.csv"), EndsWith(csv_lines(sample_ledger(0.5))));
}

TEST_F(RunWriterTest, KeepsAsManyCheckpointsAsAsked)
{
  write_outputs(*RunWriter::start(settings_for(folder), false), 0, 3);
  EXPECT_FALSE(std::filesystem::exists(path_in(folder, checkpoint_file(100))));
  EXPECT_TRUE(std::filesystem::exists(path_in(folder, checkpoint_file(200))));
  EXPECT_TRUE(std::filesystem::exists(path_in(folder, checkpoint_file(300))));
}

TEST_F(RunWriterTest, AResumedRunEndsInTheSameTablesAsOneInOneGo)
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

TEST_F(RunWriterTest, ResumingDropsTheCheckpointsOfTheAbandonedSteps)
{
  write_outputs(*RunWriter::start(settings_for(folder), false), 0, 3);
  resume_in(folder, point_200(folder));
  EXPECT_EQ(newest_good_checkpoint(folder).image->step, 200);
}

TEST_F(RunWriterTest, DoesNotResumeWhereAFileIsMissingOrTooShortAndNothingChanges)
{
  write_outputs(*RunWriter::start(settings_for(folder), false), 0, 3);
  const ResumePoint from = point_200(folder);
  const std::string head = "cannot resume from step 200, t = 0.2 s, without all of " + folder;
  const std::string advice =
      "\n  Put the file back, resume from an earlier checkpoint, or start the case anew: terp run " + folder +
      "/case.toml -o NEW_FOLDER";
  auto before = all_files_in(folder);
  ResumePoint more = from;
  more.n_rows["history"] = 7;
  EXPECT_EQ(file_error_of([&] { resume_in(folder, more); }),
      head + "/history.csv: it holds 6 rows up to there, 7 are due" + advice);
  more = from;
  more.n_rows["left_the_mesh"] = 1;
  EXPECT_EQ(file_error_of([&] { resume_in(folder, more); }), head + "/left_the_mesh.csv: it is missing" + advice);
  EXPECT_EQ(all_files_in(folder), before);
  std::filesystem::remove(folder + "/history.csv");
  before.erase("history.csv");
  EXPECT_EQ(file_error_of([&] { resume_in(folder, from); }), head + "/history.csv: it is missing" + advice);
  EXPECT_EQ(all_files_in(folder), before);
}

TEST_F(RunWriterTest, FilesOfAnotherRunAreRefusedAndNothingChanges)
{
  const std::string ours = folder + "/ours", theirs = folder + "/theirs";
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
    const std::string aside = folder + "/aside", path = path_in(ours, name);
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

TEST_F(RunWriterTest, ForceReplacesTheEarlierRun)
{
  write_outputs(*RunWriter::start(settings_for(folder), false), 0, 2);
  EXPECT_THAT(file_error_of([&] { RunWriter::start(settings_for(folder), false); }), HasSubstr("--force"));
  write_outputs(*RunWriter::start(settings_for(folder), true), 0, 0);
  EXPECT_THAT(list_frames(folder, point_frames), ElementsAre(0));
  EXPECT_EQ(newest_good_checkpoint(folder).image->step, 0);
}

TEST_F(RunWriterTest, TwoAtOnceInOneFolderAreRefused)
{
  const auto writer = RunWriter::start(settings_for(folder), false);
  EXPECT_THAT(file_error_of([&] { RunWriter::start(settings_for(folder), true); }), HasSubstr("another terp"));
  EXPECT_THAT(file_error_of([&] { resume_in(folder, {}); }), HasSubstr("another terp"));
}

TEST_F(RunWriterTest, AFailedStateIsKeptBesideTheCheckpointsOrSaysWhyNot)
{
  const auto writer = RunWriter::start(settings_for(folder + "/run"), false);
  const std::string path = folder + "/run/failed_000000104.h5";
  EXPECT_EQ(writer->save_failed(sample_image(104)), path);
  EXPECT_EQ(read_checkpoint(path).step, 104);
  EXPECT_FALSE(newest_good_checkpoint(folder + "/run").image);
  std::filesystem::remove_all(folder + "/run");
  EXPECT_THAT(writer->save_failed(sample_image(105)), StartsWith("nothing: cannot write " + folder));
}

TEST_F(RunWriterTest, ARunResumedAtItsStartShowsTheStartOnce)
{
  write_outputs(*RunWriter::start(settings_for(folder), false), 0, 0);
  write_outputs(*resume_in(folder, {}), 0, 0);
  EXPECT_EQ(
      read_file(folder + "/ledger.csv"), header_of(*sample_ledger_table()) + "\n" + csv_lines(sample_ledger(0.0)));
  EXPECT_THAT(list_frames(folder, point_frames), ElementsAre(0));
}

TEST_F(RunWriterTest, TheSummaryNamesTheCase)
{
  RunWriter::start(settings_for(folder), false)->summary(Summary{}, true);
  EXPECT_THAT(read_file(folder + "/summary.json"), HasSubstr("\"case_name\": \"model_2\""));
}

TEST_F(RunWriterTest, TheSummaryHasWhatTheRunWroteOfEachTable)
{
  const auto writer = RunWriter::start(settings_for(folder), false);
  write_outputs(*writer, 0, 1);
  writer->summary(Summary{}, true);
  const std::string ledger = read_file(folder + "/ledger.csv");
  const SavedSummary saved = read_summary(folder + "/summary.json");
  const auto table = std::ranges::find(saved.tables, "ledger.csv", &WrittenTable::file);
  ASSERT_NE(table, saved.tables.end());
  EXPECT_EQ(table->n_bytes, std::ssize(ledger));
  EXPECT_EQ(table->checksum, digits_of(ledger));
  write_file_atomically(folder + "/ledger.csv", ledger + ledger);
  EXPECT_EQ(file_error_of([&] { writer->summary(Summary{}, true); }),
      folder + "/ledger.csv: it was removed or changed while the run wrote it");
}

TEST_F(RunWriterTest, OnAFullDiskEveryWriteFailsAndNothingEarlierIsHarmed)
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
