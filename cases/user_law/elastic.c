/* Linear elastic soil in Terp's own interface, with the sum of its shear strain as state: docs/user_laws.md.
 * Build: cc -O2 -fPIC -shared -I FOLDER_OF_terp_law.h elastic.c -o elastic.so */
#include "terp_law.h"

#include <math.h>
#include <stddef.h>

static int update(terp_law_points* at)
{
  const double shear = at->parameters[0], nu = at->parameters[1], lame = 2 * shear * nu / (1 - 2 * nu);
  for (int p = 0; p < at->n; ++p) {
    const double xx = at->strain_increment[0][p], yy = at->strain_increment[1][p], zz = at->strain_increment[2][p];
    const double xy = at->strain_increment[3][p], mean = (xx + yy + zz) / 3;
    at->stress[0][p] += lame * (xx + yy + zz) + 2 * shear * xx;
    at->stress[1][p] += lame * (xx + yy + zz) + 2 * shear * yy;
    at->stress[2][p] += lame * (xx + yy + zz) + 2 * shear * zz;
    at->stress[3][p] += 2 * shear * xy;
    const double square = (xx - mean) * (xx - mean) + (yy - mean) * (yy - mean) + (zz - mean) * (zz - mean);
    at->state[0][p] += sqrt(square / 2 + xy * xy);
  }
  return TERP_LAW_OK;
}

static const terp_law_variable parameters[] = {
    {"stiffness", "Pa", "elastic shear modulus", 0.0}, {"poisson", NULL, "Poisson's ratio", 0.0}};
static const terp_law_variable state[] = {{"shear_path", NULL, "sum of the shear strain increments", 0.0}};

static const terp_law_description law = {TERP_LAW_VERSION, 2, parameters, 1, state, 1, update};

const terp_law_description* terp_law(void) { return &law; }
