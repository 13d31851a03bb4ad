#include "io/results/mesh_study.hpp"
#include "io/results/runs.hpp"
#include "io/results/sequences.hpp"

namespace mesh_study_test {

constexpr Real none = std::numeric_limits<Real>::quiet_NaN();

TEST(MeshStudy, ASequenceThatNearsItsLimitIsSettledWithOrderLimitAndError)
{
  const std::vector<Real> cells{0.9, 0.3, 0.2};  // ratios 3 and 1.5
  std::vector<Real> values;
  for (const Real h : cells) values.push_back(12.0 - 0.5 * std::pow(h, 1.4));
  const StudyQuantity q = judged(cells, values);
  EXPECT_EQ(q.answer, MeshAnswer::settled);
  EXPECT_NEAR(q.estimate.order, 1.4, 1e-9);
  EXPECT_NEAR(q.estimate.limit, 12.0, 1e-9);
  EXPECT_THAT(q.relative_error(), Optional(DoubleNear(1.25 * 0.5 * std::pow(0.2, 1.4) / values[2], 1e-9)));
  EXPECT_EQ(sentence_on(q),
      "front: 11.95 m, changes by 0.3 % between the last two sizes; order 1.4, tends to 12.00 m, error 0.5 %");
}

TEST(MeshStudy, ASmallLastChangeIsNotEnoughWhereTheErrorIsLarge)
{
  std::vector<Real> values;
  for (const Real h : {0.4, 0.2, 0.1}) values.push_back(10.0 + std::pow(h, 0.6));
  const StudyQuantity q = judged({0.4, 0.2, 0.1}, values);
  EXPECT_LT(*q.relative_change(), 0.02);  // and 3 % to go
  EXPECT_EQ(q.answer, MeshAnswer::tends);
  EXPECT_EQ(sentence_on(q),
      "front: still changes, by 1.3 % between the last two sizes: 10.58, 10.38, 10.25 m; order 0.6, tends to 10.00 m, "
      "error 3.1 %");
  EXPECT_EQ(judged({0.4, 0.2, 0.1}, {10.0, 10.05, 10.15}).answer, MeshAnswer::depends);  // 1 %, and growing
}

TEST(MeshStudy, AnOscillatingSequenceHasNoOrder)
{
  const StudyQuantity q = judged({0.4, 0.2, 0.1}, {4.1, 3.5, 5.8});
  EXPECT_EQ(q.answer, MeshAnswer::depends);
  EXPECT_FALSE(q.has_order);
  EXPECT_EQ(sentence_on(q), "front: depends on the mesh: 4.10, 3.50, 5.80 m; no order: it goes up and down");
  EXPECT_EQ(judged({0.4, 0.2, 0.1}, {4.1, 5.8, 5.79}).answer, MeshAnswer::depends);  // 0.2 %, perhaps by chance
  const StudyQuantity near = judged({0.4, 0.2, 0.1}, {5.82, 5.8, 5.81});
  EXPECT_EQ(near.answer, MeshAnswer::settled);
  EXPECT_THAT(
      sentence_on(near), EndsWith("changes by 0.2 % between the last two sizes; no order: it goes up and down"));
}

TEST(MeshStudy, OrdersThatNobodyShouldUseAreSaidSo)
{
  EXPECT_EQ(sentence_on(judged({0.4, 0.2, 0.1}, {4.0, 5.0, 7.0})),
      "front: depends on the mesh: 4.00, 5.00, 7.00 m; no order: the differences do not fall");
  const StudyQuantity steep = judged({0.4, 0.2, 0.1}, {4.0, 8.0, 8.25});
  EXPECT_EQ(steep.answer, MeshAnswer::depends);
  EXPECT_THAT(sentence_on(steep), EndsWith("; the observed order, 4, is not usable"));
  EXPECT_EQ(steep.relative_error(), std::nullopt);
}

TEST(MeshStudy, TwoSizesHaveAChangeAndNoOrder)
{
  const StudyQuantity q = judged({0.4, 0.2}, {4.0, 4.04});
  EXPECT_EQ(q.answer, MeshAnswer::settled);
  EXPECT_EQ(sentence_on(q), "front: 4.04 m, changes by 1.0 % between the last two sizes");
  EXPECT_THAT(remarks_on({"", {}, runs_with({0.4, 0.2}, {4.0, 4.04})}),
      ElementsAre("Two sizes give no order and no estimate of the error: that takes three."));
}

TEST(MeshStudy, AnEventThatSomeSizesDoNotHaveDependsOnTheMesh)
{
  const StudyQuantity q = judged({0.4, 0.2, 0.1}, {none, 2.31, 2.3}, MeasureKind::time);
  EXPECT_EQ(q.answer, MeshAnswer::some_sizes);
  EXPECT_EQ(q.change, std::nullopt);
  EXPECT_EQ(sentence_on(q), "front: depends on the mesh, only some sizes have it: none, 2.31, 2.30 m");
}

TEST(MeshStudy, ARunThatFailedIsLeftOutAndTheOthersAreJudged)
{
  auto runs = runs_with({0.8, 0.4, 0.2, 0.1}, {11.0, 10.4, none, 10.1});
  runs[2].fault = "step 3: too fast";
  const StudyQuantity q = judge_sizes(measure_of(MeasureKind::amount), runs, 0.02);
  EXPECT_THAT(q.change, Optional(DoubleNear(-0.3, 1e-12)));
  EXPECT_NEAR(q.estimate.order, std::log2(1.0 + std::sqrt(3.0)), 1e-9);  // ratios 2 and 4: x^2/(x + 1) = 2, x = 2^p
  EXPECT_THAT(remarks_on({"", {}, runs}), ElementsAre("No result on cells of 0.2 m: step 3: too fast"));
  runs[3].fault = runs[1].fault = runs[2].fault;
  EXPECT_EQ(judge_sizes(measure_of(MeasureKind::amount), runs, 0.02).answer, MeshAnswer::none);
  EXPECT_EQ(
      answer_of({{"", {}, runs}, {}}, 0.02), "Fewer than two sizes were solved: nothing can be said of the mesh.");
}

TEST(MeshStudy, ZerosHaveNoShareAndEqualValuesNoChange)
{
  EXPECT_EQ(sentence_on(judged({0.4, 0.2, 0.1}, {0.0, 0.0, 0.0})), "front: 0.00 m at all sizes");
  EXPECT_EQ(judged({0.4, 0.2, 0.1}, {7.0, 7.0 + 1e-12, 7.0}).answer, MeshAnswer::same);
  const StudyQuantity q = judged({0.4, 0.2, 0.1}, {0.4, 0.2, 0.0});
  EXPECT_EQ(q.relative_change(), std::nullopt);
  EXPECT_EQ(q.answer, MeshAnswer::depends);
  const StudyQuantity still = judged({0.4, 0.2, 0.1}, {3.0, 7.0, 7.0 * (1.0 + 1e-15)});
  EXPECT_EQ(*still.change, 0.0);
  EXPECT_FALSE(still.has_order);
}

TEST(MeshStudy, APlaceIsSeenAgainstItsDistanceWhereverTheOriginLies)
{
  RunMeasure place = measure_of(MeasureKind::place);
  place.distance = [](const RunResults&) { return std::optional(4.0); };
  for (const Real origin : {0.0, 1000.0})
    EXPECT_NEAR(
        *judge_sizes(place, runs_with({0.4, 0.2}, {origin + 4.0, origin + 4.1}), 0.02).relative_change(), 0.025, 1e-9);
  place.distance = [](const RunResults&) { return std::optional(1e-6); };  // it stood still: a share of one cell
  EXPECT_NEAR(*judge_sizes(place, runs_with({0.4, 0.2}, {4.0, 4.001}), 0.02).relative_change(), 0.005, 1e-9);
}

TEST(MeshStudy, ADifferenceBelowTheResolutionCannotBeToldFromNone)
{
  RunMeasure crest = measure_of(MeasureKind::place);
  crest.resolution = [](const RunResults&, Real cell) { return cell; };
  crest.in_steps = true;
  const StudyQuantity q = judge_sizes(crest, runs_with({0.8, 0.4, 0.2}, {5.6, 5.2, 5.0}), 0.02);
  EXPECT_EQ(q.answer, MeshAnswer::unresolved);
  EXPECT_FALSE(q.has_order);  // though 0.4 and 0.2 look like order 1
  EXPECT_THAT(
      sentence_on(q), HasSubstr("within its resolution of 0.40 m; no order: it moves in steps of its resolution"));
}

TEST(MeshStudy, APlaceHasAsManyDigitsAsShowATenthOfItsResolution)
{
  RunMeasure front = measure_of(MeasureKind::place);
  for (const auto& [cell, text] : {std::pair{0.4, "5.00"}, {0.04, "5.000"}, {0.01, "5.000"}, {0.004, "5.0000"}}) {
    front.resolution = [cell = cell](const RunResults&, Real) { return cell; };
    EXPECT_EQ(text_of(judge_sizes(front, runs_with({2.0 * cell, cell}, {5.5, 5.0}), 0.02).measure, 5.0), text);
  }
}

TEST(MeshStudy, CountsAndWordsAreEqualOrNot)
{
  EXPECT_EQ(judged({0.4, 0.2, 0.1}, {1.0, 2.0, 2.0}, MeasureKind::count).answer, MeshAnswer::depends);
  EXPECT_EQ(judged({0.4, 0.2, 0.1}, {100.0, 101.0, 101.0}, MeasureKind::count).answer, MeshAnswer::depends);
  RunMeasure verdict = measure_of(MeasureKind::word);
  verdict.words = {"stands", "floods"}, verdict.unit = "-";
  const StudyQuantity q = judge_sizes(verdict, runs_with({1.0, 0.5}, {0.0, 1.0}), 0.02);
  EXPECT_EQ(sentence_on(q), "front: depends on the mesh: stands, floods");
  EXPECT_EQ(sentence_on(judge_sizes(verdict, runs_with({1.0, 0.5}, {1.0, 1.0}), 0.02)), "front: floods at all sizes");
}

/// A sequence of runs on these cells with these fronts and a run-out of 10 m; a run whose front is NaN has failed.
StudySequence sequence_with(const std::string& name, const std::vector<Real>& cells, const std::vector<Real>& fronts)
{
  StudySequence sequence{name, {}, {}};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    sequence.runs.push_back({.cell = cells[k], .size = cells[k], .folder = "cell"});
    if (std::isnan(fronts[k])) {
      sequence.runs[k].fault = "stopped";
      continue;
    }
    const ScratchFolder scratch;
    write_run(scratch.path() + "/run", [&](Summary& s) { s.front_x = fronts[k], s.run_out = 10.0; });
    sequence.runs[k].results = read_run(scratch.path() + "/run");
  }
  return sequence;
}

