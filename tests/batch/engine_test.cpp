#include "batch/engine.hpp"

#include <fmt/format.h>

#include <regex>

#include "io/files/run_folder.hpp"
#include "batch/samples.hpp"
#include "batch/study_folder.hpp"
#include "batch/study_text.hpp"

#include <thread>

namespace engine_test {

Real outcome(const Realisation& r, const char* name) { return r.outcomes[outcome_number(name)]; }

TEST(Engine, TheTableHasTheSameBitsOnAnyNumberOfThreads)
{
  const StudyWithStores place(column_study);
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
  const StudyWithStores place(field_study);
  const std::string table = study_csv(place.study, place.run("whole"));
  for (const Index k : {2, 1, 3}) place.run("parts", {.part = {k, 3}});
  EXPECT_EQ(study_csv(place.study, read_store(place.study, place.of("parts")).rows), table);
}

TEST(Engine, APartEndsWhereAllPartsTogetherMeetTheRule)
{
  const StudyWithStores place(changed(column_study, "number = 12", "number = 240\ncov = 0.3"));
  const std::string table = study_csv(place.study, place.run("whole"));
  place.run("other", {.part = {2, 2}});
  const auto n_of_part_1 = [&](const std::string& store, double look_every) {
    const std::string file = place.of(store) + "/part_2_of_2.rows";
    place.run(store, {.part = {1, 2}, .look_every = look_every, .show = [&](const auto&, const auto&) {
                        if (!std::filesystem::exists(file))
                          std::filesystem::copy(place.of("other") + "/part_2_of_2.rows", file);
                      }});
    EXPECT_EQ(study_csv(place.study, read_store(place.study, place.of(store)).rows), table) << "cut by the rule";
    return std::ranges::count(read_file(place.of(store) + "/part_1_of_2.rows"), '\n') - 1;
  };
  EXPECT_LT(std::ranges::count(table, '\n'), 60);
  EXPECT_EQ(n_of_part_1("late", 1e6), 120);
  EXPECT_LT(n_of_part_1("soon", 0.0), 120) << "64 at most are under way when the rule is met";
}

TEST(Engine, WhatAKillHasCutIsMadeAgain)
{
  const StudyWithStores place(column_study);
  const std::string table = study_csv(place.study, place.run("whole"));
  const std::string file = place.of("whole") + "/part_1_of_1.rows", text = read_file(file);
  for (const std::size_t size : {text.size() - 1, text.size() - 40, text.size() / 2, std::size_t{30}, std::size_t{0}}) {
    write_file_atomically(place.of("cut") + "/part_1_of_1.rows", text.substr(0, size));
    EXPECT_LE(read_store(place.study, place.of("cut")).rows.size(), size + 1 < text.size() ? 11u : 12u);
    EXPECT_EQ(study_csv(place.study, place.run("cut", {.threads = 2})), table) << size;
    EXPECT_EQ(study_csv(place.study, read_store(place.study, place.of("cut")).rows), table) << "read again, " << size;
  }
}

TEST(Engine, AStoreOfAnotherStudyIsRefused)
{
  const StudyWithStores place(column_study), seed(changed(column_study, "seed = 3", "seed = 4"));
  place.run("done");
  EXPECT_THAT(refusal<FileError>([&] { read_store(seed.study, place.of("done")); }),
      HasSubstr("this is the store of another study: what is drawn, its seed or the events are others"));
  const StudyWithStores stiffer(
      changed(column_study, "seed = 3", "seed = 3\nset = { \"material.clay.density\" = 2000.0 }"));
  EXPECT_THAT(refusal<FileError>([&] { read_store(stiffer.study, place.of("done")); }), HasSubstr("another study"));
  write_file_atomically(place.of("bad") + "/part_1_of_1.rows", "0123456789abcdef\tother\n");
  EXPECT_EQ(read_store(place.study, place.of("bad")).n_broken, 1);
}

TEST(Engine, TheFormatOfTheStoreIsThatOfTheDocuments)
{
  const StudyWithStores place(column_study);
  place.run("one");
  const std::string head = read_file(place.of("one") + "/part_1_of_1.rows");
  std::smatch format;
  ASSERT_TRUE(std::regex_search(head, format, std::regex("\tterp study\t([0-9]+)\t")));
  EXPECT_THAT(read_file(source_path("docs/formats.md")),
      HasSubstr(fmt::format("the number of the format ({})", format[1].str())));
}

TEST(Engine, RealisationsThatFailAreCountedAndBoundP)
{
  // Where the field falls below the residual strength, the case is refused.
  const StudyWithStores place(changed(field_study, "number = 6", "number = 12"),
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
  const StudyWithStores place(column_study);
  Real of_what_stands = 0.0;
  for (const auto& [number, r] : place.run("all")) {
    const Real moved = r.outcomes[outcome_number("event_displacement")];
    EXPECT_EQ(moved >= 0.3, r.slid) << number << ": " << moved << " m";
    EXPECT_GT(moved, 0.0) << "soil that stands moves a little";
    if (!r.slid) of_what_stands = std::max(of_what_stands, moved);
  }
  EXPECT_GT(of_what_stands, 1e-4);
}

TEST(Engine, ARunThatEndsWhileSoilFallsSaysSo)
{
  // Without damping what stands goes on vibrating.
  const std::string damped = changed(column_case, "-9.81]\n", "-9.81]\ndamping = { local = 0.3 }\n");
  const StudyWithStores soon(column_study, damped), late(column_study, changed(damped, "end = 0.8", "end = 4.0"));
  const auto early = soon.run("soon"), rest = late.run("late");
  int n_moving = 0, n_later = 0;
  for (const auto& [number, r] : early) {
    const bool moves = !r.slid && r.outcomes[outcome_number("still_moves")] == 1.0;
    n_moving += moves, n_later += moves && rest.at(number).slid;
    if (!rest.at(number).slid) {
      EXPECT_EQ(rest.at(number).outcomes[outcome_number("still_moves")], 0.0) << number << " rests";
    }
  }
  EXPECT_GT(n_moving, 0);
  EXPECT_GT(n_later, 0) << "P(I) of the early end is too low";
}

/// What slid in a stage has slid, whatever is counted anew after it.
TEST(Engine, ASlideOfAnyStageCounts)
{
  const auto staged = [](const std::string& key) {
    return changed(column_case, "[time]\nend = 0.8\ncourant = 0.5", "[time]\ncourant = 0.5") +
           "[[stage]]\nname = \"daily\"\nduration = 0.79\n[[stage]]\nname = \"late\"\nduration = 0.01\n" + key;
  };
  const StudyWithStores plain(column_study, staged("")), anew(column_study, staged("reset_displacement = true\n"));
  const Realisations a = plain.run("plain"), b = anew.run("anew");
  int n_slid = 0;
  for (const auto& [number, r] : a) {
    n_slid += r.slid;
    EXPECT_EQ(r.slid, b.at(number).slid) << number;
    const Real way = outcome(r, "event_displacement");
    if (!r.slid) continue;
    EXPECT_NEAR(outcome(b.at(number), "event_displacement"), way, 0.1 * way) << number;
  }
  EXPECT_GT(n_slid, 1);
}

TEST(Engine, AResultThatDiffersIsNamed)
{
  std::vector<Real> kept(study_outcomes().size(), 0.1), now = kept;
  kept[outcome_number("flood_time")] = now[outcome_number("flood_time")] = std::nan("");
  EXPECT_TRUE(differing_outcomes(kept, now).empty());
  now[outcome_number("slide_volume")] = std::nextafter(0.1, 1.0);
  now[outcome_number("flood_time")] = 0.5;
  kept[outcome_number("first_slide_time")] = std::nan("");
  EXPECT_THAT(differing_outcomes(kept, now), ElementsAre("slide_volume", "first_slide_time", "flood_time"));
}

TEST(Engine, SoilTooWeakToStandAsDrawnIsCountedAsASlide)
{
  const StudyWithStores place(changed(column_study, "number = 12", "number = 6"),
      changed(column_case, "su_peak = 6.0e3\nsensitivity = 2.0", "su_peak = 6.0e3\nsensitivity = 1.0") +
          "[initial]\nstress = \"equilibrium\"\n");
  const Realisations rows = place.run("weak");
  const StudyEstimates e = estimate(place.study, rows);
  ASSERT_GT(e.counts.slid_as_drawn, 0);
  EXPECT_EQ(e.counts.failed, 0);
  Real weakest = 1e9, strongest = 0.0;
  for (const auto& [number, r] : rows) {
    if (r.slides_as_drawn()) strongest = std::max(strongest, r.inputs[0]);
    if (r.solved() && !r.slid) weakest = std::min(weakest, r.inputs[0]);
    if (!r.slides_as_drawn()) continue;
    EXPECT_THAT(r.fault, MatchesRegex("slides as drawn: no equilibrium: the soil fails in the section as it is drawn; "
                                      "after .* where soil moved furthest from [^\n]* by [0-9.]+ m"));
  }
  EXPECT_LT(strongest, weakest) << "they are the weakest: without them P is too low";
  EXPECT_EQ(study_csv(place.study, read_store(place.study, place.of("weak")).rows), study_csv(place.study, rows));
}

/// Ground that is below the water for a moment is near a flood: F, on the safe side, and told.
TEST(Engine, NearAFloodIsAFlood)
{
  const std::string dips = changed(
      column_case, "[time]\nend = 0.8", "[flood]\nwater_level = 1.99\n[initial]\nstress = \"none\"\n[time]\nend = 0.8");
  const StudyWithStores place(changed(column_study, "number = 12", "number = 6"), dips);
  const Realisations rows = place.run("near");
  int n_near = 0;
  for (const auto& [number, r] : rows) {
    ASSERT_TRUE(r.solved()) << r.fault;
    if (outcome(r, "near") != 1.0) continue;
    ++n_near;
    EXPECT_TRUE(r.flooded) << number;
  }
  ASSERT_GT(n_near, 0) << "0.8 s are too short for a flood";
  const StudyEstimates e = estimate(place.study, rows);
  EXPECT_EQ(e.n_near, n_near);
  EXPECT_GE(e.flood.happened, n_near);
  EXPECT_EQ(e.flood.failed, e.n_moving_without_flood);
  EXPECT_THAT(study_text(place.study, rows), HasSubstr("as F (docs/flood.md)"));
}

/// The same draws: what slides as drawn is held for a moment, and released. So F is known of all that come to rest.
TEST(Engine, WhatSlidesAsDrawnIsHeldAndReleased)
{
  const std::string weak = changed(column_case, "[time]\nend = 0.8\ncourant = 0.5", "[time]\ncourant = 0.5") +
                           "[initial]\nstress = \"equilibrium\"\n[flood]\nwater_level = 1.9\n[[stage]]\nname = "
                           "\"daily\"\nduration = 0.8\n";
  const std::string of_weak = changed(column_study, "number = 12", "number = 6");
  const StudyWithStores as_drawn(of_weak, weak), released(of_weak + R"([held]
stage = [
  { name = "rise", duration = 0.2, set = { at_strength = 0.25 } },
  { name = "release", ramp = 0.4, duration = 4.0, set = { at_strength = 1.0 }, reset_displacement = true },
]
)",
                                                     weak);
  const Realisations before = as_drawn.run("drawn"), after = released.run("released");
  int n_as_drawn = 0;
  for (const auto& [number, r] : before) {
    const Realisation& now = after.at(number);
    ASSERT_TRUE(now.solved()) << now.fault;
    EXPECT_EQ(outcome(now, "held"), r.slides_as_drawn() ? 1.0 : 0.0) << number;
    n_as_drawn += r.slides_as_drawn();
    if (r.slides_as_drawn()) {
      EXPECT_TRUE(now.slid && now.judges_flood) << number << ": way " << outcome(now, "event_displacement");
    } else {
      EXPECT_THAT(differing_outcomes(now.outcomes, r.outcomes), IsEmpty()) << number << " stands without being held";
    }
  }
  ASSERT_GT(n_as_drawn, 0);
  const StudyEstimates e = estimate(released.study, after);
  EXPECT_EQ(e.n_held, n_as_drawn);
  EXPECT_EQ(e.flood_after_slide.failed, e.n_moving_without_flood);
  EXPECT_EQ(e.flood_after_slide.solved + e.flood_after_slide.failed, n_as_drawn);
  EXPECT_EQ(estimate(as_drawn.study, before).flood_after_slide.failed, n_as_drawn);
  EXPECT_THAT(study_text(released.study, after), HasSubstr("solved once more with [held]"));
}

TEST(Engine, ACopyOfTheStudyReadsItsStore)
{
  const StudyWithStores place(field_study);
  const std::string folder = place.of("copied");
  write_copies(place.study, StudyPlace(folder, "part_1_of_1"));
  const std::string table = study_csv(place.study, place.run("copied"));
  std::filesystem::remove(place.folder.path() + "/column.toml");
  const Study copy = open_study(folder);
  EXPECT_EQ(study_csv(copy, read_store(copy, folder).rows), table);
}

TEST(Engine, FilesThatTheStudyNamesArePartOfIt)
{
  const ScratchFolder folder;
  const std::string table = folder.path() + "/su.csv";
  write_file_atomically(table, "x,y,value\n0,0,6e3\n4,2,9e3\n");
  const std::string text = changed(field_study, "cov = 0.3", "cov = 0.3\nmean = { csv = \"su.csv\" }");
  const std::string path = write_study(folder.path(), text), results = folder.path() + "/results";
  const Study study = open_study(path);
  write_copies(study, StudyPlace(results, "part_1_of_1"));
  EXPECT_THAT(read_file(results + "/study.toml"), HasSubstr("csv = \"study_file_1.csv\""));
  EXPECT_EQ(read_file(results + "/study_file_1.csv"), read_file(table));
  EXPECT_EQ(open_study(results).study_digits, study.study_digits) << "under another name";
  EXPECT_EQ(draw_realisation(open_study(results), 1).inputs, draw_realisation(study, 1).inputs);
  write_file_atomically(table, "x,y,value\n0,0,6e3\n4,2,9.5e3\n");
  EXPECT_NE(open_study(path).study_digits, study.study_digits) << "another strength, another study";
  const std::string sweep = R"(case = "column.toml"
[estimator]
kind = "sweep"
[[sweep]]
key = "material.clay.su_peak"
values = [6e3, { csv = "su.csv" }]
)";
  write_file_atomically(path, sweep);
  const std::string before = open_study(path).study_digits;
  write_file_atomically(table, "x,y,value\n0,0,6e3\n4,2,9.7e3\n");
  EXPECT_NE(open_study(path).study_digits, before);
}

