#include "io/case/key_table.hpp"

namespace terp {

std::vector<KeyInfo> surface_load_keys()
{
  return {
      {.path = "load[].name",
          .field = [](Case& c, std::size_t i) { return &c.loads[i].name; },
          .meaning = "its name in loads.csv; each load needs its own"},
      {.path = "load[].from",
          .field = [](Case& c, std::size_t i) { return &c.loads[i].from; },
          .unit = "m",
          .required = true,
          .meaning =
              "x at which the stretch of the surface begins that the load is put on; the soil that is there then "
              "carries it from then on, wherever it moves"},
      {.path = "load[].to",
          .field = [](Case& c, std::size_t i) { return &c.loads[i].to; },
          .unit = "m",
          .required = true,
          .meaning = "x at which the stretch ends"},
      {.path = "load[].pressure",
          .field = [](Case& c, std::size_t i) { return &c.loads[i].pressure; },
          .unit = "Pa",
          .range = not_negative,
          .usual = {500.0, 1e6},
          .required = true,
          .in_stage = true,
          .meaning = "vertical force per horizontal width, down positive; loads on the same ground add",
          .equation = "f_i = -sum_p N_i(top of p) pressure width_p,  sum_p width_p = to - from"},
      {.path = "load[].start",
          .field = [](Case& c, std::size_t i) { return &c.loads[i].start; },
          .unit = "s",
          .range = not_negative,
          .meaning = "time at which the load is put on; left out: it was always there, also in the search for "
                     "equilibrium, and in the overburden of \"k0\"",
          .default_text = "always there"},
      {.path = "load[].end",
          .field = [](Case& c, std::size_t i) { return &c.loads[i].end; },
          .unit = "s",
          .range = positive,
          .meaning = "time at which the load is taken off; left out: it stays",
          .default_text = "it stays"},
      {.path = "load[].ramp",
          .field = [](Case& c, std::size_t i) { return &c.loads[i].ramp; },
          .unit = "s",
          .range = not_negative,
          .meaning = "time over which the load grows from `start` on, and falls from `end` on, linearly; a load that "
                     "comes at once shakes the ground",
          .equation = "q(t) = pressure (t - start)/ramp for start < t < start + ramp"},
  };
}

}  // namespace terp