const StudySpread& front_of(const MeshStudy& study)
{
  return *std::ranges::find_if(study.spreads, [](const StudySpread& s) { return s.measure.name == "front_x"; });
}

TEST(MeshStudy, SetsVariantsBesideEachOtherOnTheSmallestCellsThatAllHave)
{
  const Real none = std::numeric_limits<Real>::quiet_NaN();
  const MeshStudy study = study_mesh({sequence_with("as given", {0.4, 0.2, 0.1}, {11.0, 12.0, 12.5}),
                                         sequence_with("mesh.turn=45", {0.4, 0.2, 0.1}, {11.0, 12.6, none})},
      0.02);
  EXPECT_EQ(study.spread_cell, 0.2);
  EXPECT_THAT(front_of(study).values, ElementsAre(std::optional(12.0), std::optional(12.6)));
  EXPECT_NEAR(*front_of(study).range, 0.6, 1e-12);
  EXPECT_NEAR(*front_of(study).share, 0.06, 1e-12);  // of a run-out of 10 m
  EXPECT_TRUE(front_of(study).matters);
  EXPECT_THAT(answer_on_variants(study),
      AllOf(StartsWith("On cells of 0.2 m, as given and with 1 variant: "), HasSubstr("front at the end (6.0 %)")));
}

TEST(MeshStudy, VariantsThatAgreeWithinTheToleranceDoNotMatter)
{
  const MeshStudy study = study_mesh(
      {sequence_with("as given", {0.4, 0.2}, {11.0, 12.0}), sequence_with("b", {0.4, 0.2}, {11.0, 12.19})}, 0.02);
  EXPECT_FALSE(front_of(study).matters);
  EXPECT_EQ(answer_on_variants(study),
      "On cells of 0.2 m, as given and with 1 variant: nothing differs by more than 2.0 % or its resolution.");
}

TEST(MeshStudy, VariantsAreJudgedByTheResolutionOfTheirOwnCells)
{
  const MeshStudy study = study_mesh(
      {sequence_with("as given", {2.0, 1.0}, {11.0, 12.0}), sequence_with("b", {2.0, 1.0}, {11.0, 12.4})}, 0.02);
  EXPECT_NEAR(*front_of(study).share, 0.04, 1e-12);
  EXPECT_TRUE(front_of(study).matters) << "0.4 m is more than a quarter of 1 m, and less than a quarter of 2 m";
}

TEST(MeshStudy, NothingIsSaidOfVariantsWhereThereIsOneOrNoSizeInCommon)
{
  const Real none = std::numeric_limits<Real>::quiet_NaN();
  EXPECT_EQ(answer_on_variants(study_mesh({sequence_with("as given", {0.4, 0.2}, {11.0, 12.0})}, 0.02)), "");
  const MeshStudy apart = study_mesh(
      {sequence_with("as given", {0.4, 0.2}, {none, 12.0}), sequence_with("b", {0.4, 0.2}, {11.0, none})}, 0.02);
  EXPECT_TRUE(apart.spreads.empty());
}

}  // namespace mesh_study_test
