/* NorSand (M. G. Jefferies, Nor-Sand: a simple critical state model for sand, Geotechnique 43 (1993) 91-103) in Terp's
 * own interface: docs/user_laws.md#norsand.
 * Build: cc -O2 -fPIC -shared -I FOLDER_OF_terp_law.h norsand.c -o norsand.so -lm
 *
 * p and the volume strain v are positive in compression; eta = q/p, q = sqrt(3/2 s:s); e void ratio.
 *
 *   critical state   e_c = Gamma - lambda ln(p/p_ref),   eta = M
 *   yield            eta = M/N (1 + (N - 1) (p/p_i)^(N/(1 - N))),   of N = 0: eta = M (1 + ln(p_i/p))
 *   flow             d_v_p = D d_g,   D = (M - eta)/(1 - N);   g the plastic part of the deviator strain
 *   hardening        d_p_i = h (p_max - p_i) d_g,
 *                    p_max = p (1 + chi psi_i N/M)^((N - 1)/N), of N = 0: p exp(-chi psi_i/M)
 *                    psi_i = e - e_c(p_i): D is chi psi_i at the least
 *   elasticity       G = stiffness p,   K = 2 (1 + nu)/(3 (1 - 2 nu)) G
 *
 * M is the same in all directions of shearing. The elastic part of an increment is exact. Of the plastic part, p_i
 * follows from the yield surface, and the rates are integrated by the pair of Dormand and Prince, to `tolerance`. */
#include "terp_law.h"

#include <math.h>
#include <stddef.h>

static const double tolerance = 1e-11; /* of each step of the integration, over the pressure */
static const double least_part = 1e-9; /* of an increment */

enum { stiffness, poisson, critical_ratio, volumetric_n, hardening, chi, gamma_csl, lambda, p_ref, overconsolidation,
       least_pressure, n_parameters };
enum { eps_eq_p, void_ratio, image_pressure, n_state };

/* Numbers of one point. y: s xx yy zz xy, p, g. */
enum { n_y = 6, at_p = 4, at_g = 5 };
typedef struct {
  const double* c;     /* parameters */
  double d_s[4], d_v;  /* strain increment: deviator, tension positive, and volume, compression positive */
  double e0;           /* void ratio at its start */
  double y[n_y], p_i;
} sand;

static double q_of(const double* y)
{
  return sqrt(1.5 * (y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + 2 * y[3] * y[3]));
}

/* p_i/p of a stress on the yield surface. */
static double image_ratio(const double* c, double eta)
{
  const double m = c[critical_ratio], n = c[volumetric_n];
  return n > 0 ? pow((1 - n * eta / m) / (1 - n), -(1 - n) / n) : exp(eta / m - 1);
}

static double bulk_ratio(const double* c) { return 2 * (1 + c[poisson]) / (3 * (1 - 2 * c[poisson])) * c[stiffness]; }

/* Rates of y over the increment at t of it; returns that of g, not a number where the soil has no answer. */
static double rates(const sand* at, double t, const double* y, double* rate)
{
  const double* c = at->c;
  const double p = y[at_p], q = q_of(y), eta = q / p, m = c[critical_ratio], n = c[volumetric_n];
  const double big_d = (m - eta) / (1 - n), ratio = image_ratio(c, eta), k = bulk_ratio(c);
  const double e = (1 + at->e0) * exp(-at->d_v * t) - 1;
  const double psi_i = e - c[gamma_csl] + c[lambda] * log(ratio * p / c[p_ref]);
  const double most = n > 0 ? pow(1 + c[chi] * psi_i * n / m, (n - 1) / n) : exp(-c[chi] * psi_i / m);
  double unit[4], along = 0; /* s/q, and its product with the strain */
  const double size = q_of(at->d_s), isotropic = q <= 1e-12 * p;
  for (int i = 0; i < 4; ++i) {
    unit[i] = !isotropic ? y[i] / q : size > 0 ? at->d_s[i] / size : 0;
    along += (i < 3 ? 1 : 2) * unit[i] * at->d_s[i];
  }
  const double shears = !isotropic || size > 0 ? 3 * c[stiffness] : 0;
  const double loading = 3 * c[stiffness] * along + big_d * k * at->d_v;
  const double resistance = shears + big_d * big_d * k + (big_d + eta) * c[hardening] * (most / ratio - 1);
  const double d_g = resistance > 0 ? loading / resistance : NAN;
  for (int i = 0; i < 4; ++i) rate[i] = 2 * c[stiffness] * p * (at->d_s[i] - 1.5 * unit[i] * d_g);
  rate[at_p] = k * p * (at->d_v - big_d * d_g);
  rate[at_g] = d_g;
  return d_g;
}

