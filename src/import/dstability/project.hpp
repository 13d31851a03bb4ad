// What a D-Stability file holds, in plain numbers: soils, scenarios with their stages, calculations with their results.
// All is in SI units (Pa, N/m^3, m) but angles [degrees]. x runs to the right, z upwards. A number that the file leaves
// empty ("NaN", null, "-") is not a number. Ids are resolved: a stage holds its own geometry, water, states and loads.
// Not for: stresses and strengths that follow from it (section.hpp).
#pragma once

#include "math/types.hpp"

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace terp {

inline constexpr Real not_given = std::numeric_limits<Real>::quiet_NaN();

/// Places from one end to the other, {x, z} [m].
using StixLine = std::vector<Vec<2>>;

/// A parameter with its distribution. Deterministic calculations take `value`.
struct StixParameter {
  Real value = not_given;
  Real mean = not_given, deviation = not_given;  ///< of the lognormal distribution, in the unit of the value
  bool is_probabilistic = false;
};

enum class StixStrengthModel {
  none,             ///< no strength
  advanced,         ///< c', phi' and dilatancy with the Davis reduction: CPhi, MohrCoulombAdvanced
  classic,          ///< c', phi' as they are: MohrCoulombClassic
  shansep,          ///< S and m: Su
  su_table,         ///< s_u over the vertical effective stress: SuTable
  sigma_tau_table,  ///< shear strength over the normal effective stress on the slip plane: SigmaTauTable
  unknown           ///< a name that this reader does not know; a remark tells it
};

/// Cohesion [Pa], angles [degrees].
struct StixFriction {
  StixParameter cohesion = {}, friction = {}, dilatancy = {};
};

/// Strength [Pa] over an effective stress [Pa], stresses ascending; constant beyond both ends.
struct StixTable {
  std::vector<Vec<2>> rows = {};
  bool is_probabilistic = false;
  Real variation = not_given;  ///< standard deviation over mean, of all rows
};

struct StixSoil {
  std::string id = {}, code = {}, name = {};
  Real weight_above = not_given, weight_below = not_given;  ///< above and below the phreatic line [N/m^3]
  StixStrengthModel above = StixStrengthModel::none, below = StixStrengthModel::none;
  std::string above_word = {}, below_word = {};  ///< the models as the file calls them
  StixFriction advanced = {}, classic = {};
  StixParameter ratio = {}, exponent = {};  ///< S and m of SHANSEP [-]
  StixTable su_table = {}, sigma_tau_table = {};
  std::string colour = {};  ///< "#AARRGGBB"; empty: none
};

/// A closed outline, first place not repeated. Of layers inside each other the inner one holds at a place.
struct StixLayer {
  std::string id = {}, label = {};
  StixLine outline = {};
  std::optional<std::size_t> soil = {};  ///< number in StixProject::soils; none: the file gives none
};

/// Pore pressure in three corners [Pa], linear between them.
struct StixWaterTriangle {
  std::array<Vec<2>, 3> corners = {};
  Vec<3> pressure = {};
};

struct StixHeadLine {
  std::string id = {}, label = {};
  StixLine line = {};  ///< elevation of the head over x, level beyond its ends
};

/// A line in the soil with the heads just above and below it.
struct StixReferenceLine {
  std::string label = {};
  StixLine line = {};
  std::size_t top_head = 0, bottom_head = 0;  ///< numbers in StixWater::head_lines
};

struct StixWater {
  Real unit_weight = 9810.0;  ///< of water [N/m^3]
  std::vector<StixHeadLine> head_lines = {};
  std::optional<std::size_t> phreatic = {};  ///< number in head_lines; none: no water
  std::vector<StixReferenceLine> reference_lines = {};
  bool is_mesh = false;  ///< the mesh holds, not the lines
  std::vector<StixWaterTriangle> mesh = {};
};

/// How much more the soil has carried: one of three, by `kind`.
struct StixPreload {
  enum class Kind { pop, ocr, yield_stress } kind = Kind::pop;
  StixParameter pop = {};         ///< yield stress less effective stress [Pa]
  Real ocr = 1.0;                 ///< yield stress over effective stress [-]
  Real yield_stress = not_given;  ///< [Pa]
};

struct StixStatePoint {
  std::string id = {}, label = {}, layer = {};  ///< layer: the id of the layer of this stage that it holds for
  Vec<2> place{};
  StixPreload preload = {};
};

struct StixStateLine {
  struct Value {
    std::string id = {}, label = {};
    Real x = not_given;
    StixPreload above = {}, below = {};
  };
  StixLine line = {};
  std::vector<Value> values = {};  ///< x ascending
};

/// Degree of consolidation in each layer [%], by its id.
using StixConsolidation = std::map<std::string, Real>;

struct StixUniformLoad {
  std::string label = {};
  Real start = not_given, end = not_given;  ///< x [m]
  Real magnitude = 0.0;                     ///< [Pa]
  Real spread = 0.0;                        ///< angle by which it spreads with depth, from the vertical [degrees]
  StixConsolidation consolidation = {};
};

/// A layer whose weight counts as a load on the others.
struct StixLayerLoad {
  std::string layer = {};
  StixConsolidation consolidation = {};
};

/// A straight line that is drawn in the section and has no place in a continuum: a wall, a geotextile, a nail.
struct StixDrawnLine {
  std::string label = {};
  Vec<2> start{}, end{};
};

/// The points of the profile that the file names, x [m]; not a number where it does not.
struct StixEmbankment {
  Real toe_water = not_given, top_water = not_given, top_land = not_given, shoulder_land = not_given,
       toe_land = not_given;
};

struct StixDecorations {
  std::vector<StixLine> excavations;      ///< what is above them, between their ends, is gone; the outlines are not cut
  std::vector<std::string> added_layers;  ///< ids of layers that are embankments; their outlines are in `layers`
};

struct StixStates {
  std::vector<StixStatePoint> state_points;
  std::vector<StixStateLine> state_lines;
};

struct StixLoads {
  std::vector<StixUniformLoad> loads;
  std::vector<StixLayerLoad> layer_loads;
  std::size_t line_loads = 0, trees = 0;  ///< how many; their loads are not taken over
  bool has_earthquake = false;
};

struct StixReinforcements {
  std::vector<StixDrawnLine> forbidden_lines, geotextiles, nails;
};

/// Its bases are what it names by an id.
struct StixStage : StixDecorations, StixStates, StixLoads, StixReinforcements {
  std::string id, label;
  std::vector<StixLayer> layers;  ///< in the order of the file
  StixWater water;
  StixEmbankment embankment;
};

/// One slice of a stored result. Empty numbers are not a number: drained soil has no s_u.
struct StixSlice {
  Vec<2> bottom_left{}, bottom_right{};  ///< [m]
  Real total_stress = not_given;         ///< vertical, with loads and free water [Pa]
  Real pore_pressure = not_given;        ///< capped at the total stress [Pa]
  Real normal_stress = not_given;        ///< across the slip plane [Pa]
  Real yield_stress = not_given;         ///< [Pa]
  Real su = not_given;                   ///< [Pa]
  Real friction = not_given;             ///< input [degrees]
  Real strength = not_given;             ///< in shear, along the slip plane [Pa]
};

struct StixResult {
  std::string id = {};
  std::string name = {};  ///< its member without folder and ending: "bishop/bishopresult_1"
  bool is_reliability = false;
  Real factor_of_safety = not_given;
  Real reliability_index = not_given, failure_probability = not_given;
  std::optional<bool> converged = {};
  StixLine slip_plane = {};            ///< left to right; empty: none stored
  std::vector<StixSlice> slices = {};  ///< left to right as stored
};

enum class StixCalculationKind { deterministic, design, mean, probabilistic, unknown };

struct StixCalculation {
  std::string id = {}, label = {};
  std::string method = {};  ///< AnalysisType: "Bishop", "SpencerGenetic", ...
  StixCalculationKind kind = StixCalculationKind::deterministic;
  std::string kind_word = {};
  Real model_factor = not_given, model_factor_deviation = not_given;
  std::size_t stage = 0;  ///< number in its scenario; earlier ones are the history
  std::optional<StixResult> result = {};
};

struct StixScenario {
  std::string id = {}, label = {};
  std::vector<StixStage> stages = {};
  std::vector<StixCalculation> calculations = {};
};

/// What a reader of the results must know: what was not understood, or is left out.
struct StixRemark {
  std::string where = {};                                        ///< member and path, or scenario and stage
  std::string what = {};                                         ///< one sentence
  bool is_of_format = false;                                     ///< a member, key or version that Terp does not know
  std::vector<std::pair<std::size_t, std::size_t>> stages = {};  ///< scenario and stage, from 0; none: the whole file
  std::string what_nl = {};                                      ///< in Dutch; empty of the format
};

struct StixProject {
  std::string path = {};             ///< as the user wrote it
  std::string content_version = {};  ///< "1" or "2"
  std::string application = {};      ///< that wrote it last
  std::vector<StixSoil> soils = {};
  std::vector<StixScenario> scenarios = {};  ///< of version 1: one, with all stages
  std::vector<StixRemark> remarks = {};
};

}  // namespace terp
