// Every kind of mesh arrives in the case, and keys of [mesh] that are wrong together are named.

#include "input/check_mesh.hpp"

#include "input/samples.hpp"
#include "support/paths.hpp"

#include <gmock/gmock.h>

#include <fstream>

namespace terp {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using namespace test;

const std::string graded = "origin = [-1.0, 2.0]\nsize = [16.0, 3.0]\ncells = [32, 6]\ngrading = [2.0, 0.5]";
const std::string mapped = R"(cells = 8
sides.bottom = [[0, 0], [4, 1], [8, 0]]
sides.right = [[8, 0], [8, 3]]
sides.top = [[0, 3], [8, 3]]
sides.left = [[0, 0], [0, 3]])";
const std::string polygon = R"(polygon = [[0, 0], [8, 0], [8, 1], [4, 3], [0, 3]]
cell = 0.5
edges = { base = [0], slope = [2, 3] }
refine = [
{ line = [[8, 1], [4, 3]], cell = 0.125, distance = 0.5 },
{ box = [[1, 0], [2, 1]], cell = 0.25 }]
follow_bodies = false
variant = 2)";

MeshCase mesh_of(const std::string& keys) { return read_case_text(small_case_on(keys), "case.toml").values.mesh; }

TEST(CheckMesh, ReadsAGradedRectangle)
{
  const MeshCase mesh = mesh_of(graded);
  EXPECT_EQ(mesh.kind, MeshKind::graded);
  EXPECT_EQ(mesh.origin, (Vec<2>{-1.0, 2.0}));
  EXPECT_EQ(mesh.size, (Vec<2>{16.0, 3.0}));
  EXPECT_EQ(mesh.cells, (std::array<Index, 2>{32, 6}));
  EXPECT_EQ(mesh.grading, (Vec<2>{2.0, 0.5}));
  EXPECT_EQ(mesh_of("size = [16.0, 3.0]\ncells = 6").grading, (Vec<2>{1.0, 1.0}));
  EXPECT_EQ(mesh_of("size = [16.0, 3.0]\ncell = 0.5").kind, MeshKind::rectangle);
}

TEST(CheckMesh, ReadsAGridBetweenFourSides)
{
  const MeshCase mesh = mesh_of(mapped);
  EXPECT_EQ(mesh.kind, MeshKind::mapped);
  EXPECT_EQ(mesh.cells, (std::array<Index, 2>{8, 8}));
  EXPECT_THAT(mesh.sides[0], ElementsAre(Vec<2>{0, 0}, Vec<2>{4, 1}, Vec<2>{8, 0}));
  EXPECT_THAT(mesh.sides[1], ElementsAre(Vec<2>{8, 0}, Vec<2>{8, 3}));
  EXPECT_THAT(mesh.sides[2], ElementsAre(Vec<2>{0, 3}, Vec<2>{8, 3}));
  EXPECT_THAT(mesh.sides[3], ElementsAre(Vec<2>{0, 0}, Vec<2>{0, 3}));
}

TEST(CheckMesh, ReadsAPolygon)
{
  const MeshCase mesh = mesh_of(polygon);
  EXPECT_EQ(mesh.kind, MeshKind::polygon);
  EXPECT_EQ(mesh.cell, (Vec<2>{0.5, 0.5}));
  EXPECT_EQ(mesh.polygon.size(), 5u);
  EXPECT_EQ(mesh.polygon[2], (Vec<2>{8, 1}));
  ASSERT_EQ(mesh.edges.size(), 2u);
  EXPECT_EQ(mesh.edges[1].side, "slope");
  EXPECT_THAT(mesh.edges[1].edges, ElementsAre(2, 3));
  EXPECT_FALSE(mesh.follow_bodies);
  EXPECT_EQ(mesh.variant, 2);
}

