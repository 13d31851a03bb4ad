#include "import/drawing/dxf_file.hpp"
#include "math/errors.hpp"
#include "support/test.hpp"
#include <numbers>

namespace dxf_file_test {

std::string drawing(const std::string& entities, const std::string& header = "")
{
  return "999\nmade by hand\n0\nSECTION\n2\nHEADER\n" + header + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
         "0\nENDSEC\n0\nEOF\n";
}

constexpr const char* line = "0\nLINE\n5\n1A\n8\nclay\n10\n1.5\n20\n2.0\n30\n0.0\n11\n4.0\n21\n-3.0\n31\n0.0\n";
constexpr const char* polyline =
    "0\nLWPOLYLINE\n5\n2B\n8\nsand\n90\n3\n70\n1\n43\n0.0\n10\n0.0\n20\n0.0\n10\n4.0\n20\n0.0\n10\n4.0\n20\n3.0\n";

TEST(Dxf, ReadsLinesAndPolylines)
{
  const auto read = read_dxf_text("d.dxf", drawing(std::string(line) + polyline, "9\n$INSUNITS\n70\n6\n"));
  ASSERT_EQ(read.lines.size(), 2u);
  EXPECT_EQ(read.lines[0].layer, "clay");
  EXPECT_THAT(read.lines[0].places, ElementsAre(Vec<2>{1.5, 2.0}, Vec<2>{4.0, -3.0}));
  EXPECT_FALSE(read.lines[0].closed);
  EXPECT_TRUE(read.lines[1].closed);
  EXPECT_EQ(read.lines[1].handle, "2B");
  EXPECT_EQ(read.lines[1].places.size(), 3u);
  EXPECT_THAT(read.notes, ElementsAre("The unit of the drawing is m."));
}

TEST(Dxf, ReadsOldPolylinesAndLinesEndingInReturn)
{
  std::string text = drawing(
      "  0\nPOLYLINE\n8\nsand\n66\n1\n10\n0\n20\n0\n70\n0\n0\nVERTEX\n10\n1\n20\n2\n0\nVERTEX\n"
      "10\n3\n20\n2\n0\nVERTEX\n10\n3\n20\n5\n0\nVERTEX\n10\n1\n20\n2\n0\nSEQEND\n8\nsand\n");
  for (std::size_t k = 0; (k = text.find('\n', k)) != std::string::npos; k += 2) text.replace(k, 1, "\r\n");
  const auto read = read_dxf_text("d.dxf", text);
  ASSERT_EQ(read.lines.size(), 1u);
  EXPECT_TRUE(read.lines[0].closed);  // its last place is its first
  EXPECT_EQ(read.lines[0].places.size(), 3u);
}

TEST(Dxf, TurnsUnitsIntoMetres)
{
  const auto first = [](const std::string& header, Real unit) {
    return read_dxf_text("d.dxf", drawing(line, header), unit).lines[0].places[0][0];
  };
  EXPECT_DOUBLE_EQ(first("9\n$INSUNITS\n70\n4\n", 0.0), 1.5e-3);
  EXPECT_DOUBLE_EQ(first("9\n$INSUNITS\n70\n0\n", 0.0), 1.5);
  EXPECT_DOUBLE_EQ(first("9\n$INSUNITS\n70\n4\n", dxf_unit("cm")), 1.5e-2);
  EXPECT_EQ(dxf_unit("mile"), 0.0);
}

TEST(Dxf, PassesOverAByteOrderMarkAndCommentsAnywhere)
{
  std::string text = "\xEF\xBB\xBF" + drawing(std::string(line) + polyline);
  for (const char* at : {"0\nSECTION\n2\nENT", "8\nsand", "0\nENDSEC\n0\nEOF"})
    text.insert(text.find(at), "999\nhello\n");
  EXPECT_EQ(read_dxf_text("d.dxf", text).lines.size(), 2u);
}

Real area_of(const DxfLine& line)
{
  Real sum = 0.0;
  for (std::size_t k = 0; k < line.places.size(); ++k) {
    const Vec<2> a = line.places[k], b = line.places[(k + 1) % line.places.size()];
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return sum;
}

TEST(Dxf, CountsWhatBoundsNothing)
{
  const auto read = read_dxf_text(
      "d.dxf", drawing(std::string(polyline) +
                       "0\nTEXT\n8\nnotes\n10\nabc\n0\nTEXT\n8\nnotes\n0\nCIRCLE\n8\nmarks\n10\n1\n20\n1\n40\n1\n"));
  EXPECT_EQ(read.lines.size(), 1u);
  EXPECT_THAT(read.notes, Contains("Bounds no region: 1 CIRCLE on marks, 2 TEXT on notes."));
}

TEST(Dxf, MakesChordsOfBentSides)
{
  const std::string half = "0\nLWPOLYLINE\n8\na\n70\n1\n10\n0\n20\n0\n42\n1\n10\n20\n20\n0\n";  // a half circle below
  const DxfLine bent = read_dxf_text("d.dxf", drawing(half)).lines[0];
  EXPECT_NEAR(area_of(bent), 50.0 * std::numbers::pi, 0.3);
  for (const Vec<2>& x : bent.places) EXPECT_NEAR(std::hypot(x[0] - 10.0, x[1]), 10.0, 1e-9);
  const std::string arc = "0\nARC\n8\na\n10\n0\n20\n0\n40\n10\n50\n270\n51\n90\n";
  const DxfLine right = read_dxf_text("d.dxf", drawing(arc)).lines[0];
  EXPECT_FALSE(right.closed);
  EXPECT_NEAR(right.places.front()[1], -10.0, 1e-9);
  EXPECT_NEAR(right.places.back()[1], 10.0, 1e-9);
  EXPECT_NEAR(area_of(right), 50.0 * std::numbers::pi, 0.3);
  // A parabola as a spline of degree 2 with control points 0,0 5,10 10,0: y = 2 x (10 - x) / 10 / 2.
  const std::string spline =
      "0\nSPLINE\n8\na\n70\n8\n71\n2\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n10\n0\n20\n0\n10\n5\n20\n10\n10\n10\n20"
      "\n0\n";
  const DxfLine parabola = read_dxf_text("d.dxf", drawing(spline)).lines[0];
  EXPECT_GT(parabola.places.size(), 8u);
  for (const Vec<2>& x : parabola.places) EXPECT_NEAR(x[1], 0.2 * x[0] * (10.0 - x[0]), 1e-9);
}

TEST(Dxf, PutsBlocksWhereTheyAreInserted)
{
  const std::string blocks =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nINNER\n10\n1\n20\n0\n0\nLINE\n8\n0\n10\n1\n20\n0\n11\n2\n21\n0\n0\nENDBLK\n"
      "0\nBLOCK\n2\nOUTER\n10\n0\n20\n0\n0\nINSERT\n8\n0\n2\nINNER\n10\n3\n20\n0\n0\nENDBLK\n0\nENDSEC\n";
  std::string text = drawing("0\nINSERT\n8\nclay\n2\nOUTER\n10\n10\n20\n0\n41\n-2\n42\n2\n50\n90\n");
  text.insert(text.find("0\nSECTION\n2\nENT"), blocks);
  const auto read = read_dxf_text("d.dxf", text);
  ASSERT_EQ(read.lines.size(), 1u);
  EXPECT_EQ(read.lines[0].layer, "clay");
  // (3, 0) to (4, 0), mirrored and doubled to (-6, 0) and (-8, 0), turned to (0, -6) and (0, -8), moved by 10.
  EXPECT_NEAR(read.lines[0].places[0][0], 10.0, 1e-12);
  EXPECT_NEAR(read.lines[0].places[0][1], -6.0, 1e-12);
  EXPECT_NEAR(read.lines[0].places[1][1], -8.0, 1e-12);
}

TEST(Dxf, LeavesOutLayersThatAreNotShownOrNotChosen)
{
  std::string text = drawing(std::string(line) + polyline);
  text.insert(text.find("0\nSECTION\n2\nENT"),
      "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nclay\n70\n0\n62\n-3\n0\nENDTAB\n0\nENDSEC\n");
  const auto shown = read_dxf_text("d.dxf", text);
  ASSERT_EQ(shown.lines.size(), 1u);
  EXPECT_EQ(shown.lines[0].layer, "sand");
  EXPECT_THAT(shown.notes, Contains("Layers left out: clay (off)."));
  const auto chosen = read_dxf_text("d.dxf", text, 0.0, {"clay"});
  ASSERT_EQ(chosen.lines.size(), 1u);
  EXPECT_EQ(chosen.lines[0].layer, "clay");
  EXPECT_THAT(chosen.notes, Contains("Layers left out: sand."));
  EXPECT_THAT(refusal<InputError>([&] { read_dxf_text("d.dxf", text, 0.0, {"peat"}); }),
      HasSubstr("has nothing on a layer `peat`"));
}

TEST(Dxf, ReadsWhatItWrites)
{
  const std::vector<DxfLine> lines{
      {"dike core", {{0, 0}, {4.25, 0}, {4, 3.125}}, true, ""}, {"ground", {{0, 1}, {100000.123456, 2}}, false, ""}};
  const auto read = read_dxf_text("d.dxf", dxf_text(lines));
  ASSERT_EQ(read.lines.size(), 2u);
  EXPECT_EQ(read.lines[0].layer, "dike_core");
  EXPECT_TRUE(read.lines[0].closed);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(read.lines[k].places, lines[k].places);
}

}  // namespace dxf_file_test
