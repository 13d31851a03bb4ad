// Return of a trial stress to a Mohr-Coulomb surface of given strength, cut off in tension: exact, in principal
// stresses. Not for: how the strength softens (mohr_coulomb.cpp).
#pragma once

#include "soil/laws/principal.hpp"

namespace terp {

/// Strength at one point. Angles psi <= phi < 90 degrees, phi >= 0; of psi < 0 the stiffness of a plane, and its sum
/// with that between two planes, is positive.
template <class R>
struct MohrCoulombStrength {
  R sin_phi, cos_phi, sin_psi;
  R cohesion;  ///< c [Pa]
  R tension;   ///< T [Pa], at most c cot(phi): no principal stress exceeds it
};

/// (1 + sin phi) s1 - (1 - sin phi) s3 - 2 c cos phi [Pa], tension positive: above 0 outside.
template <class R>
R mohr_coulomb_excess(R major, R minor, const MohrCoulombStrength<R>& at)
{
  return (major - minor) + at.sin_phi * (major + minor) - R(2.0) * at.cohesion * at.cos_phi;
}

/// The return; P: number type of the moduli, Real or R. Flow on a shear plane is (1 + sin psi, 0, -(1 - sin psi)), on a
/// tension plane (1, 0, 0). Each of the planes is straight and the elasticity constant, so that every region of the
/// surface has a closed form, by which plastic multipliers that are not negative lead to a stress that no plane
/// forbids.
template <class R, class P = Real>
class MohrCoulombReturn {
 public:
  MohrCoulombReturn(const MohrCoulombStrength<R>& strength, P bulk, P shear)
      : at_(strength), lame_(bulk - 2.0 / 3.0 * shear), shear_(shear)
  {
    const R volumetric = R(2.0 * lame_) * at_.sin_psi;  // elastic stress of the flow on the plane of s1 and s3
    of_major_ = volumetric + R(2.0 * shear_) * (R(1.0) + at_.sin_psi);
    of_middle_ = volumetric;
    of_minor_ = volumetric - R(2.0 * shear_) * (R(1.0) - at_.sin_psi);
  }

  /// trial: outside the surface. The order of the principal stresses is kept.
  Sorted<R> operator()(const Sorted<R>& trial) const
  {
    const Sorted<R> sheared = return_by_shear(trial);
    const auto torn = sheared.major > at_.tension;
    if (!any_of(torn)) return sheared;
    const Sorted<R> opened = return_by_tension(trial);
    const auto slips = mohr_coulomb_excess(opened.major, opened.minor, at_) > R(0.0);
    return select(torn, select(slips, return_by_both(trial), opened), sheared);
  }

 private:
  /// n : D : r of two shear planes: the flow of the one raises the excess of the other by it. major, minor: elastic
  /// stress of the flow in the two directions that the other plane looks at.
  R stiffness(R major, R minor) const { return (major - minor) + at_.sin_phi * (major + minor); }

  /// To the plane, or to the edge where the middle stress equals the major or the minor one. Beyond the apex the answer
  /// exceeds the tension limit.
  Sorted<R> return_by_shear(const Sorted<R>& trial) const
  {
    const R excess = max(R(0.0), mohr_coulomb_excess(trial.major, trial.minor, at_));
    const R own = stiffness(of_major_, of_minor_), multiplier = excess / own;
    const Sorted<R> plane{trial.major - multiplier * of_major_, trial.middle - multiplier * of_middle_,
        trial.minor - multiplier * of_minor_};
    const auto past_major = plane.major < plane.middle;
    const auto past_minor = plane.middle < plane.minor;
    if (!any_of(past_major | past_minor)) return plane;

    const R twice_c = R(2.0) * at_.cohesion * at_.cos_phi;
    const R with_minor = mohr_coulomb_excess(trial.middle, trial.minor, at_);  // of the plane of s2 and s3
    const R minor = trial.minor - of_minor_ * ((excess + with_minor) / (own + stiffness(of_middle_, of_minor_)));
    const R majors = (twice_c + (R(1.0) - at_.sin_phi) * minor) / (R(1.0) + at_.sin_phi);
    const R with_major = mohr_coulomb_excess(trial.major, trial.middle, at_);  // of the plane of s1 and s2
    const R major = trial.major - of_major_ * ((excess + with_major) / (own + stiffness(of_major_, of_middle_)));
    const R minors = ((R(1.0) + at_.sin_phi) * major - twice_c) / (R(1.0) - at_.sin_phi);
    return select(
        past_major, Sorted<R>{majors, majors, minor}, select(past_minor, Sorted<R>{major, minors, minors}, plane));
  }

  /// To one, two or three planes s = T.
  Sorted<R> return_by_tension(const Sorted<R>& trial) const
  {
    const R t = at_.tension;
    const R one = max(R(0.0), trial.major - t) * R(lame_ / (lame_ + 2.0 * shear_));
    const R middle = trial.middle - one;
    const R two = (trial.major - t + trial.middle - t) * R(lame_ / (2.0 * lame_ + 2.0 * shear_));
    const auto both = middle > t;
    const R minor = select(both, trial.minor - two, trial.minor - one);
    return {min(trial.major, t), min(middle, t), min(minor, t)};
  }

  /// To where the shear plane meets s1 = T: s1 and s3 are known, s2 stays between them.
  Sorted<R> return_by_both(const Sorted<R>& trial) const
  {
    const R t = at_.tension;
    const R minor = min(t, ((R(1.0) + at_.sin_phi) * t - R(2.0) * at_.cohesion * at_.cos_phi) / (R(1.0) - at_.sin_phi));
    const R d_major = trial.major - t, d_minor = trial.minor - minor;
    const R along(lame_ + 2.0 * shear_), across(lame_);
    const R inverse = R(1.0) / (of_major_ * across - of_minor_ * along);  // 1 / (4 G (lame + G) (1 - sin psi))
    const R by_shear = (d_major * across - d_minor * along) * inverse;
    const R by_tension = (of_major_ * d_minor - of_minor_ * d_major) * inverse;
    const R middle = trial.middle - by_shear * of_middle_ - by_tension * across;
    return {t, min(max(middle, minor), t), minor};
  }

  MohrCoulombStrength<R> at_;
  P lame_, shear_;                     // K - 2G/3, G [Pa]
  R of_major_, of_middle_, of_minor_;  // [Pa]
};

}  // namespace terp