TEST(CheckMesh, ReadsRefinements)
{
  const MeshCase mesh = mesh_of(polygon);
  ASSERT_EQ(mesh.refine.size(), 2u);
  EXPECT_THAT(mesh.refine[0].line, ElementsAre(Vec<2>{8, 1}, Vec<2>{4, 3}));
  EXPECT_EQ(mesh.refine[0].cell, 0.125);
  EXPECT_EQ(mesh.refine[0].distance, 0.5);
  EXPECT_TRUE(mesh.refine[1].line.empty());
  EXPECT_EQ(mesh.refine[1].low, (Vec<2>{1, 0}));
  EXPECT_EQ(mesh.refine[1].high, (Vec<2>{2, 1}));
  EXPECT_EQ(mesh.refine[1].distance, 0.0);
}

TEST(CheckMesh, ReadsAMeshFileWithSidesThatOnlyTheFileKnows)
{
  const ScratchFolder folder;
  std::ofstream(folder.path() + "/dike.msh");
  const std::string text = small_case_on("file = \"dike.msh\"") + "[boundary]\n\"outer slope\" = \"open\"\n";
  const Case c = read_case_text(text, folder.path() + "/case.toml").values;
  EXPECT_EQ(c.mesh.kind, MeshKind::file);
  EXPECT_EQ(c.mesh.file, "dike.msh");
  EXPECT_EQ(c.sides.at(0).side, "outer slope");
}

TEST(CheckMesh, TurnsAClockwisePolygonWithItsEdges)
{
  const MeshCase mesh = mesh_of(R"(polygon = [[0, 0], [0, 3], [4, 3], [8, 1], [8, 0]]
cell = 0.5
edges = { left = [0], crest = [1], slope = [2], base = [4], right = [3] })");
  const auto ends = [&](int side) {
    const Index k = mesh.edges[side].edges[0];
    return std::pair(mesh.polygon[k], mesh.polygon[(k + 1) % 5]);
  };
  EXPECT_EQ(ends(0), std::pair(Vec<2>({0, 3}), Vec<2>({0, 0})));
  EXPECT_EQ(ends(1), std::pair(Vec<2>({4, 3}), Vec<2>({0, 3})));
  EXPECT_EQ(ends(2), std::pair(Vec<2>({8, 1}), Vec<2>({4, 3})));
  EXPECT_EQ(ends(3), std::pair(Vec<2>({0, 0}), Vec<2>({8, 0})));
  EXPECT_EQ(ends(4), std::pair(Vec<2>({8, 0}), Vec<2>({8, 1})));
}

TEST(CheckMesh, RecordsWhatReadsTheSame)
{
  for (const std::string& keys : {graded, mapped, polygon}) {
    const CaseFile file = read_case_text(small_case_on(keys), "case.toml", {"time.end=3"});
    const MeshCase mesh = file.values.mesh, again = read_case_text(file.text, "case.toml").values.mesh;
    EXPECT_EQ(again.kind, mesh.kind);
    EXPECT_EQ(again.sides, mesh.sides);
    EXPECT_EQ(again.polygon, mesh.polygon);
    EXPECT_EQ(again.variant, mesh.variant);
    EXPECT_EQ(again.refine.size(), mesh.refine.size());
    EXPECT_EQ(again.edges.size(), mesh.edges.size());
  }
}

/// Keys of [mesh] and what the user then reads, the one error that there is.
class WrongMesh : public testing::TestWithParam<Change> {};

TEST_P(WrongMesh, IsRefused)
{
  const auto& [line, instead, message] = GetParam();
  std::string keys = line[0] == 'c' ? mapped : polygon;
  if (line[0] == 's') keys = graded;
  if (line[0] == 'r') keys = "size = [16.0, 3.0]\ncell = 0.5";
  const std::string part = std::string(line).substr(2);
  const std::string seen = message_for(small_case_on(replaced(keys, part, instead)));
  EXPECT_THAT(seen, HasSubstr(message));
  EXPECT_THAT(seen, HasSubstr("1 error; nothing was run.\n"));
}

