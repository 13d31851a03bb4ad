/* Descriptions of laws that Terp refuses, and laws that fail, one function each. */
#include "soil/libraries/terp_law.h"

#include <math.h>
#include <stddef.h>

static const terp_law_variable state[] = {{"strain_sum", NULL, NULL, 0.25}, {"calls", NULL, NULL, 0.0}};
static const terp_law_variable modulus[] = {{"modulus", "Pa", NULL, 0.0}, {"limit", NULL, NULL, 0.0}};
static const terp_law_variable bad_name[] = {{"two words", NULL, NULL, 0.0}};

/* sigma += modulus d_eps, in increments below the limit. */
static int stiff(terp_law_points* at)
{
  for (int p = 0; p < at->n; ++p) {
    for (int k = 0; k < 4; ++k) {
      if (fabs(at->strain_increment[k][p]) > at->parameters[1]) {
        at->point = p;
        return TERP_LAW_SMALLER_STEP;
      }
      at->stress[k][p] += at->parameters[0] * at->strain_increment[k][p];
    }
    at->state[0][p] += at->strain_increment[0][p];
    at->state[1][p] += 1.0;
  }
  return TERP_LAW_OK;
}

/* Linear up to a shear stress that stands behind its parameters. */
static int reads_beyond(terp_law_points* at)
{
  stiff(at);
  for (int p = 0; p < at->n; ++p)
    if (at->stress[3][p] > at->parameters[2]) at->stress[3][p] = at->parameters[2];
  return TERP_LAW_OK;
}

static int reads_beyond_state(terp_law_points* at)
{
  stiff(at);
  for (int p = 0; p < at->n; ++p)
    if (at->stress[3][p] > at->state[2][p]) at->stress[3][p] = at->state[2][p];
  return TERP_LAW_OK;
}

static int writes_beyond_state(terp_law_points* at)
{
  for (int p = 0; p < at->n; ++p) at->state[2][p] += 1.0;
  return TERP_LAW_OK;
}

static int complains(terp_law_points* at)
{
  at->point = at->n - 1;
  at->message = "the void ratio is negative";
  return TERP_LAW_FAILED;
}

static int crashes(terp_law_points* at)
{
  at->stress[0][0] = *(const double* volatile*)(size_t)8 == NULL;
  return TERP_LAW_OK;
}

static int sees_spin(terp_law_points* at)
{
  for (int p = 0; p < at->n; ++p) at->state[0][p] = at->spin[p], at->state[1][p] = at->turned;
  return TERP_LAW_OK;
}

static const terp_law_variable no_number[] = {{"void_ratio", NULL, NULL, NAN}};
static const terp_law_variable in_pascal[] = {{"held", "Pa", NULL, 0.0}};

static const terp_law_description crashing = {TERP_LAW_VERSION, 2, modulus, 2, state, 0, crashes};
static const terp_law_description spinning = {TERP_LAW_VERSION, 2, modulus, 2, state, 0, sees_spin};
static const terp_law_description torn = {TERP_LAW_VERSION, 0, NULL, 2, (const terp_law_variable*)8, 0, stiff};
static const terp_law_description huge = {TERP_LAW_VERSION, 0, NULL, 1000000, state, 0, stiff};
static const terp_law_description nan_state = {TERP_LAW_VERSION, 0, NULL, 1, no_number, 0, stiff};
static const terp_law_description held = {TERP_LAW_VERSION, 0, NULL, 1, in_pascal, 0, stiff};
static const terp_law_description reading = {TERP_LAW_VERSION, 2, modulus, 2, state, 0, reads_beyond};
static const terp_law_description reading_state = {TERP_LAW_VERSION, 2, modulus, 2, state, 0, reads_beyond_state};
static const terp_law_description writing_state = {TERP_LAW_VERSION, 2, modulus, 2, state, 0, writes_beyond_state};
static const terp_law_description good = {TERP_LAW_VERSION, 2, modulus, 2, state, 0, stiff};
static const terp_law_description failing = {TERP_LAW_VERSION, 2, modulus, 2, state, 1, complains};
static const terp_law_description old = {TERP_LAW_VERSION + 1, 0, NULL, 0, NULL, 0, stiff};
static const terp_law_description empty = {TERP_LAW_VERSION, 2, NULL, 0, NULL, 0, stiff};
static const terp_law_description named = {TERP_LAW_VERSION, 0, NULL, 1, bad_name, 0, stiff};

const terp_law_description* terp_law(void) { return &good; }
const terp_law_description* reading_law(void) { return &reading; }
const terp_law_description* reading_state_law(void) { return &reading_state; }
const terp_law_description* writing_state_law(void) { return &writing_state; }
const terp_law_description* failing_law(void) { return &failing; }
const terp_law_description* old_law(void) { return &old; }
const terp_law_description* empty_law(void) { return &empty; }
const terp_law_description* named_law(void) { return &named; }
const terp_law_description* crashing_update_law(void) { return &crashing; }
const terp_law_description* spinning_law(void) { return &spinning; }
const terp_law_description* torn_law(void) { return &torn; }
const terp_law_description* huge_law(void) { return &huge; }
const terp_law_description* nan_law(void) { return &nan_state; }
const terp_law_description* held_law(void) { return &held; }
const terp_law_description* no_law(void) { return NULL; }
const terp_law_description* crashing_law(void) { return *(const terp_law_description* volatile*)(size_t)8; }
