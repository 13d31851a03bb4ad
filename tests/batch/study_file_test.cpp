#include "batch/study_file.hpp"

#include "io/case/case_file.hpp"
#include "batch/samples.hpp"
#include "batch/study.hpp"
#include "batch/study_folder.hpp"

namespace study_file_test {

TEST(StudyFile, IsReadWithUnitsOfTheKeysThatAreDrawn)
{
  const StudySettings s = read_study_text(column_study, "studies/demo.toml");
  EXPECT_EQ(s.name, "demo");
  EXPECT_EQ(s.folder, "studies");
  ASSERT_EQ(s.numbers.size(), 1u);
  EXPECT_EQ(s.numbers[0].distribution.mean, 8e3);
  EXPECT_DOUBLE_EQ(s.numbers[0].distribution.sd, 3.2e3);
  EXPECT_EQ(s.stop.number, 12);
  EXPECT_EQ(s.event.displacement, 0.3);
}

TEST(StudyFile, TitleAndStopRuleDoNotChangeWhichStudyItIs)
{
  const auto identity = [](const std::string& text) { return identity_text(read_study_text(text, "demo.toml")); };
  const std::string first = identity(column_study);
  EXPECT_EQ(identity("title = \"other\"\n" + changed(column_study, "number = 12", "number = 99")), first);
  EXPECT_NE(identity(changed(column_study, "seed = 3", "seed = 4")), first);
  EXPECT_NE(identity(changed(column_study, "volume = 1.0", "volume = 2.0")), first);
  const std::string cube = changed(column_study, "monte_carlo", "latin_hypercube");
  EXPECT_NE(identity(changed(cube, "number = 12", "number = 99")), identity(cube)) << "its points depend on it";
}

TEST(StudyFile, WithOneMistakeHasOneMessage)
{
  expect_messages(column_study,
      {
          {"seed = 3", "sed = 3",
              "error: demo.toml:2:1: unknown key `sed`\n\n    2 | sed = 3\n      | ^^^\n  Did you mean `seed`?"},
          {"seed = 3", "seed = -3", "`seed` is out of range"},
          {"case = \"column.toml\"\n", "", "`case` is missing"},
          {"su_peak", "su_pek", "`material.clay.su_pek` is no key of a case\n\n    4 | key = \"material.clay.su_pek\""},
          {"su_peak", "su_pek", "Did you mean `material.clay.su_peak`?"},
          {"clay.su_peak", "clya.su_peak", "Did you mean `material.clay.su_peak`?"},
          {"lognormal", "lognomal", "`distribution` cannot be \"lognomal\"\n\n    5 | distribution = \"lognomal\""},
          {"cov = 0.4", "", "the distribution needs `sd` or `cov`"},
          {"cov = 0.4", "cov = 0.4\nsd = 3", "`sd` and `cov` are both given"},
          {"cov = 0.4", "cov = 0.4\nlowest = 3", "a lognormal distribution has no `lowest`"},
          {"mean = \"8 kPa\"", "mean = \"8 m\"", "`mean` cannot be in m"},
          {"mean = \"8 kPa\"", "mean = -8.0", "a lognormal distribution has a positive mean"},
          {"lognormal", "normal", "`material.clay.su_peak` is drawn where the case refuses it"},
          {"lognormal", "normal",
              "With probability 0.001 it is at most -1889. Give a distribution without such values: lognormal, or "
              "truncated_normal."},
          {"cov = 0.4",
              "cov = 0.4\n[[correlation]]\nbetween = [\"material.clay.su_peak\", \"material.clay.eta\"]\nvalue = 0.5",
              "`material.clay.eta` is not random in this study"},
          {"cov = 0.4",
              "cov = 0.4\n[[random]]\nkey = \"material.clay.su_peak\"\ndistribution = \"uniform\"\nlowest = 1\nhighest "
              "= 2",
              "`material.clay.su_peak` is given twice"},
          {"material.clay.su_peak", "output.fields.every", "no result depends on `output.fields.every`"},
          {"number = 12", "", "the stop rule cannot be met: `number` is missing"},
          {"number = 12", "number = 12\ncov = 0.1", "takes 100 events, which 12 realisations cannot have.\n"},
          {"number = 12", "number = 150\ncov = 0.1", "the stop rule cannot be met by so few realisations"},
          {"number = 12", "number = 150\ncov = 0.1", "which 150 realisations have only where P is above 0.67.\n"},
          {"monte_carlo", "monte_crlo", "`kind` cannot be \"monte_crlo\"\n\n    9 | kind = \"monte_crlo\""},
          {"monte_carlo", "sweep", "a sweep ends with its last combination"},
          {"number = 12", "number = 12\n[[sweep]]\nkey = \"material.clay.eta\"\nvalues = [1, 2]",
              "is of `kind = \"sweep\"`"},
          {"[[random]]", "[random]", "write [[random]], once for each"},
          {"volume = 1.0", "ends_run = true",
              "a realisation no longer ends with its events\n\n   13 | ends_run = true\n      |            ^^^^\n  "
              "Remove the key. With until = \"verdict\" in the case a run ends as soon as the answer to [flood] is "},
      });
}

TEST(StudyFile, KeysThatUndoEachOtherAreRefusedWithBothNames)
{
  const auto message = [](const std::string& first, const std::string& second) {
    const auto table = [](const std::string& key) {
      return "[[random]]\nkey = \"" + key + "\"\ndistribution = \"uniform\"\nlowest = 2\nhighest = 8\n";
    };
    return message_on(column_study, {"[estimator]", table(first) + table(second) + "[estimator]"});
  };
  EXPECT_THAT(message("material.clay.sensitivity", "material.clay.su_residual"),
      HasSubstr("`material.clay.sensitivity` and `material.clay.su_residual` set the same value"));
  EXPECT_THAT(message("material.*.eta", "material.clay.eta"),
      HasSubstr("`material.*.eta` and `material.clay.eta` set the same value"));
  EXPECT_EQ(message("material.clay.eta", "material.clay.sensitivity"), "");
  const Mistake nested{"[estimator]",
      "[[field]]\nkey = \"material.clay.su_peak.shansep.S\"\nmean = 0.3\ncov = 0.3\ntheta = [8.0, 4.0]\n[estimator]",
      ""};
  EXPECT_THAT(message_on(field_study, nested),
      HasSubstr("`material.clay.su_peak` and `material.clay.su_peak.shansep.S` set the same value"));
}

TEST(StudyFile, ASettingThatEachDrawReplacesIsRefused)
{
  const auto message = [](const std::string& text, const std::string& set) {
    return message_on(text, {"[estimator]", set});
  };
  const char* own = "[set]\n\"material.clay.su_peak\" = 9e3\n[estimator]";
  EXPECT_THAT(message(column_study, own), HasSubstr("`material.clay.su_peak` of [set] is lost"));
  EXPECT_EQ(message(field_study, own), "") << "the field is about it";
  EXPECT_THAT(message(column_study, "[set]\n\"material.*.su_peak\" = 9e3\n[estimator]"),
      HasSubstr("`material.*.su_peak` of [set] is lost: `material.clay.su_peak` is given in each realisation anew"));
  EXPECT_EQ(message(column_study, "[set]\n\"material.clay.eta\" = 9\n[estimator]"), "");
  const auto uniform = [](const std::string& key) {
    return "[[random]]\nkey = \"" + key + "\"\ndistribution = \"uniform\"\nlowest = 0.1\nhighest = 0.2\n";
  };
  const std::string part = "[set]\n\"forces.damping\" = { local = 0.3, averaging_time = 0.3 }\n" +
                           uniform("forces.damping.local"),
                    rest = uniform("forces.damping.averaging_time"), end = "[estimator]";
  EXPECT_EQ(message(column_study, part + end), "") << "the averaging time is that of [set]";
  EXPECT_THAT(message(column_study, part + rest + end),
      HasSubstr("`forces.damping` of [set] is lost: `forces.damping.local` and `forces.damping.averaging_time` are "
                "given in each realisation anew"));
}

TEST(StudyFile, ADrawThatAStageReplacesIsRefused)
{
  const auto message = [](const std::string& key, const char* value = "4e3") {
    const ScratchFolder folder;
    const std::string stage =
        "[[stage]]\nname = \"flood\"\nduration = 0.8\nset = { \"" + key + "\" = " + value + " }\n";
    const std::string path =
        write_study(folder.path(), column_study, changed(column_case, "[time]\nend = 0.8\ncourant = 0.5\n", stage));
    return refusal<CaseError>([&] { prepare_study(read_study(path)); });
  };
  EXPECT_THAT(message("material.clay.su_peak"),
      HasSubstr("`material.clay.su_peak` is lost in the stage `flood`, which sets `material.clay.su_peak`"));
  EXPECT_THAT(message("material.*.su_peak"), HasSubstr("which sets `material.*.su_peak`"));
  EXPECT_EQ(message("material.clay.eta", "6.0"), "");
}

TEST(StudyFile, FieldsNameTheirCorrelation)
{
  EXPECT_EQ(read_study_text(field_study, "demo.toml").fields[0].correlation, "markov");
  const std::string gaussian = changed(field_study, "cov = 0.3", "cov = 0.3\ncorrelation = \"gaussian\"");
  EXPECT_EQ(read_study_text(gaussian, "demo.toml").fields[0].correlation, "gaussian");
  EXPECT_THAT(message_on(field_study, {"cov = 0.3", "cov = 0.3\ncorrelation = \"gausian\""}),
      AllOf(HasSubstr("`correlation` cannot be \"gausian\""), HasSubstr("Did you mean `gaussian`?"),
          HasSubstr("\"markov\", \"matern_3_2\", \"matern_5_2\"")));
  const std::string pair =
      "[[field]]\nkey = \"material.clay.shear_modulus\"\ncov = 0.3\ntheta = [8.0, 4.0]\n"
      "[[correlation]]\nbetween = [\"material.clay.su_peak\", \"material.clay.shear_modulus\"]\nvalue = 0.6\n";
  EXPECT_THAT(message_on(gaussian + pair, {"seed = 3", "seed = 4"}),
      AllOf(HasSubstr("correlated fields have the same `correlation`"), HasSubstr("Got \"gaussian\" and \"markov\".")));
}

TEST(StudyFile, WhatIsDrawnTwiceOrNotAtAllIsTold)
{
  const std::string pair = "\n[[correlation]]\nbetween = [\"material.clay.su_peak\", \"material.clay.eta\"]\nvalue = ";
  const std::string eta =
      "\n[[random]]\nkey = \"material.clay.eta\"\ndistribution = \"uniform\"\nlowest = 2\nhighest = 8";
  const std::string twice = "cov = 0.4" + eta + pair + "0.9" + pair + "-0.5", one = "cov = 0.4" + eta + pair + "1.0";
  EXPECT_THAT(message_on(column_study, {"cov = 0.4", twice}),
      HasSubstr("`material.clay.su_peak` and `material.clay.eta` are correlated twice"));
  EXPECT_THAT(message_on(column_study, {"cov = 0.4", one}), HasSubstr("`value` is out of range"));
  EXPECT_THAT(message_on(column_study, {"number = 12", "number = 20000000"}),
      AllOf(HasSubstr("the study has too many realisations\n\n"), HasSubstr("At most 10000000.")));
  const std::string random = "{ random = { mean = 6e3, cov = 0.2, theta = [8.0, 4.0], box = [[0, 0], [4, 2]] } }";
  const ScratchFolder folder;
  const std::string column = changed(column_case, "su_peak = 6.0e3", "su_peak = " + random);
  EXPECT_THAT(refusal<CaseError>([&] { open_study(write_study(folder.path(), field_study, column)); }),
      HasSubstr("the mean of the field of `material.clay.su_peak` is a random field itself"));
  const std::string other =
      changed(changed(column_study, "material.clay.su_peak", "material.clay.eta"), "\"8 kPa\"", "8");
  const auto doubts = find_doubts(open_study(write_study(folder.path(), other, column)));
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_EQ(doubts[0].what, "the case has a random field at `material.clay.su_peak` that this study does not draw");
}

TEST(StudyFile, RowsOfATableAreChecked)
{
  const ScratchFolder folder;
  const std::string text = R"(case = "column.toml"
[estimator]
kind = "sweep"
form = "table"
[[sweep]]
key = "material.clay.eta"
values = [5, "8", -1]
)";
  EXPECT_THAT(refusal<CaseError>([&] { open_study(write_study(folder.path(), text)); }),
      HasSubstr("the case does not take row 2 of the table"));
  const Study study = open_study(write_study(folder.path(), changed(text, "-1", "1")));
  EXPECT_EQ(input_text(study, 0, draw_realisation(study, 1).inputs[0]), "8");
  EXPECT_EQ(input_text(study, 0, draw_realisation(study, 2).inputs[0]), "1") << "not the word at place 1";
}