// "s:", "c:", "p:", "r:": changes of `graded`, `mapped`, `polygon` or the rectangle of small_case.
const Change wrong_meshes[] = {
    {"r:cell", "grading = [1, 2]\ncell",
        "error: case.toml:5:1: `grading` does not belong to a rectangle of equal cells\n\n    5 | grading = [1, 2]\n   "
        "   "
        "| "
        "^^^^^^^\n  Keys that belong together:\n    size, cell (origin): a rectangle of equal cells\n    size, cells "
        "(grading, "
        "origin): a graded rectangle\n    sides, cells (grading): a grid between four sides\n    file: a mesh from a "
        "file\n   "
        " polygon, cell (edges, refine, follow_bodies, variant): a mesh from a polygon\n  More: terp explain mesh\n"},
    {"r:cell", "cells = 4\ncell", "error: case.toml:6:1: `cell` does not belong to a graded rectangle\n"},
    {"r:cell", "edges = { base = [0] }\ncell", "`edges` does not belong to a rectangle of equal cells"},
    {"r:cell", "follow_bodies = true\ncell", "`follow_bodies` does not belong to a rectangle of equal cells"},
    {"p:cell = 0.5", "cell = 0.5\nsize = [16, 3]", "`size` does not belong to a mesh from a polygon"},
    {"p:cell = 0.5",
        "cell = 0.5\nsides = { bottom = [[0, 0], [1, 0]], right = [[1, 0], [1, 1]], top = [[0, 1], [1, 1]], "
        "left = [[0, 0], [0, 1]] }",
        "`sides` does not belong to a mesh from a polygon"},
    {"c:cells = 8", "cells = 8\ncell = 0.5", "`cell` does not belong to a grid between four sides"},
    {"c:cells = 8", "cells = 8\norigin = [0, 0]", "`origin` does not belong to a grid between four sides"},

    {"r:size = [16.0, 3.0]\n", "",
        "error: case.toml:3:2: the key `size` is missing from [mesh]\n\n    3 | [mesh]\n      |  ^^^^\n  Meaning: "
        "width "
        "and "
        "height of a rectangle\n  Allowed: two numbers [x, y], more than 0 m\n  Keys that belong together:\n    size, "
        "cell "},
    {"r:cell = 0.5", "", "the key `cell` is missing from [mesh]\n"},
    {"s:size = [16.0, 3.0]\n", "", "the key `size` is missing from [mesh]\n"},
    {"c:cells = 8\n", "", "the key `cells` is missing from [mesh]\n"},
    {"p:cell = 0.5\n", "", "the key `cell` is missing from [mesh]\n"},
    {"p:edges", "egdes", "Did you mean `edges`?\n"},

    {"s:cells = [32, 6]", "cells = [32, 0]", "Got 0; allowed: at least 1 and at most 100000."},
    {"s:cells = [32, 6]", "cells = [32.5, 6]", "`cells` must be an integer or two integers [nx, ny]"},
    {"s:grading = [2.0, 0.5]", "grading = [2.0, 0.0]", "Got 0; allowed: more than 0."},
    {"s:grading = [2.0, 0.5]", "grading = 2.0", "`grading` must be two numbers [x, y]"},

    {"c:sides.left = [[0, 0], [0, 3]]", "", "the key `left` is missing from [mesh.sides]\n"},
    {"c:sides.left", "sides.lefft", "Did you mean `left`?\n  Keys of [mesh.sides]: bottom, right, top, left\n"},
    {"c:sides.left = [[0, 0], [0, 3]]", "sides.left = [[0, 0]]", "`left` must be at least two places [[x, y], [x, y]]"},
    {"c:sides.left = [[0, 0], [0, 3]]", "sides.left = [[0, 0], [0, 0], [0, 3]]",
        "`left` names the same place twice in a row\n"},
    {"c:sides.left = [[0, 0], [0, 3]]", "sides.left = [[0, 3], [0, 0]]",
        "error: case.toml:8:14: `bottom` and `left` do not meet\n\n    8 | sides.left = [[0, 3], [0, 0]]\n      |      "
        "   "
        "     "
        "^^^^^^^^^^^^^^^^\n  `bottom` starts at (0, 0) m, `left` starts at (0, 3) m.\n  Write bottom and top from left "
        "to "
        "right, "
        "left and right from bottom to top.\n"},
    {"c:[[8, 0], [8, 3]]", "[[8, 0.1], [8, 3]]", "`bottom` and `right` do not meet"},
    {"c:[[0, 3], [8, 3]]", "[[0, 3], [8, 4]]", "`top` ends at (8, 4) m, `right` ends at (8, 3) m."},
    {"c:[[0, 3], [8, 3]]", "[[-1, 3], [8, 3]]", "`top` starts at (-1, 3) m, `left` ends at (0, 3) m."},
    {"c:[[0, 0], [4, 1], [8, 0]]\nsides.right = [[8, 0], [8, 3]]\nsides.top = [[0, 3], [8, 3]]\nsides.left = [[0, 0], "
     "[0, "
     "3]]",
        "[[8, 0], [0, 0]]\nsides.right = [[0, 0], [0, 3]]\nsides.top = [[8, 3], [0, 3]]\nsides.left = [[8, 0], [8, 3]]",
        "the four sides run clockwise\n"},

    {"p:cell = 0.5", "cell = [0.5, 0.25]",
        "error: case.toml:5:8: `cell` must be one number for a mesh from a polygon\n"},
    {"p:[8, 1], [4, 3], [0, 3]]", "[4, 3], [0, 0]]",
        "error: case.toml:4:36: two corners of the polygon are the same\n\n    4 | polygon = [[0, 0], [8, 0], [4, 3], "
        "[0, "
        "0]]\n"
        "      |                                    ^^^^^^\n  Name each corner once; the last edge closes the polygon "
        "by "
        "itself.\n"},
    {"p:[8, 1], [4, 3]", "[4, 3], [8, 1]", "`polygon` crosses itself\n"},
    {"p:[2, 3]", "[2, 7]",
        "error: case.toml:6:35: the polygon has no edge 7\n\n    6 | edges = { base = [0], slope = [2, 7] }\n      | "
        "                                  ^\n  It has 5 corners and so the edges 0 to 4; edge k runs from corner k to "
        "corner k + "
        "1, edge "
        "4 back to corner 0.\n"},
    {"p:[2, 3]", "[2, -1]", "Got -1; allowed: at least 0."},
    {"p:[2, 3]", "[2, 0.5]", "Got the number 0.5; allowed: a table { NAME = [k, ...] }"},
    {"p:[2, 3]", "[2, 0]", "the edge 0 is named twice\n"},
    {"p:[2, 3]", "[2, 0]", "In `base` and in `slope`; an edge is part of one side only.\n"},
    {"p:[2, 3]", "[2, 2]", "Both times in `slope`.\n"},
    {"p:[2, 3]", "[]", "`edges` must be a table { NAME = [k, ...] } of edge numbers\n"},
    {"p:{ base = [0], slope = [2, 3] }", "[0, 1]", "`edges` must be a table { NAME = [k, ...] } of edge numbers\n"},
    {"p:distance = 0.5", "box = [[0, 0], [1, 1]]", "a refinement has either `line` or `box`, not both\n"},
    {"p:box = [[1, 0], [2, 1]], ", "", "error: case.toml:9:1: the refinement has no place\n"},
    {"p:, distance = 0.5", "", "error: case.toml:8:1: a line needs a `distance`\n"},
    {"p:distance = 0.5", "distance = 0", "error: case.toml:8:53: a line needs a `distance`\n"},
    {"p:box = [[1, 0], [2, 1]]", "box = [[2, 0], [1, 1]]", "`box` has no area\n"},
    {"p:, cell = 0.25", "", "the key `cell` is missing from [[mesh.refine]]\n"},
    {"p:cell = 0.25", "cell = 0.25, szie = 1", "Keys of [[mesh.refine]]: line, box, cell, distance\n"},
    {"p:follow_bodies = false", "follow_bodies = 1", "`follow_bodies` must be true or false\n"},
    {"r:cell", "variant = 1\ncell", "`variant` does not belong to a rectangle of equal cells"},
    {"p:variant = 2", "variant = -1", "Got -1; allowed: at least 0.\n"},
    {"p:variant = 2", "variant = 1.5", "Got the number 1.5; allowed: an integer, at least 0.\n"},
};

