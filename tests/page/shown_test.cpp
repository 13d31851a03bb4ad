#include "page/shown.hpp"
#include "io/results/runs.hpp"
#include "support/random.hpp"

namespace shown_test {

/// A run of n points in F frames: point p moves right by k at frame k and has S_u = 8000 - 100 k p. noise: what chance
/// adds to coordinates [m], and a thousand times to S_u [Pa].
struct Folder {
  ScratchFolder scratch;
  std::string path = write_run(scratch.path() + "/run");

  explicit Folder(int n, int n_frames, Real noise = 0.0)
  {
    Random random(3);
    std::filesystem::remove_all(path_in(path, frames_folder));
    PointFrameWriter results({path, point_frames, "0123456789abcdef"});
    for (int k = 0; k < n_frames; ++k) {
      Frame frame{.time = 0.1 * k,
          .step = k,
          .x = {},
          .fields = {{"su", "Pa", 1, {}}, {"stress", "Pa", 4, {}}, {"velocity", "m/s", 3, {}}, {"material", "-", 1, {}},
              {"volume", "m^2", 1, {}}}};
      for (int p = 0; p < n; ++p) {
        frame.x.insert(frame.x.end(), {0.5 * p + k + random.between(0.0, noise), 0.25 * p});
        frame.fields[0].values.push_back(8000.0 - 100.0 * k * p + 1000.0 * random.between(0.0, noise));
        for (const Real s : {-3000.0, -6000.0, -9000.0, 500.0 * p}) frame.fields[1].values.push_back(s);
        for (const Real v : {3.0 * k, 4.0 * k, 0.0}) frame.fields[2].values.push_back(v);
        frame.fields[3].values.push_back(p % 2);
        frame.fields[4].values.push_back(0.01);
      }
      results.append(frame);
    }
  }
  ShownRun shown(std::int64_t n_most = 1000) const { return read_shown(Frames(path), n_most); }
};

Real value(const ShownField& field, std::size_t frame, std::size_t point)
{
  return field.scale.lo + field.scale.step * field.frames[frame][point];
}

const ShownField& field_of(const ShownRun& run, const std::string& name)
{
  return *std::find_if(run.fields.begin(), run.fields.end(), [&](const ShownField& f) { return f.name == name; });
}

TEST(Shown, HasThePlacesToAFiftiethOfTheSpacingOrToTwoMillimetres)
{
  const ShownRun run = Folder(6, 3).shown();
  EXPECT_NEAR(run.point_size, 0.1, 0.1 * 6e-8);  // from volumes, which frames hold in single precision
  EXPECT_NEAR(run.x.step, 0.002, 0.002 * 6e-8);
  EXPECT_NEAR(run.x.lo + run.x.step * run.x_codes[2][3], 3.5, 0.001 + 1e-12);
  EXPECT_NEAR(run.y.lo + run.y.step * run.y_codes[2][3], 0.75, 0.001 + 1e-12);
  EXPECT_THAT(run.times, ElementsAre(0.0, 0.1, 0.2));
  EXPECT_EQ(run.bounds, (std::array<Real, 4>{0.0, 0.0, 4.5, 1.25}));
}

/// Two frames of 100 points of 1 m^2 that keep 7 kPa. The first 30 are dug away after the first frame, the last 40 come
/// after it as another soil. Where there is no soil, a frame holds zeros and where the point is drawn, here 50 m up.
struct Dug : testing::Test {
  ScratchFolder scratch;
  std::string path = write_run(scratch.path() + "/run");

