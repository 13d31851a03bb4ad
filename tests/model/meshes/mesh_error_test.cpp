#include "model/meshes/mesh_error.hpp"
#include "support/test.hpp"

namespace mesh_error_test {

Mesh<2> one_cell() { return make_rectangle({0.5, 0.0}, {1.0, 2.0}, {1, 1}); }

TEST(PlaceText, IsToTheMillimetreFarFromTheOrigin)
{
  EXPECT_EQ(place_text({121300.25, 487012.3456}), "(121300.25, 487012.346)");
  EXPECT_EQ(place_text({0.0, -3.0}), "(0, -3)");
  EXPECT_EQ(place_text({1.0 / 3.0, 0.0012345678}), "(0.333333, 0.00123457)");
  EXPECT_EQ(coordinate_text(1e30), "1e+30");
  EXPECT_EQ(coordinate_text(NAN), "nan");
}

TEST(MeshNames, AreTheMeshsOwnWithoutAFile)
{
  EXPECT_EQ(cell_name(one_cell(), 0), "cell 0");
  EXPECT_EQ(node_name(one_cell(), 3), "node 3 at (1.5, 2) m");
  EXPECT_EQ(corner_names(one_cell(), 0), "nodes 0 at (0.5, 0), 1 at (1.5, 0), 3 at (1.5, 2), 2 at (0.5, 2) m");
}

TEST(MeshNames, AreTheFilesWhereThereIsOne)
{
  Mesh<2> mesh = one_cell();
  mesh.cell_numbers = {412};
  mesh.node_numbers = {7, 8, 9, 10};
  EXPECT_EQ(cell_name(mesh, 0), "cell 0 (element 412 of the file)");
  EXPECT_EQ(node_name(mesh, 3), "node 10 at (1.5, 2) m");
  EXPECT_EQ(corner_names(mesh, 0), "nodes 7 at (0.5, 0), 8 at (1.5, 0), 10 at (1.5, 2), 9 at (0.5, 2) m");
}

TEST(MeshFaults, StopOnlyIfThereAreAny)
{
  MeshFaults faults("the mesh");
  EXPECT_TRUE(faults.empty());
  EXPECT_NO_THROW(faults.stop_if_any());
  faults.add("a", "", "");
  EXPECT_FALSE(faults.empty());
  EXPECT_THROW(faults.stop_if_any(), MeshError);
}

TEST(MeshFaults, SayEachAdviceOnceAndCountWhatIsNotShown)
{
  MeshFaults faults("the file");
  for (int k = 0; k < 12; ++k) faults.add("fault " + std::to_string(k), k == 0 ? "here" : "", "Mend it.");
  faults.count_more(3);
  EXPECT_EQ(refusal<MeshError>([&] { faults.stop_if_any(); }),
      "the file has 15 faults:\n  fault 0\n    here\n  fault 1\n  fault 2\n  fault 3\n  fault 4\n  fault 5\n  fault 6\n"
      "  fault 7\n  fault 8\n  fault 9\n  and 5 more\n  Mend it.");
}

TEST(MeshFaults, StopAtTheThousandth)
{
  MeshFaults faults("the mesh");
  for (int k = 0; k < 999; ++k) faults.add("fault", "", "");
  EXPECT_THAT(refusal<MeshError>([&] { faults.add("fault", "", ""); }),
      StartsWith("the mesh has 1000 faults or more:\n  fault\n"));
}

}  // namespace mesh_error_test
