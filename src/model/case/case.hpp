// A case as the user describes it, in plain numbers and words: what the case file says, with defaults filled in.
// Not for: anything computed. model/parts/setup builds the Model and the first State from it.
#pragma once

#include "math/types.hpp"
#include "mpm/features/load.hpp"
#include "mpm/features/side_kind.hpp"
#include "soil/laws/material.hpp"
#include "model/case/method_form.hpp"
#include "model/case/parameter_field.hpp"
#include "model/case/time_case.hpp"
#include "soil/libraries/library_case.hpp"
#include "model/seepage/permeability.hpp"
#include "model/water/water_case.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace terp {

enum class InitialStress { none, k0, equilibrium };  ///< reading R14
enum class MeshKind { rectangle, graded, mapped, file, polygon };
enum class FootingContact { rough, smooth };

/// Smaller cells near a line or in a box.
struct RefineCase {
  std::vector<Vec<2>> line;              ///< two or more places [m]; empty: a box
  Vec<2> low{0.0, 0.0}, high{0.0, 0.0};  ///< corners of the box [m]
  Real cell = 0.0;                       ///< target cell size there [m]
  Real distance = 0.0;                   ///< from the line over which the size grows back [m]
};

/// A named part of the boundary of a polygon mesh.
struct EdgesCase {
  std::string side;
  std::vector<Index> edges;  ///< edge k runs from corner k of the polygon to corner k + 1
};

struct MeshCase {
  MeshKind kind = MeshKind::rectangle;
  Vec<2> origin{0.0, 0.0};           ///< rectangle, graded: lower left corner [m]
  Vec<2> size{0.0, 0.0};             ///< rectangle, graded: width and height [m]
  Vec<2> cell{0.0, 0.0};             ///< rectangle: width and height of a cell; polygon: target size (both equal) [m]
  std::array<Index, 2> cells{0, 0};  ///< graded, mapped: number of cells along each direction
  Vec<2> grading{1.0, 1.0};          ///< graded, mapped: size of the last cell over the first, in x and y [-]
  std::array<std::vector<Vec<2>>, 4>
      sides;         ///< mapped: polylines bottom, right, top, left; bottom and top run to +x, left and right to +y [m]
  std::string file;  ///< file: gmsh mesh, relative to the case file
  std::vector<Vec<2>> polygon;     ///< polygon: corners of the domain, counter-clockwise [m]
  std::vector<EdgesCase> edges;    ///< polygon: names of its sides
  std::vector<RefineCase> refine;  ///< polygon
  bool follow_bodies = true;       ///< polygon: cells follow the outlines of the bodies
  Index variant = 0;  ///< polygon: 1, 2, ... are other meshes of the same size, to see what depends on the mesh
};

using StageNumber = std::size_t;
inline constexpr StageNumber never = std::numeric_limits<StageNumber>::max();

/// Exactly one of polygon, region and points_file says where a body is.
struct BodyCase {
  std::string name;  ///< empty: it has none
  std::string material;
  std::vector<Vec<2>> polygon;             ///< corners [m]; a box is stored as its four corners, counter-clockwise
  std::vector<std::vector<Vec<2>>> holes;  ///< [m]
  std::string region;                      ///< of a mesh file: all its cells
  std::string points_file;                 ///< CSV with header x,y,volume,material, relative to the case file
  std::array<Index, 2> points_per_cell{5, 5};
  Vec<2> velocity{0.0, 0.0};                  ///< at t = 0 [m/s]
  VelocityField velocity_at;                  ///< instead of velocity
  std::optional<std::array<Real, 4>> stress;  ///< at t = 0, xx yy zz xy as its law stores it [Pa]; none: as InitialCase
  StageNumber placed = 0;       ///< by the stage of this number, counted from 1; 0: it is there from the start
  StageNumber removed = never;  ///< dug away by the stage of this number, counted from 1
  bool is_there = true;         ///< in this case: that of a stage, or of the start
};

/// A body in messages: "body `berm`", or without a name "body 4".
inline std::string called(const BodyCase& body, std::size_t number)
{
  return "body " + (body.name.empty() ? std::to_string(number) : '`' + body.name + '`');
}

/// Which part of a soil a material is, by the phreatic line at t = 0.
enum class Zone { all, below, above };