  Dug()
  {
    std::filesystem::remove_all(path_in(path, frames_folder));
    PointFrameWriter results({path, point_frames, "0123456789abcdef"});
    for (int k = 0; k < 2; ++k) {
      Frame frame{.time = 0.1 * k, .step = k, .x = {}, .fields = {}};
      frame.fields = {{"su", "Pa", 1, {}}, {"material", "-", 1, {}}, {"volume", "m^2", 1, {}}};
      for (int p = 0; p < 100; ++p) {
        const bool there = k == 0 ? p < 60 : p >= 30;
        frame.x.insert(frame.x.end(), {1.0 * p, there ? 2.0 : 50.0});
        frame.fields[0].values.push_back(there ? 7e3 : 0.0);
        frame.fields[1].values.push_back(!there ? -1.0 : p < 60 ? 0.0 : 1.0);
        frame.fields[2].values.push_back(there ? 1.0 : 0.0);
      }
      results.append(frame);
    }
  }
};

TEST_F(Dug, PointsWithoutSoilHaveNoPlaceAndNoValue)
{
  const ShownRun run = read_shown(Frames(path), 1000);
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t p = 0; p < 100; ++p) {
      const bool there = k == 0 ? p < 60 : p >= 30;
      EXPECT_EQ(run.x_codes[k][p] != no_value, there);
      EXPECT_EQ(run.y_codes[k][p] != no_value, there);
      EXPECT_EQ(field_of(run, "su").frames[k][p] != no_value, there);
    }
  EXPECT_EQ(run.bounds, (std::array<Real, 4>{0.0, 2.0, 99.0, 2.0}));
  EXPECT_EQ(run.point_size, 1.0);
}

TEST_F(Dug, PointsWithoutSoilHaveNoShareInTheColours)
{
  const ShownRun run = read_shown(Frames(path), 1000);
  EXPECT_EQ(field_of(run, "su").high, 8.0);
  EXPECT_EQ(field_of(run, "su_ratio").low, 0.5) << "none has softened";
  const ShownField& ratio = field_of(run, "su_ratio");
  ASSERT_EQ(ratio.shares, 0);
  EXPECT_NEAR(ratio.scale.lo + ratio.scale.step * run.fields[0].frames[1][99], 1.0, 1e-6);
}

TEST_F(Dug, ABodyThatIsPlacedLaterHasItsSoil)
{
  const ShownRun run = read_shown(Frames(path), 1000);
  EXPECT_EQ(field_of(run, "material").high, 1.0);
  ASSERT_EQ(field_of(run, "material").frames.size(), 2);
  EXPECT_EQ(field_of(run, "material").frames[1][40], 0);
  EXPECT_EQ(field_of(run, "material").frames[1][99], 1);
}

TEST(Shown, HasFieldsInReadableUnitsWithTheirMeanStressSpeedAndStrengthRatio)
{
  const ShownRun run = Folder(6, 3).shown();
  std::vector<std::string> names;
  for (const ShownField& f : run.fields) names.push_back(f.name);
  EXPECT_THAT(names, ElementsAre("su", "su_ratio", "pressure", "velocity", "material"));
  EXPECT_EQ(field_of(run, "su").unit, "kPa");
  EXPECT_NEAR(value(field_of(run, "su"), 2, 4), 7.2, field_of(run, "su").scale.step);
  EXPECT_NEAR(value(field_of(run, "pressure"), 1, 2), -6.0, 1e-9);
  EXPECT_NEAR(value(field_of(run, "velocity"), 2, 0), 10.0, field_of(run, "velocity").scale.step);
  EXPECT_EQ(field_of(run, "material").frames.size(), 1);
  EXPECT_THAT(field_of(run, "material").frames[0], ElementsAre(0, 1, 0, 1, 0, 1));
}

TEST(Shown, TheStrengthRatioHasTheCodesOfTheStrengthWhereAllBeganAlike)
{
  const ShownRun run = Folder(6, 3).shown();
  const ShownField& ratio = field_of(run, "su_ratio");
  ASSERT_EQ(ratio.shares, 0);
  EXPECT_NEAR(ratio.scale.lo + ratio.scale.step * run.fields[0].frames[2][4], 0.9, 1e-3);
}