TEST(StudyFile, FieldsThatTheCaseDoesNotTakeAreRefused)
{
  expect_messages(field_study,
      {
          {"su_peak", "su_remoulded", "the field of `material.clay.su_remoulded` needs `mean`"},
          {"material.clay.su_peak", "mesh.cell", "the field of `mesh.cell` needs `box`"},
          {"key = \"material.clay.su_peak\"", "key = \"material.clay.density\"\nbox = [[0, 0], [4, 2]]",
              "the case does not take the field of `material.clay.density`"},
          {"cov = 0.3", "cov = 0.3\ndistribution = \"normal\"", "a normal field so wide has negative values"},
          {"theta = [8.0, 4.0]", "theta = [8.0, 0.0]", "`theta` is out of range"},
          {"theta = [8.0, 4.0]", "theta = [8.0, 4.0]\nbox = [[0, 0], [3, 2]]",
              "`su_peak` has no value in part of the soil"},
      });
}

TEST(StudyFile, AFieldOfDensitySaysWhatDensityMayBe)
{
  const std::string message = message_on(
      field_study, {"key = \"material.clay.su_peak\"", "key = \"material.clay.density\"\nbox = [[0, 0], [4, 2]]"});
  EXPECT_THAT(message, HasSubstr("`density` cannot vary from place to place"));
  EXPECT_THAT(message, Not(HasSubstr("there is no material"))) << "one fault, one message";
}

