// Stored slices beside computed ones, in all samples.
#include "import/dstability/slices.hpp"

#include "archives.hpp"
#include "import/dstability/section.hpp"

namespace slices_test {

std::map<std::string, ResultSlices> results_of(const std::string& sample)
{
  std::map<std::string, ResultSlices> results;
  for (ResultSlices& result : compare_slices(read_stix(sample_path(sample)))) {
    const std::string name = result.name;
    results[name] = std::move(result);
  }
  return results;
}

/// What the samples are known to hold: how many results fit, how many of these at each slice, and how many do not.
struct Known {
  std::string sample;
  int fits, at_each_slice, other;
};
const std::vector<Known> known{{"berm-fragility-2023", 1, 1, 0}, {"example-2020.03-v1", 2, 2, 0},
    {"tutorial-2020-v1", 5, 2, 0}, {"tutorial-2022.01-v1", 5, 5, 0}, {"tutorial-2023", 5, 5, 0},
    {"tutorial-2026.01", 8, 8, 0}, {"all-result-kinds-stale", 0, 0, 6}};

/// In three results of 2020 a few slices have the weight of another section.
bool fits_at_each_slice(const ResultSlices& result)
{
  return result.state == SliceState::fits && largest_deviation(result).total_stress < 100.0;
}

TEST(Slices, FitInAllSamplesThatWereNotEdited)
{
  for (const Known& sample : known) {
    int fits = 0, at_each = 0, other = 0;
    for (const auto& [name, result] : results_of(sample.sample)) {
      ++(result.state == SliceState::fits ? fits : other);
      EXPECT_EQ(result.trouble, "");
      if (!fits_at_each_slice(result)) continue;
      ++at_each;
      const SliceDeviation most = largest_deviation(result);
      EXPECT_EQ(most.missing, 0u) << sample.sample << name;
      EXPECT_GE(most.compared, 2 * result.rows.size()) << sample.sample << name;
      EXPECT_LT(most.total_stress, 50.0) << sample.sample << name;
      EXPECT_LT(most.pore_pressure, 50.0) << sample.sample << name;
      EXPECT_LT(most.yield_stress, 100.0) << sample.sample << name;
      EXPECT_LT(most.su, 1e-3) << sample.sample << name;
      EXPECT_NEAR(result.resistance, 1.0, 0.02) << sample.sample << name;  // a border within 1 mm of the plane
    }
    EXPECT_EQ(fits, sample.fits) << sample.sample;
    EXPECT_EQ(at_each, sample.at_each_slice) << sample.sample;
    EXPECT_EQ(other, sample.other) << sample.sample;
  }
}

/// Strength in shear a little above the foot of a slice, with the stored normal stress.
Real strength_at(const StixSection& section, const StixSlice& slice, Real above)
{
  const auto place = section.at({std::midpoint(slice.bottom_left[0], slice.bottom_right[0]),
      std::midpoint(slice.bottom_left[1], slice.bottom_right[1]) + above});
  if (!place) return not_given;
  if (!std::isnan(place->su)) return place->su;
  return place->cohesion + slice.normal_stress * std::tan(place->friction * std::numbers::pi / 180.0);
}

/// Within 1 mm of a boundary between two layers D-Stability takes the weaker one.
Real nearest_strength(const StixSection& section, const StixSlice& slice)
{
  Real nearest = strength_at(section, slice, 0.0);
  for (const Real above : {-1e-3, 1e-3})
    if (const Real other = strength_at(section, slice, above);
        std::abs(other - slice.strength) < std::abs(nearest - slice.strength))
      nearest = other;
  return nearest;
}

TEST(Slices, HaveTheStoredStrengthDrainedAndUndrained)
{
  int n = 0;
  for (const Known& sample : known) {
    const StixProject project = read_stix(sample_path(sample.sample));
    for (const ResultSlices& result : compare_slices(project)) {
      if (!fits_at_each_slice(result)) continue;
      const StixCalculation& c = project.scenarios[result.scenario].calculations[result.calculation];
      const StixSection section(project, result.scenario, c.stage, basis_of(c.kind));
      for (const StixSlice& slice : c.result->slices) {
        if (slice.normal_stress == 0.0) continue;  // the last slice of Spencer in 2020: stresses are not stored
        EXPECT_NEAR(nearest_strength(section, slice), slice.strength, 1e-3 * slice.strength + 1.0)
            << sample.sample << " " << result.name << " at x = " << slice.bottom_left[0];
        n += std::isnan(slice.friction) ? 0 : 1;  // drained
      }
    }
  }
  EXPECT_GT(n, 100);
}

TEST(Slices, OfASectionThatWasEditedSaySo)
{
  const auto results = results_of("all-result-kinds-stale");
  EXPECT_EQ(results.at("bishopbruteforce/bishopbruteforceresult").state, SliceState::other_section);
  EXPECT_EQ(results.at("bishopbruteforce/bishopbruteforceresult").why,
      "25 of 38 slices have another total stress or pore pressure");
  EXPECT_EQ(results.at("bishop/bishopresult").state, SliceState::other_strengths);
}

/// A section whose first `n` slices were changed.
ResultSlices with_changed(std::size_t n, void (*change)(StixSlice&))
{
  StixProject project = read_stix(sample_path("berm-fragility-2023"));
  auto& slices = project.scenarios[0].calculations[0].result->slices;
  for (std::size_t k = 0; k < n; ++k) change(slices[k]);
  return compare_slices(project)[0];
}

TEST(Slices, OneSliceMakesNoOtherSection)
{
  const std::size_t n = compare_slices(read_stix(sample_path("berm-fragility-2023")))[0].rows.size();
  ASSERT_GE(n, 25u);  // one slice is less than 5 %
  const auto heavier = [](StixSlice& s) { s.total_stress += std::max(200.0, 0.02 * s.total_stress); };
  const auto wetter = [](StixSlice& s) { s.pore_pressure += 500.0 + 0.03 * s.total_stress; };
  EXPECT_EQ(with_changed(1, heavier).state, SliceState::fits);
  EXPECT_EQ(with_changed(n / 20 + 1, heavier).state, SliceState::other_section);
  EXPECT_EQ(with_changed(1, wetter).state, SliceState::fits);
  EXPECT_EQ(with_changed(n / 20 + 1, wetter).state, SliceState::other_section);
}

TEST(Slices, OfOtherStrengthsSayByHowMuch)
{
  const ResultSlices same = with_changed(0, nullptr);
  EXPECT_NEAR(same.resistance, 1.0, 2e-3);
  const ResultSlices other = with_changed(same.rows.size(), [](StixSlice& s) { s.strength /= 0.93; });
  EXPECT_EQ(other.state, SliceState::other_strengths);
  EXPECT_NEAR(other.resistance, 0.93, 2e-3);
  EXPECT_THAT(other.why, HasSubstr("0.93 times the stored one"));
}

TEST(Slices, AreWrittenAsATable)
{
  StixProject project = read_stix(sample_path("berm-fragility-2023"));
  project.scenarios[0].calculations[0].result->slices.resize(1);
  const std::string csv = slices_csv(compare_slices(project));
  EXPECT_THAT(csv, StartsWith("result,x,z,stale,total_stress_computed,total_stress_stored,pore_pressure_computed,"
                              "pore_pressure_stored,yield_stress_computed,yield_stress_stored,su_computed,su_stored\n"
                              "bishopbruteforce/bishopbruteforceresult,"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 2);
  EXPECT_EQ(std::ranges::count(csv, ','), 22);
}

TEST(Slices, OfAStageThatCannotBeComputedSayWhy)
{
  StixProject project = read_stix(sample_path("berm-fragility-2023"));
  project.scenarios[0].stages[0].layers[0].soil.reset();
  const auto results = compare_slices(project);
  EXPECT_THAT(results[0].trouble, HasSubstr("has no soil"));
  EXPECT_EQ(results[0].state, SliceState::other_section);
  EXPECT_THAT(slices_csv(results), HasSubstr(",1,nan,"));
}

TEST(Slices, WithoutAComputedNumberAreCounted)
{
  StixProject project = read_stix(sample_path("berm-fragility-2023"));
  StixSlice& first = project.scenarios[0].calculations[0].result->slices[0];
  first.bottom_left[1] = first.bottom_right[1] = 500.0;  // far above the ground: nothing is computed there
  const SliceDeviation most = largest_deviation(compare_slices(project)[0]);
  EXPECT_EQ(most.missing, 2u);  // total stress and pore pressure; this slice is of drained soil
}

TEST(Slices, HaveNamesInQuotesWhereTheTableNeedsThem)
{
  ResultSlices result;
  result.name = "bishop/a,\"b\"\x1B[31m";
  result.rows.resize(1);
  EXPECT_THAT(slices_csv({result}), HasSubstr("\n\"bishop/a,\"\"b\"\"?[31m\","));
}

}  // namespace slices_test
