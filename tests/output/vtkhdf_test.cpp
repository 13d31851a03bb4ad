// results.vtkhdf: what is written is read back, by HDF5 here and by h5py.
#include "output/vtkhdf.hpp"

#include "output/files.hpp"
#include "output/hdf5_file.hpp"
#include "output/samples.hpp"
#include "output/small_disk.hpp"
#include "support/paths.hpp"

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>

namespace terp {
namespace {

using test::cut_after;
using test::file_error_of;
using test::sample_frame;
using testing::ElementsAre;
using testing::HasSubstr;

/// A results file with frames first...last.
std::string write_frames(const std::string& folder, int first, int last)
{
  const std::string path = folder + "/results.vtkhdf";
  ResultsFile results(path);
  for (int k = first; k <= last; ++k) results.append(sample_frame(k));
  return path;
}

/// All numbers of a dataset's frame k of five points.
std::vector<Real> rows_of_frame(const Hdf5File& file, const std::string& name, std::size_t k)
{
  const auto values = file.read<Real>(name);
  const auto n = static_cast<std::size_t>(5 * (file.shape(name).size() == 1 ? 1 : file.shape(name)[1]));
  return {
      values.begin() + static_cast<std::ptrdiff_t>(k * n), values.begin() + static_cast<std::ptrdiff_t>((k + 1) * n)};
}

TEST(Vtkhdf, HasTheHeaderOfTheFormat)
{
  const test::ScratchFolder folder;
  const Hdf5File file(write_frames(folder.path(), 0, 0), Hdf5File::Mode::read);
  EXPECT_THAT(file.integers("/VTKHDF", "Version"), ElementsAre(2, 0));
  EXPECT_EQ(file.text("/VTKHDF", "Type"), "UnstructuredGrid");
}

TEST(Vtkhdf, FramesAreReadBackToTheBit)
{
  const test::ScratchFolder folder;
  const Hdf5File file(write_frames(folder.path(), 0, 2), Hdf5File::Mode::read);
  for (int k = 0; k < 3; ++k) {
    const Frame frame = sample_frame(k);
    const auto row = static_cast<std::size_t>(k);
    EXPECT_EQ(rows_of_frame(file, "/VTKHDF/PointData/su", row), frame.fields[0].values);
    EXPECT_EQ(rows_of_frame(file, "/VTKHDF/PointData/stress", row), frame.fields[2].values);
    EXPECT_EQ(file.read<Real>("/VTKHDF/Steps/Values")[row], frame.time);
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/Steps/step")[row], frame.step);
  }
}

TEST(Vtkhdf, PlacesAndVectorsHaveAZero)
{
  const test::ScratchFolder folder;
  const Hdf5File file(write_frames(folder.path(), 0, 1), Hdf5File::Mode::read);
  EXPECT_THAT(file.shape("/VTKHDF/Points"), ElementsAre(10, 3));
  const auto places = rows_of_frame(file, "/VTKHDF/Points", 1);
  EXPECT_THAT(std::vector<Real>(places.begin() + 3, places.begin() + 6), ElementsAre(1010.1, 1010.2, 0.0));
  const auto velocity = rows_of_frame(file, "/VTKHDF/PointData/velocity", 1);
  EXPECT_THAT(std::vector<Real>(velocity.begin() + 3, velocity.begin() + 6), ElementsAre(1010.4, 1010.5, 0.0));
}

TEST(Vtkhdf, TheCellsAreWrittenOnceAndEveryStepPointsAtThem)
{
  const test::ScratchFolder folder;
  const Hdf5File file(write_frames(folder.path(), 0, 1), Hdf5File::Mode::read);
  const auto integers = [&](const std::string& name) { return file.read<std::int64_t>("/VTKHDF/" + name); };
  EXPECT_THAT(integers("Connectivity"), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(integers("Offsets"), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(file.read<std::uint8_t>("/VTKHDF/Types"), ElementsAre(1, 1, 1, 1, 1));
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    EXPECT_THAT(integers(name), ElementsAre(5));
  EXPECT_THAT(integers("Steps/NumberOfParts"), ElementsAre(1, 1));
  for (const char* name : {"PartOffsets", "CellOffsets", "ConnectivityIdOffsets"}) {
    EXPECT_THAT(integers(std::string("Steps/") + name), ElementsAre(0, 0));
  }
  EXPECT_THAT(file.shape("/VTKHDF/Steps/CellOffsets"), ElementsAre(2, 1));
  EXPECT_THAT(integers("Steps/PointOffsets"), ElementsAre(0, 5));
  EXPECT_THAT(integers("Steps/PointDataOffsets/stress"), ElementsAre(0, 5));
  EXPECT_THAT(integers("Steps/PointDataOffsets/id"), ElementsAre(0, 0));
  EXPECT_THAT(integers("PointData/id"), ElementsAre(0, 1, 2, 3, 4));
}

TEST(Vtkhdf, EveryFieldSaysItsUnitAndComponents)
{
  const test::ScratchFolder folder;
  const Hdf5File file(write_frames(folder.path(), 0, 0), Hdf5File::Mode::read);
  EXPECT_EQ(file.text("/VTKHDF/PointData/stress", "unit"), "Pa");
  EXPECT_EQ(file.text("/VTKHDF/PointData/stress", "components"), "xx yy zz xy");
  EXPECT_EQ(file.text("/VTKHDF/PointData/velocity", "unit"), "m/s");
  EXPECT_EQ(file.text("/VTKHDF/Points", "unit"), "m");
  EXPECT_EQ(file.text("/VTKHDF/Steps/Values", "unit"), "s");
}

TEST(Vtkhdf, TruncatingDropsTheLaterFramesAndAppendingGoesOnThere)
{
  const test::ScratchFolder folder;
  const std::string path = write_frames(folder.path(), 0, 4);
  cut_after(ResultsFile(path), 250, sample_frame(0).fields);  // frames of steps 0, 100, 200 stay
  ResultsFile(path).append(sample_frame(7));
  const Hdf5File file(path, Hdf5File::Mode::read);
  EXPECT_THAT(file.integers("/VTKHDF/Steps", "NSteps"), ElementsAre(4));
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Steps/step"), ElementsAre(0, 100, 200, 700));
  EXPECT_EQ(rows_of_frame(file, "/VTKHDF/PointData/su", 3), sample_frame(7).fields[0].values);
  EXPECT_THAT(file.shape("/VTKHDF/PointData/su"), ElementsAre(20));
}

TEST(Vtkhdf, CountsTheFramesUpToAStep)
{
  const test::ScratchFolder folder;
  EXPECT_EQ(ResultsFile(folder.path() + "/none").count_until(100), 0);
  const ResultsFile results(write_frames(folder.path(), 0, 4));
  EXPECT_EQ(results.count_until(99), 1);
  EXPECT_EQ(results.count_until(100), 2);
  EXPECT_EQ(results.count_until(1000), 5);
}

TEST(Vtkhdf, TheFrameOfTheStepItselfStays)
{
  const test::ScratchFolder folder;
  const std::string path = write_frames(folder.path(), 0, 2);
  cut_after(ResultsFile(path), 100, sample_frame(0).fields);
  EXPECT_THAT(Hdf5File(path, Hdf5File::Mode::read).read<std::int64_t>("/VTKHDF/Steps/step"), ElementsAre(0, 100));
}

TEST(Vtkhdf, AFrameThatWasCutShortIsOverwritten)
{
  const test::ScratchFolder folder;
  const std::string path = write_frames(folder.path(), 0, 1);
  {
    Hdf5File file(path, Hdf5File::Mode::change);  // as if the process had died before NSteps was written
    file.set_integers("/VTKHDF/Steps", "NSteps", {1});
    file.close();
  }
  reserve_space(path, 5000);
  ResultsFile(path).append(sample_frame(3));
  const Hdf5File file(path, Hdf5File::Mode::read);
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Steps/step"), ElementsAre(0, 300));
  EXPECT_EQ(rows_of_frame(file, "/VTKHDF/PointData/su", 1), sample_frame(3).fields[0].values);
}

TEST(Vtkhdf, AFrameOfAnotherRunIsRefused)
{
  const test::ScratchFolder folder;
  const std::string path = write_frames(folder.path(), 0, 0);
  Frame fewer_points = sample_frame(1), other_field = sample_frame(1), other_size = sample_frame(1);
  fewer_points.x.resize(8);
  EXPECT_EQ(file_error_of([&] { ResultsFile(path).append(fewer_points); }),
      "cannot add the frame of step 100 to " + path + ": the file has 5 points, the run 4");
  other_field.fields[0].name = "pore_pressure";
  EXPECT_THAT(
      file_error_of([&] { ResultsFile(path).append(other_field); }), HasSubstr("the file has no field pore_pressure"));
  other_size.fields[0].n_components = 2;
  EXPECT_THAT(file_error_of([&] { ResultsFile(path).append(other_size); }), HasSubstr("field su has another size"));
  other_size.fields.erase(other_size.fields.begin());
  EXPECT_THAT(
      file_error_of([&] { ResultsFile(path).append(other_size); }), HasSubstr("the file has 3 fields, the run 2"));
}

TEST(Vtkhdf, AFullDiskLeavesTheEarlierFramesWhole)
{
  const test::SmallDisk disk(1 << 20);
  if (!disk.is_there()) GTEST_SKIP() << "cannot mount a small disk";
  const std::string path = write_frames(disk.path(), 0, 1);
  disk.fill();
  EXPECT_THAT(file_error_of([&] { ResultsFile(path).append(sample_frame(2)); }),
      testing::AllOf(testing::StartsWith("cannot write " + path), HasSubstr("No space left on device")));
  const Hdf5File file(path, Hdf5File::Mode::read);
  EXPECT_THAT(file.integers("/VTKHDF/Steps", "NSteps"), ElementsAre(2));
  EXPECT_EQ(rows_of_frame(file, "/VTKHDF/PointData/su", 1), sample_frame(1).fields[0].values);
}

TEST(Vtkhdf, EveryFrameThatFittedOnTheDiskIsWhole)
{
  const test::SmallDisk disk(700 << 10);
  if (!disk.is_there()) GTEST_SKIP() << "cannot mount a small disk";
  const std::string path = disk.path() + "/results.vtkhdf";
  ResultsFile results(path);
  int n_frames = 0;
  const auto write_until_full = [&] {
    for (; n_frames < 20000; ++n_frames) results.append(sample_frame(n_frames));
  };
  EXPECT_THAT(file_error_of(write_until_full), HasSubstr("No space left on device"));
  const Hdf5File file(path, Hdf5File::Mode::read);
  ASSERT_GT(n_frames, 1);
  EXPECT_THAT(file.integers("/VTKHDF/Steps", "NSteps"), ElementsAre(n_frames));
  const auto last = static_cast<std::size_t>(n_frames - 1);
  EXPECT_EQ(rows_of_frame(file, "/VTKHDF/PointData/su", 0), sample_frame(0).fields[0].values);
  EXPECT_EQ(rows_of_frame(file, "/VTKHDF/PointData/su", last), sample_frame(n_frames - 1).fields[0].values);
}

/// Reads as VTK's own reader does: where each array of step k begins follows from Steps.
constexpr const char* read_like_vtk = R"(
import h5py, sys
with h5py.File(sys.argv[1]) as file:
    root = file["VTKHDF"]; steps = root["Steps"]
    assert root.attrs["Type"] == b"UnstructuredGrid" and list(root.attrs["Version"]) == [2, 0]
    assert steps.attrs["NSteps"] == 3
    for k in range(3):
        part = steps["PartOffsets"][k]
        n, n_cells = root["NumberOfPoints"][part], root["NumberOfCells"][part]
        first = steps["CellOffsets"][k, 0] + part
        assert list(root["Offsets"][first:first + n_cells + 1]) == [0, 1, 2, 3, 4, 5]
        point = steps["PointOffsets"][k]
        assert list(root["Points"][point + 4]) == [1000.0 * k + 40.1, 1000.0 * k + 40.2, 0.0]
        stress = root["PointData/stress"][steps["PointDataOffsets/stress"][k]:][:n]
        assert list(stress[4]) == [1000.0 * k + 40 + part for part in (0.6, 0.7, 0.8, 0.9)]
        assert list(root["PointData/id"][steps["PointDataOffsets/id"][k]:][:n]) == [0, 1, 2, 3, 4]
    assert root["PointData/stress"].attrs["unit"] == b"Pa"
    assert root["PointData/stress"].compression == "gzip" and root["PointData/stress"].shuffle
)";

TEST(Vtkhdf, H5pyReadsItTheWayVtkDoes)
{
  if (std::system("/usr/bin/python3 -c 'import h5py' 2>/dev/null") != 0) GTEST_SKIP() << "no h5py";
  const test::ScratchFolder folder;
  const std::string path = write_frames(folder.path(), 0, 2);
  write_file_atomically(folder.path() + "/read.py", read_like_vtk);
  EXPECT_EQ(std::system(("/usr/bin/python3 " + folder.path() + "/read.py " + path).c_str()), 0);
}

/// Points first ... first + n - 1 of a frame of five.
Frame part_of(const Frame& whole, std::int64_t first, std::int64_t n)
{
  Frame part = whole;
  const auto cut = [&](std::vector<Real>& values, std::int64_t row) {
    values = std::vector<Real>(values.begin() + first * row, values.begin() + (first + n) * row);
  };
  cut(part.x, 2);
  for (auto& field : part.fields) cut(field.values, field.n_components);
  part.first = first;
  part.n_all = whole.n_points();
  return part;
}

TEST(Vtkhdf, AFrameInPartsIsThatFrame)
{
  const test::ScratchFolder folder;
  const std::string path = folder.path() + "/parts.vtkhdf";
  ResultsFile results(path);
  for (int k = 0; k < 3; ++k)
    for (const auto& [first, n] : {std::pair{0, 2}, {2, 2}, {4, 1}}) {
      results.append(part_of(sample_frame(k), first, n));
      EXPECT_EQ(ResultsFile(path).count_until(1000), k + (first == 4));  // counts when it is whole
    }
  const Hdf5File parts(path, Hdf5File::Mode::read), whole(write_frames(folder.path(), 0, 2), Hdf5File::Mode::read);
  for (const char* name : {"Points", "PointData/su", "PointData/velocity", "PointData/stress", "Steps/Values"})
    EXPECT_EQ(parts.read<Real>(std::string("/VTKHDF/") + name), whole.read<Real>(std::string("/VTKHDF/") + name))
        << name;
  EXPECT_EQ(parts.read<std::int64_t>("/VTKHDF/PointData/id"), whole.read<std::int64_t>("/VTKHDF/PointData/id"));
}

TEST(Vtkhdf, AFrameWhosePartsDoNotAllComeIsNotThere)
{
  const test::ScratchFolder folder;
  const std::string path = write_frames(folder.path(), 0, 0);
  {
    ResultsFile results(path);
    results.append(part_of(sample_frame(1), 0, 3));
  }
  ResultsFile(path).append(sample_frame(1));
  const Hdf5File file(path, Hdf5File::Mode::read);
  EXPECT_EQ(rows_of_frame(file, "/VTKHDF/PointData/su", 1), sample_frame(1).fields[0].values);
  EXPECT_EQ(ResultsFile(path).count_until(1000), 2);
}

}  // namespace
}  // namespace terp
