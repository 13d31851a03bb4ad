#include "page/thin.hpp"

namespace thin_test {

using testing::IsSupersetOf;

/// 81 frames in 10 s of a row of points over 10 m that goes right by 5 cm a frame until `stops`.
ShownRun row_that_stops_at(std::size_t stops)
{
  ShownRun run{.n_points = 100, .x = {0.0, 0.001}, .y = {0.0, 0.001}, .bounds = {0.0, 0.0, 10.0, 0.0}};
  for (std::size_t f = 0; f < 81; ++f) {
    run.frames.push_back(f);
    run.times.push_back(0.125 * static_cast<Real>(f));
    Codes x;
    for (std::size_t p = 0; p < 100; ++p) x.push_back(static_cast<std::uint16_t>(100 * p + 50 * std::min(f, stops)));
    run.x_codes.push_back(x);
    run.y_codes.emplace_back(100);
  }
  for (std::uint32_t p = 0; p < 100; ++p) run.ids.push_back(p);
  return run;
}

std::vector<std::size_t> kept(std::vector<ShownRun> runs, std::size_t which = 0)
{
  leave_out_unmissed_frames(runs);
  EXPECT_EQ(runs[which].times.size(), runs[which].frames.size());
  EXPECT_EQ(runs[which].x_codes.size(), runs[which].frames.size());
  return runs[which].frames;
}

TEST(Thin, FramesGoWhereHardlyAnythingMovesButNeverManyAtATime)
{
  // 10 cm, two frames, are a hundredth of the width; a gap is at most five frames.
  EXPECT_THAT(kept({row_that_stops_at(6)}),
      ElementsAre(0, 2, 4, 9, 14, 19, 24, 29, 34, 39, 44, 49, 54, 59, 64, 69, 74, 79, 80));
}

TEST(Thin, AFrameInWhichColoursChangeStays)
{
  ShownRun run = row_that_stops_at(0);
  ShownField field;
  field.high = 10.0, field.scale = {0.0, 0.1}, field.frames.assign(81, Codes(100));
  for (std::size_t f = 3; f < 81; ++f) field.frames[f].assign(100, 11);  // 1.1 of 10
  run.fields.push_back(field);
  EXPECT_THAT(kept({run}), IsSupersetOf({0, 2, 3}));
  for (Codes& codes : run.fields[0].frames)
    if (codes[0] > 0) codes.assign(100, 9);
  EXPECT_THAT(kept({run}), Not(Contains(2)));
}

TEST(Thin, MomentsStay)
{
  ShownRun run = row_that_stops_at(0);
  run.moments = {0.38, 8.8};
  EXPECT_THAT(kept({run}), IsSupersetOf({3, 70}));
}

TEST(Thin, SoilThatComesStays)
{
  ShownRun run = row_that_stops_at(0);
  for (std::size_t f = 0; f < 4; ++f)
    for (std::size_t p = 0; p < 50; ++p) run.x_codes[f][p] = run.y_codes[f][p] = no_value;
  EXPECT_THAT(kept({run}), IsSupersetOf({3, 4}));
}

TEST(Thin, RunsOfTheSameTimesKeepTheSameFrames)
{
  const std::vector<ShownRun> runs{row_that_stops_at(6), row_that_stops_at(30)};
  EXPECT_EQ(kept(runs, 0), kept(runs, 1));
  EXPECT_THAT(kept(runs, 0), Contains(28));
  ShownRun later = row_that_stops_at(0);
  for (Real& time : later.times) time += 0.05;
  EXPECT_THAT(kept({runs[1], later}, 1), Not(Contains(28)));
}

}  // namespace thin_test
