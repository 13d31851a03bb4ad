// Frames read as they were written.
#include "results/frames.hpp"

#include "results/runs.hpp"

#include <filesystem>

#include <gmock/gmock.h>

namespace terp {
namespace {

using test::file_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

struct FramesTest : testing::Test {
  test::ScratchFolder scratch;
  std::string path = path_in(test::write_run(scratch.path() + "/run"), results_file);
};

TEST_F(FramesTest, TellsTimesStepsAndFields)
{
  const Frames frames(path);
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

TEST_F(FramesTest, ReadsPlacesAndFieldsToTheBit)
{
  const Frames frames(path);
  for (int k = 0; k < 3; ++k) {
    const Frame written = test::sample_frame(k);
    EXPECT_EQ(frames.places(static_cast<std::size_t>(k)), written.x);
    EXPECT_EQ(frames.read("su", static_cast<std::size_t>(k)), written.fields[0].values);
    EXPECT_EQ(frames.read("stress", static_cast<std::size_t>(k)), written.fields[2].values);
  }
  EXPECT_THAT(frames.read("velocity", 1), testing::Contains(0.0).Times(5));  // z
}

TEST_F(FramesTest, AreThoseOfTheFileWhenItWasOpenedWhateverTheRunAdds)
{
  const Frames frames(path);
  ResultsFile(path).append(test::sample_frame(3));
  EXPECT_EQ(frames.times().size(), 3);
  EXPECT_EQ(frames.places(2), test::sample_frame(2).x);
  EXPECT_EQ(Frames(path).places(3), test::sample_frame(3).x);
}

TEST_F(FramesTest, OfAnotherCaseThatTookThePlaceAreNotMixedIn)
{
  const Frames frames(path);
  std::filesystem::remove(path);
  ResultsFile(path, "0123456789abcdef").append(test::sample_frame(0));
  EXPECT_EQ(
      file_error_of([&] { frames.places(0); }), "cannot read " + path + ": it has become the file of another case");
}

TEST_F(FramesTest, NamesTheFieldsWhenAskedForAnother)
{
  const Frames frames(path);
  EXPECT_EQ(test::case_error_of([&] { frames.read("sigma", 0); }),
      "error: " + path + " has no field `sigma`\n  It has: su, velocity, stress\n");
}

TEST_F(FramesTest, AFrameThatIsNotThereIsAnErrorThatNamesTheFile)
{
  const Frames frames(path);
  EXPECT_THAT(file_error_of([&] { frames.places(3); }),
      testing::AllOf(HasSubstr("cannot read rows 15 to 19"), HasSubstr(path), HasSubstr("it has 15")));
}

TEST_F(FramesTest, OfANewerFormatAreRefusedWithItsVersion)
{
  Hdf5File(path, Hdf5File::Mode::change).set_integers("/VTKHDF", "Version", {3, 0});
  EXPECT_EQ(
      file_error_of([&] { Frames{path}; }), "cannot read " + path +
                                                ": it is of VTKHDF version 3.0, terp " TERP_VERSION
                                                " reads version 2\n  A newer terp wrote it: read it with that one.");
}

TEST_F(FramesTest, TablesThatDoNotHoldWhatTheFileSaysAreRefused)
{
  const auto written = [&](const char* table, std::int64_t n_columns) {
    const std::string other = scratch.path() + "/other.vtkhdf";
    std::filesystem::remove(other);
    Hdf5File file(other, Hdf5File::Mode::create);
    const std::vector<Real> fifteen(15, 1.0);
    file.create_group("/VTKHDF");
    file.create_group("/VTKHDF/Steps");
    file.create_group("/VTKHDF/PointData");
    file.set_integers("/VTKHDF", "Version", {2, 0});
    file.set_integers("/VTKHDF/Steps", "NSteps", {1});
    file.write<std::int64_t>("/VTKHDF/NumberOfPoints", {1}, std::vector<std::int64_t>{5});
    file.write<Real>("/VTKHDF/Steps/Values", {1}, std::vector<Real>{0.0});
    file.write<Real>("/VTKHDF/Steps/step", {1}, std::vector<Real>{0.0});
    const auto add = [&](const std::string& name, std::int64_t usual) {
      const std::int64_t n = name == table ? n_columns : usual;
      file.write<Real>(name, {15 / n, n}, fifteen);
      file.set_text(name, "unit", "m");
    };
    add("/VTKHDF/Points", 3);
    add("/VTKHDF/PointData/velocity", 3);
    return other;
  };
  EXPECT_EQ(Frames(written("", 0)).places(0).size(), 10);
  EXPECT_THAT(
      file_error_of([&] { Frames{written("/VTKHDF/Points", 1)}; }), HasSubstr("its points have no three coordinates"));
  EXPECT_THAT(file_error_of([&] { Frames{written("/VTKHDF/Points", 5)}; }),
      HasSubstr("it has 3 rows, 1 frames of 5 points take more"));
  EXPECT_THAT(file_error_of([&] { Frames{written("/VTKHDF/PointData/velocity", 5)}; }),
      HasSubstr("cannot read /VTKHDF/PointData/velocity"));
}

TEST(Magnitudes, AreLengthsOfVectorsAndSizesOfNumbers)
{
  EXPECT_THAT(magnitudes({3.0, 4.0, 0.0, 1.0, 2.0, 2.0}, 3), ElementsAre(5.0, 3.0));
  EXPECT_THAT(magnitudes({-2.5, 1.5}, 1), ElementsAre(2.5, 1.5));
}

}  // namespace
}  // namespace terp
