#include "import/dstability/foreign_file.hpp"
#include "math/errors.hpp"
#include "support/test.hpp"

namespace foreign_file_test {

std::string refused(const std::string& path, std::string_view content)
{
  return refusal<InputError>([&] { kind_of_section(path, content); });
}

TEST(ForeignFile, IsNamedByItsContentOrEndingWithTheWayIn)
{
  EXPECT_EQ(refused("a.sti", "Input file for a slope program : version 20.1.1\n"),
      "a.sti: is a file of the old D-Geo Stability\n  Open it in D-Stability and save it there: terp import "
      "section.stix.");
  EXPECT_THAT(refused("a.dwg", "AC1032"), HasSubstr("is a DWG file\n  Save the drawing as ASCII DXF."));
  EXPECT_THAT(refused("a.dxf", "AutoCAD Binary DXF\r\n"), HasSubstr("is a binary DXF file"));
  EXPECT_THAT(refused("a.gsz", "PK section.xml"), HasSubstr("is a file of GeoStudio (SLOPE/W)"));
  EXPECT_THAT(refused("a.zip", "PK xl/workbook.xml"), HasSubstr("is a workbook of Excel"));
  EXPECT_THAT(refused("a.gef", "#GEFID = 1, 1, 0\n"), HasSubstr("is a GEF file"));
  EXPECT_THAT(refused("a.geojson", "{\"type\": 1}"), HasSubstr("is a JSON file (GeoJSON)"));
  EXPECT_THAT(refused("a.GOM", "$$STARTCOUNTERS"), HasSubstr("is a mesh of another program"));
  EXPECT_THAT(refused("a.pdf", "%PDF-1.7"), HasSubstr("is a PDF file"));
  EXPECT_THAT(refused("a.foo", ""), HasSubstr("is empty"));
  EXPECT_THAT(refused("a.foo", "words and words\n"), HasSubstr("is no section that Terp reads"));
  EXPECT_THAT(refused("a.zip", "PK nothing"), HasSubstr("is a zip file, and no section of D-Stability"));
  EXPECT_THAT(refusal<InputError>([] { kind_of_section("/"); }), HasSubstr("is a folder"));
}

TEST(ForeignFile, KnowsWhatTerpReadsUnderAnyName)
{
  EXPECT_EQ(kind_of_section("a.zip", "PK soils.json"), SectionFile::dstability);
  EXPECT_EQ(kind_of_section("a.stix", "damaged"), SectionFile::dstability);
  EXPECT_EQ(kind_of_section("a.txt", "999\nby hand\n  0\nSECTION\n"), SectionFile::drawing);
  EXPECT_EQ(kind_of_section("a.DXF", "damaged"), SectionFile::drawing);
  EXPECT_EQ(kind_of_section("a.csv", "l,z\n0,-1.0\n"), SectionFile::profile);
  EXPECT_EQ(kind_of_section("a.txt", "x y\n0 0\n"), SectionFile::profile);
}

}  // namespace foreign_file_test