TEST(StudyFile, AKeyThatIsNoNumberIsToldFromAnUnknownOne)
{
  const auto message = [](const char* key) {
    return message_on(column_study, {"key = \"material.clay.su_peak\"", key});
  };
  EXPECT_THAT(message("key = \"body.*.points_per_cell\""), HasSubstr("`body.*.points_per_cell` is not one number"));
  EXPECT_THAT(message("key = \"body.*.points_per_sell\""), HasSubstr("Did you mean `body.*.points_per_cell`?"));
}

TEST(StudyFile, ASlideOfMoreSoilThanThereIsIsRefused)
{
  EXPECT_THAT(message_on(column_study, {"volume = 1.0", "volume = 8.0"}),
      AllOf(HasSubstr(": no slide can be so large\n"), HasSubstr("volume = 8.0"),
          HasSubstr("Got 8 m^2; the case has 8 m^2 of soil. P(I) would be 0, whatever is drawn.")));
  EXPECT_THAT(message_on(column_study, {"displacement = 0.3", "displacement = 10.5"}),
      AllOf(HasSubstr(": no soil can move so far\n"), HasSubstr("Got 10.5 m; the mesh is 10.44 m from corner")));
  const ScratchFolder folder;
  EXPECT_NO_THROW(open_study(write_study(folder.path(), changed(column_study, "volume = 1.0", "volume = 7.9"))));
  const std::string sweep =
      "case = \"column.toml\"\n[estimator]\nkind = \"sweep\"\n[[sweep]]\nkey = \"material.clay.eta\"\nvalues = [5, 6]\n"
      "[events]\nvolume = 8.0\n";
  EXPECT_NO_THROW(open_study(write_study(folder.path(), sweep))) << "of a sample smaller than the default event, too";
}