struct MaterialCase {
  std::string name;              ///< the user's: "clay"; of the two parts of a soil "clay below", "clay above"
  std::string model;             ///< the law's: "tresca_softening"
  Real density = 0.0;            ///< [kg/m^3]
  std::vector<Real> parameters;  ///< in the order of the law's table; of one that varies a value that it may have, and
                                 ///< in a model the mean over its points
  std::vector<ParameterField> fields = {};  ///< ascending; those that the law lets vary
  SofteningOptions softening = {};
  Drainage drainage = Drainage::by_law;
  Real undrained_poisson_ratio = 0.495;                           ///< nu_u of Drainage::undrained_effective [-]
  Real water_stiffness = std::numeric_limits<Real>::quiet_NaN();  ///< K_w/n instead [Pa]; NaN: it follows from nu_u
  Permeability permeability = {};
  Storage storage = {};
  Real k0 = std::numeric_limits<Real>::quiet_NaN();  ///< instead of initial.k0 [-]; NaN: that
  std::string soil = {};                             ///< of one of two parts: the name that bodies use; else empty
  Zone zone = Zone::all;
  bool ground = true;                  ///< false: water, or a load on the soil; not what a slope or a dike is made of
  std::vector<RatioCase> ratios = {};  ///< by the number of the parameter that follows from one; for the record
  std::string color = {};              ///< of the soil in pictures, "#rrggbb"; empty: they choose one
  LibraryCase library = {};            ///< of the model "library"
  std::shared_ptr<const MaterialType> from_library = nullptr;  ///< its law, once it was loaded

  /// The name that bodies use.
  const std::string& called() const { return soil.empty() ? name : soil; }
  /// Effective stress where there is water, else total stress.
  bool stores_effective() const
  {
    if (drainage != Drainage::by_law) return drainage != Drainage::undrained;
    const MaterialType* law = find_material(model);
    return law != nullptr && !law->total_stress;
  }
  bool has_excess_pressure() const { return drainage == Drainage::undrained_effective; }
  /// Whether a limit of tension acts.
  bool tears() const
  {
    const MaterialType* law = find_material(model);
    if (law == nullptr || law->torn == nullptr) return false;
    const auto k = std::ranges::find(law->parameters, tension_cutoff, &ParameterInfo::name) - law->parameters.begin();
    return k < std::ssize(parameters) && std::isfinite(parameters[static_cast<std::size_t>(k)]);
  }
  /// Its law in the form that the options of softening and a limit of tension ask for; nullptr if there is none of that
  /// name.
  const MaterialType* type() const { return type(tears()); }
  const MaterialType* type(bool tears_in_some_stage) const
  {
    const MaterialType* law = find_material(model, softening, tears_in_some_stage);
    return law != nullptr && law->by_library ? from_library.get() : law;
  }
  /// The same, if all parameters are known.
  const MaterialType* complete_type() const
  {
    const bool is_complete = std::ranges::none_of(parameters, [](Real value) { return std::isnan(value); });
    return is_complete ? type() : nullptr;
  }
  /// Whether its law carries no shear stress at rest.
  bool is_fluid() const
  {
    const MaterialType* law = complete_type();
    return law != nullptr && law->make(parameters)->shear_modulus() == 0.0;
  }
};

/// Replaces every parameter of a material by change(its number, value), those that vary at each place.
template <class Change>
void change_parameters(MaterialCase& material, Change change)
{
  for (std::size_t k = 0; k < material.parameters.size(); ++k)
    material.parameters[k] = change(k, material.parameters[k]);
  for (ParameterField& field : material.fields)
    field.value_at = [k = field.parameter, before = field.value_at, change](
                         const PlaceInSoil& x) { return change(k, before(x)); };
}

/// A rigid block that moves with a prescribed velocity on or in the soil.
struct FootingCase {
  std::string name = "footing";
  Vec<2> low{0.0, 0.0}, high{0.0, 0.0};  ///< corners of the box at t = 0 [m]
  Vec<2> velocity{0.0, 0.0};             ///< after the ramp [m/s]
  Real ramp = 0.0;                       ///< time over which the velocity grows from zero [s]
  FootingContact contact = FootingContact::rough;
};

/// A force per mass that acts on each point: of its place now and at t = 0 [m], and the time [s].
struct BodyForceCase {
  BodyForce at;          ///< empty: none
  bool changes = false;  ///< with the time
  std::string text;      ///< as the case file has it
};

struct ForcesCase {
  Vec<2> gravity{0.0, 0.0};    ///< [m/s^2]
  Real local_damping = 0.0;    ///< alpha of local (Cundall) damping, reading R13 [-]
  Real averaging_time = 0.0;   ///< of the out-of-balance force that local damping looks at; 0: its value now [s]
  Real viscous_damping = 0.0;  ///< mass-proportional damping coefficient [1/s]
  BodyForceCase body;          ///< beside gravity
};

struct InitialCase {
  InitialStress stress = InitialStress::none;
  /// Horizontal over vertical effective stress, where the material has none [-]; NaN: not given (k0_at).
  Real k0 = std::numeric_limits<Real>::quiet_NaN();
  Real damping = 0.2;       ///< local damping while seeking equilibrium [-]
  Real limit = 1e-4;        ///< out-of-balance force over weight at which equilibrium is reached [-]
  Index max_steps = 20000;  ///< give up after this many steps
};

