#include "coarse_column.hpp"
#include "import/drawing/dxf_file.hpp"
#include "import/drawing/section_export.hpp"
#include "model/bodies/polygon.hpp"

namespace section_export_test {

TEST(SectionExport, DrawsTheGroundAndTheOutlinesOfARun)
{
  const ScratchFolder scratch;
  const std::string run = scratch.path() + "/run", dxf = scratch.path() + "/after.dxf",
                    csv = scratch.path() + "/after.csv";
  succeeded(test::run_column(run));
  EXPECT_EQ(succeeded(test::terp({"export", run, "--dxf", dxf, "--profile", csv})).out,
      "section at t = 0 and 0.2 s in " + dxf + "\nsection at t = 0 and 0.2 s in " + csv + "\n");
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

TEST(SectionExport, HasNothingOfABodyThatWasDugAway)
{
  const std::string box = "material = \"soil\"\npoints_per_cell = 6\nbox = ";
  const ScratchFolder scratch;
  const std::string run = scratch.path() + "/run", dxf = scratch.path() + "/after.dxf",
                    csv = scratch.path() + "/after.csv", file = scratch.path() + "/a.toml";
  std::ofstream(file) << "initial.stress = \"k0\"\n[mesh]\nsize = [4.0, 4.0]\ncell = 0.5\n"
                         "[[body]]\n" +
                             box +
                             "[[0.0, 0.0], [4.0, 1.0]]\n"
                             "[[body]]\nname = \"fill\"\n" +
                             box +
                             "[[0.0, 1.0], [4.0, 3.0]]\n"
                             "[material.soil]\nmodel = \"linear_elastic\"\ndensity = 1800.0\nshear_modulus = 5.0e6\n"
                             "poisson_ratio = 0.3\n[forces]\ngravity = [0.0, -9.81]\n"
                             "[boundary]\nleft = \"roller\"\nright = \"roller\"\nbottom = \"fixed\"\n"
                             "[[stage]]\nname = \"before\"\nduration = 0.02\n"
                             "[[stage]]\nname = \"dig\"\nduration = 0.02\nremove = [\"fill\"]\n";
  EXPECT_EQ(test::terp({"run", file, "-o", run, "-j", "1"}).status, 0);
  succeeded(test::terp({"export", run, "--dxf", dxf, "--profile", csv}));
  Real area = 0.0;
  for (const DxfLine& line : read_dxf(dxf).lines)
    if (line.closed) area += signed_area(line.places);
  EXPECT_NEAR(area, 4.0, 0.5);  // of 12 m^2 before
  std::istringstream profile(text_of(csv));
  std::string row;
  std::getline(profile, row);
  for (int n = 0; std::getline(profile, row) || n == 0; ++n) {
    Real x = 0.0, start = 0.0, end = 0.0;
    ASSERT_EQ(std::sscanf(row.c_str(), "%lf,%lf,%lf", &x, &start, &end), 3) << row;
    EXPECT_NEAR(start, 3.0, 0.2);
    EXPECT_NEAR(end, 1.0, 0.2);
  }
}

TEST(SectionExport, HasTheHeightOfTheVerdict)
{
  const ScratchFolder scratch;
  const std::string run = scratch.path() + "/run";
  EXPECT_EQ(
      test::terp({"run", source_path("cases/dike/dike.toml"), "-o", run, "-j", "1", "-q", "--set", "mesh.cell=1",
                     "--set", "stage[0].at_most=0.2", "--set", "stage[1].ramp=0.2", "--set", "stage[1].at_most=0.4"})
          .status,
      0);
  Real highest = -1e9;
  for (const auto& [x, before, after] : profile_of(read_run(run))) highest = std::max(highest, after);
  EXPECT_NEAR(highest, read_run(run).summary.values.flood->residual_height, 1e-6);
}

TEST(SectionExport, RefusesARunWhoseFirstOrLastFrameCannotBeRead)
{
  const ScratchFolder scratch;
  const std::string run = scratch.path() + "/run", out = scratch.path() + "/after";
  succeeded(test::run_column(run));
  const auto first = run + "/frames/points_00000.vtkhdf";
  std::string last;
  for (const auto& file : std::filesystem::directory_iterator(run + "/frames"))
    last = std::max(last, file.path().string());
  for (const std::string& frame : {first, last}) {
    const std::string whole = text_of(frame);
    std::string flipped = whole;
    flipped[whole.size() / 3] = static_cast<char>(~flipped[whole.size() / 3]);
    for (const std::string& damaged :
        {whole.substr(0, whole.size() / 2), std::string(), flipped, std::string("none")}) {
      if (damaged == "none")
        std::filesystem::remove(frame);
      else
        std::ofstream(frame, std::ios::binary | std::ios::trunc) << damaged;
      for (const std::string form : {"--dxf", "--profile"}) {
        const auto result = test::terp({"export", run, form, out});
        EXPECT_EQ(result.status, 1) << frame << damaged.size();
        EXPECT_THAT(result.err, HasSubstr(frame));
        EXPECT_FALSE(std::filesystem::exists(out));
      }
    }
    std::ofstream(frame, std::ios::binary | std::ios::trunc) << whole;
  }
}

TEST(SectionExport, IsOfTheSoilThatHasNotLeft)
{
  const auto body = [](const char* box, int points, const char* speed) {
    return fmt::format(
        "[[body]]\nmaterial = \"soil\"\nbox = {}\npoints_per_cell = {}\nvelocity = [{}, 0.0]\n", box, points, speed);
  };
  const ScratchFolder scratch;
  const std::string run = scratch.path() + "/run", csv = scratch.path() + "/after.csv",
                    file = scratch.path() + "/a.toml";
  const auto after = [&](const std::string& bodies) {
    std::ofstream(file) << "scheme = \"mpm_gp\"\n[time]\nend = 0.8\n[mesh]\nsize = [4.0, 2.0]\ncell = 0.5\n" + bodies +
                               "[material.soil]\nmodel = \"linear_elastic\"\ndensity = 1800.0\nshear_modulus = 1.0e6\n"
                               "poisson_ratio = 0.3\n[boundary]\nleft = \"roller\"\nbottom = \"roller\"\nright = "
                               "\"open\"\n[output]\nfields = { every = 0.4 }\n";
    EXPECT_EQ(test::terp({"run", file, "-o", run, "-j", "1", "-q", "--force"}).status, 0);
    return test::terp({"export", run, "--profile", csv});
  };
  const std::string leaves = body("[[2.0, 0.0], [4.0, 1.0]]", 3, "5.0");
  EXPECT_EQ(after(body("[[0.0, 0.0], [1.0, 1.5]]", 2, "0.0") + leaves).status, 0);
  EXPECT_EQ(text_of(csv), "x,start,end\n0.2500,1.5000,1.5000\n0.7500,1.5000,1.5000\n");
  std::filesystem::remove(csv);
  const auto none = after(leaves);
  EXPECT_EQ(none.status, 1);
  EXPECT_EQ(none.err, "error: " + run + ": no soil is left at t = 0.8 s: there is no section to export\n");
  EXPECT_FALSE(std::filesystem::exists(csv));
}

}  // namespace section_export_test
