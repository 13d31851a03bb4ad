#include "io/files/point_frames.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/samples.hpp"
#include "support/scratch.hpp"

namespace point_frames_test {

/// Path of frame `last` of a run with frames 0...last.
std::string write_frames(const std::string& folder, int last)
{
  PointFrameWriter writer({folder, point_frames, "0123456789abcdef"});
  for (int k = 0; k <= last; ++k) writer.append(sample_frame(k));
  return path_in(folder, frame_file(point_frames, last));
}

Frame part_of(const Frame& whole, std::size_t first, std::size_t n)
{
  const auto rows = [&](const std::vector<Real>& values, std::size_t columns) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first * columns);
    return std::vector<Real>(begin, begin + static_cast<std::ptrdiff_t>(n * columns));
  };
  Frame part = whole;
  part.first = static_cast<std::int64_t>(first), part.n_all = whole.n_points();
  part.x = rows(whole.x, 2);
  for (PointField& field : part.fields) field.values = rows(field.values, static_cast<std::size_t>(field.n_components));
  return part;
}

using PointFrames = ScratchTest;

TEST_F(PointFrames, HaveTheHeaderOfTheFormatAndOneVertexPerPoint)
{
  const Hdf5File file(write_frames(folder, 1), Hdf5File::Mode::read);
  EXPECT_THAT(file.integers("/VTKHDF", "Version"), ElementsAre(1, 0));
  EXPECT_EQ(file.text("/VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Connectivity"), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Offsets"), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(file.read<std::uint8_t>("/VTKHDF/Types"), ElementsAre(1, 1, 1, 1, 1));
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    EXPECT_THAT(file.read<std::int64_t>(std::string("/VTKHDF/") + name), ElementsAre(5));
}

TEST_F(PointFrames, KeepPlacesToTheBitAndFieldsInSinglePrecision)
{
  const Hdf5File file(write_frames(folder, 2), Hdf5File::Mode::read);
  const Frame frame = sample_frame(2);
  EXPECT_EQ(file.read<Real>("/VTKHDF/PointData/su"), as_single(frame.fields[0].values));
  EXPECT_EQ(file.read<Real>("/VTKHDF/PointData/stress"), as_single(frame.fields[2].values));
  EXPECT_THAT(file.shape("/VTKHDF/PointData/stress"), ElementsAre(5, 4));
  const auto x = file.read<Real>("/VTKHDF/Points"), v = file.read<Real>("/VTKHDF/PointData/velocity");
  EXPECT_THAT(std::vector<Real>(x.begin() + 3, x.begin() + 6), ElementsAre(2010.1, 2010.2, 0.0));
  EXPECT_THAT(std::vector<Real>(v.begin() + 3, v.begin() + 6), ElementsAre(2010.4f, 2010.5f, 0.0));
}

TEST_F(PointFrames, KeepFieldsToTheBitWhereTheyAreToBeExact)
{
  PointFrameWriter({folder, point_frames, ""}, true).append(sample_frame(2));
  const Hdf5File file(path_in(folder, frame_file(point_frames, 0)), Hdf5File::Mode::read);
  EXPECT_EQ(file.read<Real>("/VTKHDF/PointData/su"), sample_frame(2).fields[0].values);
  EXPECT_NE(sample_frame(2).fields[0].values, as_single(sample_frame(2).fields[0].values));
}

TEST_F(PointFrames, StateUnitsAndComponents)
{
  const Hdf5File file(write_frames(folder, 0), Hdf5File::Mode::read);
  EXPECT_EQ(file.text("/VTKHDF/PointData/stress", "unit"), "Pa");
  EXPECT_EQ(file.text("/VTKHDF/PointData/stress", "components"), "xx yy zz xy");
  EXPECT_EQ(file.text("/VTKHDF/PointData/velocity", "components"), "x y z");
  EXPECT_EQ(file.text("/VTKHDF/Points", "unit"), "m");
}

TEST_F(PointFrames, WholeNumbersAreKeptAsSuch)
{
  Frame frame = sample_frame(0);
  frame.fields[0] = {"cell", "-", 1, {-1.0, 0.0, 16777217.0, 19999999.0, 3.0}};  // 2^24 + 1 is no float
  PointFrameWriter({folder, point_frames, ""}).append(frame);
  const Hdf5File file(path_in(folder, frame_file(point_frames, 0)), Hdf5File::Mode::read);
  EXPECT_EQ(file.read<Real>("/VTKHDF/PointData/cell"), frame.fields[0].values);
  EXPECT_FALSE(file.holds_reals("/VTKHDF/PointData/cell"));
}

TEST_F(PointFrames, AFrameInPartsIsThatInOnePieceAndThereWhenItsLastPartIs)
{
  const std::string whole = write_frames(folder + "/whole", 0);
  PointFrameWriter writer({folder, point_frames, "0123456789abcdef"});
  const std::string path = path_in(folder, frame_file(point_frames, 0));
  writer.append(part_of(sample_frame(0), 0, 2));
  writer.append(part_of(sample_frame(0), 2, 2));
  EXPECT_FALSE(std::filesystem::exists(path));
  writer.append(part_of(sample_frame(0), 4, 1));
  EXPECT_EQ(Hdf5File(path, Hdf5File::Mode::read).read<Real>("/VTKHDF/PointData/stress"),
      Hdf5File(whole, Hdf5File::Mode::read).read<Real>("/VTKHDF/PointData/stress"));
}

}  // namespace point_frames_test
