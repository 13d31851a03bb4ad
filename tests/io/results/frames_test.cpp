#include "io/results/frames.hpp"
#include "io/results/runs.hpp"
#include "support/leaks.hpp"

namespace frames_test {

struct FramesTest : testing::Test {
  ScratchFolder scratch;
  std::string folder = write_run(scratch.path() + "/run");

  std::string path_of(int k) const { return path_in(folder, frame_file(point_frames, k)); }
  PointFrameWriter writer_from(int k, const std::string& run = "0123456789abcdef") const
  {
    return PointFrameWriter({folder, point_frames, run, k});
  }
};

TEST_F(FramesTest, TellsTimesStepsAndFields)
{
  const Frames frames(folder);
  EXPECT_EQ(frames.n_points(), 5);
  EXPECT_THAT(frames.times(), ElementsAre(0.0, 0.1, 0.2));
  EXPECT_THAT(frames.steps(), ElementsAre(0, 100, 200));
  ASSERT_EQ(frames.fields().size(), 3);
  EXPECT_EQ(frames.fields()[0].name, "su");
  EXPECT_EQ(frames.fields()[0].unit, "Pa");
  EXPECT_EQ(frames.field("su").n_components, 1);
  EXPECT_EQ(frames.field("velocity").n_components, 3);
  EXPECT_EQ(frames.field("stress").n_components, 4);
  EXPECT_TRUE(frames.has("stress"));
  EXPECT_FALSE(frames.has("id"));
}

TEST_F(FramesTest, ReadsPlacesAndFields)
{
  const Frames frames(folder);
  for (int k = 0; k < 3; ++k) {
    const Frame written = sample_frame(k);
    EXPECT_EQ(frames.places(static_cast<std::size_t>(k)), written.x);
    EXPECT_EQ(frames.read("su", static_cast<std::size_t>(k)), as_single(written.fields[0].values));
    EXPECT_EQ(frames.read("stress", static_cast<std::size_t>(k)), as_single(written.fields[2].values));
  }
  EXPECT_THAT(frames.read("velocity", 1), Contains(0.0).Times(5));  // z
  EXPECT_TRUE(frames.warnings().empty());
}

TEST_F(FramesTest, HavePlacesAndValuesOnlyWhereThereIsSoil)
{
  constexpr Real gone = -1.0;
  const std::pair<const char*, std::vector<Real>> signs[] = {{"material", {0.0, gone, 2.0, gone, 1.0}},
      {"cell", {0.0, gone, 9.0, gone, 5.0}}, {"volume", {0.1, 0.0, 0.1, 0.0, 0.1}}};
  for (const auto& [name, values] : signs) {
    SCOPED_TRACE(name);
    Frame frame = sample_frame(0);
    frame.fields.push_back({name, "-", 1, values});
    for (int k = 0; k < 3; ++k) writer_from(k).append(frame);
    const Frames frames(folder);
    const std::vector<Real> x = frames.places(0), stress = frames.read("stress", 0), sign = frames.read(name, 0);
    for (std::size_t p = 0; p < 5; ++p) {
      const bool there = p % 2 == 0;
      EXPECT_EQ(is_soil(x, p), there);
      EXPECT_EQ(std::isnan(sign[p]), !there);
      for (std::size_t d = 0; d < 2; ++d) EXPECT_EQ(std::isnan(x[2 * p + d]), !there);
      for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(std::isnan(stress[4 * p + c]), !there);
    }
    EXPECT_EQ(x[4], frame.x[4]);
  }
}

TEST_F(FramesTest, AreThoseOfTheFolderWhenItWasOpenedWhateverTheRunAdds)
{
  const Frames frames(folder);
  writer_from(3).append(sample_frame(3));
  EXPECT_EQ(frames.times().size(), 3);
  EXPECT_EQ(frames.places(2), sample_frame(2).x);
  EXPECT_EQ(Frames(folder).places(3), sample_frame(3).x);
}

TEST_F(FramesTest, OfAnotherCaseAreNotMixedIn)
{
  const Frames frames(folder);
  writer_from(0, "fedcba9876543210").append(sample_frame(0));
  EXPECT_EQ(file_error_of([&] { frames.places(0); }),
      "cannot read " + path_of(0) + ": it has become the file of another case");
  EXPECT_EQ(file_error_of([&] { Frames{folder}; }),
      "cannot read " + path_of(1) + ": it is of a run of another case than the frames before it");
}

TEST_F(FramesTest, NamesTheFieldsWhenAskedForAnother)
{
  const Frames frames(folder);
  EXPECT_EQ(case_error_of([&] { frames.read("sigma", 0); }),
      "error: " + folder + " has no field `sigma`\n  It has: su, velocity, stress\n");
}

TEST_F(FramesTest, AFrameThatIsNotThereIsAnErrorThatNamesTheFolder)
{
  EXPECT_EQ(file_error_of([&] { Frames(folder).places(3); }), folder + ": there is no frame 3, it has 3");
}

TEST_F(FramesTest, ThatAreMissingOrCutAreNamedAndLeftOut)
{
  std::filesystem::remove(path_of(0));
  write_file_atomically(path_of(1), read_file(path_of(1)).substr(0, 2000));
  const Frames frames(folder);
  EXPECT_THAT(frames.steps(), ElementsAre(200));
  EXPECT_EQ(frames.places(0), sample_frame(2).x);
  EXPECT_THAT(in_english(frames.warnings()),
      ElementsAre(path_of(0) + " is missing", StartsWith(path_of(1) + " is left out: cannot read " + path_of(1))));
}

TEST_F(FramesTest, WithAFlippedBitInAFieldFailWhenItIsReadAndCanBeLeftOut)
{
  const Frame sample = sample_frame(1);
  std::string bytes = read_file(path_of(1));
  std::size_t at = 0;  // of a byte of a field: where only the field cannot be read
  for (bool found = false; !found; ++at) {
    ASSERT_LT(at, bytes.size());
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    write_file_atomically(path_of(1), damaged);
    found = Frames(folder).times().size() == 3 &&
            !file_error_of([&] { static_cast<void>(Frames(folder).read("su", 1)); }).empty();
  }
  Frames frames(folder);
  EXPECT_THAT(file_error_of([&] { frames.read("su", 1); }), HasSubstr("/VTKHDF/PointData/su in " + path_of(1)));
  EXPECT_EQ(frames.places(1), sample.x);
  frames.leave_out_damaged();
  EXPECT_THAT(frames.steps(), ElementsAre(0, 200));
  EXPECT_THAT(in_english(frames.warnings()), ElementsAre(HasSubstr(path_of(1) + " is left out: ")));
}

TEST_F(FramesTest, OfAnotherFormatAreNamedWithItsVersion)
{
  for (int k = 0; k < 3; ++k) {
    Hdf5File file(path_of(k), Hdf5File::Mode::create);
    file.create_group("/VTKHDF");
    file.set_integers("/VTKHDF", "Version", {2, 0});
    for (const char* name : {"frame", "step"}) file.set_integers("/", name, {k});
    file.set_real("/", "time", 0.0);
    file.set_text("/", "case", "0123456789abcdef");
    file.write<std::int64_t>("/VTKHDF/NumberOfPoints", {1}, std::vector<std::int64_t>{5});
  }
  EXPECT_THAT(file_error_of([&] { Frames{folder}; }),
      AllOf(StartsWith(folder + ": it holds no frame that can be read"),
          HasSubstr(path_of(2) + " is left out: it is of VTKHDF version 2.0, terp " TERP_VERSION " reads version 1")));
}

TEST_F(FramesTest, ThatDoNotHoldWhatTheOthersHoldAreLeftOut)
{
  Frame other = sample_frame(1);
  other.fields.pop_back();
  writer_from(1).append(other);
  const Frames frames(folder);
  EXPECT_THAT(frames.steps(), ElementsAre(0, 200));
  EXPECT_THAT(
      in_english(frames.warnings()), ElementsAre(HasSubstr("its points or fields are not those of the other frames")));
}

TEST(Magnitudes, AreLengthsOfVectorsAndSizesOfNumbers)
{
  EXPECT_THAT(magnitudes({3.0, 4.0, 0.0, 1.0, 2.0, 2.0}, 3), ElementsAre(5.0, 3.0));
  EXPECT_THAT(magnitudes({-2.5, 1.5}, 1), ElementsAre(2.5, 1.5));
}

}  // namespace frames_test