TEST(Engine, AnotherLibraryOfTheSameNameIsAnotherStudy)
{
  const ScratchFolder folder;
  write_file_atomically(folder.path() + "/law.so", "first build");
  const std::string path = write_study(folder.path(), column_study + "[set]\n\"material.clay.library\" = \"law.so\"\n");
  const auto identity = [&] { return identity_text(read_study(path)); };
  const std::string before = identity();
  write_file_atomically(folder.path() + "/law.so", "second build");
  EXPECT_NE(identity(), before);
}

TEST(Engine, NumbersOfASweepAreInTheTableInFull)
{
  const StudyWithStores place(R"(case = "column.toml"
[estimator]
kind = "sweep"
[[sweep]]
key = "material.clay.shear_modulus"
values = [1000001, 1000002]
)");
  EXPECT_THAT(study_csv(place.study, place.run("swept")), AllOf(HasSubstr(",1000001,"), HasSubstr(",1000002,")));
}

TEST(Engine, ACopyFollowsTheStudyAsLongAsItIsTheSame)
{
  const StudyWithStores place(column_study);
  const std::string folder = place.of("results");
  write_copies(place.study, StudyPlace(folder, "report"));
  const std::string path =
      write_study(place.folder.path(), changed(column_study, "seed = 3", "seed = 3\nconfidence = 0.8"));
  write_copies(open_study(path), StudyPlace(folder, "report"));
  EXPECT_EQ(open_study(folder).settings.confidence, 0.8);
  const std::string copy = read_file(folder + "/study.toml");
  write_copies(open_study(folder), StudyPlace(folder, "report"));
  EXPECT_EQ(read_file(folder + "/study.toml"), copy) << "a copy is not copied onto itself";
}

