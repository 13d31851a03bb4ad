#include "io/case/explain.hpp"
#include "io/case/case_file.hpp"
#include "io/case/key_text.hpp"
#include "model/meshes/structured.hpp"
#include "mpm/schemes/scheme.hpp"
#include "support/test.hpp"

namespace explain_test {

TEST(Explain, KnowsEveryKeyDottedAndByItsLastPart)
{
  for (const KeyInfo& key : all_keys()) {
    EXPECT_THAT(explain(topic_of(key.path)), HasSubstr(last_part(key.path))) << key.path;
    EXPECT_FALSE(explain(last_part(key.path)).empty()) << key.path;
  }
}

TEST(Explain, KnowsEveryLawSchemeAndSection)
{
  for (const MaterialType* law : all_materials())
    EXPECT_THAT(explain(std::string(law->name)), HasSubstr(std::string(law->summary)));
  for (const Scheme* scheme : all_schemes())
    EXPECT_THAT(explain(std::string(scheme->name)), HasSubstr(std::string(scheme->summary)));
  for (const SectionInfo& section : all_sections())
    EXPECT_THAT(explain(topic_of(section.path)), HasSubstr(section.meaning));
}

TEST(Explain, SaysOfASchemeWhichFormIsThePapers)
{
  const std::string word = "In the form of the paper: as = \"paper\" in [method]";
  EXPECT_THAT(explain("mpm_gp"), AllOf(HasSubstr(word), Not(HasSubstr("overlap"))));
  EXPECT_THAT(explain("standard_mpm"), Not(HasSubstr(word)));
  const std::string mixed = explain("mpm_mixed");
  EXPECT_THAT(mixed, AllOf(HasSubstr(word), HasSubstr("With shares that overlap, the default of soil, it is another"),
                         HasSubstr("none loses strength to its\n  neighbours, and none regains any")));
}

TEST(Explain, GivesTheEquationsOfAMaterial)
{
  EXPECT_THAT(explain("tresca_softening"),
      HasSubstr(
          "\nEquations\n  sigma_1 - sigma_3 <= 2 S_u, principal stresses sorted in three dimensions; the pressure "
          "never changes\n  S_u      = su_residual + (su_peak - su_residual) exp(-eta eps_eq_p)   Eq. (5)\n"));
  for (const MaterialType* law : all_materials()) {
    const std::string first(law->equations.substr(0, law->equations.find('\n')));
    EXPECT_FALSE(first.empty()) << law->name;
    EXPECT_THAT(explain(std::string(law->name)), HasSubstr("\nEquations\n  " + first + "\n")) << law->name;
  }
}

TEST(Explain, GivesTheSizesOfCellsThatAGradedMeshHas)
{
  EXPECT_THAT(explain("mesh.grading"), HasSubstr("    equation  h_k = h_1 grading^((k - 1) / (n - 1)), k = 1 to n\n"));
  constexpr Index n = 7;
  constexpr Real grading = 3.5;
  const std::vector<Real> ends = graded_shares(n, grading);
  const auto size = [&](Index k) { return ends[k] - ends[k - 1]; };
  for (Index k = 1; k <= n; ++k) EXPECT_NEAR(size(k), size(1) * std::pow(grading, (k - 1.0) / (n - 1.0)), 1e-14) << k;
}

TEST(Explain, GivesMeaningEquationAllowedAndDefault)
{
  EXPECT_EQ(explain("courant"),
      "key of the case file\n"
      "  time.courant\n"
      "    share of the stable time step that is used (reading R19)\n"
      "    equation  dt = courant min_e(L_e) / c_p,  c_p = sqrt((K + 4G/3) / rho)\n"
      "    allowed   a number, more than 0 and at most 1\n"
      "    default   0.98\n");
}

TEST(Explain, TakesKeysAsTheyStandInACase)
{
  EXPECT_THAT(explain("material.clay.eta"), HasSubstr("shape factor"));
  EXPECT_THAT(explain("body[0].box"), HasSubstr("lower left"));
  EXPECT_THAT(explain("boundary.bottom.adhesion"), HasSubstr("unit      Pa"));
  EXPECT_EQ(explain("softening.length"), explain("material.softening.length"));
  EXPECT_THAT(explain("su_peak"), HasSubstr("key of material model `tresca_softening`"));
}

TEST(Explain, SaysThatAKeyIsRequired) { EXPECT_THAT(explain("footing.box"), HasSubstr("none: the key is required")); }

TEST(Explain, SaysWhatAKeyIsRequiredFor)
{
  EXPECT_THAT(explain("mesh.size"), HasSubstr("default   none: required for a rectangle, graded or not\n"));
  EXPECT_THAT(explain("body.material"), HasSubstr("none: required for a body with box, polygon or region\n"));
}

TEST(Explain, HasAMeaningForEveryKeyAndSection)
{
  for (const KeyInfo& key : all_keys()) EXPECT_GT(key.meaning.size(), 10u) << key.path;
  for (const SectionInfo& section : all_sections()) EXPECT_GT(section.meaning.size(), 10u) << section.path;
}

TEST(Explain, SaysWhichKeysOfAMeshBelongTogether)
{
  EXPECT_THAT(
      explain("mesh"), HasSubstr("Keys that belong together\n  size, cell (origin): a rectangle of equal cells\n"));
  EXPECT_THAT(explain("mesh.refine"), HasSubstr("[[mesh.refine]]: section of the case file, may be left out\n"));
  EXPECT_THAT(explain("boundary"), HasSubstr("left_the_mesh.csv"));
}

TEST(Explain, TellsThatAParameterDefaultsToAnother)
{
  EXPECT_THAT(explain("mohr_coulomb"),
      HasSubstr("cohesion_residual\n    cohesion that softening leaves\n    unit      Pa\n    allowed   a number or a "
                "field, at least 0 Pa\n    as text   \"1 kPa\", in kPa, Pa, MPa, GPa, N/m2, kN/m2, MN/m2, N/mm2, bar\n"
                "    default   the value of `cohesion`\n"));
}

TEST(Explain, ListsTheKindsOfFieldsAndWhatStandsForAParameter)
{
  EXPECT_THAT(explain("field"), HasSubstr("{ depth = [[0, 8e3], [5, 15e3]] }\n"));
  EXPECT_THAT(explain("su_residual"), HasSubstr("    instead   sensitivity\n"));
  EXPECT_EQ(explain("shansep"), explain("field"));
  for (const char* word : {"SHANSEP", "pop", "POP", "ocr"}) EXPECT_EQ(explain(word), explain("field")) << word;
  EXPECT_THAT(explain("yield_stress"), HasSubstr("key of material model `modified_cam_clay`"));
}

TEST(Explain, OffersTheNearestTopic)
{
  EXPECT_THAT(refusal<CaseError>([] { explain("tresca_softning"); }),
      HasSubstr("error: there is nothing to explain about `tresca_softning`\n\n  Did you mean "
                "`tresca_softening`?\n  Material models: linear_elastic"));
  EXPECT_THAT(
      refusal<CaseError>([] { explain("summary"); }), HasSubstr("\n  Files of a run: history.csv, ledger.csv, "));
}

TEST(List, NamesMaterialsSchemesAndFields)
{
  for (const char* name : {"linear_elastic", "tresca_softening", "standard_mpm", "mpm_mixed", "mpm_gp", "eps_eq_p",
           "su", "displacement", "parameter_su_peak"})
    EXPECT_THAT(list(), HasSubstr(std::string("\n  ") + name + " "));
}

TEST(Explain, KnowsTheQuantitiesThatARunReports)
{
  EXPECT_EQ(
      explain("front_left_x"), "in ledger.csv\n  front_left_x\n    front of the slope to the left\n    unit      m\n");
  EXPECT_THAT(explain("footings.csv"),
      HasSubstr("footings.csv: file of a run\n  displacement and measured reaction of each footing\n\n"
                "Quantities\n  time\n    of the step\n    unit      s\n"));
  EXPECT_THAT(explain("summary.json"), HasSubstr("  run_out\n    of the front since t = 0;"));
  EXPECT_THAT(explain("v_999"), AllOf(HasSubstr("in ledger.csv\n"), HasSubstr("in summary.json\n  v_999\n")));
  EXPECT_EQ(explain("displacement"), "in the frames\n  displacement\n    displacement since t = 0\n    unit      m\n");
  EXPECT_THAT(explain("parameter_su_peak"), HasSubstr("in the frames\n  parameter_su_peak\n"));
}

}  // namespace explain_test
