/* A soil law of your own for Terp, in C or in any language that can offer a C function: docs/user_laws.md.
 *
 * The library has one function without arguments, `terp_law` unless the case file names another `symbol`. It returns
 * the description of the law. Build:   cc -O2 -fPIC -shared -I FOLDER_OF_THIS_HEADER law.c -o law.so
 *
 * Stress and strain: tension positive, components xx yy zz xy, tensorial shear (half the engineering shear). SI units,
 * but stresses are in the `stress_unit` of the case, Pa unless it gives another.
 * The zz component of the strain increment is small but not zero with B-bar.
 */
#ifndef TERP_LAW_H
#define TERP_LAW_H

#ifdef __cplusplus
extern "C" {
#endif

#define TERP_LAW_VERSION 1

/* A parameter, or a state variable. All texts must stay where they are. */
typedef struct {
  const char* name;    /* letters, digits and _; not empty */
  const char* unit;    /* "Pa"; NULL: it has none */
  const char* meaning; /* one line; may be NULL */
  double initial;      /* of a state variable: its value at t = 0, unless the case file gives another */
} terp_law_variable;

/* The points of one call. Arrays of n numbers unless said otherwise; p counts the points. */
typedef struct {
  int n;
  double time; /* at the start of the step [s] */
  double dt;   /* length of the step [s] */
  const double* parameters;
  double* stress[4];                 /* in: at the start of the step; out: at its end [Pa] */
  const double* strain_increment[4]; /* of the step [-] */
  double* const* state;              /* state[k][p]; in: at the start, out: at the end */
  const double* spin;                /* of the step, positive counter-clockwise [-] */
  int turned;                        /* not 0: stress has been turned by spin; state has not */
  const double* x;                   /* places [m] */
  const double* y;
  const double* cell_size; /* square root of the area of the cell that the point lies in [m] */
  int point;               /* out, on failure: which point */
  const char* message;     /* out, on failure: why; shown to the user; may stay NULL */
} terp_law_points;

/* What `update` returns. */
enum {
  TERP_LAW_OK = 0,
  TERP_LAW_SMALLER_STEP = 1, /* the increment of points->point is too large: Terp calls again with parts of it */
  TERP_LAW_FAILED = 2        /* the run stops, with points->message */
};

typedef struct {
  int version; /* TERP_LAW_VERSION */
  int n_parameters;
  const terp_law_variable* parameters;
  int n_state;
  const terp_law_variable* state;
  int thread_safe; /* not 0: several threads may call `update` at the same time */
  int (*update)(terp_law_points* points);
} terp_law_description;

#ifdef __cplusplus
}
#endif

#endif
