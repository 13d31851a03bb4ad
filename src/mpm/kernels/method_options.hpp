// The numerical choices that the paper leaves open, as options with the defaults of docs/methods.md.
#pragma once

#include "math/types.hpp"

#include <limits>

namespace terp {

enum class Shares { by_law, point, overlap };         ///< where a point counts: decision 0042
enum class Weights { hybrid, summed };                ///< Omega_GP of Eqs. (2), (4): reading R3
enum class StrainShares { plain, transposed };        ///< strain of the Gauss points, handed back to points
enum class VolumeChange { centre, soil };             ///< where the volume change of a cell is taken: reading R5
enum class Pressure { constant, balanced };           ///< the smooth pressure within a cell
enum class ObjectiveRate { none, jaumann };           ///< reading R17
enum class CutCells { mean, slip };                   ///< soils of one cell along their border: decision 0071
enum class RemapContact { unused_strength, across };  ///< contact in pass 4: decision 0037

struct MethodOptions {
  Shares shares = Shares::by_law;  ///< by_law: overlap, but point in a case with a fluid; Model has what it is
  Weights weights = Weights::hybrid;
  Real filled_fraction = 0.9;  ///< a cell is filled when its points fill at least this part of it, R3 [-]
  bool b_bar = true;           ///< volumetric strain of the cell centre at all Gauss points, and its force: R4, R5
  StrainShares strain_shares = StrainShares::transposed;
  VolumeChange volume_change = VolumeChange::soil;
  Pressure pressure = Pressure::balanced;
  ObjectiveRate objective_rate = ObjectiveRate::none;
  CutCells cut_cells = CutCells::slip;
  RemapContact remap_contact = RemapContact::unused_strength;
  Real relaxation_time = 0.0;  ///< with which points lose the velocity that the mesh does not see; 0: never [s]
  Real flip = std::numeric_limits<Real>::quiet_NaN();  ///< 1: pure FLIP, 0: pure PIC; NaN: by law, Model has it [-]
  Real small_mass = 1e-9;                              ///< nodes lighter than this times rho V_e keep v = a = 0 [-]
};

}  // namespace terp
