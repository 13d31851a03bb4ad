// A case as the user describes it, in plain numbers and words: what the case file says, with defaults filled in.
// Not for: anything computed. simulation/setup builds the Model and the first State from it.
#pragma once

#include "base/types.hpp"
#include "transfer/method_options.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace terp {

enum class InitialStress { none, k0, equilibrium };                               ///< reading R14
enum class SideKind { free, roller, fixed, velocity, contact_bilateral, contact_separating };  ///< reading R15
enum class DeviatoricNorm { half, von_mises };                                    ///< reading R18

struct TimeCase {
  Real end = 0.0;       ///< [s]
  Real courant = 0.98;  ///< dt = courant * min(L_e) / c_p, reading R19
};

struct MeshCase {
  Vec<2> origin{0.0, 0.0};  ///< lower left corner [m]
  Vec<2> size{0.0, 0.0};    ///< width and height [m]
  Vec<2> cell{0.0, 0.0};    ///< width and height of a cell [m]
};

struct BodyCase {
  std::string material;
  std::vector<Vec<2>> polygon;           ///< corners [m]; a box is stored as its four corners, counter-clockwise
  std::array<Index, 2> points_per_cell{5, 5};
  Vec<2> velocity{0.0, 0.0};             ///< at t = 0 [m/s]
};

struct MaterialCase {
  std::string name;             ///< the user's: "clay"
  std::string model;            ///< the law's: "tresca_softening"
  Real density = 0.0;           ///< [kg/m^3]
  std::vector<Real> parameters; ///< in the order of the law's table
};

struct SideCase {
  std::string side;  ///< "left", "right", "bottom", "top"
  SideKind kind = SideKind::free;
  Real adhesion = 0.0;          ///< a [Pa]
  Real friction = 0.0;          ///< tangent of the contact friction angle [-]
  Vec<2> velocity{0.0, 0.0};    ///< of SideKind::velocity [m/s]
};

struct ForcesCase {
  Vec<2> gravity{0.0, 0.0};     ///< [m/s^2]
  Real local_damping = 0.0;     ///< alpha of local (Cundall) damping, reading R13 [-]
  Real viscous_damping = 0.0;   ///< mass-proportional damping coefficient [1/s]
};

struct InitialCase {
  InitialStress stress = InitialStress::none;
  Real k0 = 1.0;                ///< horizontal over vertical stress, InitialStress::k0 [-]
  Real damping = 0.8;           ///< local damping while seeking equilibrium [-]
  Real limit = 1e-3;            ///< out-of-balance force over weight at which equilibrium is reached [-]
  Index max_steps = 20000;      ///< give up after this many steps
};

struct OutputCase {
  Real fields_every = 0.0;      ///< [s]; 0: only first and last
  std::vector<std::string> field_names;  ///< empty: all
  Real history_every = 0.01;    ///< [s]
  std::vector<std::pair<std::string, Vec<2>>> history_points;  ///< name and initial place [m]
  Real ledger_every = 0.01;     ///< [s]
  Real checkpoint_every = 0.0;  ///< [s]; 0: only at the end and when stopped
  Index checkpoint_keep = 2;    ///< how many of the newest are kept; 0: all
  DeviatoricNorm deviatoric_norm = DeviatoricNorm::half;
};

struct Case {
  std::string title;
  std::string name;             ///< of the file without .toml: the run folder's name
  std::string scheme = "mpm_gp";
  TimeCase time;
  MeshCase mesh;
  std::vector<BodyCase> bodies;
  std::vector<MaterialCase> materials;
  ForcesCase forces;
  InitialCase initial;
  std::vector<SideCase> sides;
  MethodOptions method;
  OutputCase output;
};

}  // namespace terp