TEST(Engine, FoldersOfTheUserAreLeftAlone)
{
  const StudyWithStores place(column_study);
  const auto refused = [&](const std::string& folder) {
    return refusal<FileError>([&] { check_study_folder(place.study, folder); });
  };
  EXPECT_THAT(refused(place.folder.path()),
      HasSubstr(
          "the folder holds the study file, in whose place a copy would be written\n  Give the results a folder of "
          "their own: -o DIR"));
  EXPECT_EQ(refused(place.of("empty")), "");
  write_file_atomically(place.of("other") + "/study.toml", "case = \"mine.toml\"\n");
  EXPECT_THAT(refused(place.of("other")), HasSubstr("the folder holds a study.toml that Terp did not write"));
  write_file_atomically(place.of("run") + "/case.toml", column_case);
  EXPECT_THAT(refused(place.of("run")), HasSubstr("the folder holds a case.toml of something else"));
  const std::string own = place.of("own");
  write_file_atomically(own + "/study.toml", column_study);
  write_file_atomically(own + "/column.toml", column_case);
  EXPECT_THAT(refusal<FileError>([&] { check_study_folder(open_study(own), own); }), HasSubstr("holds the study file"));
  write_copies(place.study, StudyPlace(place.of("copied"), "report"));
  EXPECT_EQ(refused(place.of("copied")), "");
  EXPECT_EQ(refusal<FileError>([&] { check_study_folder(open_study(place.of("copied")), place.of("copied")); }), "");
}