TEST(Shown, TheScaleOfStrengthIsThatOfSoilThatSoftens)
{
  const ScratchFolder scratch;
  const std::string path = write_run(scratch.path() + "/run");
  std::filesystem::remove_all(path_in(path, frames_folder));
  PointFrameWriter results({path, point_frames, "0123456789abcdef"});
  for (int k = 0; k < 2; ++k) {
    Frame frame{.time = 0.1 * k, .step = k, .x = {}, .fields = {{"su", "Pa", 1, {}}, {"cohesion", "Pa", 1, {}}}};
    for (int p = 0; p < 20; ++p) {  // half of it strong, which stays; half weak, which falls to 0.55
      frame.x.insert(frame.x.end(), {0.5 * p, 0.25 * p});
      frame.fields[0].values.push_back(p % 2 == 0 ? 100e3 : k == 0 ? 20e3 : 11e3);
      frame.fields[1].values.push_back(2e3);
    }
    results.append(frame);
  }
  const ShownRun run = read_shown(Frames(path), 1000);
  EXPECT_EQ(field_of(run, "su").high, 20.0);
  EXPECT_EQ(field_of(run, "su_ratio").low, 0.5);
  EXPECT_EQ(field_of(run, "su_ratio").high, 1.0);
  EXPECT_EQ(field_of(run, "cohesion").unit, "kPa");  // and so its values
  EXPECT_NEAR(field_of(run, "cohesion").high, 2.0, 1e-9);
}

/// Two frames of a row of points, 10 cm apart, that go by 3 m and 4 m. displacement_off: what the file has more of it
/// [m].
ShownRun moved(Real displacement_off, bool one_comes_later = false)
{
  const ScratchFolder scratch;
  const std::string path = write_run(scratch.path() + "/run");
  std::filesystem::remove_all(path_in(path, frames_folder));
  PointFrameWriter results({path, point_frames, "0123456789abcdef"});
  for (int k = 0; k < 2; ++k) {
    Frame frame{.time = 0.1 * k,
        .step = k,
        .x = {},
        .fields = {{"displacement", "m", 3, {}}, {"volume", "m^2", 1, {}}, {"material", "-", 1, {}}}};
    for (int p = 0; p < 20; ++p) {
      const bool there = k == 1 || p > 0 || !one_comes_later;
      const Real gone = there ? 1.0 * k : 0.0;
      frame.x.insert(frame.x.end(), {0.1 * p + 3.0 * gone, 4.0 * gone});
      for (const Real u : {3.0 * gone + displacement_off * k, 4.0 * gone, 0.0}) frame.fields[0].values.push_back(u);
      frame.fields[1].values.push_back(there ? 0.01 : 0.0);
      frame.fields[2].values.push_back(there ? 0.0 : -1.0);
    }
    results.append(frame);
  }
  return read_shown(Frames(path), 1000);
}

TEST(Shown, TheDisplacementIsWhatThePlacesSayIfTheyDo)
{
  const ShownRun run = moved(0.0);
  EXPECT_TRUE(field_of(run, "displacement").of_places);
  EXPECT_TRUE(field_of(run, "displacement").frames.empty());
  EXPECT_EQ(field_of(run, "displacement").scale.step, run.x.step);
  EXPECT_EQ(field_of(run, "displacement").high, 5.0);

  for (const ShownRun& other : {moved(0.02), moved(0.0, true)}) {
    EXPECT_FALSE(field_of(other, "displacement").of_places);
    EXPECT_EQ(field_of(other, "displacement").frames.size(), 2);
  }
}

TEST(Shown, StepsAreRoundAndAFewHundredMakeTheScale)
{
  const ShownRun run = Folder(6, 3).shown();
  for (const auto& [name, high, step] :
      {std::tuple{"su", 8.0, 0.02}, {"pressure", 6.0, 0.05}, {"velocity", 10.0, 0.1}}) {
    const ShownField& field = field_of(run, name);
    EXPECT_EQ(field.high, high) << name;
    EXPECT_NEAR(field.scale.step, step, 1e-12) << name;
    EXPECT_NEAR(std::remainder(field.scale.lo, step), 0.0, 1e-9) << name;
  }
}

