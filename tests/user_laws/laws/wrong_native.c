/* Descriptions of laws that Terp refuses, and laws that fail, one function each. */
#include "user_laws/terp_law.h"

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

static int complains(terp_law_points* at)
{
  at->point = at->n - 1;
  at->message = "the void ratio is negative";
  return TERP_LAW_FAILED;
}

static const terp_law_description good = {TERP_LAW_VERSION, 2, modulus, 2, state, 0, stiff};
static const terp_law_description failing = {TERP_LAW_VERSION, 2, modulus, 2, state, 1, complains};
static const terp_law_description old = {TERP_LAW_VERSION + 1, 0, NULL, 0, NULL, 0, stiff};
static const terp_law_description empty = {TERP_LAW_VERSION, 2, NULL, 0, NULL, 0, stiff};
static const terp_law_description named = {TERP_LAW_VERSION, 0, NULL, 1, bad_name, 0, stiff};

const terp_law_description* terp_law(void) { return &good; }
const terp_law_description* failing_law(void) { return &failing; }
const terp_law_description* old_law(void) { return &old; }
const terp_law_description* empty_law(void) { return &empty; }
const terp_law_description* named_law(void) { return &named; }
const terp_law_description* no_law(void) { return NULL; }
const terp_law_description* crashing_law(void) { return *(const terp_law_description* volatile*)(size_t)8; }
