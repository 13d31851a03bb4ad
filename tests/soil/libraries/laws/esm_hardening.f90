! An external soil model of Anura3D: von Mises soil whose strength is set from PROPS in the first call, in kPa.
! PROPS: shear modulus, Poisson's ratio, strength k (|s| <= k, |s| = sqrt(1/2 s:s)). STATEV: k, calls.
subroutine esm(npt, noel, idset, stress, eunloading, plasticmultiplier, dstran, nstatev, statev, naddvar, &
               additionalvar, cmname, nprops, props, numberofphases, ntens)
  implicit none
  integer, parameter :: dp = kind(1.0d0)
  character(len=80) :: cmname
  integer :: npt, noel, idset, nstatev, naddvar, nprops, numberofphases, ntens
  real(dp) :: stress(ntens), eunloading, plasticmultiplier, dstran(ntens), statev(nstatev), additionalvar(naddvar), &
              props(nprops), lame, mean, size
  if (nint(additionalvar(10)) == 1 .and. nint(additionalvar(11)) == 1) statev = [props(3), 0.0_dp]
  lame = 2 * props(1) * props(2) / (1 - 2 * props(2))
  stress(1:3) = stress(1:3) + lame * sum(dstran(1:3)) + 2 * props(1) * dstran(1:3)
  stress(4) = stress(4) + props(1) * dstran(4)
  mean = sum(stress(1:3)) / 3
  stress(1:3) = stress(1:3) - mean
  size = sqrt(sum(stress(1:3)**2) / 2 + stress(4)**2)
  if (size > statev(1)) stress = stress * statev(1) / size
  stress(1:3) = stress(1:3) + mean
  statev(2) = statev(2) + 1
  eunloading = lame + 2 * props(1)
end subroutine
