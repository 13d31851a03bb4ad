! A user-defined soil model of Plaxis: von Mises clay whose strength falls linearly with its plastic strain, in kPa.
! Props: shear modulus, Poisson's ratio, strength k (|s| <= k, |s| = sqrt(1/2 s:s)), fall of it per strain, least one.
! StVar: k, set in task 1; plastic strain sqrt(1/2 e_p:e_p); calls.
subroutine user_mod(IDTask, iMod, IsUndr, iStep, iTer, iEl, Int, X, Y, Z, Time0, dTime, Props, Sig0, Swp0, StVar0, &
                    dEps, D, Bulk_W, Sig, Swp, StVar, ipl, nStat, NonSym, iStrsDep, iTimeDep, iTang, iPrjDir, &
                    iPrjLen, iAbort)
  implicit none
  integer, parameter :: dp = kind(1.0d0)
  integer :: IDTask, iMod, IsUndr, iStep, iTer, iEl, Int, ipl, nStat, NonSym, iStrsDep, iTimeDep, iTang, iPrjDir(*), &
             iPrjLen, iAbort, k
  real(dp) :: X, Y, Z, Time0, dTime, Props(50), Sig0(20), Swp0, StVar0(*), dEps(12), D(6, 6), Bulk_W, Sig(6), Swp, &
              StVar(*), lame, mean, size, step
  if (iMod /= 1) then
    iAbort = 1
    return
  end if
  select case (IDTask)
  case (1)
    StVar0(1) = Props(3)
  case (2)
    lame = 2 * Props(1) * Props(2) / (1 - 2 * Props(2))
    Sig = Sig0(1:6) + Props(1) * dEps(1:6)
    Sig(1:3) = Sig(1:3) + lame * sum(dEps(1:3)) + Props(1) * dEps(1:3)
    mean = sum(Sig(1:3)) / 3
    Sig(1:3) = Sig(1:3) - mean
    size = sqrt(sum(Sig(1:3)**2) / 2 + sum(Sig(4:6)**2))
    StVar(1:2) = StVar0(1:2)
    if (size > StVar0(1)) then
      ! size - 2 G d = k - fall d, d the increment of the plastic strain
      step = (size - StVar0(1)) / (2 * Props(1) - Props(4))
      if (StVar0(1) - Props(4) * step < Props(5)) step = (size - Props(5)) / (2 * Props(1))
      StVar(1) = max(Props(5), StVar0(1) - Props(4) * step)
      StVar(2) = StVar0(2) + step
      Sig = Sig * StVar(1) / size
      ipl = 1
    end if
    Sig(1:3) = Sig(1:3) + mean
    StVar(3) = StVar0(3) + 1
  case (3, 6)
    D = 0
    lame = 2 * Props(1) * Props(2) / (1 - 2 * Props(2))
    D(1:3, 1:3) = lame
    do k = 1, 3
      D(k, k) = lame + 2 * Props(1)
      D(k + 3, k + 3) = Props(1)
    end do
  case (4)
    nStat = 3
  case (5)
    NonSym = 0
    iStrsDep = 0
    iTimeDep = 0
    iTang = 0
  end select
end subroutine