// The river would slope down to the next place of the line.
TEST(StudyFile, OnePlaceOfALineOfTheWaterIsDoubted)
{
  const ScratchFolder folder;
  const std::string column = column_case + "[water]\nphreatic_line = [[0.0, 1.0], [8.0, 0.0]]\n";
  const auto doubts = [&](const char* key, const char* mean) {
    const std::string text = changed(changed(column_study, "material.clay.su_peak", key), "\"8 kPa\"", mean);
    return find_doubts(open_study(write_study(folder.path(), text, column)));
  };
  EXPECT_TRUE(doubts("material.clay.su_peak", "8e3").empty());
  const auto found = doubts("water.phreatic_line[0][1]", "0.5");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].key, "random[0].key");
  EXPECT_EQ(found[0].what, "`water.phreatic_line[0][1]` moves one place of the line, the others stay");
  EXPECT_THAT(found[0].detail, HasSubstr("For its level take [fragility]"));
}

TEST(StudyFile, AContradictingCorrelationNamesItsPair)
{
  const std::string more = R"([[random]]
key = "material.clay.eta"
distribution = "uniform"
lowest = 1
highest = 9
[[random]]
key = "material.clay.shear_modulus"
distribution = "lognormal"
mean = 1e6
cov = 0.1
[[correlation]]
between = ["material.clay.su_peak", "material.clay.eta"]
value = 0.9
[[correlation]]
between = ["material.clay.su_peak", "material.clay.shear_modulus"]
value = 0.3
[[correlation]]
between = ["material.clay.eta", "material.clay.shear_modulus"]
value = -0.8
)";
  const std::string message = message_on(column_study + more, {"seed = 3", "seed = 3"});
  EXPECT_THAT(message, AllOf(HasSubstr(": the correlations contradict each other\n"), HasSubstr("value = -0.8")));
  EXPECT_THAT(message, HasSubstr("Between `material.clay.eta` and `material.clay.shear_modulus` it is -0.8, which does "
                                 "not go with those before: the matrix is not positive definite."));
}

