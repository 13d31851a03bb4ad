#include "io/case/mesh_kinds.hpp"
#include "io/case/keys.hpp"
#include "support/test.hpp"

namespace mesh_kinds_test {

MeshKind kind_of(const std::string& keys) { return mesh_kind_of(parse_toml(keys)).kind; }

TEST(MeshKinds, StandInTheOrderOfTheEnum)
{
  for (std::size_t k = 0; k < all_mesh_kinds().size(); ++k)
    EXPECT_EQ(static_cast<std::size_t>(all_mesh_kinds()[k].kind), k);
  EXPECT_EQ(all_mesh_kinds().size(), 5u);
}

TEST(MeshKinds, FollowFromTheKeysThatAreGiven)
{
  EXPECT_EQ(kind_of("size = [1, 1]\ncell = 1"), MeshKind::rectangle);
  EXPECT_EQ(kind_of(""), MeshKind::rectangle);
  EXPECT_EQ(kind_of("size = [1, 1]\ncells = 1"), MeshKind::graded);
  EXPECT_EQ(kind_of("sides = {}\ncells = 1"), MeshKind::mapped);
  EXPECT_EQ(kind_of("polygon = []\ncell = 1"), MeshKind::polygon);
  EXPECT_EQ(kind_of("file = \"a.msh\""), MeshKind::file);
}

TEST(MeshKinds, TakeEveryKeyOfTheSection)
{
  for (const std::string& key : names_in_section("mesh")) {
    const auto takes = [&](const MeshKindInfo& info) { return is_allowed(info, key); };
    EXPECT_TRUE(std::any_of(all_mesh_kinds().begin(), all_mesh_kinds().end(), takes)) << key;
  }
  for (const MeshKindInfo& info : all_mesh_kinds())
    for (const std::string& key : info.needed)
      EXPECT_TRUE(key == "sides" || !find_key("mesh." + key)->required_for.empty()) << key;
}

TEST(MeshKinds, AreListedWithTheirKeys)
{
  EXPECT_EQ(mesh_kinds_text("- "),
      "- size, cell (origin): a rectangle of equal cells\n"
      "- size, cells (grading, origin): a graded rectangle\n"
      "- sides, cells (grading): a grid between four sides\n"
      "- file: a mesh from a file\n"
      "- polygon, cell (edges, refine, follow_bodies, variant): a mesh from a polygon");
}

TEST(MeshKinds, KnowTheNamesOfTheirSides)
{
  const auto sides = [](const std::string& mesh) { return sides_of_mesh(parse_toml("[mesh]\n" + mesh)); };
  EXPECT_THAT(*sides("size = [1, 1]"), ElementsAre("left", "right", "bottom", "top"));
  EXPECT_THAT(*sides("sides = {}"), ElementsAre("left", "right", "bottom", "top"));
  EXPECT_THAT(*sides("polygon = []\nedges = { base = [0], slope = [1] }"), ElementsAre("base", "slope"));
  EXPECT_THAT(*sides("polygon = []"), ElementsAre());
  EXPECT_FALSE(sides("file = \"a.msh\"").has_value());
}

}  // namespace mesh_kinds_test
