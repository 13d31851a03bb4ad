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

std::string refused(const std::string& text)
{
  std::string all;
  try {
    read_dxf_text("d.dxf", text);
  } catch (const InputError& error) {
    for (const Problem& p : error.problems()) all += p.key + " " + p.what + ". " + p.detail + "\n";
  }
  return all;
}

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
  EXPECT_THAT(refused(drawing(line, "9\n$INSUNITS\n70\n3\n")),
      HasSubstr("d.dxf has a unit that Terp does not know. $INSUNITS is 3; known are 1 in, 2 ft, 4 mm"));
}

TEST(Dxf, DoubtsAWidthThatNoSectionHas)
{
  const auto doubts = [](const std::string& header) { return read_dxf_text("d.dxf", drawing(line, header)).doubts; };
  EXPECT_THAT(doubts("9\n$INSUNITS\n70\n6\n"), IsEmpty());
  EXPECT_THAT(doubts("9\n$INSUNITS\n70\n4\n"),  // millimetres, the unit of an empty drawing
      ElementsAre(ContainsRegex("^The section is 0.00[0-9]+ m wide: is that the unit of the drawing[?] --unit takes")));
}

TEST(Dxf, SaysThatLettersOfLayersWereLost)
{
  std::string lost(line);
  lost.replace(lost.find("8\n") + 2, 0, "\xEF");
  EXPECT_THAT(read_dxf_text("d.dxf", drawing(lost, "9\n$DWGCODEPAGE\n3\nANSI_932\n9\n$INSUNITS\n70\n6\n")).doubts,
      ElementsAre(
          HasSubstr("Letters of layer names were lost: they are not of the code page of the drawing, ANSI_932.")));
}

TEST(Dxf, RefusesOtherEntitiesByNameAndHandle)
{
  const std::string text = refused(drawing(std::string(line) + "0\nSPLINE\n5\n3C\n8\nclay\n10\n1\n20\n1\n"
                                                               "0\nTEXT\n8\nnotes\n1\nclay\n"));
  EXPECT_THAT(text, HasSubstr("d.dxf: SPLINE with handle 3C is not read. It is on layer clay. Terp reads LINE, "
                              "LWPOLYLINE and POLYLINE with straight sides. Turn it into one of these, or delete it."));
  EXPECT_THAT(text, HasSubstr("TEXT without a handle is not read. It is on layer notes."));
}

TEST(Dxf, RefusesArcsMeshesAndWhatIsTurned)
{
  EXPECT_THAT(refused(drawing(std::string(polyline) + "42\n0.5\n")),
      HasSubstr("LWPOLYLINE with handle 2B has arcs. It is on layer sand. 1 of its sides are bent (code 42)."));
  EXPECT_THAT(refused(drawing("0\nPOLYLINE\n70\n16\n0\nVERTEX\n10\n1\n20\n2\n0\nSEQEND\n")), HasSubstr("is a mesh"));
  EXPECT_THAT(
      refused(drawing(std::string(line) + "230\n-1.0\n")), HasSubstr("does not lie in the plane of the drawing"));
  EXPECT_THAT(refused(drawing("0\nLWPOLYLINE\n8\na\n10\n1\n20\n2\n")), HasSubstr("has fewer than two places. It is"));
}

TEST(Dxf, CountsWhatItDoesNotList)
{
  std::string many;
  for (int k = 0; k < 14; ++k) many += "0\nARC\n5\n" + std::to_string(k) + "\n";
  EXPECT_THAT(refused(drawing(many)), HasSubstr("d.dxf has 4 more such entities."));
}

TEST(Dxf, LeavesOutLayouts)
{
  const auto read = read_dxf_text("d.dxf", drawing(std::string(line) + "0\nTEXT\n67\n1\n1\ntitle\n"));
  EXPECT_EQ(read.lines.size(), 1u);
  EXPECT_THAT(read.notes[0], HasSubstr("1 entities of layouts (paper space) were left out."));
}

TEST(Dxf, RefusesPlacesWithoutXOrY)
{
  const std::string said = "has a place without x or y. It is on layer";
  EXPECT_THAT(refused(drawing("0\nLINE\n8\na\n10\n40\n20\n0\n")), HasSubstr("LINE without a handle " + said));
  EXPECT_THAT(refused(drawing("0\nLWPOLYLINE\n8\na\n70\n1\n10\n0\n20\n0\n10\n40\n10\n40\n20\n5\n")), HasSubstr(said));
  EXPECT_THAT(
      refused(drawing("0\nPOLYLINE\n8\na\n0\nVERTEX\n20\n2\n0\nVERTEX\n10\n3\n20\n2\n0\nSEQEND\n")), HasSubstr(said));
}

