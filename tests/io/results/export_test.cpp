#include "io/results/export.hpp"
#include "io/results/runs.hpp"

namespace export_test {

TEST(ParseFrames, TakesNumbersRangesAndLast)
{
  EXPECT_THAT(parse_frames("0,5,7:9,last", 20), ElementsAre(0, 5, 7, 8, 9, 19));
  EXPECT_THAT(parse_frames("0:last", 3), ElementsAre(0, 1, 2));
  EXPECT_THAT(parse_frames("2,2,1", 3), ElementsAre(1, 2));
}

TEST(ParseFrames, SaysWhichFramesThereAre)
{
  for (const char* text : {"3", "x", "", "0,", "1:", "-1"})
    EXPECT_THAT(case_error_of([&] { parse_frames(text, 3); }),
        AllOf(StartsWith("error: there is no frame `"), HasSubstr("the run has frames 0 to 2")))
        << text;
}

TEST(ParseFrames, RefusesARangeThatRunsBackwards)
{
  EXPECT_THAT(
      case_error_of([] { parse_frames("0,2:1", 3); }), StartsWith("error: the frames `2:1` in `0,2:1` run backwards"));
  EXPECT_THAT(parse_frames("1:1", 3), ElementsAre(1));
}

struct ExportTest : testing::Test {
  ScratchFolder scratch;
  Frames frames{write_run(scratch.path() + "/run")};
  std::string folder = scratch.path() + "/out/csv";
};

TEST_F(ExportTest, HasAColumnPerComponentAndTheShortestNumbersOfTheirPrecision)
{
  const auto paths = export_frames(frames, {{"stress", "su"}, "1", folder});
  EXPECT_THAT(paths, ElementsAre(folder + "/frame_00001.csv", folder + "/frames.csv"));
  EXPECT_THAT(read_file(paths[0]), StartsWith("id,x,y,stress_xx,stress_yy,stress_zz,stress_xy,su\n0,1000.1,1000.2,1000."
                                              "6,1000.7,1000.8,1000.9,1000.3\n1,1010.1,"));
  EXPECT_EQ(read_file(paths[1]), "file,time,step\nframe_00001.csv,0.1,100\n");
}

TEST_F(ExportTest, AllFramesAndFieldsUnlessToldOtherwise)
{
  const auto paths = export_frames(frames, {{}, "", folder});
  ASSERT_EQ(paths.size(), 4);
  EXPECT_THAT(read_file(paths[2]), StartsWith("id,x,y,su,velocity_x,velocity_y,velocity_z,stress_xx,"));
}

TEST_F(ExportTest, HasNoRowOfAPointWithoutSoil)
{
  Frame frame = sample_frame(1);
  frame.fields.push_back({"material", "-", 1, {0.0, -1.0, 0.0, 0.0, -1.0}});
  for (int k = 0; k < 3; ++k)
    PointFrameWriter({scratch.path() + "/run", point_frames, "0123456789abcdef", k}).append(frame);
  Frames dug(scratch.path() + "/run");
  const auto paths = export_frames(dug, {{"material"}, "last", folder});
  EXPECT_EQ(read_file(paths[0]), "id,x,y,material\n0,1000.1,1000.2,0\n2,1020.1,1020.2,0\n3,1030.1,1030.2,0\n");
}

TEST_F(ExportTest, LeavesDamagedFramesOut)
{
  const std::string path = scratch.path() + "/run/frames/points_00001.vtkhdf", bytes = read_file(path);
  write_file_atomically(path, bytes.substr(0, bytes.size() / 2));
  EXPECT_THAT(export_frames(frames, {{"su"}, "", folder}), SizeIs(3));
  EXPECT_THAT(in_english(frames.warnings()), ElementsAre(HasSubstr(path)));
}

}  // namespace export_test
