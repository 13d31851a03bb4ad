// What a law in Fortran gave back. Its arrays have numbers between them that it must leave alone: a law that takes an
// array for longer than it was told is noticed where it writes, and gets no number where it reads.
// Not for: other memory (os/own_copy.hpp).
#pragma once

#include "soil/libraries/interface.hpp"

#include <algorithm>
#include <cstring>

namespace terp {

inline constexpr int n_tens = 4, most_tens = 6;  ///< stresses that a law takes: of plane strain, of all
inline constexpr std::size_t name_length = 80;   ///< letters of the name of a material

class FencedArrays {
  static constexpr std::size_t fence = n_numbers_beyond;
  using Marks = std::array<std::uint64_t, fence>;

 public:
  static std::size_t n_numbers(std::size_t n_state, std::size_t n_parameters)
  {
    return n_state + n_parameters + 3 * fence;
  }

  /// memory: of n_numbers.
  FencedArrays(double* memory, std::size_t n_state, std::size_t n_parameters, const NumbersBeyond& beyond)
      : first_(memory), n_state_(n_state), n_parameters_(n_parameters)
  {
    of_state_.fill(beyond.state), of_parameters_.fill(beyond.parameters);
    std::memcpy(first_, of_state_.data(), sizeof of_state_);
    std::memcpy(state() + n_state_, of_state_.data(), sizeof of_state_);
    std::memcpy(parameters() + n_parameters_, of_parameters_.data(), sizeof of_parameters_);
  }

  double* state() const { return first_ + fence; }
  double* parameters() const { return state() + n_state_ + fence; }

  /// Says so in `points` where the law wrote beyond its arrays.
  void check(LawPoints& points) const
  {
    const auto is_whole = [](const double* at, const Marks& marks) {
      return std::memcmp(at, marks.data(), sizeof marks) == 0;
    };
    const auto fail = [&](const char* array, std::size_t n, const char* cure) {
      points.cure = cure;
      points.fail("the law writes beyond its array {}, of {} numbers", array, n);
    };
    if (!is_whole(first_, of_state_) || !is_whole(state() + n_state_, of_state_))
      return fail("STATEV", n_state_, "a larger `state` of the material: the law has more variables");
    if (!is_whole(parameters() + n_parameters_, of_parameters_))
      fail("PROPS", n_parameters_, "more `parameters` of the material: the law has more");
  }

 private:
  double* first_;
  std::size_t n_state_, n_parameters_;
  Marks of_state_, of_parameters_;  // what stands between the arrays
};

/// False, and says so in `points`, where the law returned shear stress out of the plane, 13 or 23 of six components: it
/// is lost. What an artificial viscosity or a loose iteration of the law leaves there does not count. stress_unit [Pa].
inline bool is_plane(std::span<const double> stress, Real stress_unit, LawPoints& points)
{
  constexpr double slight = 1e-3;       // of the largest component
  constexpr double slight_stress = 10;  // [Pa] half a millimetre of soil
  double largest = 0.0;
  for (const double component : stress.first(4)) largest = std::max(largest, std::abs(component));
  const double limit = std::max(slight * largest, slight_stress / stress_unit);
  for (const double component : stress.subspan(4)) {
    if (std::abs(component) <= limit || points.failed) continue;
    points.fail(
        "the law returned a shear stress out of the plane, 13 or 23, of {:.4g} Pa, where {:.4g} Pa may be lost: plane "
        "strain has no place for it",
        component * stress_unit, limit * stress_unit);
  }
  return !points.failed;
}

/// What the calls of laws in Fortran share.
class FortranCalls : public LawCalls {
 protected:
  FortranCalls(const LibraryCase& library, const std::string& material, int n_components)
      : n_components_(n_components), n_state_(library.state.size()), stress_unit_(library.stress_unit)
  {
    for (const NamedNumber& number : library.parameters) parameters_.push_back(number.value);
    name_.fill(' ');
    std::copy_n(material.begin(), std::min(material.size(), name_length), name_.begin());
  }

  void take(const LawPoints& points, double* stress, double* state) const
  {
    for (int k = 0; k < n_tens; ++k) stress[k] = points.sigma[k][points.at];
    for (std::size_t k = 0; k < n_state_; ++k) state[k] = points.state[k][points.at];
  }
  void give_back(const double* stress, const double* state, LawPoints& points) const
  {
    for (int k = 0; k < n_tens; ++k) points.sigma[k][points.at] = stress[k];
    for (std::size_t k = 0; k < n_state_; ++k) points.state[k][points.at] = state[k];
  }

  int n_components_;
  std::size_t n_state_;
  Real stress_unit_;  // [Pa]
  std::vector<Real> parameters_;
  std::array<char, name_length> name_;
};

}  // namespace terp
