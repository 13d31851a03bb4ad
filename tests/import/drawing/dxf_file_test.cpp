#include "import/drawing/dxf_file.hpp"
#include "math/errors.hpp"
#include "support/test.hpp"

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