/// A vertical pressure on a stretch of the surface of the soil.
struct LoadCase {
  std::string name = "load";
  Real from = 0.0, to = 0.0;                            ///< x of the ends of the stretch where the load begins [m]
  Real pressure = 0.0;                                  ///< force per width, down positive [Pa]
  Real start = -std::numeric_limits<Real>::infinity();  ///< [s]; -infinity: it was always there
  Real end = std::numeric_limits<Real>::infinity();     ///< [s]; infinity: it stays
  Real ramp = 0.0;  ///< time over which it grows from `start` on, and falls from `end` on [s]
};

/// The water that the ground shall hold back; how it is judged: run/measure/flood.cpp.
struct FloodCase {
  bool given = false;                                         ///< the case has [flood]
  Real water_level = std::numeric_limits<Real>::quiet_NaN();  ///< [m]; NaN: not given
  Real smallest_freeboard = 0.0;                              ///< height over the water level that must remain [m]
  Real smallest_width = 0.0;  ///< width of the ground at the water level that must remain [m]
  Real intact_below = 0.01;   ///< eps_eq_p below which soil counts as intact [-]
  Real least_depth = 0.0;     ///< below the first ground; what moved from above it is neither slide nor damage [m]
  /// A profile that must fit inside the ground: its width at the level [m], and n of its slopes of 1:n; NaN: none.
  Real profile_width = std::numeric_limits<Real>::quiet_NaN(), profile_slope = std::numeric_limits<Real>::quiet_NaN();
  RiverSide river = RiverSide::deduced;

  bool asks_profile() const { return profile_width == profile_width && profile_slope == profile_slope; }
  bool asks() const { return given || water_level == water_level; }
};

struct OutputCase {
  Real fields_every = 0.0;                                     ///< [s]; 0: only first and last
  std::vector<std::string> field_names;                        ///< empty: all
  Real history_every = 0.01;                                   ///< [s]
  std::vector<std::pair<std::string, Vec<2>>> history_points;  ///< name and initial place [m]
  Real ledger_every = 0.01;                                    ///< [s]
  Real checkpoint_every = 0.0;                                 ///< [s]; 0: only at the end and when stopped
  Index checkpoint_keep = 2;                                   ///< how many of the newest are kept; 0: all
  bool mesh = false;  ///< whether mesh.vtkhdf also says what the mesh carries at the times of the fields
};

/// A slip plane that another method found, to be drawn over the slip surface. The run does not look at it.
struct SlipPlaneCase {
  /// The undrained strength that the other method took at a place.
  struct Strength {
    Vec<2> x;  ///< [m]
    Real su;   ///< [Pa]
  };
  std::string name, method;                                        ///< "D-Stability, flood", "Uplift-Van"
  Real factor_of_safety = std::numeric_limits<Real>::quiet_NaN();  ///< NaN: not given
  std::vector<Vec<2>> line;                                        ///< [m]
  std::vector<Strength> su;                                        ///< empty: not given
};

/// Whether a stage places or removes the body.
inline bool comes_or_goes(const BodyCase& body) { return body.placed > 0 || body.removed != never; }

/// The velocity that a body or a side has at a place [m/s].
template <class BodyOrSide>
Vec<2> velocity_of(const BodyOrSide& which, Vec<2> x)
{
  return which.velocity_at ? which.velocity_at(x) : which.velocity;
}

/// Path of a file that a case names, relative to the case's own folder.
std::string path_of(const std::string& folder, const std::string& file);

struct Case {
  std::string title;
  std::string name;    ///< of the file without .toml: the run folder's name
  std::string folder;  ///< that holds the case file: other files are named relative to it
  std::string scheme = "mpm_gp";
  Real at_strength = 1.0;  ///< all strengths are divided by this [-]
  TimeCase time;
  std::vector<StageCase> stages;
  MeshCase mesh;
  std::vector<BodyCase> bodies;
  std::vector<MaterialCase> materials;
  ForcesCase forces;
  InitialCase initial;
  WaterCase water;
  std::vector<SideCondition> sides;
  std::vector<FootingCase> footings;
  std::vector<LoadCase> loads;
  MethodOptions method;
  MethodForm method_form = MethodForm::terp;  ///< what `method` was before its own keys were read
  OutputCase output;
  FloodCase flood;
  std::vector<SlipPlaneCase> slip_planes;
  /// The case of the whole run, whose ground at t = 0 strengths follow from; none: it is this one.
  std::shared_ptr<const Case> ground_of = nullptr;
};

}  // namespace terp
