#include "import/dstability/archives.hpp"
#include "import/dstability/section.hpp"
#include "model/bodies/polygon.hpp"
#include "support/process.hpp"

namespace stix_export_test {

/// The berm on cells of 2 m, 0.2 s from k0, in which it hardly moves.
struct ShortRun {
  ScratchFolder scratch;
  std::string run = scratch.path() + "/run", stix = scratch.path() + "/after.stix";

  ShortRun()
  {
    const std::string folder = scratch.path() + "/case";
    succeeded(test::terp({"import", sample_path(berm), "--cell", "2", "-o", folder}));
    EXPECT_EQ(test::terp({"run", folder + "/case.toml", "-o", run, "-j", "1", "-q", "--set", "initial.stress=\"k0\"",
                             "--set", "time.at_most=0.2"})
                  .status,
        0);
  }
};

TEST(StixExport, IsTheSectionOfTheRunInLayersOfTheFile)
{
  const ShortRun short_run;
  EXPECT_THAT(
      succeeded(test::terp({"export", short_run.run, "--stix", short_run.stix, "--template", sample_path(berm)})).out,
      StartsWith("section at t = 0.2 s, "));
  const StixProject project = read_stix(short_run.stix);
  ASSERT_EQ(project.scenarios.size(), 2u);
  const StixStage &before = project.scenarios[0].stages[0], &after = project.scenarios[1].stages.back();
  Real area = 0.0, of_file = 0.0;
  for (const StixLayer& layer : after.layers) area += std::abs(signed_area(Polygon(layer.outline)));
  for (const StixLayer& layer : before.layers) of_file += std::abs(signed_area(Polygon(layer.outline)));
  EXPECT_NEAR(area, of_file, 0.005 * of_file);
  for (const Real x : {25.0, 41.0, 59.0, 85.0}) {  // middles of columns
    const StixStageColumn old_column(project, before, x), column(project, after, x);
    EXPECT_NEAR(column.ground(), old_column.ground(), 0.06) << "it settles meanwhile, at x = " << x;
    EXPECT_NEAR(column.pore_pressure(-25.0), old_column.pore_pressure(-25.0), 100.0);
    const auto soil_at = [&](const StixStageColumn& of, const StixStage& stage) {
      for (const SoilBand& band : of.bands())
        if (band.top > -25.0 && band.bottom < -25.0) return *stage.layers[band.layer].soil;
      return std::size_t{1000};
    };
    EXPECT_EQ(soil_at(column, after), soil_at(old_column, before));
  }
}

TEST(StixExport, NeedsTheFileThatTheCaseIsOf)
{
  const ShortRun short_run;
  const auto alone = test::terp({"export", short_run.run, "--stix", short_run.stix});
  EXPECT_NE(alone.status, 0);
  EXPECT_THAT(alone.err, HasSubstr("--template section.stix"));
  EXPECT_FALSE(std::filesystem::exists(short_run.stix));
}

}  // namespace stix_export_test
