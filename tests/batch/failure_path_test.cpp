#include "batch/failure_path.hpp"

#include "batch/samples.hpp"
#include "batch/study_text.hpp"

#include <nlohmann/json.hpp>

namespace failure_path_test {

Study study_of_20() { return study_of(changed(column_study, "number = 12", "number = 20")); }

/// 20: 10 slide, of which 4 go on; of those 3 come below the water, one of them for a moment; of the other 6 one does.
/// The last has no result; the one before it slides as drawn.
Realisations rows_of(const Study& study)
{
  Realisations rows = rows_without_runs(study, [](Real) { return 0.0; });
  for (auto& [number, r] : rows) {
    const auto set = [&r = r](const char* name, Real value) { r.outcomes[outcome_number(name)] = value; };
    r.judges_flood = true, r.slid = number < 10;
    set("slides", r.slid ? number < 4 ? 2.0 : 1.0 : 0.0);
    const bool is_below = number < 3 || number == 5;
    set("flood_time", is_below ? 7.0 : std::nan(""));
    set("near", number == 2 ? 1.0 : 0.0);
    r.flooded = is_below;
  }
  rows.at(18).fault = "slides as drawn: no equilibrium", rows.at(18).slid = true, rows.at(18).outcomes.clear();
  rows.at(18).judges_flood = false;
  rows.at(19).fault = "stopped itself", rows.at(19).outcomes.clear();
  return rows;
}

std::array<std::int64_t, 3> counts(const PathEvent& event)
{
  return {event.estimate.happened, event.estimate.solved, event.estimate.failed};
}

TEST(FailurePath, HasEachEventGivenTheOneBefore)
{
  const Study study = study_of_20();
  const auto path = failure_path(study, rows_of(study));
  ASSERT_EQ(path.size(), 6u);
  EXPECT_EQ(path[0].key, "first_slide");
  EXPECT_THAT(counts(path[0]), ElementsAre(11, 19, 1));
  EXPECT_THAT(counts(path[1]), ElementsAre(4, 10, 2)) << "follow-up slides";
  EXPECT_THAT(counts(path[2]), ElementsAre(3, 4, 2)) << "ground below the water, after them";
  EXPECT_THAT(counts(path[3]), ElementsAre(1, 6, 2)) << "without them";
  EXPECT_THAT(counts(path[4]), ElementsAre(3, 4, 2)) << "not those that are near";
  EXPECT_THAT(counts(path[5]), ElementsAre(0, 8, 1)) << "a flood without a slide";
  EXPECT_DOUBLE_EQ(*path[1].estimate.probability(), 0.4);
  EXPECT_EQ(path[1].estimate.bounds.high, clopper_pearson(6, 12, 0.95).high) << "what is not known may have gone on";
  EXPECT_EQ(path[1].estimate.bounds.low, clopper_pearson(4, 12, 0.95).low);
}

TEST(FailurePath, IsInTextTableAndJsonInBothLanguages)
{
  const Study study = study_of_20();
  const Realisations rows = rows_of(study);
  EXPECT_THAT(study_text(study, rows),
      AllOf(HasSubstr("failure path (faalpad)"), HasSubstr("follow-up slides              given first slide"),
          HasSubstr("4 of 10, 2 unknown")));
  EXPECT_THAT(failure_path_csv(study, rows),
      AllOf(HasSubstr("nan,follow-up slides,vervolgafschuivingen,first slide,eerste afschuiving,4,10,2,0.4,"),
          HasSubstr("\"water flows over, to the end\"")));
  const auto path = nlohmann::json::parse(study_json(study, rows))["failure_path"];
  ASSERT_EQ(path.size(), 6u);
  EXPECT_EQ(path[0]["given"], "");
  EXPECT_EQ(path[3]["name"]["nl"], "grond onder het waterpeil");
  EXPECT_EQ(path[3]["given_name"]["nl"], "geen vervolgafschuiving");
  EXPECT_EQ(path[4]["happened"], 3);
  EXPECT_EQ(path[4]["of"], 4);
  EXPECT_EQ(path[4]["unknown"], 2);
}

TEST(FailurePath, OfACurveIsOneAtEachLevel)
{
  const Study study =
      study_of(changed(column_study, "number = 12", "number = 2") +
               "[fragility]\nlevels = [1.0, 2.0]\n[fragility.set]\n\"forces.gravity\" = [0.0, \"-h\"]\n");
  Realisations rows = rows_without_runs(study, [](Real) { return 0.0; });
  for (auto& [number, r] : rows) r.slid = study.level_of(number) == 1;
  EXPECT_THAT(counts(failure_path(study, rows, 0)[0]), ElementsAre(0, 2, 0));
  EXPECT_THAT(counts(failure_path(study, rows, 1)[0]), ElementsAre(2, 2, 0));
  EXPECT_THAT(counts(failure_path(study, rows, 1)[3]), ElementsAre(0, 0, 2)) << "no water is judged";
  const auto json = nlohmann::json::parse(study_json(study, rows));
  EXPECT_EQ(json["failure_path"].size(), 0u);
  EXPECT_EQ(json["levels"][1]["failure_path"][0]["happened"], 2);
}

TEST(FailurePath, IsNoneWhereRealisationsDoNotCountAlike)
{
  EXPECT_TRUE(has_failure_path(study_of(column_study)));
  EXPECT_FALSE(
      has_failure_path(study_of("case = \"column.toml\"\n[estimator]\nkind = \"sweep\"\n[[sweep]]\nkey = "
                                "\"material.clay.eta\"\nvalues = [5, 6]\n")));
}

}  // namespace failure_path_test