TEST(Engine, AReportAndTheEndOfARunWriteOneAfterTheOther)
{
  const ScratchFolder folder;
  std::optional<StudyPlace> report(place_of_results(folder.path()));
  std::atomic<bool> written{false};
  std::thread end([&] {
    const StudyPlace place = place_of_results(folder.path());
    written = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(250));
  EXPECT_FALSE(written) << "it would be replaced by what the report read before";
  report.reset();
  end.join();
  EXPECT_TRUE(written);
}

TEST(Engine, AStoreIsClearedByWhoHoldsAllOfItAlone)
{
  const StudyWithStores place(column_study);
  const std::string folder = place.of("results");
  {
    const StudyPlace writer(folder, "part_1_of_1");
    write_copies(place.study, writer);
    write_results(place.study, writer, place.run("results"), "now");
  }
  const StudyPlace again(folder, "part_1_of_1");
  EXPECT_THROW(StudyPlace(folder, "part_1_of_1"), FileError);
  {
    const StudyPlace other(folder, "part_2_of_3");
    EXPECT_THAT(refusal<FileError>([&] { again.clear(); }),
        HasSubstr("another terp writes part_2_of_3 of this study; nothing was removed"));
  }
  EXPECT_EQ(read_store(place.study, folder).rows.size(), 12u);
  std::filesystem::create_directories(folder + "/kept/3");
  again.clear();
  EXPECT_FALSE(std::filesystem::exists(folder + "/kept")) << "runs of realisations that may change";
  EXPECT_TRUE(read_store(place.study, folder).rows.empty());
  EXPECT_FALSE(std::filesystem::exists(folder + "/results.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/study.toml")) << "it may be what was read";
}

}  // namespace engine_test
