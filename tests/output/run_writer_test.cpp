// The files of a whole run, and of one that was resumed.
#include "output/run_writer.hpp"

#include "output/checkpoint.hpp"
#include "output/hdf5_file.hpp"
#include "output/mesh_file.hpp"
#include "output/samples.hpp"
#include "output/small_disk.hpp"
#include "output/table_csv.hpp"
#include "simulation/left_points.hpp"
#include "simulation/run_table.hpp"
#include "support/process.hpp"

#include <filesystem>

#include <gmock/gmock.h>

namespace terp {
namespace {

using test::file_error_of;
using test::sample_frame;
using test::sample_history;
using test::sample_image;
using test::sample_ledger;
using testing::HasSubstr;

RunWriterSettings settings_for(const std::string& folder)
{
  return {folder, {"model_2", "title = \"column\"\n"}, 2, "material.clay.eta = 50\n", all_tables()};
}

/// A run in a folder that goes on from a step of its files.
std::unique_ptr<RunWriter> resume_in(const std::string& folder, const ResumePoint& from)
{
  return RunWriter::resume(settings_for(folder), FolderLock(folder), from);
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

TEST(RunWriter, ANewRunHasItsCaseAndTheHeadersOfItsTables)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path() + "/runs/model_2";
  RunWriter::start(settings_for(folder), false);
  EXPECT_EQ(read_file(folder + "/case.toml"), "title = \"column\"\n");
  EXPECT_EQ(read_file(folder + "/history.csv"), header_of(*history_table()) + "\n");
  EXPECT_EQ(read_file(folder + "/ledger.csv"), header_of(*ledger_table()) + "\n");
}

TEST(RunWriter, ARowIsInTheFileOnceTheWriterHasFinished)
{
  const test::ScratchFolder scratch;
  const auto writer = RunWriter::start(settings_for(scratch.path()), false);
  writer->rows(sample_ledger(0.5));
  writer->finish();
  EXPECT_THAT(read_file(scratch.path() + "/ledger.csv"), testing::EndsWith(csv_lines(sample_ledger(0.5))));
}

TEST(RunWriter, KeepsAsManyCheckpointsAsAsked)
{
  const test::ScratchFolder scratch;
  write_outputs(*RunWriter::start(settings_for(scratch.path()), false), 0, 3);
  EXPECT_FALSE(std::filesystem::exists(path_in(scratch.path(), checkpoint_file(100))));
  EXPECT_TRUE(std::filesystem::exists(path_in(scratch.path(), checkpoint_file(200))));
  EXPECT_TRUE(std::filesystem::exists(path_in(scratch.path(), checkpoint_file(300))));
}

TEST(RunWriter, AResumedRunEndsInTheSameTablesAsOneInOneGo)
{
  const test::ScratchFolder one_go, resumed;
  write_outputs(*RunWriter::start(settings_for(one_go.path()), false), 0, 5);
  write_outputs(*RunWriter::start(settings_for(resumed.path()), false), 0, 4);
  std::filesystem::remove(path_in(resumed.path(), checkpoint_file(400)));
  const StateImage image = newest_good_checkpoint(resumed.path()).image.value();
  write_outputs(*resume_in(resumed.path(),
                    {.step = image.step, .time = image.time, .n_points = 5, .fields = sample_frame(0).fields}),
      4, 5);
  for (const char* name : {"history.csv", "ledger.csv", "case.toml"}) {
    EXPECT_EQ(read_file(path_in(resumed.path(), name)), read_file(path_in(one_go.path(), name))) << name;
  }
  const Hdf5File a(path_in(one_go.path(), results_file), Hdf5File::Mode::read);
  const Hdf5File b(path_in(resumed.path(), results_file), Hdf5File::Mode::read);
  for (const char* name : {"/VTKHDF/Points", "/VTKHDF/PointData/stress", "/VTKHDF/Steps/Values"}) {
    EXPECT_EQ(a.read<Real>(name), b.read<Real>(name)) << name;
  }
}

TEST(RunWriter, ResumingDropsTheCheckpointsOfTheAbandonedSteps)
{
  const test::ScratchFolder scratch;
  write_outputs(*RunWriter::start(settings_for(scratch.path()), false), 0, 3);
  resume_in(scratch.path(), {.step = 200,
                                .time = 0.2,
                                .n_points = 5,
                                .n_rows = {{"history", 6}, {"ledger", 3}},
                                .fields = sample_frame(0).fields});
  EXPECT_EQ(newest_good_checkpoint(scratch.path()).image->step, 200);
}

TEST(RunWriter, DoesNotResumeWhereAFileIsMissingOrTooShort)
{
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path();
  write_outputs(*RunWriter::start(settings_for(folder), false), 0, 3);
  const ResumePoint from{.step = 200,
      .time = 0.2,
      .n_points = 5,
      .n_frames = 3,
      .n_rows = {{"history", 6}, {"ledger", 3}},
      .fields = sample_frame(0).fields};
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
  more.n_frames = 4;
  EXPECT_EQ(file_error_of([&] { resume_in(folder, more); }),
      head + "/results.vtkhdf: it holds 3 frames up to there, 4 are due" + advice);
  more = from;
  more.n_rows["left_the_mesh"] = 1;
  EXPECT_EQ(file_error_of([&] { resume_in(folder, more); }), head + "/left_the_mesh.csv: it is missing" + advice);
  std::filesystem::remove(folder + "/history.csv");
  EXPECT_EQ(file_error_of([&] { resume_in(folder, from); }), head + "/history.csv: it is missing" + advice);
  std::filesystem::remove(folder + "/results.vtkhdf");
  EXPECT_EQ(file_error_of([&] { resume_in(folder, from); }), head + "/results.vtkhdf: it is missing" + advice);
  EXPECT_EQ(read_file(folder + "/ledger.csv"), ledger);
  EXPECT_EQ(newest_good_checkpoint(folder).image->step, 300);
}

/// All bytes of the files of a folder.
std::string bytes_of(const std::string& folder)
{
  std::string bytes;
  for (const std::string& name : test::names_in(folder)) bytes += name + '\n' + read_file(path_in(folder, name));
  return bytes;
}

/// A run with frames of points and mesh, and where its checkpoint of step 200 has it go on.
ResumePoint write_run_with_mesh(const std::string& folder, const std::string& case_record)
{
  RunWriterSettings settings = settings_for(folder);
  settings.case_record = case_record;
  write_outputs(*RunWriter::start(std::move(settings), false), 0, 3);
  const MeshFile mesh(folder + "/mesh.vtkhdf", digits_of(case_record));
  mesh.create(make_rectangle({0.0, 0.0}, {4.0, 1.0}, {2, 1}), true);
  for (int k = 0; k <= 3; ++k)
    mesh.append({.time = 0.1 * k,
        .step = 100 * k,
        .mass = std::vector<Real>(6, 1.0 + k),
        .velocity = std::vector<Real>(12, 2.0 + k),
        .pressure = {0.5, 1.5 + k}});
  return {.step = 200,
      .time = 0.2,
      .n_points = 5,
      .n_nodes = 6,
      .n_cells = 2,
      .n_frames = 3,
      .n_mesh_frames = 3,
      .n_rows = {{"history", 6}, {"ledger", 3}},
      .tables = read_checkpoint(path_in(folder, checkpoint_file(200))).tables,
      .fields = sample_frame(0).fields};
}

TEST(RunWriter, FilesOfAnotherRunAreRefusedAndNothingChanges)
{
  const test::ScratchFolder scratch;
  const std::string ours = scratch.path() + "/ours", theirs = scratch.path() + "/theirs";
  const ResumePoint from = write_run_with_mesh(ours, settings_for(ours).case_record);
  write_run_with_mesh(theirs, "material.clay.eta = 60\n");
  write_file_atomically(theirs + "/ledger.csv", header_of(*ledger_table()) + '\n' + csv_lines(sample_ledger(0.0)) +
                                                    csv_lines(sample_ledger(0.05)) + csv_lines(sample_ledger(0.2)));
  write_file_atomically(theirs + "/history.csv", header_of(*history_table()) + '\n' + csv_lines(sample_history(0.0)) +
                                                     csv_lines(sample_history(0.05)) + csv_lines(sample_history(0.2)));
  for (const std::string name : {"results.vtkhdf", "mesh.vtkhdf", "ledger.csv", "history.csv"}) {
    const std::string aside = scratch.path() + "/aside", path = path_in(ours, name);
    std::filesystem::copy_file(path, aside);
    std::filesystem::copy_file(path_in(theirs, name), path, std::filesystem::copy_options::overwrite_existing);
    const std::string before = bytes_of(ours);
    EXPECT_THAT(file_error_of([&] { resume_in(ours, from); }),
        testing::AllOf(testing::StartsWith("cannot resume from step 200, t = 0.2 s: " + path + " is not "),
            HasSubstr("another "),
            HasSubstr("\n  Put a copy of it back, or start the case anew: terp run " + ours +
                      "/case.toml -o NEW_FOLDER\n  Nothing was changed")));
    EXPECT_EQ(bytes_of(ours), before) << name;
    std::filesystem::rename(aside, path);
  }
  write_file_atomically(ours + "/left_the_mesh.csv", header_of(*left_table()) + "\n0.05,3,1,2,3,4,5\n");
  EXPECT_THAT(file_error_of([&] { resume_in(ours, from); }), HasSubstr("left_the_mesh.csv is not what this run wrote"));
  std::filesystem::remove(ours + "/left_the_mesh.csv");
  ResumePoint more_points = from, finer_mesh = from, more_nodes = from, more_fields = from, wider_fields = from;
  more_points.n_points = 6, finer_mesh.n_cells = 8, more_nodes.n_nodes = 7;
  more_fields.fields = {{"su", "Pa", 1, {}}, {"strain", "-", 4, {}}};
  wider_fields.fields = {{"su", "Pa", 4, {}}};
  EXPECT_THAT(file_error_of([&] { resume_in(ours, more_points); }),
      HasSubstr("results.vtkhdf is not of this run: it has 5 cells, the run 6\n"));
  EXPECT_THAT(file_error_of([&] { resume_in(ours, finer_mesh); }),
      HasSubstr("mesh.vtkhdf is not of this run: it has 2 cells, the run 8\n"));
  EXPECT_THAT(file_error_of([&] { resume_in(ours, more_nodes); }),
      HasSubstr("mesh.vtkhdf is not of this run: it has 6 points, the run 7\n"));
  EXPECT_THAT(file_error_of([&] { resume_in(ours, more_fields); }), HasSubstr("/VTKHDF/PointData/strain"));
  EXPECT_THAT(file_error_of([&] { resume_in(ours, wider_fields); }),
      HasSubstr("/VTKHDF/PointData/su has the shape 20; 4 steps of 5 rows x 4 are due"));
  EXPECT_NO_THROW(resume_in(ours, from));
}

TEST(RunWriter, DamageAnywhereInAFileOfFramesIsHarmlessOrRefusedBeforeAnythingChanges)
{
  const test::ScratchFolder scratch;
  const std::string whole = scratch.path() + "/whole", folder = scratch.path() + "/run";
  const ResumePoint from = write_run_with_mesh(whole, settings_for(whole).case_record);
  int n_refused = 0;
  for (const std::string name : {"results.vtkhdf", "mesh.vtkhdf"}) {
    const std::string sound = read_file(path_in(whole, name));
    for (std::size_t at = 0; at < sound.size(); at += 997) {
      std::filesystem::remove_all(folder);
      std::filesystem::copy(whole, folder);
      std::string damaged = sound;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
      write_file_atomically(path_in(folder, name), damaged);
      const std::string before = bytes_of(folder);
      if (file_error_of([&] { resume_in(folder, from); }).empty()) continue;
      ++n_refused;
      EXPECT_EQ(bytes_of(folder), before) << name << " at " << at;
    }
  }
  EXPECT_GT(n_refused, 10);
}

TEST(RunWriter, ForceReplacesTheEarlierRun)
{
  const test::ScratchFolder scratch;
  write_outputs(*RunWriter::start(settings_for(scratch.path()), false), 0, 2);
  EXPECT_THAT(file_error_of([&] { RunWriter::start(settings_for(scratch.path()), false); }), HasSubstr("--force"));
  write_outputs(*RunWriter::start(settings_for(scratch.path()), true), 0, 0);
  const Hdf5File file(path_in(scratch.path(), results_file), Hdf5File::Mode::read);
  EXPECT_EQ(file.integers("/VTKHDF/Steps", "NSteps").at(0), 1);
  EXPECT_EQ(newest_good_checkpoint(scratch.path()).image->step, 0);
}

TEST(RunWriter, TwoAtOnceInOneFolderAreRefused)
{
  const test::ScratchFolder scratch;
  const auto writer = RunWriter::start(settings_for(scratch.path()), false);
  EXPECT_THAT(file_error_of([&] { RunWriter::start(settings_for(scratch.path()), true); }), HasSubstr("another terp"));
  EXPECT_THAT(file_error_of([&] { resume_in(scratch.path(), {}); }), HasSubstr("another terp"));
}

TEST(RunWriter, AFailedStateIsKeptBesideTheCheckpoints)
{
  const test::ScratchFolder scratch;
  const auto writer = RunWriter::start(settings_for(scratch.path()), false);
  const std::string path = writer->write_failed(sample_image(104));
  EXPECT_EQ(path, scratch.path() + "/failed_000000104.h5");
  EXPECT_EQ(read_checkpoint(path).step, 104);
  EXPECT_FALSE(newest_good_checkpoint(scratch.path()).image);
}

TEST(RunWriter, AFailedStateThatCannotBeKeptSaysWhy)
{
  const test::ScratchFolder scratch;
  const auto writer = RunWriter::start(settings_for(scratch.path() + "/run"), false);
  EXPECT_EQ(writer->save_failed(sample_image(104)), scratch.path() + "/run/failed_000000104.h5");
  std::filesystem::remove_all(scratch.path() + "/run");
  EXPECT_THAT(writer->save_failed(sample_image(105)), testing::StartsWith("nothing: cannot write " + scratch.path()));
}

TEST(RunWriter, ARunResumedAtItsStartShowsTheStartOnce)
{
  const test::ScratchFolder scratch;
  write_outputs(*RunWriter::start(settings_for(scratch.path()), false), 0, 0);
  write_outputs(*resume_in(scratch.path(), {.n_points = 5, .fields = sample_frame(0).fields}), 0, 0);
  EXPECT_EQ(
      read_file(scratch.path() + "/ledger.csv"), header_of(*ledger_table()) + "\n" + csv_lines(sample_ledger(0.0)));
  const Hdf5File file(path_in(scratch.path(), results_file), Hdf5File::Mode::read);
  EXPECT_EQ(file.integers("/VTKHDF/Steps", "NSteps").at(0), 1);
}

TEST(RunWriter, TheSummaryNamesTheCase)
{
  const test::ScratchFolder scratch;
  RunWriter::start(settings_for(scratch.path()), false)->summary(Summary{}, true);
  EXPECT_THAT(read_file(scratch.path() + "/summary.json"), HasSubstr("\"case_name\": \"model_2\""));
}

TEST(RunWriter, AFolderBelowAFileIsRefusedBeforeAnythingRuns)
{
  const test::ScratchFolder scratch;
  write_file_atomically(scratch.path() + "/file", "");
  EXPECT_THAT(file_error_of([&] { RunWriter::start(settings_for(scratch.path() + "/file/sub"), false); }),
      testing::AllOf(HasSubstr(scratch.path() + "/file/sub"), HasSubstr("Not a directory")));
}

TEST(RunWriter, OnAFullDiskEveryWriteFailsAndNothingEarlierIsHarmed)
{
  const test::SmallDisk disk(2 << 20);
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
  EXPECT_THAT(read_file(folder + "/history.csv"), testing::EndsWith(csv_lines(sample_history(0.1))));
  EXPECT_EQ(newest_good_checkpoint(folder).image->step, 100);
  EXPECT_TRUE(newest_good_checkpoint(folder).skipped.empty());
  const Hdf5File file(path_in(folder, results_file), Hdf5File::Mode::read);
  EXPECT_EQ(file.integers("/VTKHDF/Steps", "NSteps").at(0), 2);
}

}  // namespace
}  // namespace terp
