// mesh.vtkhdf: nodes and cells. What the mesh carries: tests/run/report/mesh_frame_test.cpp, and a run in tests/app.
#include "io/files/mesh_file.hpp"
#include "io/files/samples.hpp"
#include "support/paths.hpp"

namespace mesh_file_test {

TEST(MeshFile, HoldsNodesAndCellsOfTheMesh)
{
  const ScratchFolder folder;
  const std::string path = folder.path() + "/mesh.vtkhdf";
  write_mesh(path, make_rectangle({0.0, 0.0}, {4.0, 1.0}, {2, 1}), "0123456789abcdef");
  const Hdf5File file(path, Hdf5File::Mode::read);
  EXPECT_EQ(file.text("/VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_EQ(file.text("/", "case"), "0123456789abcdef");
  EXPECT_THAT(file.read<Real>("/VTKHDF/Points"), ElementsAre(0, 0, 0, 2, 0, 0, 4, 0, 0, 0, 1, 0, 2, 1, 0, 4, 1, 0));
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Connectivity"), ElementsAre(0, 1, 4, 3, 1, 2, 5, 4));
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/Offsets"), ElementsAre(0, 4, 8));
  EXPECT_THAT(file.read<std::uint8_t>("/VTKHDF/Types"), ElementsAre(9, 9));
  EXPECT_THAT(file.read<std::int64_t>("/VTKHDF/NumberOfConnectivityIds"), ElementsAre(8));
  const Mesh<2> mesh = read_mesh(path);
  EXPECT_EQ(mesh.nodes.back(), (Vec<2>{4.0, 1.0}));
  EXPECT_THAT(mesh.cells[1], ElementsAre(1, 2, 5, 4));
  EXPECT_EQ(mesh.neighbours[0][1], 1);
}

}  // namespace mesh_file_test
