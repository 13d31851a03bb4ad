#include "import/dstability/study_text.hpp"

#include "io/case/case_file.hpp"
#include "io/case/expression.hpp"
#include "import/dstability/archives.hpp"
#include "import/dstability/case_folder.hpp"
#include "import/dstability/read_stix.hpp"
#include "import/dstability/sections.hpp"

namespace study_text_test {

std::string file_of(const CaseFolder& folder, const std::string& name)
{
  const auto found = std::ranges::find(folder.files, name, [](const auto& file) { return file.first; });
  return found == folder.files.end() ? "" : found->second;
}

CaseFolder folder_of(const StixProject& project, std::size_t scenario = 0)
{
  return case_folder_of(project, {.scenario = scenario,
                                     .stage = project.scenarios[scenario].stages.size() - 1,
                                     .cell = 2.0,
                                     .basis = StixBasis::mean,
                                     .kinds = kinds(),
                                     .has_study = true});
}

/// The value of a key of [follow], with one name at a value.
Real followed(const std::string& study, const std::string& key, const std::string& name, Real value)
{
  const std::string line = "\"" + key + "\" = \"";
  const std::size_t at = study.find(line);
  if (at == std::string::npos) return not_given;
  const std::string formula = study.substr(at + line.size(), study.find("\"\n", at) - at - line.size());
  return Expression(formula, {name}, {})(std::vector<Real>{value});
}

std::string declared(const std::string& study, const std::string& name)
{
  const std::size_t at = study.find("name         = \"" + name + "\"");
  return at == std::string::npos ? "" : study.substr(at, study.find("\n\n", at) - at);
}

TEST(StudyText, HasTheDistributionsOfTheFile)
{
  const CaseFolder folder = folder_of(read_stix(sample_path("tutorial-2023")), 1);
  const std::string study = file_of(folder, "study.toml");
  EXPECT_THAT(declared(study, "S_clay_shallow"),
      AllOf(HasSubstr("\"lognormal\""), HasSubstr("mean         = 0.3\nsd           = 0.05")));
  EXPECT_THAT(
      declared(study, "m_clay_shallow"), AllOf(HasSubstr("\"truncated_normal\""), HasSubstr("highest      = 1.0")));
  EXPECT_EQ(declared(study, "m_peat_deep"), "") << "its deviation is 0";
  EXPECT_THAT(declared(study, "model_factor"), HasSubstr("mean         = 1.05\nsd           = 0.033"));
  EXPECT_EQ(declared(study, "phi_sand"), "") << "plain in the file";
  EXPECT_THAT(study, AllOf(HasSubstr("\"stage[1].set.at_strength\" = \"model_factor\""),
                         HasSubstr("at_strength = \"0.5 * model_factor\""), HasSubstr("those of the file.")));
  EXPECT_THAT(study, HasSubstr("\"material.peat_deep.su_peak.shansep.water\" = \"high_water_water\"")) << "when held";
  EXPECT_THAT(folder.notes, Not(Contains(testing::Field(&Sentence::en, HasSubstr("NOT of the file")))));
}

TEST(StudyText, DrawsTheFrictionOfTheFileBeforeItIsReduced)
{
  StixProject project = project_of({clay_on_sand()});
  project.soils[0].advanced.friction = {.value = 28.0, .mean = 30.0, .deviation = 3.0, .is_probabilistic = true};
  project.soils[0].advanced.cohesion = {.value = 2e3, .mean = 2e3, .deviation = 500.0, .is_probabilistic = true};
  std::string study;
  for (const Real psi : {5.0, 0.0}) {
    project.soils[0].advanced.dilatancy = {.value = psi};
    study = file_of(folder_of(project), "study.toml");
    for (const Real phi : {25.0, 30.0, 37.0})
      EXPECT_NEAR(followed(study, "material.sand_below.friction_angle", "phi_sand", phi),
          davis_reduced(2e3, phi, psi).friction, 1e-6)
          << psi;
  }
  EXPECT_THAT(study, HasSubstr("\"material.sand_below.cohesion\" = \"c_sand * cos(phi_sand * "));
  EXPECT_THAT(declared(study, "c_sand"), HasSubstr("mean         = 2000\nsd           = 500"));
}

TEST(StudyText, SaysThatSpreadsByKindAreNotOfTheFile)
{
  StixProject project = project_of({clay_on_sand()});
  project.soils[1].ratio = {.value = 0.25};
  const CaseFolder folder = folder_of(project);
  const std::string study = file_of(folder, "study.toml");
  EXPECT_THAT(study, HasSubstr("NOT of the file"));
  EXPECT_THAT(declared(study, "S_clay"), HasSubstr("mean         = 0.25\nsd           = 0.0375"));
  EXPECT_THAT(declared(study, "phi_sand"), HasSubstr("mean         = 30\nsd           = 1.5"));
  EXPECT_THAT(folder.notes, Contains(testing::Field(&Sentence::nl, HasSubstr("NIET van het bestand"))));
  EXPECT_THAT(
      file_of(folder, "report.md"), HasSubstr("## Study: what is random\n\n- The distributions of the study are NOT"));
}

/// POP of one state in all of the clay.
StixProject with_pop(StixParameter pop, std::vector<StixStage> stages)
{
  stages[0].state_points = {
      {.id = "p", .label = "p", .layer = "clay", .place = {10.0, -3.0}, .preload = {.pop = std::move(pop)}}};
  return project_of(std::move(stages));
}

TEST(StudyText, DrawsThePopOfAState)
{
  const StixParameter pop{.value = 10e3, .mean = 12e3, .deviation = 4e3, .is_probabilistic = true};
  const CaseFolder folder = folder_of(with_pop(pop, {clay_on_sand()}));
  EXPECT_THAT(declared(file_of(folder, "study.toml"), "pop_clay_below"),
      HasSubstr("mean         = 12000\nsd           = 4000"));
  EXPECT_NEAR(followed(file_of(folder, "study.toml"), "material.clay_below.su_peak.shansep.pop", "pop_clay_below", 9e3),
      9e3, 1.0);
}

TEST(StudyText, OfAGridTheGridIsWithoutThePop)
{
  const StixParameter pop{.value = 10e3, .mean = 12e3, .deviation = 4e3, .is_probabilistic = true};
  StixStage later = clay_on_sand();
  later.label = "pit", later.excavations = {{{4.0, -0.5}, {6.0, -0.5}}};
  const CaseFolder folder = folder_of(with_pop(pop, {clay_on_sand(), later}));
  EXPECT_THAT(file_of(folder, "case.toml"),
      HasSubstr("yield_stress = { csv = \"yield_stress_clay_below.csv\" }, pop = \"12 kPa\""));
  const StixProject project = with_pop(pop, {clay_on_sand(), later});
  const StixPlace place = place_in(project, {16.0, -3.0}, StixBasis::mean);
  const std::string csv = file_of(folder, "yield_stress_clay_below.csv");
  EXPECT_THAT(csv, HasSubstr(fmt::format("16.0,-3.0,{:.1f}\n", place.yield_stress - 12e3)));
}

}  // namespace study_text_test
