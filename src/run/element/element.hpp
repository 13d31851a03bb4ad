// A law by itself at one point: strains or stresses of each component are prescribed, one after the other, and the rest
// follows from the law. docs/element.md.
// Not for: the paths of laboratory tests (element_tests.hpp).
#pragma once

#include "model/parts/model.hpp"

#include <memory>
#include <string>
#include <vector>

namespace terp {

/// A law with its parameters, and the water in its pores.
struct ElementSoil {
  std::string name;  ///< of the material
  const MaterialType* type = nullptr;
  std::shared_ptr<const Material> law = nullptr;
  Real at_strength = 1.0;
  Real water_compressibility = 0.0;  ///< n/K_w of undrained soil [1/Pa]; 0: water cannot be compressed
  bool stores_effective = true;      ///< false: stresses are total ones, and no pore pressure is known
};

/// The soil of a material as a point of a run has it, without what a mesh or its neighbours do to softening. Throws
/// InputError where a parameter varies from place to place.
ElementSoil element_soil(const Case& c, const MaterialCase& material);

/// The same at a place of the section, with the parameters and the stress that a start with K0 has there.
struct ElementAtPlace {
  ElementSoil soil;
  std::array<Real, 4> stress;  ///< effective [Pa]
};
ElementAtPlace element_at(const Model& model, const MaterialCase& material, Vec<2> x);

enum class Control { strain, stress };

/// A leg of the path: components xx yy zz xy go in equal increments to their targets.
struct ElementLeg {
  std::array<Control, 4> control{};
  std::array<Real, 4> target{};  ///< strain since the start [-], or stress [Pa]: total where the soil is undrained;
                                 ///< NaN: that where the leg begins
  int increments = 1;
  Real duration = 1.0;  ///< [s]
};

struct ElementPath {
  std::array<Real, 4> stress{};  ///< at the start [Pa]; effective, or of soil that stores it total
  bool undrained = false;
  std::vector<ElementLeg> legs = {};
};

/// A quantity over the increments of a path, the start first.
struct ElementColumn {
  std::string name, unit, label;
  std::vector<Real> values;
};

struct ElementResult {
  std::vector<ElementColumn> columns;
  std::string fault;  ///< why the path was not followed to its end, in words; empty: it was
  const std::vector<Real>& at(std::string_view name) const;
};

/// Follows the path as far as the soil goes. void_ratio: at the start; NaN: not known, and no column. Throws InputError
/// where the soil cannot begin with the stress, or the path can have no answer.
ElementResult follow_path(const ElementSoil& soil, const ElementPath& path, Real void_ratio);

}  // namespace terp
