// The law of a library at work: points go to it in blocks, what comes back is looked at, a fault is kept in words.
// Not for: how the library is called (interface.hpp).
#pragma once

#include "os/turn.hpp"
#include "soil/laws/material.hpp"
#include "soil/libraries/interface.hpp"

#include <atomic>
#include <utility>

namespace terp {

/// What all laws of one material of a case share.
struct LibraryInUse {
  std::string material;                          ///< the user's name
  std::string title;                             ///< of the library, for messages
  std::shared_ptr<const SharedLibrary> library;  ///< holds the code of `calls`
  std::shared_ptr<const LawCalls> calls;
  std::shared_ptr<const OneAtATime> turns;  ///< of a library that is not thread safe; else nullptr
  std::size_t n_state = 0;                  ///< rows, those that are kept for the law included
  std::size_t strength_row = 0;             ///< of the state variable that is the strength, if any is
  Real stress_unit = 1.0;                   ///< of the library [Pa]
  Real shear_modulus = 0.0;                 ///< of the case [Pa]
};

/// Shared by all materials whose library is this file, whatever its path is written like: it is loaded once.
std::shared_ptr<const OneAtATime> turns_of(const std::string& path);

/// The first n values, for messages.
template <class Value>
std::string list_of(std::size_t n, Value&& value)
{
  std::string text;
  for (std::size_t k = 0; k < n; ++k) text += fmt::format("{}{:.6g}", k == 0 ? "" : ", ", value(k));
  return n == 0 ? "none" : text;
}

/// Of the points of a call, for messages.
struct PointsBefore {
  std::array<LawPoints::Row<Real>, 4> sigma;
  std::vector<Real> state;
};

class LibraryMaterial final : public Material {
 public:
  /// values: shear modulus [Pa], Poisson's ratio. With s times the shear modulus of the case the law is that of soil s
  /// times as stiff: it sees strains s times as large, in times sqrt(s) times as long (decision 0035).
  LibraryMaterial(std::shared_ptr<const MaterialType> type, const LibraryInUse& in_use, std::span<const Real> values);

  /// What stands behind the arrays of the library from now on.
  void put_beyond(const NumbersBeyond& numbers) { beyond_ = numbers; }
  void update(const StressArrays<2>& arrays) const override;
  void soften(const SofteningOptions&, const SofteningArrays&) const override {}
  Moduli moduli() const override { return moduli_; }
  Moduli moduli(const LawRows&) const override { return moduli_; }
  Real viscosity() const override { return 0.0; }
  Real viscosity(const LawRows&) const override { return 0.0; }
  Real derived(int, const LawRows&) const override;
  Real softened_strain() const override;
  std::span<const int> varying() const override { return {}; }
  std::string fault() const override;

 private:
  void take_points(const StressArrays<2>& arrays, Index first, LawPoints& points, std::vector<Index>& entries) const;
  void call(LawPoints& points) const;
  void check(LawPoints& points) const;
  void give_back(const LawPoints& points, const std::vector<Index>& entries, const StressArrays<2>& arrays) const;
  void keep_fault(const LawPoints& points, const PointsBefore& before) const;
  std::string describe_place(const LawPoints& points) const;
  std::string describe_input(const LawPoints& points, const PointsBefore& before) const;

  std::shared_ptr<const MaterialType> type_;  // its texts stay as long as the law does
  LibraryInUse in_use_;
  Moduli moduli_;
  Real stiffening_;
  NumbersBeyond beyond_;
  mutable std::atomic<bool> has_fault_ = false;
  OneAtATime faults_;
  mutable std::string fault_;
  mutable std::pair<Index, std::int64_t> place_of_fault_;  // cell and number: the least one is reported
};

}  // namespace terp
