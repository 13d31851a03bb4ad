#include "io/files/frame_files.hpp"
#include "io/files/point_frames.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/samples.hpp"
#include "support/scratch.hpp"

namespace frame_files_test {

const std::string run = "0123456789abcdef";

void write_frames(const std::string& folder, int n)
{
  PointFrameWriter writer({folder, point_frames, run});
  for (int k = 0; k < n; ++k) writer.append(sample_frame(k));
}

std::string path_of_frame(const std::string& folder, int k) { return path_in(folder, frame_file(point_frames, k)); }

using FrameFiles = ScratchTest;

TEST_F(FrameFiles, HaveNumberedNames)
{
  EXPECT_EQ(frame_file(mesh_frames, 7), "frames/mesh_00007.vtkhdf");
  EXPECT_EQ(number_of_frame(point_frames, "points_00012.vtkhdf"), 12);
  EXPECT_EQ(number_of_frame(point_frames, "points_123456.vtkhdf"), 123456);
  for (const char* other : {"mesh_00012.vtkhdf", "points_.vtkhdf", "points_-1.vtkhdf", "points_1.vtkhdf.tmp"})
    EXPECT_EQ(number_of_frame(point_frames, other), -1) << other;
}

TEST_F(FrameFiles, WhoseFolderIsRemovedWhileTheRunGoesOnEndIt)
{
  PointFrameWriter writer({folder, point_frames, run});
  for (int k = 0; k < 2; ++k) writer.append(sample_frame(k));
  writer.frames().require_all();
  std::filesystem::remove(path_of_frame(folder, 1));
  EXPECT_EQ(file_error_of([&] { writer.frames().require_all(); }),
      path_of_frame(folder, 1) + ": it was removed while the run went on");
  std::filesystem::remove_all(path_in(folder, frames_folder));
  EXPECT_EQ(file_error_of([&] { writer.append(sample_frame(2)); }),
      path_in(folder, frames_folder) + ": it was removed while the run went on");
}

TEST_F(FrameFiles, StateNumberTimeStepAndRun)
{
  write_frames(folder, 3);
  const FrameHead head = read_head(Hdf5File(path_of_frame(folder, 2), Hdf5File::Mode::read));
  EXPECT_EQ(head.number, 2);
  EXPECT_EQ(head.time, sample_frame(2).time);
  EXPECT_EQ(head.step, 200);
  EXPECT_EQ(head.run, run);
  EXPECT_THAT(list_frames(folder, point_frames), ElementsAre(0, 1, 2));
  EXPECT_TRUE(list_frames(folder, mesh_frames).empty());
}

TEST_F(FrameFiles, AreListedWithTheirTimesForParaView)
{
  write_frames(folder, 2);
  EXPECT_EQ(read_file(path_in(folder, "results.vtkhdf.series")),
      "{\n \"file-series-version\": \"1.0\",\n \"files\": [\n"
      "  {\n   \"name\": \"frames/points_00000.vtkhdf\",\n   \"time\": 0.0\n  },\n"
      "  {\n   \"name\": \"frames/points_00001.vtkhdf\",\n   \"time\": 0.1\n  }\n ]\n}\n");
}

TEST_F(FrameFiles, OfEqualRunsAreEqualToTheByte)
{
  write_frames(folder + "/a", 2);
  write_frames(folder + "/b", 2);
  EXPECT_EQ(read_file(path_of_frame(folder + "/a", 1)), read_file(path_of_frame(folder + "/b", 1)));
}

TEST_F(FrameFiles, ThatAreMissingOrNotThoseOfTheirNameAreNamed)
{
  write_frames(folder, 4);
  std::filesystem::remove(path_of_frame(folder, 1));
  std::filesystem::copy_file(
      path_of_frame(folder, 0), path_of_frame(folder, 2), std::filesystem::copy_options::overwrite_existing);
  const FrameCheck check = check_frames(folder, point_frames, 4, run);
  ASSERT_EQ(check.good.size(), 2);
  EXPECT_EQ(check.good[1].number, 3);
  EXPECT_THAT(check.faults, ElementsAre(path_of_frame(folder, 1) + " is missing; the run goes on without it",
                                path_of_frame(folder, 2) + " is damaged; the run goes on without it: it is frame 0"));
  EXPECT_TRUE(check.stranger.empty());
  EXPECT_EQ(check_frames(folder, point_frames, 1, "of another").stranger, path_of_frame(folder, 0));
}

TEST_F(FrameFiles, OneFlippedBitAnywhereIsFoundOrChangesNothingThatIsRead)
{
  write_frames(folder, 1);
  const std::string path = path_of_frame(folder, 0), sound = read_file(path);
  const auto content = [&] {
    const Hdf5File file(path, Hdf5File::Mode::read);
    std::vector<Real> values = file.read<Real>("/VTKHDF/Points");
    for (const auto& name : file.members("/VTKHDF/PointData"))
      for (const Real v : file.read<Real>("/VTKHDF/PointData/" + name)) values.push_back(v);
    return values;
  };
  const auto expected = content();
  int n_found = 0;
  for (std::size_t at = 0; at < sound.size(); at += 13) {
    std::string damaged = sound;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    write_file_atomically(path, damaged);
    if (!check_frames(folder, point_frames, 1, run).faults.empty())
      ++n_found;
    else
      EXPECT_EQ(content(), expected) << "bit " << at % 8 << " of byte " << at;
  }
  EXPECT_GT(n_found, 100);
}

TEST_F(FrameFiles, OfAFolderThatCannotBeReadAreNoEmptyList)
{
  EXPECT_THAT(list_frames(folder, point_frames), IsEmpty());
  std::ofstream(folder + "/frames") << "no folder";
  EXPECT_THAT(refusal<FileError>([&] { list_frames(folder, point_frames); }),
      AllOf(StartsWith("cannot read "), HasSubstr("/frames: ")));
}

TEST_F(FrameFiles, FromANumberOnAreRemoved)
{
  write_frames(folder, 4);
  remove_frames_from(folder, mesh_frames, 0);
  remove_frames_from(folder, point_frames, 2);
  EXPECT_THAT(list_frames(folder, point_frames), ElementsAre(0, 1));
}

TEST_F(FrameFiles, ThatAreNotEndedLeaveNothing)
{
  FrameSeries(folder, point_frames, run).begin(0.0, 0, 1000);
  EXPECT_TRUE(std::filesystem::is_empty(folder + "/frames"));
}

}  // namespace frame_files_test
