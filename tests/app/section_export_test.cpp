#include "coarse_column.hpp"
#include "drawing/dxf_file.hpp"
#include "points/polygon.hpp"

namespace section_export_test {

TEST(SectionExport, DrawsTheGroundAndTheOutlinesOfARun)
{
  const ScratchFolder scratch;
  const std::string run = scratch.path() + "/run", dxf = scratch.path() + "/after.dxf",
                    csv = scratch.path() + "/after.csv";
  succeeded(test::run_column(run));
  EXPECT_EQ(succeeded(test::terp({"export", run, "--dxf", dxf, "--profile", csv})).out,
      "section in " + dxf + "\nsection in " + csv + "\n");
  const DxfDrawing drawing = read_dxf(dxf);
  ASSERT_GE(drawing.lines.size(), 3u);
  EXPECT_EQ(drawing.lines[0].layer, "ground_start");
  EXPECT_EQ(drawing.lines[1].layer, "ground_end");
  Real area = 0.0;
  for (const DxfLine& line : drawing.lines)
    if (line.closed) area += signed_area(line.places);
  EXPECT_NEAR(area, 16.0, 1.0);  // the column is 8 by 2 m
  EXPECT_THAT(text_of(csv), StartsWith("x,start,end\n"));
}

}  // namespace section_export_test
