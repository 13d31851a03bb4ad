#include "batch/study.hpp"

#include "batch/samples.hpp"
#include "batch/statistics.hpp"

namespace draw_test {

const std::string two_numbers = changed(column_study, "number = 12", "number = 2000") + R"([[random]]
key = "material.clay.eta"
distribution = "uniform"
lowest = 2.0
highest = 8.0
[[correlation]]
between = ["material.clay.su_peak", "material.clay.eta"]
value = -0.5
)";

/// Inputs of all realisations, by number of the input.
std::vector<std::vector<Real>> inputs_of(const Study& study)
{
  std::vector<std::vector<Real>> columns(study.input_names().size());
  for (Index k = 0; k < study.n_realisations; ++k) {
    const Draw draw = draw_realisation(study, k);
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].push_back(draw.inputs[i]);
  }
  return columns;
}

TEST(Draw, HasTheMomentsAndTheCorrelationOfTheFile)
{
  const auto columns = inputs_of(study_of(two_numbers));
  const auto n = static_cast<Real>(columns[0].size());
  const Real mean = std::accumulate(columns[0].begin(), columns[0].end(), 0.0) / n;
  EXPECT_NEAR(mean, 8e3, 4.0 * 3.2e3 / std::sqrt(n)) << "four standard errors";
  EXPECT_NEAR(std::accumulate(columns[1].begin(), columns[1].end(), 0.0) / n, 5.0, 4.0 * 6.0 / std::sqrt(12.0 * n));
  // Spearman's of a Gaussian copula: 6/pi asin(rho/2)
  EXPECT_NEAR(*spearman(columns[0], columns[1]), 6.0 / std::numbers::pi * std::asin(-0.25), 4.0 / std::sqrt(n));
}

TEST(Draw, DependsOnTheNumberOfTheRealisationAlone)
{
  const Study study = study_of(two_numbers), shorter = study_of(changed(two_numbers, "number = 2000", "number = 20"));
  EXPECT_EQ(draw_realisation(study, 7).changes, draw_realisation(shorter, 7).changes);
  EXPECT_NE(draw_realisation(study, 7).changes, draw_realisation(study, 8).changes);
  const Study other = study_of(changed(two_numbers, "seed = 3", "seed = 4"));
  EXPECT_NE(draw_realisation(study, 7).changes, draw_realisation(other, 7).changes);
}

TEST(Draw, ALatinHypercubeHasOneRealisationInEachStratum)
{
  const std::string text =
      changed(changed(two_numbers, "number = 2000", "number = 50"), "monte_carlo", "latin_hypercube");
  auto columns = inputs_of(study_of(text.substr(0, text.find("[[correlation]]"))));
  std::ranges::sort(columns[1]);
  for (std::size_t k = 0; k < 50; ++k) {
    EXPECT_GE(columns[1][k], 2.0 + 6.0 * static_cast<Real>(k) / 50.0 - 1e-9);
    EXPECT_LE(columns[1][k], 2.0 + 6.0 * static_cast<Real>(k + 1) / 50.0 + 1e-9);
  }
}

TEST(Draw, AFieldGoesToTheCaseAndMultipliesWhatStandsThere)
{
  const Study study = study_of(field_study);
  const Draw draw = draw_realisation(study, 2);
  ASSERT_EQ(draw.changes.size(), 1u);
  EXPECT_EQ(draw.changes[0],
      "material.clay.su_peak={ random = { mean = 6000.0, cov = 0.3, theta = [8, 4], box = [[0, 0], [4, 2]], "
      "distribution = \"lognormal\", seed = 3, realisation = 2, field = 0 } }");
  const Study smooth = study_of(changed(field_study, "cov = 0.3", "cov = 0.3\ncorrelation = \"gaussian\""));
  EXPECT_THAT(draw_realisation(smooth, 2).changes[0], EndsWith("field = 0, correlation = \"gaussian\" } }"));
  EXPECT_NE(FieldOverTrend(smooth, 0, 2).at({1.0, 1.0}), FieldOverTrend(study, 0, 2).at({1.0, 1.0}));
  const ScratchFolder folder;
  write_study(folder.path(), field_study);
  EXPECT_EQ(read_case(folder.path() + "/column.toml", draw.changes).values.materials[0].fields.size(), 3u)
      << "su_residual and su_remoulded follow it";
}

TEST(Draw, AFieldHasTheValuesOfSoundingsInItsPicturesToo)
{
  const Study study = study_of(changed(field_study, "cov = 0.3", "cov = 0.3\nknown = [[1.0, 1.0, 12e3]]"));
  for (const Index sample : {0, 3})
    EXPECT_NEAR(FieldOverTrend(study, 0, sample).at({1.0, 1.0}), 2.0, 1e-9) << "12 kPa over a trend of 6 kPa";
}

TEST(Draw, FieldsThatAreCorrelatedShareAPart)
{
  const Study study = study_of(field_study + R"([[field]]
key = "material.clay.shear_modulus"
cov = 0.3
theta = [8.0, 4.0]
[[correlation]]
between = ["material.clay.su_peak", "material.clay.shear_modulus"]
value = 0.6
)");
  EXPECT_THAT(draw_realisation(study, 0).changes[1], HasSubstr("mix = [[0, 0.6], [1, 0.8]]"));
}

TEST(Draw, AGridTurnsItsLastKeyFastest)
{
  const Study study = study_of(R"(case = "column.toml"
set = { "time.end" = 0.4 }
[estimator]
kind = "sweep"
[[sweep]]
key = "material.clay.eta"
values = [5, 10, 20]
[[sweep]]
key = "scheme"
values = ["mpm_gp", "mpm_mixed"]
)");
  EXPECT_EQ(study.n_realisations, 6);
  EXPECT_THAT(
      draw_realisation(study, 3).changes, ElementsAre("time.end=0.4", "material.clay.eta=10", "scheme=\"mpm_mixed\""));
  EXPECT_EQ(input_text(study, 1, draw_realisation(study, 3).inputs[1]), "mpm_mixed");
}

}  // namespace draw_test
