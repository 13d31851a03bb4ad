// Parameters of laws that vary from point to point: their values at a place, checked, and the rows that hold them.
// Not for: which parameters may vary (the laws' tables), nor where the values come from (ParameterField).
#pragma once

#include "model/bodies/setup_points.hpp"

namespace terp {

/// Numbers of the parameters of a material that vary, ascending. Throws InputError if the law does not let one.
std::vector<int> varying_parameters(const MaterialCase& material, const MaterialType& type);

/// Of each point to be whose material has fields: their values there, in the order of the fields.
struct FieldsOfPoints {
  struct Point {
    Index material;
    Vec<2> x;           ///< [m]
    std::size_t first;  ///< of its values
  };
  std::vector<Point> points = {};
  std::vector<Real> values = {};
};

/// Parameters of a material at a place, in the order of the law's table. Throws InputError if one is outside its range
/// there, or the law refuses them together.
std::vector<Real> parameters_at(const MaterialCase& material, const MaterialType& type, const PlaceInSoil& at);

/// "material.\"peat\".below.su_peak"
std::string parameter_key(const MaterialCase& material, std::string_view parameter);

/// Value of a parameter of a law at its peak; NaN: the law has none of the name, or it varies or is not given.
Real parameter_of(const MaterialCase& material, const MaterialType& law, std::string_view name);

/// Sets the rows of the parameters that vary. of_bodies: whose points, by number of the body; empty: of all.
void set_point_parameters(
    const Model& model, const Seeds& seeds, StepState& state, const std::vector<bool>& of_bodies = {});

/// What limits the time step in a material, or in one of its points.
struct Stiffness {
  Index material;
  Moduli moduli;
  Real viscosity;  ///< [Pa s]
};

inline constexpr const char* less_compressible_than_soil = "undrained soil must be less compressible than its skeleton";

/// K_w/n of the materials in use that are undrained and store effective stress: given, or from nu_u where the soil is
/// stiffest, so that the time step is that of nu_u and softer soil is nearer to incompressible. Throws InputError where
/// nu_u is not above the Poisson's ratio of the soil.
void set_water_stiffness(const Parts& parts, const FieldsOfPoints& fields, Soils& soils);

/// The longest time step that is stable with it [s].
Real stable_step(const StageSoil& soil, const Stiffness& stiffness);

/// Throws InputError if a point cannot take a value in the row of a parameter of its law: outside its range, refused by
/// the law, or too stiff for the time step of the run.
void check_point_parameter(
    const Model& model, const StepState& state, const PointBlock<2>& block, Index lane, int row, Real value);

/// Sets it. Parameters that the case finds from it, by a ratio or as a default, change in proportion.
void set_point_parameter(const Model& model, const PointBlock<2>& block, Index lane, int row, Real value);

/// Of each material in use; of each point of those whose parameters vary. Throws as parameters_at.
std::vector<Stiffness> list_stiffness(const StageSoil& soil, std::span<const Index> used, const FieldsOfPoints& fields);

}  // namespace terp
