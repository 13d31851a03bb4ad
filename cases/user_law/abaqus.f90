! Utility routines of Abaqus that a user material (UMAT) may call, written from their documented meaning. A law that calls
! one of them is built with this file beside its own: docs/user_laws.md.
! Build    gfortran -O2 -fPIC -shared law.f abaqus.f90 -o law.so
!
! Components are those of a UMAT: NDI direct ones, then NSHR shears 12, 13, 23. LSTR = 1: stress, with tensorial shear.
! LSTR = 2: strain, with engineering shear.

module abaqus_tensors
  implicit none
  integer, parameter :: dp = selected_real_kind(15)
  integer, parameter :: row(3) = [1, 1, 2], column(3) = [2, 3, 3]  ! of the shears

contains

  pure function tensor_of(s, lstr, ndi, nshr) result(t)
    real(dp), intent(in) :: s(*)
    integer, intent(in) :: lstr, ndi, nshr
    real(dp) :: t(3, 3)
    integer :: k
    t = 0
    do k = 1, ndi
      t(k, k) = s(k)
    end do
    do k = 1, nshr
      t(row(k), column(k)) = s(ndi + k) / lstr
      t(column(k), row(k)) = t(row(k), column(k))
    end do
  end function

  ! Values, largest first, and directions in the columns of v, right-handed. Jacobi's method: each turn clears one shear.
  pure subroutine principal(t, p, v)
    real(dp), intent(in) :: t(3, 3)
    real(dp), intent(out) :: p(3), v(3, 3)
    real(dp) :: a(3, 3), turn(3, 3), angle
    integer :: sweep, k, i, j, order(3)
    a = t
    v = reshape([1, 0, 0, 0, 1, 0, 0, 0, 1], [3, 3])
    do sweep = 1, 50
      if (sum(abs([a(1, 2), a(1, 3), a(2, 3)])) <= epsilon(1.0_dp)**2 * sum(abs(t))) exit
      do k = 1, 3
        i = row(k)
        j = column(k)
        if (a(i, j) == 0) cycle
        angle = atan2(2 * a(i, j), a(i, i) - a(j, j)) / 2
        turn = reshape([1, 0, 0, 0, 1, 0, 0, 0, 1], [3, 3])
        turn(i, i) = cos(angle)
        turn(j, j) = turn(i, i)
        turn(j, i) = sin(angle)
        turn(i, j) = -turn(j, i)
        a = matmul(transpose(turn), matmul(a, turn))
        a(i, j) = 0
        a(j, i) = 0
        v = matmul(v, turn)
      end do
    end do
    p = [a(1, 1), a(2, 2), a(3, 3)]
    order = [1, 2, 3]
    do k = 1, 3
      do i = 1, 2
        if (p(order(i)) < p(order(i + 1))) order(i:i + 1) = order([i + 1, i])
      end do
    end do
    p = p(order)
    v = v(:, order)
    v(:, 3) = [v(2, 1) * v(3, 2) - v(3, 1) * v(2, 2), v(3, 1) * v(1, 2) - v(1, 1) * v(3, 2), &
               v(1, 1) * v(2, 2) - v(2, 1) * v(1, 2)]
  end subroutine

end module

! SINV1 = trace / 3, SINV2 = sqrt(3/2 s:s) with the deviator s: the stress of von Mises.
subroutine sinv(stress, sinv1, sinv2, ndi, nshr)
  use abaqus_tensors
  implicit none
  integer :: ndi, nshr, k
  real(dp) :: stress(*), sinv1, sinv2, t(3, 3)
  t = tensor_of(stress, 1, ndi, nshr)
  sinv1 = (t(1, 1) + t(2, 2) + t(3, 3)) / 3
  do k = 1, 3
    t(k, k) = t(k, k) - sinv1
  end do
  sinv2 = sqrt(1.5_dp * sum(t * t))
end subroutine

! PS: principal values, largest first.
subroutine sprinc(s, ps, lstr, ndi, nshr)
  use abaqus_tensors
  implicit none
  integer :: lstr, ndi, nshr
  real(dp) :: s(*), ps(3), v(3, 3)
  call principal(tensor_of(s, lstr, ndi, nshr), ps, v)
end subroutine

! AN(k, :): direction cosines of PS(k).
subroutine sprind(s, ps, an, lstr, ndi, nshr)
  use abaqus_tensors
  implicit none
  integer :: lstr, ndi, nshr
  real(dp) :: s(*), ps(3), an(3, 3), v(3, 3)
  call principal(tensor_of(s, lstr, ndi, nshr), ps, v)
  an = transpose(v)
end subroutine

! SPRIME = R S R^T; R is DROT of the UMAT.
subroutine rotsig(s, r, sprime, lstr, ndi, nshr)
  use abaqus_tensors
  implicit none
  integer :: lstr, ndi, nshr, k
  real(dp) :: s(*), r(3, 3), sprime(*), t(3, 3)
  t = tensor_of(s, lstr, ndi, nshr)
  t = matmul(r, matmul(t, transpose(r)))
  do k = 1, ndi
    sprime(k) = t(k, k)
  end do
  do k = 1, nshr
    sprime(ndi + k) = lstr * t(row(k), column(k))
  end do
end subroutine

! Ends the run.
subroutine xit
  implicit none
  stop 1
end subroutine

! A message, in which %I, %R and %S stand for the next of INTV, REALV and CHARV. LOP = -3 ends the run.
subroutine stdb_abqerr(lop, string, intv, realv, charv)
  use abaqus_tensors, only: dp
  implicit none
  integer :: lop, intv(*), at, n(3)
  real(dp) :: realv(*)
  character(len=*) :: string
  character(len=8) :: charv(*)
  character(len=32) :: number
  n = 0
  write (0, '(a)', advance='no') merge('message of the law: ', 'error of the law:   ', lop >= -1)
  at = 1
  do while (at <= len_trim(string))
    number = string(at:min(at + 1, len(string)))
    select case (number(1:2))
    case ('%I', '%i')
      n(1) = n(1) + 1
      write (number, '(i0)') intv(n(1))
    case ('%R', '%r')
      n(2) = n(2) + 1
      write (number, '(es13.6)') realv(n(2))
    case ('%S', '%s')
      n(3) = n(3) + 1
      number = charv(n(3))
    case default
      write (0, '(a)', advance='no') string(at:at)
      at = at + 1
      cycle
    end select
    write (0, '(a)', advance='no') trim(adjustl(number))
    at = at + 2
  end do
  write (0, '()')
  if (lop == -3) call xit
end subroutine

subroutine getoutdir(outdir, lenoutdir)
  implicit none
  character(len=*) :: outdir
  integer :: lenoutdir
  outdir = '.'
  lenoutdir = 1
end subroutine

subroutine getjobname(jobname, lenjobname)
  implicit none
  character(len=*) :: jobname
  integer :: lenjobname
  jobname = 'terp'
  lenjobname = 4
end subroutine
