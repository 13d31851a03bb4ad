// All findings are warnings, since a run is possible with each of these values. Gravity gets at most one: the first
// that applies, from a wrong sign to an unusual size. Unit weights are looked for in the tree of the file, because the
// case holds densities only. By then each weight has been divided by 9.81 m/s^2, whatever the gravity of the case is.

#include "io/case/check_case.hpp"

#include "io/case/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

using Problems = std::vector<Problem>;

constexpr Range usual_gravity = between(1.0, 30.0);  // [m/s^2]: from the moon's to three times that of the earth
constexpr Real much_damping = 0.5;                   // of slow loading; soil that moves wants 0 to 0.1

std::string vector_text(Vec<2> v) { return fmt::format("[{}, {}]", v[0], v[1]); }

void check_gravity(const Case& values, Problems& warnings)
{
  const Vec<2> g = values.forces.gravity;
  const Real size = std::hypot(g[0], g[1]);
  const auto warn = [&](std::string what, std::string detail) {
    warnings.push_back({"forces.gravity", std::move(what), std::move(detail), "forces.gravity"});
  };
  if (size == 0.0) return;  // run/findings/scale_warnings looks for what else moves the soil
  if (g[1] > 0.0) {
    warn("gravity points upward",
        fmt::format("Got {} m/s^2. The y axis points up: usual is [0.0, -9.81].", vector_text(g)));
  } else if (std::abs(g[0]) > std::abs(g[1])) {
    warn("gravity acts more to the side than down",
        fmt::format("Got {} m/s^2, in the order x, y: usual is [0.0, -9.81]. A slope of 20 degrees may be turned\n"
                    "instead of its mesh: [3.36, -9.22].",
            vector_text(g)));
  } else if (!usual_gravity.contains(size)) {
    warn(fmt::format("gravity of {:.4g} m/s^2 is unusual", size),
        "Usual: [0.0, -9.81] m/s^2. A centrifuge at 50 g has [0.0, -490.5].");
  }
}

void check_damping(const Case& values, Problems& warnings)
{
  const Real alpha = values.forces.local_damping;
  if (alpha == 0.0 && values.forces.averaging_time > 0.0)
    warnings.push_back({"forces.damping.averaging_time", "`averaging_time` has no effect",
        "It belongs to local damping, which is 0: give forces.damping.local too.", "forces.damping.averaging_time",
        false, {"forces.damping"}});
  if (alpha > 0.0 && values.forces.averaging_time > values.time.end)
    warnings.push_back({"forces.damping.averaging_time", "the averaging time is longer than the run",
        fmt::format(
            "Got {:.4g} s, the run ends at {:.4g} s: damping hardly begins. Usual: the time in which a compression "
            "wave\ncrosses the soil once or twice, 0.02 s for 2 m of clay.",
            values.forces.averaging_time, values.time.end),
        "forces.damping.averaging_time", false, {"forces.damping"}});
  if (!(alpha > much_damping)) return;
  warnings.push_back({"forces.damping.local", fmt::format("local damping of {} slows all motion", alpha),
      fmt::format("Soil falls with {:.2g} of gravity, and a failure is as much too slow. Usual: 0 to 0.1 for soil that "
                  "moves, up to {} for slow loading.\nFor stress at rest before the run: initial.stress = "
                  "\"equilibrium\", which has a damping of its own.",
          1.0 - alpha, much_damping),
      "forces.damping.local", false, {"forces.damping"}});
}

/// Densities given as unit weights, where gravity is not that which they are divided by.
void check_weights(const Node& node, const std::string& path, Real gravity, Problems& warnings)
{
  constexpr Real same = 0.005;  // relative: 9.8 and 9.81 m/s^2
  if (gravity == 0.0 || std::abs(gravity - standard_gravity) <= same * standard_gravity) return;
  for (const Node& item : node.items) check_weights(item, join_path(path, item.name), gravity, warnings);
  const auto quantity = node.kind == NodeKind::text ? parse_quantity(node.text) : std::nullopt;
  if (!quantity || quantity->unit == nullptr || !quantity->unit->is_weight) return;
  const Real density = quantity->value();
  warnings.push_back({path,
      fmt::format("a unit weight is divided by {} m/s^2, but gravity is {:.4g} m/s^2", standard_gravity, gravity),
      fmt::format("\"{}\" makes {:.6g} kg/m^3, which weighs {:.4g} kN/m^3 in this case.\n"
                  "Give the density in kg/m^3 if it shall weigh otherwise.",
          node.text, density, 1e-3 * density * gravity),
      "material.density", false, {"forces.gravity"}});
}

}  // namespace

void check_physics(const Node& root, const Case& values, Problems& warnings)
{
  check_gravity(values, warnings);
  const Vec<2> g = values.forces.gravity;
  if (const Node* materials = find_item(root, "material"))
    check_weights(*materials, "material", std::hypot(g[0], g[1]), warnings);
  check_damping(values, warnings);
}

}  // namespace terp