TEST(Shown, MorePointsThanAllowedAreSampledTheSameWayEachTime)
{
  const Folder folder(2000, 2);
  const ShownRun run = folder.shown(500);
  EXPECT_EQ(run.n_points, 2000);
  EXPECT_NEAR(static_cast<double>(run.ids.size()), 500.0, 50.0);
  EXPECT_TRUE(std::is_sorted(run.ids.begin(), run.ids.end()));
  EXPECT_EQ(run.ids, folder.shown(500).ids);
  for (std::size_t p = 0; p < run.ids.size(); p += 50)
    EXPECT_NEAR(run.x.lo + run.x.step * run.x_codes[0][p], 0.5 * run.ids[p], run.x.step);
}

TEST(Fit, LeavesWhatFits)
{
  std::vector<ShownRun> runs{Folder(50, 3).shown()};
  const auto before = runs[0].x_codes;
  fit(runs, 100'000);
  EXPECT_EQ(runs[0].x_codes, before);
}

TEST(Fit, CoarsensFieldsFirstThenPlacesThenLeavesOutFramesAndKeepsTheLast)
{
  const ShownRun full = Folder(200, 65, 1.0).shown();
  std::vector<ShownRun> runs{full};
  fit(runs, estimate_bytes(runs) - 1);
  EXPECT_EQ(runs[0].x.step, full.x.step);
  ASSERT_EQ(runs[0].frames.size(), 65);
  EXPECT_EQ(runs[0].fields[0].scale.step, 2.0 * full.fields[0].scale.step);
  EXPECT_NEAR(value(runs[0].fields[0], 64, 3), value(full.fields[0], 64, 3), full.fields[0].scale.step + 1e-9);
  EXPECT_EQ(runs[0].fields[1].frames.size(), runs[0].fields[1].shares < 0 ? 65 : 0);

  fit(runs, estimate_bytes({full}) / 3);
  EXPECT_GT(runs[0].x.step, full.x.step);
  EXPECT_LT(runs[0].frames.size(), 65);
  EXPECT_EQ(runs[0].ids.size(), 200);
  EXPECT_EQ(runs[0].frames.size(), runs[0].x_codes.size());
  EXPECT_EQ(runs[0].frames.size(), runs[0].fields[0].frames.size());
  EXPECT_EQ(runs[0].frames.size(), runs[0].times.size());
  EXPECT_EQ(runs[0].frames.back(), 64);
  EXPECT_EQ(runs[0].times.back(), full.times.back());
}

TEST(Fit, LeavesOutPointsLast)
{
  std::vector<ShownRun> runs{Folder(2000, 4).shown()};
  fit(runs, 400);
  EXPECT_LT(runs[0].ids.size(), 2000);
  EXPECT_EQ(runs[0].ids.size(), runs[0].x_codes[0].size());
  EXPECT_EQ(runs[0].ids.size(), runs[0].fields[0].frames[0].size());
  const std::size_t p = runs[0].ids.size() / 2;
  EXPECT_NEAR(runs[0].x.lo + runs[0].x.step * runs[0].x_codes[0][p], 0.5 * runs[0].ids[p], runs[0].x.step);
}

TEST(Fit, HalvesThePointsUntilTheyFit)
{
  const ShownRun full = Folder(4000, 4, 1.0).shown(4000);
  std::vector<ShownRun> runs{full};
  constexpr std::size_t most = 6000;
  fit(runs, most);
  EXPECT_LE(estimate_bytes(runs), most);
  const auto n = static_cast<Real>(runs[0].ids.size());
  EXPECT_LT(n, 1500.0);  // more than one halving
  EXPECT_GT(n, 100.0);
  EXPECT_NEAR(runs[0].point_size, full.point_size * std::sqrt(4000.0 / n), 0.1 * runs[0].point_size);
}

}  // namespace shown_test
