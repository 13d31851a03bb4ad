#include "io/case/key_table.hpp"

namespace terp {
namespace {

std::vector<std::string> river_words() { return {"deduced", "left", "right"}; }

}  // namespace

std::vector<KeyInfo> flood_keys()
{
  return {
      {.path = "flood.water_level",
          .field = [](Case& c, std::size_t) { return &c.flood.water_level; },
          .unit = "m",
          .meaning = "height of the water that the ground shall hold back; left out: the highest free water of the run "
                     "at the river's end of the section"},
      {.path = "flood.smallest_freeboard",
          .field = [](Case& c, std::size_t) { return &c.flood.smallest_freeboard; },
          .unit = "m",
          .range = not_negative,
          .usual = {0.01, 5.0},
          .meaning = "height over the water level that the highest ground must keep; less counts as flooding"},
      {.path = "flood.smallest_width",
          .field = [](Case& c, std::size_t) { return &c.flood.smallest_width; },
          .unit = "m",
          .range = not_negative,
          .usual = {0.01, 1e3},
          .meaning = "width that the ground must keep at the water level; less counts as flooding, less of intact soil "
                     "as damage"},
      {.path = "flood.intact_below",
          .field = [](Case& c, std::size_t) { return &c.flood.intact_below; },
          .range = positive,
          .usual = {1e-4, 1.0},
          .meaning = "plastic strain eps_eq_p below which soil counts as intact"},
      {.path = "flood.least_depth",
          .field = [](Case& c, std::size_t) { return &c.flood.least_depth; },
          .unit = "m",
          .range = not_negative,
          .usual = {0.1, 5.0},
          .meaning = "depth below the first ground from below which soil must come to be a slide or damage; what moves "
                     "above it ravels"},
      {.path = "flood.smallest_profile.width",
          .field = [](Case& c, std::size_t) { return &c.flood.profile_width; },
          .unit = "m",
          .range = positive,
          .usual = {0.1, 20.0},
          .meaning = "width at the water level of a profile that is looked for inside the ground that remains; it "
                     "changes no verdict"},
      {.path = "flood.smallest_profile.slope",
          .field = [](Case& c, std::size_t) { return &c.flood.profile_slope; },
          .range = positive,
          .usual = {0.5, 10.0},
          .meaning = "n of its slopes of 1:n, to both sides down from the water level"},
      {.path = "flood.river",
          .field = [](Case& c, std::size_t) { return word_field(c.flood.river); },
          .words = river_words,
          .meaning = "end of the section at which the river is; deduced: where the free water stands higher, or the "
                     "ground lies below the level if it does not at the other end"},
  };
}

}  // namespace terp
