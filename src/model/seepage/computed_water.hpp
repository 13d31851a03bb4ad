// Water that follows from permeabilities, river, ponds and heads at the sides: the steady flow of each situation of a
// case. docs/methods.md, "Seepage". Not for: lines (water_pressure.hpp), the equations (free_surface.hpp).
#pragma once

#include "model/parts/model.hpp"
#include "model/seepage/flow_surface.hpp"
#include "model/seepage/free_surface.hpp"
#include "model/seepage/walls.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace terp {

/// The soil of a case at t = 0 as water sees it.
struct SeepageSection {
  WalledMesh walled;  ///< the mesh of the flow
  std::vector<BodyOutline> outlines;
  std::vector<FlowMaterial> materials;        ///< by outline
  std::vector<std::vector<Side>> sides = {};  ///< by outline
  std::vector<SoilEdge> edges;                ///< surface of the soil
  std::vector<Side> walls = {};               ///< that let no water through
  Real left = 0.0, right = 0.0;               ///< ends of the soil [m]
  Real cell = 0.0;                            ///< typical size [m]

  /// Number of the outline at a place; none: no soil.
  std::optional<std::size_t> soil_at(Vec<2> x) const;
};

/// Throws InputError where a soil has no permeability, or no outline.
SeepageSection seepage_section(const Case& whole, const SharedMesh& mesh);

/// Highest soil over x [m]; none: minus infinity.
Real ground_over(const SeepageSection& section, Real x);

/// The elevation of the free water over a place of the ground [m]; minus infinity: none.
class FreeWaterLevels {
 public:
  FreeWaterLevels(const SeepageSection& section, const SeepageCase& of);

  struct Stretch {
    Real from, to, level;  ///< [m]
    Index part;
  };
  const std::vector<Stretch>& stretches() const { return stretches_; }
  /// Free water on a place of an edge of the section; nullptr: none.
  const Stretch* on(std::size_t edge, Vec<2> x) const;
  Real level_over(Real x) const;

 private:
  std::vector<Stretch> stretches_;
  std::vector<char> in_river_;  // by edges: below the level of the river, and linked to its side by such
};

/// Conditions on the way from one situation to another: levels run linearly where both have the same places.
SeepageCase between(const SeepageCase& from, const SeepageCase& to, Real share);

/// Names of what water passes: seepage faces, river, ponds, then the heads at the sides.
std::vector<std::string> names_of_parts(const SeepageCase& of);

/// The heads that a situation gives at the ends and the base of the soil. Throws InputError where a side has no soil.
std::vector<SurfacePlace> side_conditions(
    const Mesh<2>& mesh, const SeepageSection& section, const SeepageCase& of, const std::string& path);

/// All conditions of a situation on the surface of the soil. Throws InputError where a stretch or a side has no soil.
std::vector<SurfacePlace> surface_conditions(
    const Mesh<2>& mesh, const SeepageSection& section, const SeepageCase& of, const std::string& path);

/// The water of a situation.
struct ComputedWater {
  FlowSoil soil;
  FlowResult flow;
  std::vector<Vec<2>> table;  ///< the phreatic line, with the levels of free water [m]
};

struct WaterOptions {
  Real band = 0.0;                              ///< as in suction_band_of [m]
  bool stores = false;                          ///< places are fine enough for what soil stores
  std::optional<FlowStep> step = std::nullopt;  ///< in time; none: steady
};

/// path: of the keys of the situation, "water" or "water.situation[0]". Throws InputError where flows do not balance.
ComputedWater compute_water(const Mesh<2>& mesh, const SeepageSection& section, const SeepageCase& of,
    const WaterOptions& options, const std::string& path);

/// A situation takes over what was computed for it.
void set_computed(WaterSituation& situation, const SeepageSection& section, const ComputedWater& water);

/// The phreatic line of heads at nodes, with the levels of free water [m].
std::vector<Vec<2>> table_of(
    const Mesh<2>& mesh, const SeepageSection& section, const FreeWaterLevels& free, std::span<const Real> heads);

/// Height of the band over which soil dries [m].
Real suction_band_of(const WaterCase& water, const SeepageSection& section);

/// The case with the heads and the phreatic line of each situation that is to be computed. Others stay as they are.
Case with_computed_water(const Case& whole, const SharedMesh& mesh);

}  // namespace terp