TEST(StudyFile, CellsThatAverageAFieldAreDoubted)
{
  const ScratchFolder folder;
  const auto doubts = [&](const std::string& text) { return find_doubts(study_in(folder.path(), text)); };
  EXPECT_TRUE(doubts(field_study).empty());
  const auto found = doubts(changed(field_study, "[8.0, 4.0]", "[8.0, 2.0]"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].what, "the cells hardly resolve the random field");
  EXPECT_THAT(found[0].detail, HasSubstr("has 86 % of the standard deviation of a point"))
      << "sqrt(2 (1 + exp(-1) - 1))";
}

TEST(StudyFile, ASlideThatIsSmallerThanAPointOrASettlementOrHugeIsDoubted)
{
  const ScratchFolder folder;
  const auto doubts = [&](const std::string& text) { return find_doubts(study_in(folder.path(), text)); };
  EXPECT_THAT(doubts(changed(column_study, "displacement = 0.3", "displacement = 3e-4")),
      ElementsAre(told("events.displacement", "soil that only settles counts as a slide", _)));
  EXPECT_THAT(doubts(changed(column_study, "displacement = 0.3", "displacement = 5.0")),
      ElementsAre(told("events.displacement", "a slide moves farther than the section is high", _)));
  EXPECT_THAT(doubts(changed(column_study, "volume = 1.0", "volume = 0.01")),
      ElementsAre(told("events.volume", "a slide may be smaller than a material point", _)));
}

}  // namespace study_file_test
