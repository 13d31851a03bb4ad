// What a material point carries, one entry for each quantity: the list that blocks are sized by, and that frames,
// checkpoints and the averaging of MPM-Mixed read. It is made at setup, so that a row which nobody uses does not exist.
// Not for: the numbers themselves (point_blocks.hpp).
#pragma once

#include "math/tensor.hpp"
#include "math/types.hpp"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace terp {

/// The rows that every material point has, as offsets for the kernels; RowTable lists these and all others. Row r of
/// a block is data + r * capacity, one Real per point.
template <int Dim>
struct PointRows {
  static constexpr int x = 0;                        ///< position [m], Dim rows
  static constexpr int xi = x + Dim;                 ///< local coordinates in the cell [-], Dim rows; follow from x
  static constexpr int v = xi + Dim;                 ///< velocity [m/s], Dim rows
  static constexpr int mass = v + Dim;               ///< [kg per m]
  static constexpr int volume = mass + 1;            ///< Omega_p [m^2]
  static constexpr int sigma = volume + 1;           ///< Cauchy stress [Pa], n_sym rows
  static constexpr int strain = sigma + n_sym<Dim>;  ///< accumulated total strain [-], n_sym rows
  static constexpr int id = strain + n_sym<Dim>;     ///< whole number, exact as a Real
  static constexpr int state = id + 1;               ///< those that laws and others add
};
using Rows = PointRows<2>;

/// How a quantity of the points reaches the Gauss points of MPM-Mixed, where the law runs (reading R9).
enum class Averaging {
  cell,      ///< its mean over the cell, which the points then take
  sub_cell,  ///< its mean over the sub-cell, which the points then take
  keep,      ///< its mean over the sub-cell is used at the Gauss point; the points keep their own values
};

/// One quantity of the points: `n` rows of a block from `first` on, one for each component.
struct RowInfo {
  std::string name;  ///< of the array in checkpoints, and of the field in frames
  std::string unit;
  std::string meaning;
  std::string owner;  ///< what added it: "motion", "law"
  Averaging averaging = Averaging::keep;
  Real initial = 0.0;                                 ///< value of each component at t = 0
  std::vector<std::pair<Index, Real>> initials = {};  ///< the same of materials that have another, by their numbers
  bool shown = false;                                 ///< in frames
  bool saved = true;                                  ///< in checkpoints
  std::vector<Index> of = {};  ///< numbers of the materials whose points have it; empty: all points do
  int n = 1;
  int first = 0;  ///< set by the table

  bool is_of(Index material) const;
  Real initial_in(Index material) const;
  bool operator==(const RowInfo&) const = default;
};

class RowTable {
 public:
  /// The fixed rows of PointRows<2>.
  RowTable();

  /// Adds a row and returns its number. A row of the same name is shared: it must agree in unit and averaging, and its
  /// materials are joined.
  int add(RowInfo info);

  std::span<const RowInfo> entries() const { return entries_; }
  /// Those beyond the fixed ones.
  std::span<const RowInfo> added() const { return entries().subspan(n_fixed_); }
  int n_rows() const;
  bool operator==(const RowTable&) const = default;

 private:
  std::vector<RowInfo> entries_;
  std::size_t n_fixed_ = 0;
};

/// Rows of numbers as a law takes them: row k begins at data + number[k] * stride, or at data + k * stride where no
/// numbers are given.
struct RowView {
  Real* data = nullptr;
  std::ptrdiff_t stride = 1;
  const int* number = nullptr;

  Real* operator()(std::size_t k) const
  {
    return data + (number == nullptr ? static_cast<std::ptrdiff_t>(k) : number[k]) * stride;
  }
};

}  // namespace terp
