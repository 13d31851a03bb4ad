! Tresca soil whose undrained strength softens, as a user material (UMAT) of Abaqus/Standard in plane strain: the same
! law as Terp's own tresca_softening, to compare with. docs/user_laws.md leads through it.
!
!   S_u = su_residual + (su_peak - su_residual) exp(-eta k),  k the equivalent plastic strain, sqrt(1/2 de_p : de_p)
!
! PROPS    shear_modulus [Pa], poisson_ratio, su_peak [Pa], su_residual [Pa], eta
! STATEV   k
! Build    gfortran -O2 -fPIC -shared tresca.f90 -o tresca.so

module tresca_law
  implicit none
  private
  integer, parameter, public :: dp = kind(1.0d0)
  public :: return_to_surface, yields

  type, public :: clay
    real(dp) :: g, peak, residual, eta
  end type

contains

  pure function strength(soil, k) result(su)
    type(clay), intent(in) :: soil
    real(dp), intent(in) :: k
    real(dp) :: su
    su = soil%residual + (soil%peak - soil%residual) * exp(-soil%eta * k)
  end function

  ! -dS_u/dk
  pure function fall(soil, k) result(slope)
    type(clay), intent(in) :: soil
    real(dp), intent(in) :: k
    real(dp) :: slope
    slope = soil%eta * (soil%peak - soil%residual) * exp(-soil%eta * k)
  end function

  ! True of principal stresses, largest first, beyond the yield surface by more than round-off.
  pure function yields(soil, s, k)
    type(clay), intent(in) :: soil
    real(dp), intent(in) :: s(3), k
    logical :: yields
    yields = s(1) - s(3) > 2 * strength(soil, k) * (1 + 1e-11_dp)
  end function

  ! s: principal stresses, largest first; in: elastic trial, out: on the yield surface. k: in, out.
  pure subroutine return_to_surface(soil, s, k)
    type(clay), intent(in) :: soil
    real(dp), intent(inout) :: s(3), k
    real(dp) :: trial(3), edge(3), d
    trial = s
    d = solve_plane(soil, trial, k)
    s = trial + [-1, 0, 1] * 2 * soil%g * d
    if (s(1) >= s(2) .and. s(2) >= s(3)) then
      k = k + d
      return
    end if
    if (s(1) < s(2)) then
      edge = [2, 2, -4] / 3.0_dp   ! largest = middle
    else
      edge = [4, -2, -2] / 3.0_dp  ! middle = smallest
    end if
    d = solve_edge(soil, trial - sum(trial) / 3, edge, k, d)
    k = k + d
    s = sum(trial) / 3 + strength(soil, k) * edge
  end subroutine

  ! (s1 - s3)/2 - 2 G d = S_u(k + d), by Newton's method from 0
  pure function solve_plane(soil, s, k) result(d)
    type(clay), intent(in) :: soil
    real(dp), intent(in) :: s(3), k
    real(dp) :: d, next
    integer :: step
    d = 0
    do step = 1, 50
      next = max(0.0_dp, d + ((s(1) - s(3)) / 2 - 2 * soil%g * d - strength(soil, k + d)) &
                             / (2 * soil%g - fall(soil, k + d)))
      if (abs(next - d) <= 1e-15_dp * next) exit
      d = next
    end do
    d = next
  end function

  ! 2 G d = |t - S_u(k + d) edge|,  |a| = sqrt(1/2 a:a)
  pure function solve_edge(soil, t, edge, k, first) result(d)
    type(clay), intent(in) :: soil
    real(dp), intent(in) :: t(3), edge(3), k, first
    real(dp) :: d, next, rest(3), distance
    integer :: step
    d = first
    do step = 1, 50
      rest = t - strength(soil, k + d) * edge
      distance = sqrt(sum(rest * rest) / 2)
      next = max(0.0_dp, d - (2 * soil%g * d - distance) &
                             / (2 * soil%g - sum(rest * edge) / (2 * distance) * fall(soil, k + d)))
      if (abs(next - d) <= 1e-15_dp * next) exit
      d = next
    end do
    d = next
  end function

end module

subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, &
                temp, dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, &
                celent, dfgrd0, dfgrd1, noel, npt, layer, kspt, jstep, kinc)
  use tresca_law
  implicit none
  character(len=80) :: cmname
  integer :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, jstep(4), kinc
  real(dp) :: stress(ntens), statev(nstatv), ddsdde(ntens, ntens), sse, spd, scd, rpl, ddsddt(ntens), drplde(ntens), &
              drpldt, stran(ntens), dstran(ntens), time(2), dtime, temp, dtemp, predef(1), dpred(1), props(nprops), &
              coords(3), drot(3, 3), pnewdt, celent, dfgrd0(3, 3), dfgrd1(3, 3)
  type(clay) :: soil
  real(dp) :: lame, mean, half, radius, cos2, sin2, s(3), p(3)
  integer :: rank_zz

  soil = clay(props(1), props(3), props(4), props(5))
  lame = 2 * props(1) * props(2) / (1 - 2 * props(2))
  stress(1:3) = stress(1:3) + lame * sum(dstran(1:3)) + 2 * props(1) * dstran(1:3)
  stress(4) = stress(4) + props(1) * dstran(4)  ! DSTRAN(4) is the engineering shear strain

  ! principal stresses: two in the plane, and that across it
  mean = (stress(1) + stress(2)) / 2
  half = (stress(1) - stress(2)) / 2
  radius = sqrt(half**2 + stress(4)**2)
  cos2 = 1
  sin2 = 0
  if (radius > 0) then
    cos2 = half / radius
    sin2 = stress(4) / radius
  end if
  p = [mean + radius, mean - radius, stress(3)]
  rank_zz = 2
  s = [p(1), p(3), p(2)]
  if (p(3) > p(1)) then
    rank_zz = 1
    s = [p(3), p(1), p(2)]
  else if (p(3) < p(2)) then
    rank_zz = 3
    s = p
  end if

  if (.not. yields(soil, s, statev(1))) return
  call return_to_surface(soil, s, statev(1))

  select case (rank_zz)
  case (1)
    p = [s(2), s(3), s(1)]
  case (2)
    p = [s(1), s(3), s(2)]
  case default
    p = [s(1), s(2), s(3)]
  end select
  mean = (p(1) + p(2)) / 2
  radius = (p(1) - p(2)) / 2
  stress = [mean + radius * cos2, mean - radius * cos2, p(3), radius * sin2]
end subroutine
