#include "model/meshes/check_mesh.hpp"
#include "support/golden.hpp"
#include "support/meshes.hpp"

namespace check_mesh_test {

std::string refusal_of(const Mesh<2>& mesh)
{
  return refusal<MeshError>([&] { check_mesh(mesh); });
}

/// Nodes 3-4-5 above 0-1-2: two unit squares side by side.
Mesh<2> two_squares()
{
  Mesh<2> mesh;
  mesh.nodes = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {2.0, 1.0}};
  mesh.cells = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  return mesh;
}

TEST(CheckMesh, AcceptsWhatTerpMakesItself)
{
  EXPECT_EQ(refusal_of(two_squares()), "");
  EXPECT_EQ(refusal_of(make_rectangle({-3.0, 100.0}, {7.0, 0.001}, {40, 30})), "");
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    EXPECT_EQ(refusal_of(distorted_rectangle(12, 8, 0.1, 0.35, seed)), "");
}

TEST(CheckMesh, AcceptsCellsThatTouchInOneNodeAndPartsThatDoNotTouch)
{
  Mesh<2> mesh;
  mesh.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}, {7, 0}, {8, 0}, {8, 1}, {7, 1}};
  mesh.cells = {{0, 1, 2, 3}, {2, 4, 5, 6}, {7, 8, 9, 10}};
  EXPECT_EQ(refusal_of(mesh), "");
}

void (*const wrong_meshes[])(Mesh<2>&) = {
    [](Mesh<2>& mesh) {
      mesh.cells[1] = {1, 4, 5, 2};
    },
    [](Mesh<2>& mesh) {
      mesh.cells[1] = {1, 4, 5, 2};
      mesh.cell_numbers = {70, 80};
      mesh.node_numbers = {10, 11, 12, 13, 14, 15};
    },
    [](Mesh<2>& mesh) {
      mesh.nodes[4] = {1.6, 0.4};
    },
    [](Mesh<2>& mesh) {
      mesh.cells[0] = {0, 4, 1, 3};
    },
    [](Mesh<2>& mesh) {
      mesh.nodes[4] = {0.5, 0.5};
    },
    [](Mesh<2>& mesh) {
      for (auto& x : mesh.nodes) x[1] *= 1e-7;
    },
    [](Mesh<2>& mesh) {
      mesh.cells[1] = {1, 2, 5, 5};
    },
    [](Mesh<2>& mesh) {
      mesh.nodes[5] = {1.0, 1.0 + 1e-8};
    },
    [](Mesh<2>& mesh) {
      mesh.cells.push_back({4, 3, 0, 1});
    },
    [](Mesh<2>& mesh) {
      mesh.nodes.insert(mesh.nodes.end(), {{3.0, -1.0}, {3.0, 3.0}});
      mesh.cells.push_back({1, 6, 7, 4});
    },
    [](Mesh<2>& mesh) {
      mesh.nodes[2] = {0.2, 0.1}, mesh.nodes[5] = {0.2, 0.9};
      mesh.cells[1] = {1, 4, 5, 2};
    },
    [](Mesh<2>& mesh) {
      mesh.nodes.insert(mesh.nodes.end(), {{1.0, 0.4}, {2.0, 0.4}});
      mesh.cells[1] = {1, 2, 7, 6};
      mesh.cells.push_back({6, 7, 5, 4});
    },
    [](Mesh<2>& mesh) {
      mesh.nodes.insert(mesh.nodes.end(), {{1.0, 0.0}, {1.0, 1.0 + 1e-9}});
      mesh.cells[1] = {6, 2, 5, 7};
    },
    [](Mesh<2>& mesh) { mesh.cells[1][2] = 6; },
    [](Mesh<2>& mesh) {
      mesh.nodes[3] = {0.0, NAN};
    },
    [](Mesh<2>& mesh) {
      mesh.nodes[3] = {0.0, 1e12};
    },
    [](Mesh<2>& mesh) { mesh = {}; },
    [](Mesh<2>& mesh) {
      mesh = make_rectangle({0.0, 0.0}, {5.0, 1.0}, {5, 1});
      mesh.nodes[7] = {1.7, 0.4};
      mesh.cells.push_back(mesh.cells[3]);
    },
    [](Mesh<2>& mesh) {
      mesh = make_rectangle({0.0, 0.0}, {5.0, 3.0}, {5, 3});
      for (auto& cell : mesh.cells) std::swap(cell[1], cell[3]);
    },
};

TEST(CheckMesh, RefusesWhatIsNoMeshInTheWordsOfTheGoldenText)
{
  std::string all;
  for (const auto& change : wrong_meshes) {
    Mesh<2> mesh = two_squares();
    change(mesh);
    all += refusal_of(mesh) + "\n\n";
  }
  expect_golden("tests/model/meshes/faults.txt", all);
}

TEST(CheckMesh, JudgesShapeWithoutRegardToSize)
{
  for (const Real scale : {1e-6, 1.0, 1e6}) {
    Mesh<2> mesh = two_squares();
    mesh.nodes[4] = {0.5 + 1e-4, 0.5 + 1e-4};  // almost straight: slow, but it works
    for (auto& x : mesh.nodes)
      for (Real& value : x) value *= scale;
    EXPECT_EQ(refusal_of(mesh), "") << scale;
  }
}

TEST(CheckMesh, AllowsANarrowGap)
{
  Mesh<2> mesh = two_squares();
  mesh.nodes.insert(mesh.nodes.end(), {{1.00001, 0.0}, {1.00001, 1.0}});
  mesh.cells[1] = {6, 2, 5, 7};
  EXPECT_EQ(refusal_of(mesh), "");
}

TEST(CheckMesh, RefusesMeshesLaidOverEachOther)
{
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {4.0, 4.0}, {4, 4});
  const Mesh<2> other = make_rectangle({2.77, 1.13}, {4.0, 4.0}, {4, 4});
  const Index n = mesh.n_nodes();
  mesh.nodes.insert(mesh.nodes.end(), other.nodes.begin(), other.nodes.end());
  for (auto cell : other.cells) {
    for (Index& i : cell) i += n;
    mesh.cells.push_back(cell);
  }
  EXPECT_THAT(refusal_of(mesh), AllOf(HasSubstr("overlap"), HasSubstr("A place may belong to one cell only.")));
}

}  // namespace check_mesh_test
