// A dike whose soil is drawn anew, for tests of the verdict on the water.
#pragma once

#include "run/measure/followers.hpp"
#include "support/simulations.hpp"

namespace terp::test {

/// A dike of 4 m on ground of 1 m: crest from x = 18 to 22 m, slopes of 1:2, in a mesh of 40 m x 8 m; water to 4 m.
inline Case dike()
{
  Case c = column("mpm_gp", 0.5);
  BodyCase soil = body("clay", {0.0, 0.0}, {40.0, 1.0});
  soil.polygon = {{0.0, 0.0}, {40.0, 0.0}, {40.0, 1.0}, {30.0, 1.0}, {22.0, 5.0}, {18.0, 5.0}, {10.0, 1.0}, {0.0, 1.0}};
  soil.points_per_cell = {4, 4};
  c.mesh.size = {40.0, 8.0};
  c.bodies = {soil};
  c.flood.water_level = 4.0;
  return c;
}

/// What rows of the ledger say of drawings, one second apart.
struct Drawn : Simulation {
  std::vector<TableRow> rows;

  explicit Drawn(const Case& description = dike()) : Simulation(description, 1, all_followers()) { look(); }
  void look() { rows.push_back(keep_ledger(model, state, work)); }
  /// The soil becomes another within 0.2 s and rests for two seconds, a row every 0.1 s.
  Drawn& become(const std::function<Vec<2>(Vec<2>)>& place)
  {
    draw_points(*this, place);
    for (int k = 0; k < 24; ++k) state.time += 0.1, look();
    return *this;
  }
  FloodSummary flood() const { return *summarise(model, state).flood; }
};

}  // namespace terp::test
