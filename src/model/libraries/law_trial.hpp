// A law of a library called outside of a run.
#pragma once

#include "mpm/points/soil_material.hpp"

#include <array>
#include <vector>

namespace terp {

/// Calls a law for points of a block as they are, on copies.
class LawTrial {
 public:
  /// cell_size: of the cell of the block [m]. dt: length of a step [s]. material and block must outlive this.
  LawTrial(const SoilMaterial& material, const PointBlock<2>& block, Real cell_size, Real dt);
  LawTrial(const LawTrial&) = delete;
  LawTrial& operator=(const LawTrial&) = delete;

  /// Stress and state of the block again, and the same strain increment for all points: xx yy zz xy, tensorial shear.
  void prepare(const std::array<Real, 4>& d_eps);
  /// Another such increment, from where the last call left the points.
  void call();
  /// Stress of a point after the call less that before [Pa].
  std::array<Real, 4> stress_change(Index lane) const;
  /// After the call, of all points: rows of stress, then of state.
  std::vector<Real> stress_and_state() const;

 private:
  using Rows = std::array<std::vector<Real>, 4>;

  const SoilMaterial& material_;
  std::vector<Real> none_, state_before_, state_, work_;
  Rows sigma_before_, sigma_, d_eps_;
  Index cell_;
  Real cell_size_;
  Surroundings<2> around_;
  StressArrays<2> arrays_{};
};

}  // namespace terp