TEST(Dxf, RefusesAZThatVariesInOneEntity)
{
  std::string line_in_space = line;
  line_in_space.replace(line_in_space.find("31\n0.0"), 6, "31\n99");
  EXPECT_THAT(refused(drawing(line_in_space)),
      HasSubstr("LINE with handle 1A does not lie in one plane. It is on layer clay. Its z goes from 0 to 99."));
  EXPECT_THAT(
      refused(drawing("0\nPOLYLINE\n70\n9\n30\n5\n0\nVERTEX\n10\n1\n20\n2\n30\n0\n0\nVERTEX\n10\n3\n20\n2\n30\n7\n"
                      "0\nVERTEX\n10\n3\n20\n5\n30\n14\n0\nSEQEND\n")),
      HasSubstr("does not lie in one plane"));
  EXPECT_EQ(read_dxf_text(
                "d.dxf", drawing("0\nPOLYLINE\n30\n5\n0\nVERTEX\n10\n1\n20\n2\n30\n0\n0\nVERTEX\n10\n3\n20\n2\n30\n0\n"
                                 "0\nSEQEND\n"))
                .lines.size(),
      1u);
}

TEST(Dxf, LeavesOutWhatTheDrawingHides)
{
  const auto read = read_dxf_text("d.dxf", drawing(std::string(line) + polyline + "60\n1\n"));
  EXPECT_EQ(read.lines.size(), 1u);
  EXPECT_THAT(read.notes[0], HasSubstr("1 entities that the drawing hides (code 60) were left out."));
}

TEST(Dxf, PassesOverAByteOrderMarkAndCommentsAnywhere)
{
  std::string text = "\xEF\xBB\xBF" + drawing(std::string(line) + polyline);
  for (const char* at : {"0\nSECTION\n2\nENT", "8\nsand", "0\nENDSEC\n0\nEOF"})
    text.insert(text.find(at), "999\nhello\n");
  EXPECT_EQ(read_dxf_text("d.dxf", text).lines.size(), 2u);
}

TEST(Dxf, ReadsNamesOfLayersInTheCodePageOfTheHeader)
{
  std::string old = polyline;
  old.replace(old.find("sand"), 4, "kle\xEF");
  EXPECT_EQ(read_dxf_text("d.dxf", drawing(old, "9\n$DWGCODEPAGE\n3\nANSI_1252\n")).lines[0].layer, "kle\xC3\xAF");
}

TEST(Dxf, RefusesWhatIsNoDrawing)
{
  EXPECT_THAT(refused(""), HasSubstr("d.dxf is no DXF file. It is empty."));
  EXPECT_THAT(refused("AutoCAD Binary DXF\r\n"), HasSubstr("is a binary DXF file. Save the drawing as ASCII DXF."));
  EXPECT_THAT(refused("AC1027 and so on"), HasSubstr("is a DWG file"));
  EXPECT_THAT(refused("zero\nSECTION\n"), HasSubstr("Line 1 should be a group code, a whole number; got `zero`."));
  EXPECT_THAT(refused("0\nLINE\n"), HasSubstr("Line 2 should begin a section; got code 0 with `LINE`."));
  EXPECT_THAT(refused("0\nSECTION\n2\nENTITIES\n0\nLINE\n"), HasSubstr("The section ENTITIES has no ENDSEC."));
  EXPECT_THAT(refused("0\nSECTION\n2"), HasSubstr("ends in the middle of a pair. Line 3 is the last one."));
  EXPECT_THAT(refused("0\nEOF\n"), HasSubstr("has no entities"));
  EXPECT_THAT(refused(drawing("")), HasSubstr("has no lines"));
  EXPECT_THAT(refused(drawing("0\nLINE\n10\nabc\n")),
      HasSubstr("has a value that is no number. Line 16: group code 10 needs a number, got `abc`."));
  EXPECT_THAT(refused(drawing("0\nLINE\n10\n1e9\n20\n0\n11\n0\n21\n0\n")),
      HasSubstr("has a place beyond all maps. 1e+09, 0 m on"));
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

TEST(Dxf, NamesAFileThatIsNotThere)
{
  EXPECT_THAT(refusal<FileError>([] { read_dxf("/no/such.dxf"); }), HasSubstr("cannot read /no/such.dxf"));
}

}  // namespace dxf_file_test
