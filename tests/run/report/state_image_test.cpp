#include "support/simulations.hpp"

namespace state_image_test {

/// A column on the move, with books.
Case moving_column(const char* scheme)
{
  Case c = column(scheme);
  c.bodies[0].velocity = {2.0, 0.0};
  return c;
}

TEST(StateImage, ARestoredRunGoesOnInTheSameBits)
{
  for (const char* scheme : {"standard_mpm", "mpm_mixed", "mpm_gp"}) {
    Simulation whole = followed(moving_column(scheme));
    make_steps(whole, 150);
    keep_ledger(whole.model, whole.state, whole.work);
    Simulation rest(build_model(moving_column(scheme), 1), restore(whole.model, make_image(whole.state)));
    EXPECT_EQ(first_difference(make_image(whole.state), make_image(rest.state)), "") << scheme;
    for (Simulation* s : {&whole, &rest}) {
      make_steps(*s, 150);
      keep_ledger(s->model, s->state, s->work);
    }
    EXPECT_EQ(first_difference(make_image(whole.state), make_image(rest.state)), "") << scheme;
  }
}

TEST(StateImage, HoldsEverythingThatAStateRemembers)
{
  Simulation s = followed(moving_column("mpm_gp"));
  keep_ledger(s.model, s.state, s.work);
  make_steps(s, 3);
  keep_ledger(s.model, s.state, s.work);
  State& state = s.state;
  state.work = {.gravity = 1.0,
      .damping = 2.0,
      .boundary = 3.0,
      .clamps = 3.5,
      .plastic = 4.0,
      .slip = 4.5,
      .internal = 5.0,
      .taken = 5.0625,
      .reset = 5.09375,
      .relaxation = 5.125,
      .exchanged = 5.25,
      .from_outside = 5.375,
      .last_step = 5.5};
  state.energy_marks = {.most_lost = 5.625, .most_dissipated = 5.75, .most_unexplained = 5.875};
  state.start_energy = 6.0;
  state.clamped = 7;
  state.rows_reported["ledger"] = 11;
  state.frames_reported = 12;
  state.largest_v_999 = 9.0;
  state.has_no_start = true;
  const State back = restore(s.model, make_image(state));
  EXPECT_EQ(back.step, 3);
  EXPECT_EQ(back.time, state.time);
  EXPECT_TRUE(back.has_no_start);
  EXPECT_EQ(back.work.gravity, 1.0);
  EXPECT_EQ(back.work.damping, 2.0);
  EXPECT_EQ(back.work.boundary, 3.0);
  EXPECT_EQ(back.work.clamps, 3.5);
  EXPECT_EQ(back.work.plastic, 4.0);
  EXPECT_EQ(back.work.slip, 4.5);
  EXPECT_EQ(back.work.internal, 5.0);
  EXPECT_EQ(back.work.relaxation, 5.125);
  EXPECT_EQ(back.work.exchanged, 5.25);
  EXPECT_EQ(back.work.last_step, 5.5);
  EXPECT_EQ(back.work.taken, 5.0625);
  EXPECT_EQ(back.work.reset, 5.09375);
  EXPECT_EQ(back.work.from_outside, 5.375);
  EXPECT_EQ(back.energy_marks.most_lost, 5.625);
  EXPECT_EQ(back.energy_marks.most_dissipated, 5.75);
  EXPECT_EQ(back.energy_marks.most_unexplained, 5.875);
  EXPECT_EQ(back.start_energy, 6.0);
  EXPECT_EQ(back.clamped, 7);
  EXPECT_EQ(back.rows_reported, state.rows_reported);
  EXPECT_EQ(back.frames_reported, 12);
  EXPECT_EQ(back.largest_v_999, 9.0);
  EXPECT_EQ(back.x_initial, state.x_initial);
}

TEST(StateImage, InPartsHasTheSameArrays)
{
  Simulation s = followed(moving_column("mpm_gp"));
  make_steps(s, 150);
  keep_ledger(s.model, s.state, s.work);
  StateImage joined;
  int n_parts = 0;
  for_each_part(s.state, 1000, [&](const StateImage& part) {
    EXPECT_EQ(part.part, n_parts++);
    std::size_t n_values = 0;
    for (const NamedArray& array : part.arrays) {
      if (array.first == 0) joined.arrays.push_back({array.name, array.shape, array.values});
      std::visit(
          [&](const auto& more) {
            auto& all = std::get<std::decay_t<decltype(more)>>(joined.arrays.back().values);
            EXPECT_EQ(array.name, joined.arrays.back().name);
            const std::size_t row = array.shape.size() == 2 ? static_cast<std::size_t>(array.shape[1]) : 1;
            if (array.first > 0) {
              EXPECT_EQ(all.size(), static_cast<std::size_t>(array.first) * row);
              all.insert(all.end(), more.begin(), more.end());
            }
            n_values += more.size();
          },
          array.values);
    }
    EXPECT_LE(n_values, 1000u);
    joined.time = part.time;
    joined.step = part.step;
    EXPECT_EQ(part.last, joined.arrays.back().name == make_image(s.state).arrays.back().name);
  });
  EXPECT_GT(n_parts, 20);
  EXPECT_EQ(first_difference(joined, make_image(s.state)), "");
}

/// Takes other values for every array of the followers that is not bound to others, and for those of a slide.
TEST(StateImage, WhatFollowersRememberComesFromTheImage)
{
  Simulation s = followed(moving_column("mpm_gp"));
  keep_ledger(s.model, s.state, s.work);
  for (const ActiveFollower& active : s.state.followers) active.follower->frame(s.model, s.state);
  StateImage image = make_image(s.state);
  int n_changed = 0;
  for (NamedArray& array : image.arrays) {
    if (!array.name.starts_with("followers/") || array.name == "followers/points_that_left/reported") continue;
    if (array.name.ends_with("/slip_surfaces")) array = {array.name, {6}, std::vector<Real>{0.5, 2, 0, 0.75, 3, 2}};
    if (array.name.ends_with("/slip_places")) array = {array.name, {4}, std::vector<Real>{1, 2, 3, 4}};
    if (array.name.ends_with("/before/onset_surfaces"))
      array = {array.name, {6}, std::vector<Real>{0.25, 1, 0, 0.5, 2, 0}};
    if (array.name.ends_with("/before/slides"))
      array = {array.name, {12}, std::vector<Real>{0.5, 0.75, 8, 6, 11, 1, 1.5, std::nan(""), 2, 3, 4, -1}};
    if (array.name.starts_with("followers/slopes/")) continue;
    if (auto* reals = std::get_if<std::vector<Real>>(&array.values))
      for (Real& value : *reals) value = std::isnan(value) ? 3.0 : value + 0.125;
    else
      for (std::int64_t& value : std::get<std::vector<std::int64_t>>(array.values)) value = 1 - value;
    ++n_changed;
  }
  EXPECT_GE(n_changed, 8);
  EXPECT_EQ(first_difference(make_image(restore(s.model, image)), image), "");
}

TEST(StateImage, WithoutOneOfItsArraysIsRefused)
{
  Simulation s = followed(moving_column("mpm_gp"));
  const StateImage image = make_image(s.state);
  for (std::size_t k = 0; k < image.arrays.size(); ++k) {
    StateImage cut = image;
    cut.arrays.erase(cut.arrays.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_THROW(restore(s.model, cut), FileError) << image.arrays[k].name;
  }
}

TEST(StateImage, WithATimeOrASurfaceThatNoRunHasIsRefused)
{
  Simulation s = followed(moving_column("mpm_gp"));
  const StateImage sound = make_image(s.state);
  EXPECT_NO_THROW(restore(s.model, sound));
  for (const Real time : {std::nan(""), -0.1, HUGE_VAL}) {
    StateImage image = sound;
    image.time = time;
    EXPECT_THROW(restore(s.model, image), FileError) << time;
  }
  StateImage image = sound;
  image.step = -1;
  EXPECT_THROW(restore(s.model, image), FileError);
  for (const char* name : {"followers/slopes/heights", "followers/slopes/columns"}) {
    image = sound;
    const auto array =
        std::find_if(image.arrays.begin(), image.arrays.end(), [&](const NamedArray& a) { return a.name == name; });
    std::get<std::vector<Real>>(array->values) =
        std::string(name) == "followers/slopes/heights" ? std::vector<Real>{} : std::vector<Real>{0.0, 0.0, 0.0};
    EXPECT_THROW(restore(s.model, image), FileError) << name;
  }
}

TEST(StateImage, OfAnotherCaseIsRefused)
{
  const Simulation s = followed(moving_column("mpm_gp"));
  StateImage image = make_image(s.state);
  Case elastic = moving_column("mpm_gp");
  elastic.materials = {test::elastic(2e6, 0.3, 2000.0)};
  elastic.bodies[0].material = "rock";
  EXPECT_THAT([&] { restore(Simulation(elastic).model, image); },
      ThrowsMessage<FileError>(
          "the checkpoint does not fit this case: its points carry `eps_eq_p`, which the points of this case do not"));
  const Simulation rock(elastic);
  EXPECT_THAT([&] { restore(s.model, make_image(rock.state)); },
      ThrowsMessage<FileError>(
          "the checkpoint does not fit this case: its points have no `eps_eq_p` (accumulated equivalent plastic "
          "strain, Eq. (6)), which the points of this case carry"));
  std::get<std::vector<std::int64_t>>(image.arrays[0].values)[4] = 1000000;
  EXPECT_THAT([&] { restore(s.model, image); },
      ThrowsMessage<FileError>("the checkpoint does not fit this case: a point lies in a cell, or is of a "
                               "material or a body, that the case does not have"));
}

/// A column whose points of odd numbers are of body 1.
StateImage image_of_two_bodies(const Simulation& s)
{
  StateImage image = make_image(s.state);
  std::vector<std::int64_t> body;
  for_each_point(s.state.points,
      [&](const PointBlock<2>& block, Index lane) { body.push_back(std::llround(block.row(Rows::id)[lane]) % 2); });
  const auto n = static_cast<std::int64_t>(body.size());
  image.arrays.push_back({"points/body", {n}, std::move(body)});
  return image;
}

TEST(StateImage, BodiesArePreservedWhilePointsMoveAndARunGoesOn)
{
  for (const char* scheme : {"standard_mpm", "mpm_mixed", "mpm_gp"}) {
    Case c = moving_column(scheme);
    c.bodies.push_back(c.bodies[0]);  // a case of two bodies, the second on the first
    const Simulation start(c);
    Simulation whole(build_model(c, 1), restore(start.model, image_of_two_bodies(start)));
    make_steps(whole, 100);
    Simulation rest(build_model(c, 1), restore(whole.model, make_image(whole.state)));
    for (Simulation* s : {&whole, &rest}) make_steps(*s, 100);
    EXPECT_EQ(first_difference(make_image(whole.state), make_image(rest.state)), "") << scheme;
    Index n_moved = 0;
    for_each_point(rest.state.points, [&](const PointBlock<2>& block, Index lane) {
      const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
      ASSERT_EQ(block.body, static_cast<Index>(id % 2));
      if (std::abs(block.row(Rows::x)[lane] - rest.state.x_initial[2 * id]) > 0.3) ++n_moved;
    });
    EXPECT_GT(n_moved, 0) << scheme;
  }
}

TEST(StateImage, SaysNothingOfBodiesWhereThereIsOne)
{
  const Simulation s(moving_column("mpm_gp"));
  StateImage image = make_image(s.state);
  const auto is_body = [](const NamedArray& a) { return a.name == "points/body"; };
  EXPECT_TRUE(std::none_of(image.arrays.begin(), image.arrays.end(), is_body));
  EXPECT_THAT(
      [&] { restore(s.model, image_of_two_bodies(s)); }, ThrowsMessage<FileError>(HasSubstr("or a body, that")));
}

TEST(StateImage, TellsHowManyPointsTheRunBeganWith)
{
  EXPECT_EQ(count_points(make_image(followed(column("mpm_gp")).state)), 1600);
  EXPECT_THROW(count_points(StateImage{}), FileError);
}

}  // namespace state_image_test
