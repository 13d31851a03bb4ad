// The same table on any number of threads, in parts, and after a part of it was lost.
#include "study/engine.hpp"

#include <fmt/format.h>

#include "output/run_folder.hpp"
#include "study/samples.hpp"
#include "study/study_folder.hpp"
#include "study/study_text.hpp"
#include "support/test.hpp"

namespace {

struct Place {
  ScratchFolder folder;
  Study study;
  explicit Place(const std::string& text, const std::string& column = column_case)
      : study(prepare_study(read_study(write_study(folder.path(), text, column))))
  {
  }

  std::string of(const std::string& name) const
  {
    const std::string path = folder.path() + '/' + name;
    make_folder(path);
    return path;
  }
  Realisations run(const std::string& name, EngineOptions options = {}) const
  {
    Realisations rows = read_store(study, of(name)).rows;
    run_realisations(study, of(name), options, never_stop, rows);
    return rows;
  }
};

TEST(Engine, TheTableHasTheSameBitsOnAnyNumberOfThreads)
{
  const Place place(column_study);
  const Realisations one = place.run("one");
  const std::string table = study_csv(place.study, one);
  EXPECT_EQ(std::ranges::count(table, '\n'), 13);
  const StudyEstimates e = estimate(place.study, one);
  EXPECT_GT(e.slide.happened, 0) << "some slide";
  EXPECT_LT(e.slide.happened, 12) << "and some do not";
  for (const int threads : {2, 4})
    EXPECT_EQ(study_csv(place.study, place.run(fmt::format("of_{}", threads), {.threads = threads})), table) << threads;
  EXPECT_EQ(study_csv(place.study, read_store(place.study, place.of("one")).rows), table) << "as it is read again";
}

TEST(Engine, PartsMakeTheWholeTable)
{
  const Place place(field_study);
  const std::string table = study_csv(place.study, place.run("whole"));
  for (const Index k : {2, 1, 3}) place.run("parts", {.part = {k, 3}});
  EXPECT_EQ(study_csv(place.study, read_store(place.study, place.of("parts")).rows), table);
}

TEST(Engine, WhatAKillHasCutIsMadeAgain)
{
  const Place place(column_study);
  const std::string table = study_csv(place.study, place.run("whole"));
  const std::string file = place.of("whole") + "/part_1_of_1.rows", text = read_file(file);
  for (const std::size_t size : {text.size() - 1, text.size() - 40, text.size() / 2, std::size_t{30}, std::size_t{0}}) {
    write_file_atomically(place.of("cut") + "/part_1_of_1.rows", text.substr(0, size));
    EXPECT_LE(read_store(place.study, place.of("cut")).rows.size(), size + 1 < text.size() ? 11u : 12u);
    EXPECT_EQ(study_csv(place.study, place.run("cut", {.threads = 2})), table) << size;
  }
}

TEST(Engine, AStoreOfAnotherStudyIsRefused)
{
  const Place place(column_study), seed(changed(column_study, "seed = 3", "seed = 4"));
  place.run("done");
  EXPECT_THAT(refusal<FileError>([&] { read_store(seed.study, place.of("done")); }),
      HasSubstr("this is the store of another study: what is drawn, its seed or the events are others"));
  const Place stiffer(changed(column_study, "seed = 3", "seed = 3\nset = { \"material.clay.density\" = 2000.0 }"));
  EXPECT_THAT(refusal<FileError>([&] { read_store(stiffer.study, place.of("done")); }), HasSubstr("another study"));
  write_file_atomically(place.of("bad") + "/part_1_of_1.rows", "0123456789abcdef\tother\n");
  EXPECT_EQ(read_store(place.study, place.of("bad")).n_broken, 1);
}

TEST(Engine, RealisationsThatFailAreCountedAndBoundP)
{
  // Where the field falls below the residual strength, the case is refused.
  const Place place(changed(field_study, "number = 6", "number = 12"),
      changed(column_case, "sensitivity = 2.0", "su_residual = 4.5e3"));
  const Realisations rows = place.run("some");
  const StudyEstimates e = estimate(place.study, rows);
  EXPECT_EQ(e.slide.solved + e.slide.failed, 12);
  ASSERT_GT(e.slide.failed, 0);
  ASSERT_GT(e.slide.solved, 0);
  ASSERT_EQ(e.faults.size(), 1u);
  EXPECT_THAT(e.faults[0].what,
      StartsWith("refused: material.clay.su_residual: the residual strength exceeds the peak strength"));
  EXPECT_EQ(e.slide.bounds.low, clopper_pearson(e.slide.happened, 12, 0.95).low);
  EXPECT_EQ(e.slide.bounds.high, clopper_pearson(e.slide.happened + e.slide.failed, 12, 0.95).high);
  EXPECT_THAT(study_text(place.study, rows), HasSubstr("Failed realisations count in both bounds"));
}

// The volume of the event has moved as far as its displacement where, and only where, the event happened.
TEST(Engine, TheDisplacementOfTheVolumeSaysHowFarAwayTheEventIs)
{
  const Place place(column_study);
  Real of_what_stands = 0.0;
  for (const auto& [number, r] : place.run("all")) {
    const Real moved = r.outcomes[outcome_number("event_displacement")];
    EXPECT_EQ(moved >= 0.3, r.slid) << number << ": " << moved << " m";
    EXPECT_GT(moved, 0.0) << "soil that stands moves a little";
    if (!r.slid) of_what_stands = std::max(of_what_stands, moved);
  }
  EXPECT_GT(of_what_stands, 1e-4);
}

TEST(Engine, ACopyOfTheStudyReadsItsStore)
{
  const Place place(field_study);
  const std::string folder = place.of("copied");
  prepare_study_folder(place.study, folder, {});
  const std::string table = study_csv(place.study, place.run("copied"));
  std::filesystem::remove(place.folder.path() + "/column.toml");
  const Study copy = open_study(folder);
  EXPECT_EQ(study_csv(copy, read_store(copy, folder).rows), table);
}

}  // namespace
