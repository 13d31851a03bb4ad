#include "io/files/stability_json.hpp"
#include "io/files/files.hpp"
#include "support/golden.hpp"
#include <nlohmann/json.hpp>

namespace stability_json_test {

StabilityResult result()
{
  StabilityResult r;
  r.strengths = {{"material.clay.su_peak", "Pa", 8000.0}};
  r.options.search.tolerance = 0.1;
  r.relief = 4.0, r.cell = r.given_cell = 0.5;
  r.height = 4.0, r.displacement = 0.05, r.n_points = 900, r.rest_steps = 70;
  for (const auto& [factor, verdict] : {std::pair{1.0, TrialVerdict::stable}, {1.1, TrialVerdict::undecided}}) {
    Trial trial;
    trial.factor = factor, trial.verdict = verdict, trial.reason = "why", trial.steps = 12;
    trial.windows = {{0.5, 0.01, 1e-3}, {1.0, 0.02, 5e-5}};
    enter(std::move(trial), r.search);
  }
  return r;
}

/// A mechanism of a slope that fails to the left.
Mechanism left_slope()
{
  Mechanism m;
  m.factor = 1.1;
  m.moving = MovingSoil{.way = Facing::left,
      .slope = Facing::left,
      .line = {{1.0, 0.5}, {2.0, 0.0}, {3.0, 4.0}},
      .entry = {3.0, 4.0},
      .exit = {1.0, 0.5},
      .highest_x = 5.0,
      .depth = 2.5,
      .area = 7.25,
      .other_way = 0.1};
  return m;
}

struct Variant {
  const char* name;
  std::function<void(StabilityResult&)> change;
  const char* scheme = "mpm_gp";
};

void fail_at(StabilityResult& r, Real factor)
{
  Trial trial;
  trial.factor = factor, trial.verdict = TrialVerdict::failed, trial.reason = "why";
  enter(std::move(trial), r.search);
}

void give_mechanism(StabilityResult& r, const char* sand, Real least_depth)
{
  Mechanism m = left_slope();
  r.mechanism = std::make_shared<const Mechanism>(m);
  m.factor = 1.05, m.moving->depth = 0.4, m.moving->area = 0.97;
  r.creep = std::make_shared<const Mechanism>(m);
  m.moving->sand = sand, r.options.rules.least_depth = least_depth;
  if (*sand != 0) r.mechanism = std::make_shared<const Mechanism>(m);
}

const Variant variants[] = {{"found, with creep and no failure", [](StabilityResult&) {}},
    {"of a scheme that locks", [](StabilityResult&) {}, "standard_mpm"},
    {"not found", [](StabilityResult& r) { r.search.not_stable.reset(); }},
    {"a failure above an undecided trial", [](StabilityResult& r) { fail_at(r, 1.4); }},
    {"a failure where it creeps", [](StabilityResult& r) { fail_at(r, 1.1); }},
    {"stopped", [](StabilityResult& r) { fail_at(r, 1.1), r.stopped = true; }},
    {"two sizes of cells",
        [](StabilityResult& r) {
          r.sizes = {{1.0, 1.15, 0.0}, {0.5, 1.1, 0.0}};
        }},
    {"finer cells gave more",
        [](StabilityResult& r) {
          r.sizes = {{1.0, 1.05, 0.0, 1.06}, {0.5, 1.15, 0.05, 1.2}};
        }},
    {"few cells on one of two sizes",
        [](StabilityResult& r) {
          r.sizes = {{1.0, 1.15, 0.0, 1.15, 4.0}, {0.5, 1.05, 0.05, 1.1, 8.0}};
        }},
    {"two sizes, stopped",
        [](StabilityResult& r) {
          r.sizes = {{1.0, 1.15, 0.0}, {0.5, 1.1, 0.0}}, r.stopped = true;
        }},
    {"three sizes with an order",
        [](StabilityResult& r) {
          r.sizes = {{2.0, 1.4, 0.0}, {1.0, 1.2, 0.0}, {0.5, 1.1, 0.0}};
        }},
    {"three sizes whose differences hardly fall",
        [](StabilityResult& r) {
          r.sizes = {{2.0, 1.31, 0.0}, {1.0, 1.2, 0.0}, {0.5, 1.1, 0.0}};
        }},
    {"three sizes without order",
        [](StabilityResult& r) {
          r.sizes = {{2.0, 1.1, 0.0}, {1.0, 1.2, 0.0}, {0.5, 1.1, 0.0}};
        }},
    {"cells of two widths a height",
        [](StabilityResult& r) { r.cell = 1.409, r.given_cell = 1.99230769, r.relief = 10.0; }},
    {"a mesh from a file", [](StabilityResult& r) { r.cell = 1.409, r.given_cell = 0.0, r.relief = 10.0; }},
    {"two cells move", [](StabilityResult& r) { r.relief = 1.0; }},
    {"four", [](StabilityResult& r) { r.relief = 2.0; }},
    {"with tension",
        [](StabilityResult& r) {
          r.with_tension = SizedFactor{0.5, 1.155, 0.01};
        }},
    {"with tension, two sizes",
        [](StabilityResult& r) {
          r.with_tension = SizedFactor{0.5, 1.155, 0.01}, r.sizes = {{1.0, 1.15, 0.0}, {0.5, 1.1, 0.0}};
        }},
    {"a mechanism and one that creeps", [](StabilityResult& r) { give_mechanism(r, "", 0.0); }},
    {"a face of sand", [](StabilityResult& r) { give_mechanism(r, "bank", 0.0); }},
    {"a face of sand, only deep soil", [](StabilityResult& r) { give_mechanism(r, "bank", 2.0); }},
    {"along the top of an aquifer",
        [](StabilityResult& r) {
          fail_at(r, 1.1);
          Mechanism m = left_slope();
          m.moving->depth = 5.0, m.moving->border = BorderUnderSlip{"sand", 10.0, 52.0, 1.5, 135.5e3, 426.4e3};
          r.mechanism = std::make_shared<const Mechanism>(m);
        }},
    {"factors of other methods", [](StabilityResult& r) {
       r.slip_planes.resize(2);
       r.slip_planes[0].name = "flood", r.slip_planes[0].method = "Bishop", r.slip_planes[0].factor_of_safety = 1.0;
       r.slip_planes[1].name = "by hand";
     }}};

TEST(StabilityText, AndJsonAreThoseOfTheGoldenText)
{
  std::string all;
  for (const auto& [name, change, scheme] : variants) {
    StabilityResult r = result();
    change(r);
    auto json = nlohmann::ordered_json::parse(stability_json(r, scheme, {"cut", "title = \"x\""}));
    for (const char* key : {"trials", "terp_version", "case"}) json.erase(key);
    all += std::string("== ") + name + "\n" + stability_text(r, scheme) + json.dump() + "\n";
  }
  expect_golden("tests/io/files/stability.txt", all);
}

TEST(StabilityJson, HoldsTheTrials)
{
  const auto json = nlohmann::json::parse(stability_json(result(), "mpm_gp", {"cut", "title = \"x\""}));
  EXPECT_EQ(json["trials"][1]["verdict"], "undecided");
  EXPECT_EQ(json["trials"][0]["displacement"][1], 0.02);
}

}  // namespace stability_json_test
