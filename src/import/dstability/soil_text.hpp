// The soils of an imported section as materials of a case: what the file says of them, and defaults for the rest.
// Not for: the tables of defaults (soil_defaults.hpp), which body is of which material (case_folder.hpp).
#pragma once

#include "math/sentence.hpp"
#include "import/dstability/case_text.hpp"
#include "import/dstability/section.hpp"
#include "import/dstability/soil_defaults.hpp"

#include <optional>

namespace terp {

inline constexpr Real face_depth = 1.0;  ///< of the cohesion of a face below the ground [m]

/// How the yield stress of a SHANSEP soil is said.
struct PreloadText {
  std::string value;    ///< `pop = "10 kPa"`, or `yield_stress = { csv = "FILE.csv" }`
  std::string comment;  ///< where it is from
};

/// Of a grid in a file; pop: what a study draws beside it [Pa].
PreloadText grid_preload(const std::string& file, bool of_all_stages, Real pop);

/// POP of a soil that a study draws: mean and deviation, and what its `pop` of the case has beside it [Pa].
struct RandomPop {
  Real mean = 0.0, deviation = 0.0, rest = 0.0;
  bool operator==(const RandomPop&) const = default;
};

/// One material: a soil above or below the phreatic line, or both if they are alike.
struct SoilUse {
  const StixSoil* soil = nullptr;
  bool above = false;                 ///< of the two models and weights
  std::string name, where;            ///< key in the case; "below the phreatic line" or empty
  std::string stage;                  ///< label of the analysed stage
  std::string strength_water;         ///< the [[water.situation]] of its strength; empty: that of the start
  PreloadText preload = {};           ///< of SHANSEP
  Real largest_stress = 0.0;          ///< vertical effective stress in it, at most [Pa]
  Real face_cohesion = 0.0;           ///< in the outer metre of the section [Pa]; 0: that of the soil
  std::optional<RandomPop> pop = {};  ///< of SHANSEP, in a study
};

struct SoilText {
  CaseMaterialText material;
  std::vector<Sentence> assumed;  ///< for the report
};

/// Throws InputError, one problem for each number of the soil that is empty or out of range, or if it has no strength
/// that Terp can take over. The key is the soil; the detail names the stage.
SoilText soil_text(const SoilUse& use, StixBasis basis, const std::vector<SoilKind>& kinds);

/// Key of the water that an undrained strength follows from; empty: it follows from none.
std::string strength_water_key(const SoilUse& use);

/// A soil of which nothing but its name is known: all from the defaults.
CaseMaterialText default_soil_text(const std::string& name, const std::string& label, const SoilKind& kind);

/// True if both sides of the phreatic line have the same strength and weight.
bool same_above_and_below(const StixSoil& soil);

/// Its strength below the phreatic line or above it is an undrained one.
bool has_su(const StixSoil& soil);
/// zone: 2: above the phreatic line, else below it.
bool is_shansep(const StixSoil& soil, int zone);

/// "18 kN/m3", "12.5 kPa".
std::string kilo_text(Real value, const char* unit);

}  // namespace terp
