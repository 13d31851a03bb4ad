! An elastic user material that uses the utility routines of Abaqus. STATEV: a strain that turns with the soil, its
! largest principal value, the stress of von Mises. PROPS: shear modulus [Pa], Poisson's ratio, a stress of von Mises
! [Pa] from which it calls STDB_ABQERR with LOP = -3.
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, &
                temp, dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, &
                celent, dfgrd0, dfgrd1, noel, npt, layer, kspt, jstep, kinc)
  include 'ABA_PARAM.INC'
  character*80 cmname
  dimension stress(ntens), statev(nstatv), ddsdde(ntens, ntens), ddsddt(ntens), drplde(ntens), stran(ntens), &
    dstran(ntens), time(2), predef(1), dpred(1), props(nprops), coords(3), drot(3, 3), dfgrd0(3, 3), dfgrd1(3, 3), &
    jstep(4)
  dimension strain(6), values(3), intv(1), realv(1)
  character*8 charv(1)
  elame = 2 * props(1) * props(2) / (1 - 2 * props(2))
  stress(1:3) = stress(1:3) + elame * sum(dstran(1:3)) + 2 * props(1) * dstran(1:3)
  stress(4) = stress(4) + props(1) * dstran(4)
  call rotsig(statev(1), drot, strain, 2, ndi, nshr)
  statev(1:4) = strain(1:4) + dstran
  call sprinc(statev(1), values, 2, ndi, nshr)
  statev(5) = values(1)
  call sinv(stress, smean, statev(6), ndi, nshr)
  if (statev(6) <= props(3)) return
  write (0, '(a)') 'the law looks at its stress'
  intv(1) = noel
  realv(1) = statev(6)
  charv(1) = cmname(1:8)
  call stdb_abqerr(-3, '%S of cell %I has a stress of %R Pa', intv, realv, charv)
end subroutine