/* Stress after the part t of the increment without plastic strain, from the state of `at`. */
static void elastic(const sand* at, double t, double* y)
{
  const double k = bulk_ratio(at->c), x = k * at->d_v * t, mean = fabs(x) > 1e-12 ? expm1(x) / x : 1;
  for (int i = 0; i < 4; ++i) y[i] = at->y[i] + 2 * at->c[stiffness] * at->y[at_p] * mean * at->d_s[i] * t;
  y[at_p] = at->y[at_p] * exp(x);
  y[at_g] = at->y[at_g];
}

/* Above 0 outside the yield surface. */
static double beyond(const sand* at, const double* y)
{
  const double* c = at->c;
  const double eta = q_of(y) / y[at_p], n = c[volumetric_n];
  if (n > 0 && n * eta >= c[critical_ratio]) return 1;
  return log(image_ratio(c, eta) * y[at_p] / at->p_i);
}

/* One step of Dormand and Prince from t on. Returns its error over the pressure. */
static double step(const sand* at, double t, double h, double* next)
{
  static const double nodes[7] = {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1, 1};
  static const double a[7][6] = {{0}, {1. / 5}, {3. / 40, 9. / 40}, {44. / 45, -56. / 15, 32. / 9},
      {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
      {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
      {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}};
  static const double differ[7] = {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40};
  double rate[7][n_y], error = 0;
  for (int stage = 0; stage < 7; ++stage) {
    for (int i = 0; i < n_y; ++i) {
      next[i] = at->y[i];
      for (int j = 0; j < stage; ++j) next[i] += h * a[stage][j] * rate[j][i];
    }
    if (!(next[at_p] > 0)) return INFINITY;
    if (isnan(rates(at, t + nodes[stage] * h, next, rate[stage]))) return INFINITY;
  }
  for (int i = 0; i < n_y; ++i) {
    double sum = 0;
    for (int stage = 0; stage < 7; ++stage) sum += differ[stage] * rate[stage][i];
    error = fmax(error, fabs(h * sum) / (i == at_g ? 1 : at->y[at_p]));
  }
  return error;
}

/* The elastic part from t on; returns where it ends: at the yield surface, or 1. */
static double go_elastic(sand* at, double t)
{
  double y[n_y], low = 0, high = 1 - t;
  elastic(at, high, y);
  if (beyond(at, y) > 0) {
    for (int k = 0; k < 100 && high - low > 0; ++k) {
      const double middle = 0.5 * (low + high);
      if (middle == low || middle == high) break;
      elastic(at, middle, y);
      if (beyond(at, y) > 0)
        high = middle;
      else
        low = middle;
    }
    elastic(at, low, y);
    high = low;
  }
  for (int i = 0; i < n_y; ++i) at->y[i] = y[i];
  return t + high;
}

/* Returns 0 where the soil has no answer. */
static int strain_sand(sand* at)
{
  double t = 0, h = 1;
  while (t < 1) {
    double rate[n_y], next[n_y];
    const int yields = beyond(at, at->y) >= -1e-13;
    if (!yields || rates(at, t, at->y, rate) < 0) {
      const double p_i = at->p_i, from = t;
      if (yields) at->p_i *= 1 + 1e-13; /* it goes inwards from the surface itself */
      t = go_elastic(at, t);
      at->p_i = p_i;
      if (yields && t == from) return 0;
      continue;
    }
    h = fmin(h, 1 - t);
    const double error = step(at, t, h, next);
    if (error <= tolerance) {
      t = h >= 1 - t ? 1 : t + h;
      for (int i = 0; i < n_y; ++i) at->y[i] = next[i];
      at->p_i = image_ratio(at->c, q_of(next) / next[at_p]) * next[at_p];
    }
    h *= fmin(4, fmax(0.1, 0.9 * pow(tolerance / fmax(error, 1e-30), 0.2)));
    if (h < least_part) return 0;
  }
  return 1;
}

static int update(terp_law_points* points)
{
  const double* c = points->parameters;
  for (int k = 0; k < points->n; ++k) {
    sand at = {.c = c, .e0 = points->state[void_ratio][k], .p_i = points->state[image_pressure][k]};
    double sigma[4], mean = 0;
    for (int i = 0; i < 4; ++i) sigma[i] = points->stress[i][k], at.d_s[i] = points->strain_increment[i][k];
    for (int i = 0; i < 3; ++i) mean += sigma[i] / 3, at.d_v -= at.d_s[i];
    for (int i = 0; i < 4; ++i) at.y[i] = sigma[i] - (i < 3 ? mean : 0), at.d_s[i] += i < 3 ? at.d_v / 3 : 0;
    at.y[at_p] = fmax(-mean, c[least_pressure]);
    const double eta = q_of(at.y) / at.y[at_p];
    const double most = c[volumetric_n] > 0 ? 0.99 * c[critical_ratio] / c[volumetric_n] : 20;
    if (eta > most) /* a stress from before that no sand of these parameters has */
      for (int i = 0; i < 4; ++i) at.y[i] *= most / eta;
    if (!(at.p_i > 0)) at.p_i = c[overconsolidation] * image_ratio(c, fmin(eta, most)) * at.y[at_p];
    if (!strain_sand(&at)) {
      points->point = k;
      points->message = "NorSand has no answer to this strain increment: it softens too fast for its elastic stiffness";
      return TERP_LAW_FAILED;
    }
    if (at.y[at_p] < c[least_pressure]) { /* what has come apart */
      at.y[at_p] = c[least_pressure];
      for (int i = 0; i < 4; ++i) at.y[i] = 0;
    }
    for (int i = 0; i < 4; ++i) points->stress[i][k] = at.y[i] - (i < 3 ? at.y[at_p] : 0);
    points->state[eps_eq_p][k] += sqrt(0.75) * at.y[at_g];
    points->state[void_ratio][k] = (1 + at.e0) * exp(-at.d_v) - 1;
    points->state[image_pressure][k] = at.p_i;
  }
  return TERP_LAW_OK;
}

static const terp_law_variable parameters[n_parameters] = {{"stiffness", NULL, "G/p", 0},
    {"poisson_ratio", NULL, "elastic Poisson's ratio", 0}, {"M", NULL, "q/p of the critical state", 0},
    {"N", NULL, "volumetric coupling, 0 to 0.5", 0}, {"h", NULL, "plastic hardening modulus", 0},
    {"chi", NULL, "least dilatancy over the state parameter, about 3.5", 0},
    {"Gamma", NULL, "void ratio of the critical state at p_ref", 0},
    {"lambda", NULL, "fall of the critical void ratio for each ln p", 0},
    {"p_ref", "Pa", "pressure of Gamma, 1 kPa in most of the literature", 0},
    {"overconsolidation", NULL, "image pressure at the start over that of a stress on the yield surface", 0},
    {"least_pressure", "Pa", "below which p does not fall", 0}};
static const terp_law_variable state[n_state] = {
    {"eps_eq_p", NULL, "plastic strain, sum of sqrt(1/2 d_e_p : d_e_p)", 0},
    {"void_ratio", NULL, "void ratio e", 0.7}, {"image_pressure", "Pa", "p_i; 0: of the first stress", 0}};

static const terp_law_description law = {TERP_LAW_VERSION, n_parameters, parameters, n_state, state, 1, update};

const terp_law_description* terp_law(void) { return &law; }
