#include "model/meshes/check_mesh.hpp"
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

struct WrongMesh {
  void (*change)(Mesh<2>&);
  std::vector<std::string> words;
};

const WrongMesh wrong_meshes[] = {
    {[](Mesh<2>& mesh) {
       mesh.cells[1] = {1, 4, 5, 2};
     },
        {"the mesh has 1 fault:\n  cell 1 is inverted, its nodes run clockwise: detJ = -0.25 m^2 at node 1 at (1, 0) "
         "m\n"
         "    nodes 1 at (1, 0), 4 at (1, 1), 5 at (2, 1), 2 at (2, 0) m\n"
         "  The nodes of a cell run counter-clockwise. A surface drawn the other way round, all its cells clockwise, "
         "is "
         "turned; among others such a cell is folded over. In gmsh: move its nodes, optimise the mesh, or use a "
         "smaller "
         "element size there. In a file written by a program: give its nodes in the other order."}},
    {[](Mesh<2>& mesh) {  // the numbers of a file
       mesh.cells[1] = {1, 4, 5, 2};
       mesh.cell_numbers = {70, 80};
       mesh.node_numbers = {10, 11, 12, 13, 14, 15};
     },
        {"cell 1 (element 80 of the file) is inverted", "at node 11 at (1, 0) m",
            "nodes 11 at (1, 0), 14 at (1, 1), 15 at (2, 1), 12 at (2, 0) m"}},
    {[](Mesh<2>& mesh) {
       mesh.nodes[4] = {1.6, 0.4};
     },
        {"cell 1 is not convex: detJ = -0.05 m^2 at node 4 at (1.6, 0.4) m"}},
    {[](Mesh<2>& mesh) {
       mesh.cells[0] = {0, 4, 1, 3};
     },
        {"cell 0 crosses itself"}},
    {[](Mesh<2>& mesh) {
       mesh.nodes[4] = {0.5, 0.5};
     },
        {"cell 0 is degenerate, a corner is straight: detJ = 0 m^2 at node 4 at (0.5, 0.5) m"}},
    {[](Mesh<2>& mesh) {
       for (auto& x : mesh.nodes) x[1] *= 1e-7;
     },
        {"cell 1 is degenerate: two of its nodes lie at one place"}},
    {[](Mesh<2>& mesh) {
       mesh.cells[1] = {1, 2, 5, 5};
     },
        {"cell 1 is degenerate: it names a node twice"}},
    {[](Mesh<2>& mesh) {
       mesh.nodes[5] = {1.0, 1.0 + 1e-8};
     },
        {"cell 1 is degenerate: two of its nodes lie at one place"}},
    {[](Mesh<2>& mesh) {
       mesh.cells.push_back({4, 3, 0, 1});
     },
        {"the mesh has 1 fault:\n  cell 0 and cell 2 have the same nodes\n"
         "    nodes 4 at (1, 1), 3 at (0, 1), 0 at (0, 0), 1 at (1, 0) m\n"
         "  Remove one of the two. In gmsh: Tools menu, Remove duplicate elements; look for two surfaces at one "
         "place."}},
    {[](Mesh<2>& mesh) {
       mesh.nodes.insert(mesh.nodes.end(), {{3.0, -1.0}, {3.0, 3.0}});
       mesh.cells.push_back({1, 6, 7, 4});
     },
        {"a side is shared by 3 cells: cell 0, cell 1, cell 2\n    node 1 at (1, 0) m, node 4 at (1, 1) m",
            "A side belongs to one or two cells."}},
    {[](Mesh<2>& mesh) {  // a clockwise cell of a file, turned round, lies over its neighbour
       mesh.nodes[2] = {0.2, 0.1}, mesh.nodes[5] = {0.2, 0.9};
       mesh.cells[1] = {1, 4, 5, 2};
     },
        {"cell 0 and cell 1 lie on the same side of their common side\n    node 1 at (1, 0) m, node 4 at (1, 1) m",
            "The mesh is folded there"}},
    {[](Mesh<2>& mesh) {
       mesh.nodes.insert(mesh.nodes.end(), {{1.0, 0.4}, {2.0, 0.4}});
       mesh.cells[1] = {1, 2, 7, 6};
       mesh.cells.push_back({6, 7, 5, 4});
     },
        {"the mesh has 1 fault:\n  cell 0 has a hanging node inside a side\n"
         "    node 6 at (1, 0.4) m lies between node 1 at (1, 0) m and node 4 at (1, 1) m\n"
         "  Cells must meet side to side. Two surfaces that touch must share their curve and its nodes. In gmsh: "
         "`Coherence;` in the .geo file before meshing, or `Coherence Mesh;` after it (Tools menu: Remove duplicate "
         "nodes)."}},
    {[](Mesh<2>& mesh) {
       mesh.nodes.insert(mesh.nodes.end(), {{1.0, 0.0}, {1.0, 1.0 + 1e-9}});
       mesh.cells[1] = {6, 2, 5, 7};
     },
        {"the mesh has 2 faults:\n  two nodes lie at one place\n    node 1 at (1, 0) m, node 6 at (1, 0) m\n",
            "    node 4 at (1, 1) m, node 7 at (1, 1) m\n", "`Coherence Mesh;`"}},
    {[](Mesh<2>& mesh) { mesh.cells[1][2] = 6; }, {"cell 1 names node 6, of 6"}},
    {[](Mesh<2>& mesh) {
       mesh.nodes[3] = {0.0, NAN};
     },
        {"a coordinate is not a length that Terp can use\n    node 3 at (0, nan) m"}},
    {[](Mesh<2>& mesh) {
       mesh.nodes[3] = {0.0, 1e12};
     },
        {"node 3 at (0, 1e+12) m\n  Coordinates are in metres, finite, at most 1e+09 m."}},
    {[](Mesh<2>& mesh) { mesh = {}; }, {"the mesh has 1 fault:\n  it has no cells"}},
};

TEST(CheckMesh, RefusesWhatIsNoMesh)
{
  for (const auto& [change, words] : wrong_meshes) {
    Mesh<2> mesh = two_squares();
    change(mesh);
    for (const std::string& part : words) EXPECT_THAT(refusal_of(mesh), HasSubstr(part));
  }
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

TEST(CheckMesh, ListsFaultsOfSeveralKindsAtOnce)
{
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {5.0, 1.0}, {5, 1});
  mesh.nodes[7] = {1.7, 0.4};
  mesh.cells.push_back(mesh.cells[3]);
  EXPECT_THAT(refusal_of(mesh),
      AllOf(HasSubstr("2 faults"), HasSubstr("not convex"), HasSubstr("cell 3 and cell 5 have the same nodes")));
}

TEST(CheckMesh, ListsTenOfManyFaults)
{
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {5.0, 3.0}, {5, 3});
  for (auto& cell : mesh.cells) std::swap(cell[1], cell[3]);
  const std::string text = refusal_of(mesh);
  EXPECT_THAT(text, AllOf(HasSubstr("15 faults"), HasSubstr("cell 9 is inverted"), HasSubstr("\n  and 5 more\n")));
  EXPECT_THAT(text, Not(HasSubstr("cell 10 is")));
}

}  // namespace check_mesh_test