INSTANTIATE_TEST_SUITE_P(Catalogue, WrongMesh, testing::ValuesIn(wrong_meshes));

TEST(CheckMesh, RefusesAFileBesideARectangle)
{
  EXPECT_THAT(message_for(small_case_on("size = [16.0, 3.0]\ncell = 0.5\nfile = \"a.msh\"")),
      HasSubstr("error: case.toml:4:1: `size`, `cell` do not belong to a mesh from a file\n"));
}

TEST(CheckMesh, RefusesARefinementThatIsNoListOfTables)
{
  EXPECT_THAT(message_for(small_case_on("polygon = [[0, 0], [1, 0], [0, 1]]\ncell = 0.5\nrefine = { cell = 1 }")),
      HasSubstr("`refine` must be a list of tables\n\n    6 | refine = { cell = 1 }\n      | ^^^^^^\n  Write "
                "[[mesh.refine]], with two brackets, above each one.\n"));
}

TEST(CheckMesh, TakesARefinementBelowItsOwnHeader)
{
  const MeshCase mesh = mesh_of(
      "polygon = [[0, 0], [1, 0], [0, 1]]\ncell = 0.5\n[[mesh.refine]]\nbox = [[0, 0], [0.5, 0.5]]\ncell = 0.1");
  ASSERT_EQ(mesh.refine.size(), 1u);
  EXPECT_EQ(mesh.refine[0].cell, 0.1);
}

