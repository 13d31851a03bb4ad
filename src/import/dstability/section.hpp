// One stage of a scenario with the stages before it: soil, stresses and strength at any place. docs/dstability.md.
// Not for: reading the file (read_stix.hpp), comparing with stored slices (slices.hpp).
#pragma once

#include "math/sentence.hpp"
#include "import/dstability/ground_column.hpp"
#include "import/dstability/soil_strength.hpp"
#include "import/dstability/water_column.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace terp {

inline constexpr Real just_inside = 1e-6;  ///< [m] from an end of the section
inline constexpr Real beyond_end = 0.01;   ///< [m] beyond an end: coordinates of drawings are in cm

/// What holds at a place of the soil. Stresses are vertical, pressures positive [Pa].
struct StixPlace {
  std::size_t layer = 0;      ///< number in StixStage::layers
  const StixSoil* soil = {};  ///< of the project
  bool below_water = false;   ///< below the phreatic line
  Real total_stress = 0.0;    ///< with free water and loads
  Real load_stress = 0.0;     ///< the part of the uniform loads
  Real pore_pressure = 0.0;   ///< of the water and of loads that are not consolidated, at most the total stress
  Real effective_stress = 0.0;
  Real yield_stress = 0.0;  ///< the largest effective stress plus POP of this stage and those before it
  StixStrengthModel model = StixStrengthModel::none;  ///< the one that holds above or below the phreatic line
  Real su = not_given;                                ///< [Pa]; of `shansep` and `su_table`
  Real ratio = not_given, exponent = not_given;       ///< S and m [-]; of `shansep`
  Real cohesion = not_given, friction = not_given;    ///< after the Davis reduction [Pa, degrees]; of drained soil
};

class StixColumn;

/// Ids of layers that have more than one state point: which one holds cannot be known.
std::vector<std::string> layers_with_two_states(const StixStage& stage);

/// "clay (L 1)": the soil of a layer with its label; many files have one label for all layers. Labels may be empty.
std::string name_of_layer(const StixProject& project, const StixLayer& layer);

/// A stage, ready to be evaluated. The project must outlive it.
class StixSection {
 public:
  /// scenario, stage: numbers from 0. Throws InputError if a layer of this stage or one before it has no soil or two
  /// state points, a soil no unit weight, or a state no POP.
  StixSection(const StixProject& project, std::size_t scenario, std::size_t stage, StixBasis basis);
  ~StixSection();

  const StixProject& project() const { return *project_; }
  const StixStage& stage() const { return *stages_.back(); }
  const std::vector<const StixStage*>& history() const { return stages_; }  ///< the stages up to this one, it included
  StixBasis basis() const { return basis_; }
  /// What speaks against states of the history, sentences: those that say less than what the soil carries anyhow.
  const std::vector<Sentence>& state_doubts() const { return state_doubts_; }

  /// All that depends on x alone: one per x, for many z. The section must outlive it.
  StixColumn column(Real x) const;
  /// At one place; empty above the ground.
  std::optional<StixPlace> at(Vec<2> place) const;

 private:
  friend class StixColumn;
  void check(std::size_t scenario) const;
  void set_preloads();

  const StixProject* project_;
  std::vector<const StixStage*> stages_;  ///< of the history; the last is the one that is asked for
  StixBasis basis_;
  std::vector<std::vector<Real>> point_pops_;  ///< POP of each state point of each stage [Pa]
  struct LinePops {
    std::vector<Vec<2>> above, below;  ///< POP over x [m, Pa]
  };
  std::vector<std::vector<LinePops>> line_pops_;  ///< of each state line of each stage
  std::vector<Sentence> state_doubts_;
};

/// One stage along a vertical line, without its history.
class StixStageColumn {
 public:
  StixStageColumn(const StixProject& project, const StixStage& stage, Real x);

  const std::vector<SoilBand>& bands() const { return bands_; }
  const StixWaterColumn& water() const { return water_; }
  Real ground() const { return ground_; }  ///< elevation [m]; not a number where there is no soil
  Real load_stress(Real z) const;          ///< of uniform loads, by their spread [Pa]
  Real total_stress(Real z) const;         ///< vertical [Pa]
  Real pore_pressure(Real z) const;        ///< capped [Pa]
  Real effective_stress(Real z) const { return total_stress(z) - pore_pressure(z); }

 private:
  Real stress_of_load(std::size_t number, Real z) const;  ///< [Pa]

  const StixProject* project_;
  const StixStage* stage_;
  Real x_;
  std::vector<Real> load_grounds_;  ///< elevation from which the depth below each load counts [m]
  std::vector<SoilBand> bands_;
  Real ground_;
  StixWaterColumn water_;
};

class StixColumn {
 public:
  StixColumn(const StixSection& section, Real x);

  Real ground() const { return now().ground(); }
  const StixStageColumn& now() const { return stages_.back(); }  ///< the stage that is asked for
  std::optional<StixPlace> at(Real z) const;                     ///< empty above the ground
  Real largest_effective_stress(Real z) const;                   ///< vertical, of all stages so far [Pa]
  std::vector<Real> pops(Real z) const;                          ///< of each stage; where it has no soil zero [Pa]

 private:
  Real pop(std::size_t stage, Real z) const;
  Real yield_stress(Real z) const;
  void set_strength(StixPlace& place) const;

  const StixSection* section_;
  Real x_;
  std::vector<StixStageColumn> stages_;
};

}  // namespace terp
