/* A user material that is elastic, and does what PROPS(3) says from the time PROPS(4) on, at points right of PROPS(5).
 * PROPS: shear modulus [Pa], Poisson's ratio, kind, time [s], x [m], a limit. */
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { elastic, nan_stress, nan_state, bad_memory, divides, aborts, leaves, never_small, small_parts, overflows,
       counts, turns, changes_rounding, tenths, nan_answer, beyond_state, beyond_props, reads_props, has_strength,
       has_size, crashes_in_c, tensorial_shear, counts_to_six, no_strength,
       adds_beyond_state, compares_beyond_props, compares_beyond_state, compares_in_extension,
       loops, leaves_at_once, copies_itself };

static volatile int zero = 0;
static int calls = 0, copies = 0;

static int deepen(volatile char* above)
{
  volatile char here[4096];
  here[0] = above[0];
  return deepen(here) + here[1];
}

void umat_(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
    double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran, double* time, double* dtime,
    double* temp, double* dtemp, double* predef, double* dpred, char* cmname, int* ndi, int* nshr, int* ntens,
    int* nstatv, double* props, int* nprops, double* coords, double* drot, double* pnewdt, double* celent,
    double* dfgrd0, double* dfgrd1, int* noel, int* npt, int* layer, int* kspt, int* jstep, int* kinc, size_t length)
{
  (void)sse, (void)spd, (void)scd, (void)rpl, (void)ddsddt, (void)drplde, (void)drpldt, (void)stran;
  (void)temp, (void)dtemp, (void)predef, (void)dpred, (void)cmname, (void)ndi, (void)nshr, (void)ntens;
  (void)dfgrd0, (void)layer, (void)kspt, (void)jstep, (void)kinc, (void)length, (void)noel, (void)npt;
  const double shear = props[0], lame = 2 * props[0] * props[1] / (1 - 2 * props[1]);
  const double volume = dstran[0] + dstran[1] + dstran[2];
  const int kind = (int)props[2];
  for (int k = 0; k < 3; ++k) stress[k] += lame * volume + 2 * shear * dstran[k];
  stress[3] += (kind == tensorial_shear ? 2 : 1) * shear * dstran[3]; /* the strain is engineering: once is right */
  props[0] = -1.0; /* a law may use PROPS as it likes */
  if (*nstatv > 0) statev[0] += 1.0;
  if (*nstatv == 5) { /* what it was given, for a test to look at */
    statev[1] = *dtime, statev[2] = dfgrd1[0], statev[3] = dfgrd1[3], statev[4] = stran[0] + dstran[0];
  }
  if (*nstatv == 8) {
    statev[1] = dfgrd1[0], statev[2] = dfgrd1[3], statev[3] = dfgrd1[1], statev[4] = dfgrd1[4];
    statev[5] = stran[0] + dstran[0], statev[6] = stran[1] + dstran[1], statev[7] = stran[3] + dstran[3];
  }
  if (time[1] < props[3] || coords[0] < props[4]) return;
  switch (kind) {
    case nan_stress: stress[1] = NAN; break;
    case nan_state: statev[0] = NAN; break;
    case bad_memory: *(volatile double*)(size_t)(8 * zero + 8) = 1.0; break;
    case divides: stress[0] = (kind + 7) / zero; break;
    case aborts: abort();
    case leaves: exit(0);
    case never_small: *pnewdt = 0.5; break;
    case small_parts:
      if (fabs(dstran[0]) + fabs(dstran[1]) > props[5]) *pnewdt = 0.5, stress[0] = NAN;
      break;
    case overflows: {
      volatile char first = 0;
      stress[0] = deepen(&first);
      break;
    }
    case counts: statev[0] = ++calls; break;
    case turns: statev[0] = drot[1]; break;
    case changes_rounding: fesetround(FE_UPWARD); break;
    case tenths:
      if (*dtime > props[5]) *pnewdt = 0.1;
      break;
    case nan_answer: *pnewdt = NAN; break;
    case beyond_state: statev[*nstatv] = 1.0; break;
    case adds_beyond_state: statev[*nstatv] += 1.0; break;
    case beyond_props: props[*nprops] = 1.0; break;
    case reads_props: stress[0] += props[*nprops]; break;
    case has_strength:
      if (fabs(stress[3]) > props[5]) stress[3] = NAN;
      break;
    case has_size:
      if (*celent != props[5]) stress[0] = NAN;
      break;
    case counts_to_six: /* whatever NTENS is, as many laws do */
      for (int k = 0; k < 36; ++k) ddsdde[k] = 1e9;
      for (int k = 4; k < 6; ++k) {
        if (stress[k] != 0 || dstran[k] != 0) stress[0] = NAN;
        stress[k] = 1e9;
      }
      if (props[5] > 0 && *dtime > props[5]) *pnewdt = 0.1;
      break;
    case compares_beyond_props: /* of a number that is none nothing is larger */
      if (stress[3] > props[*nprops]) stress[3] = props[*nprops];
      break;
    case compares_beyond_state: /* in compression alone */
      if (dstran[1] < -1e-4 && stress[1] < statev[*nstatv]) stress[1] = statev[*nstatv];
      break;
    case compares_in_extension:
      if (dstran[1] > 1e-4 && stress[1] > props[*nprops]) stress[1] = props[*nprops];
      break;
    case loops:
      while (!zero) continue;
      break;
    case no_strength: statev[0] = -0.5; break;
    case crashes_in_c: puts((const char*)(size_t)(8 * zero + 8)); break;
    case leaves_at_once: _exit(0);
    case copies_itself:
      if (++copies == 1 && fork() < 0) abort();
      break;
    default: break;
  }
}

/* An external soil model that takes STATEV for longer than it is; without STATEV an elastic one that counts to six. */
void esm_(int* npt, int* noel, int* idset, double* stress, double* eunloading, double* plasticmultiplier,
    double* dstran, int* nstatev, double* statev, int* naddvar, double* additionalvar, char* cmname, int* nprops,
    double* props)
{
  (void)npt, (void)noel, (void)idset, (void)eunloading, (void)plasticmultiplier, (void)naddvar, (void)additionalvar;
  (void)cmname, (void)nprops;
  if (*nstatev > 0) {
    statev[*nstatev] = 1.0;
    return;
  }
  const double lame = 2 * props[0] * props[1] / (1 - 2 * props[1]), volume = dstran[0] + dstran[1] + dstran[2];
  for (int k = 0; k < 6; ++k) stress[k] += k < 3 ? lame * volume + 2 * props[0] * dstran[k] : props[0] * dstran[k];
  if (stress[4] != 0 || stress[5] != 0) stress[0] = NAN;
  if (*nprops == 3 && stress[1] > props[3]) stress[1] = props[3]; /* a limit of the tension, which is not given */
  stress[5] = 1e9;
}