TEST(CheckMesh, DoubtsARefinementThatRefinesNothing)
{
  const std::string seen = message_for(small_case_on(replaced(polygon, "cell = 0.25", "cell = 0.75")));
  EXPECT_THAT(seen, StartsWith("accepted\nwarning: case.toml:9:34: the refinement has no effect\n"));
  EXPECT_THAT(seen, HasSubstr("Its cells of 0.75 m are not smaller than mesh.cell = 0.5 m.\n"));
}

TEST(CheckMesh, TakesOnlySidesThatAPolygonNames)
{
  const std::string head = "[boundary]\nslop = \"roller\"\n";
  EXPECT_THAT(message_for(head + small_case_on(polygon)),
      HasSubstr("error: case.toml:2:1: unknown key `slop`\n\n    2 | slop = \"roller\"\n      | ^^^^\n  Did you mean "
                "`slope`?\n  Keys of [boundary]: base, slope\n"));
  EXPECT_THAT(message_for(head + small_case_on("polygon = [[0, 0], [1, 0], [0, 1]]\ncell = 0.5")),
      HasSubstr("No side of this mesh has a name. Name them as in edges = { base = [0] } in [mesh].\n"));
  EXPECT_EQ(message_for("[boundary]\nslope = \"roller\"\n" + small_case_on(polygon)), "accepted\n");
}

TEST(CheckMesh, TakesTheFourSidesOfEveryGrid)
{
  const std::string head = "[boundary]\nright = \"open\"\n";
  EXPECT_EQ(message_for(head + small_case_on(graded)), "accepted\n");
  EXPECT_EQ(message_for(head + small_case_on(mapped)), "accepted\n");
  EXPECT_THAT(
      message_for("[boundary]\nrigth = \"open\"\n" + small_case_on(mapped)), HasSubstr("Did you mean `right`?"));
}

}  // namespace
}  // namespace terp
