// mesh.vtkhdf: nodes and cells once, what they carry frame after frame.
#include "output/mesh_file.hpp"

#include "output/hdf5_file.hpp"
#include "output/samples.hpp"
#include "support/paths.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using test::cut_after;
using testing::ElementsAre;

/// Two cells of 2 m by 1 m side by side.
Mesh<2> two_cells() { return make_rectangle({0.0, 0.0}, {4.0, 1.0}, {2, 1}); }

/// Values of six nodes and two cells with no two equal numbers.
MeshFrame sample(int k)
{
  MeshFrame frame{
      .time = 0.1 * k, .step = 100 * k, .mass = {}, .velocity = {}, .pressure = {10.0 * k + 0.5, 10.0 * k + 0.75}};
  for (int i = 0; i < 6; ++i) {
    frame.mass.push_back(100.0 * k + i);
    frame.velocity.insert(frame.velocity.end(), {100.0 * k + i + 0.1, 100.0 * k + i + 0.2});
  }
  return frame;
}

/// A mesh file with frames 0 ... last.
std::string write_frames(const std::string& folder, int last)
{
  const std::string path = folder + "/mesh.vtkhdf";
  const MeshFile file(path);
  file.create(two_cells(), true);
  for (int k = 0; k <= last; ++k) file.append(sample(k));
  return path;
}

TEST(MeshFile, HoldsNodesAndCellsOfTheMesh)
{
  const test::ScratchFolder folder;
  const std::string path = folder.path() + "/mesh.vtkhdf";
  MeshFile(path).create(two_cells(), false);
  const Hdf5File file(path, Hdf5File::Mode::read);
  EXPECT_EQ(file.text("/VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_THAT(file.read<Real>("/VTKHDF/Points"), ElementsAre(0, 0, 0, 2, 0, 0, 4, 0, 0, 0, 1, 0, 2, 1, 0, 4, 1, 0));
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Connectivity"), ElementsAre(0, 1, 4, 3, 1, 2, 5, 4));
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Offsets"), ElementsAre(0, 4, 8));
  EXPECT_THAT(file.read<std::uint8_t>("/VTKHDF/Types"), ElementsAre(9, 9));
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/NumberOfConnectivityIds"), ElementsAre(8));
  EXPECT_FALSE(file.exists("/VTKHDF/Steps"));
}

TEST(MeshFile, FramesAreReadBackToTheBit)
{
  const test::ScratchFolder folder;
  const Hdf5File file(write_frames(folder.path(), 2), Hdf5File::Mode::read);
  EXPECT_THAT(file.integers("/VTKHDF/Steps", "NSteps"), ElementsAre(3));
  EXPECT_THAT(file.read<Real>("/VTKHDF/CellData/pressure"), ElementsAre(0.5, 0.75, 10.5, 10.75, 20.5, 20.75));
  const auto mass = file.read<Real>("/VTKHDF/PointData/mass");
  EXPECT_THAT(std::vector<Real>(mass.begin() + 12, mass.end()), ElementsAre(200, 201, 202, 203, 204, 205));
  EXPECT_THAT(file.shape("/VTKHDF/PointData/velocity"), ElementsAre(18, 3));
  const auto velocity = file.read<Real>("/VTKHDF/PointData/velocity");
  EXPECT_THAT(std::vector<Real>(velocity.begin() + 18, velocity.begin() + 24),
      ElementsAre(100.1, 100.2, 0.0, 101.1, 101.2, 0.0));
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Steps/PointOffsets"), ElementsAre(0, 0, 0));
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Steps/PointDataOffsets/velocity"), ElementsAre(0, 6, 12));
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Steps/CellDataOffsets/pressure"), ElementsAre(0, 2, 4));
  EXPECT_EQ(file.text("/VTKHDF/CellData/pressure", "unit"), "Pa");
  EXPECT_EQ(file.text("/VTKHDF/PointData/velocity", "components"), "x y z");
}

TEST(MeshFile, TruncatingDropsTheLaterFramesAndAppendingGoesOnThere)
{
  const test::ScratchFolder folder;
  const std::string path = write_frames(folder.path(), 4);
  const MeshFile mesh(path);
  EXPECT_EQ(mesh.count_until(250), 3);
  cut_after(mesh, 250);  // frames of steps 0, 100, 200 stay
  mesh.append(sample(7));
  const Hdf5File file(path, Hdf5File::Mode::read);
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Steps/step"), ElementsAre(0, 100, 200, 700));
  EXPECT_THAT(file.shape("/VTKHDF/PointData/mass"), ElementsAre(24));
  EXPECT_THAT(
      file.read<Real>("/VTKHDF/CellData/pressure"), ElementsAre(0.5, 0.75, 10.5, 10.75, 20.5, 20.75, 70.5, 70.75));
  EXPECT_THAT(file.shape("/VTKHDF/Points"), ElementsAre(6, 3));
}

TEST(MeshFile, TruncatingToNothingLeavesTheMesh)
{
  const test::ScratchFolder folder;
  const std::string path = write_frames(folder.path(), 1);
  cut_after(MeshFile(path), -1);
  MeshFile(path).append(sample(0));
  const Hdf5File file(path, Hdf5File::Mode::read);
  EXPECT_THAT(file.read<Real>("/VTKHDF/CellData/pressure"), ElementsAre(0.5, 0.75));
  EXPECT_THAT(file.shape("/VTKHDF/Points"), ElementsAre(6, 3));
}

TEST(MeshFile, ThatIsMissingOrHasNoStepsHasNoFrames)
{
  const test::ScratchFolder folder;
  const MeshFile mesh(folder.path() + "/mesh.vtkhdf");
  EXPECT_EQ(mesh.count_until(100), 0);
  EXPECT_EQ(mesh.open_to_cut(), nullptr);
  mesh.create(two_cells(), false);
  EXPECT_EQ(mesh.count_until(100), 0);
  cut_after(mesh, 0);
  EXPECT_EQ(mesh.count_until(100), 0);
}

}  // namespace
}  // namespace terp
