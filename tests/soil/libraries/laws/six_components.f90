! Von Mises soil with linear hardening on as many components as it is given, as a UMAT and as an ESM of Anura3D. It was
! written for three dimensions: each norm adds up all shear components, 13 and 23 too.
! PROPS: shear modulus, Poisson's ratio, strength k (|s| <= k, |s| = sqrt(1/2 s:s)), modulus of hardening, the only
! NTENS that it takes (0: any), a share of the strain 12 that it returns as stress 13. STATEV: strain, k.
module von_mises
  implicit none
  integer, parameter :: dp = kind(1.0d0)
contains
  subroutine update(n, stress, dstran, statev, props)
    integer, intent(in) :: n
    real(dp), intent(in) :: dstran(n), props(6)
    real(dp), intent(inout) :: stress(n), statev(2)
    real(dp) :: g, lame, mean, size, flow
    if (nint(props(5)) /= 0 .and. n /= nint(props(5))) then
      stress = transfer(-1_8, 1.0_dp)  ! not a number
      return
    end if
    g = props(1)
    lame = 2 * g * props(2) / (1 - 2 * props(2))
    stress(1:3) = stress(1:3) + lame * sum(dstran(1:3)) + 2 * g * dstran(1:3)
    stress(4:n) = stress(4:n) + g * dstran(4:n)
    mean = sum(stress(1:3)) / 3
    stress(1:3) = stress(1:3) - mean
    size = sqrt(sum(stress(1:3)**2) / 2 + sum(stress(4:n)**2))
    statev(2) = props(3) + props(4) * statev(1)
    if (size > statev(2)) then
      flow = (size - statev(2)) / (g + props(4))
      statev(1) = statev(1) + flow
      statev(2) = props(3) + props(4) * statev(1)
      stress = stress * (statev(2) / size)
    end if
    stress(1:3) = stress(1:3) + mean
    if (n == 6) stress(5) = stress(5) + g * props(6) * dstran(4)
  end subroutine
end module

subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, temp, &
                dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, celent, &
                dfgrd0, dfgrd1, noel, npt, layer, kspt, jstep, kinc)
  use von_mises
  implicit none
  character(len=80) :: cmname
  integer :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, jstep(4), kinc
  real(dp) :: stress(ntens), statev(nstatv), ddsdde(ntens, ntens), sse, spd, scd, rpl, ddsddt(ntens), drplde(ntens), &
              drpldt, stran(ntens), dstran(ntens), time(2), dtime, temp, dtemp, predef(1), dpred(1), props(nprops), &
              coords(3), drot(3, 3), pnewdt, celent, dfgrd0(3, 3), dfgrd1(3, 3)
  if (ndi + nshr /= ntens) error stop
  ddsdde = props(1)
  call update(ntens, stress, dstran, statev, props)
end subroutine

subroutine esm(npt, noel, idset, stress, eunloading, plasticmultiplier, dstran, nstatev, statev, naddvar, &
               additionalvar, cmname, nprops, props, numberofphases, ntens)
  use von_mises
  implicit none
  character(len=80) :: cmname
  integer :: npt, noel, idset, nstatev, naddvar, nprops, numberofphases, ntens
  real(dp) :: stress(ntens), eunloading, plasticmultiplier, dstran(ntens), statev(nstatev), additionalvar(naddvar), &
              props(nprops)
  call update(ntens, stress, dstran, statev, props)
end subroutine
