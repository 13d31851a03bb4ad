#include "run/loop/follower.hpp"
#include "support/law_cases.hpp"

namespace history_audit_test {

const std::string audit = "followers/history_audit/";
std::int64_t n_fell(const Simulation& s) { return flags_set(s.state, audit + "fell"); }
std::int64_t n_rose(const Simulation& s) { return flags_set(s.state, audit + "rose"); }

/// Four points of 0.25 m^2.
Simulation four_points() { return followed(clamped_cell("mpm_gp")); }

TEST(HistoryAudit, RisingPlasticStrainIsNoViolation)
{
  Simulation s = four_points();
  for (const Real eps : {0.01, 0.02, 0.02}) {
    set_value(s.state, 1, Rows::state, eps);
    keep_ledger(s.model, s.state, s.work);
  }
  EXPECT_EQ(n_fell(s), 0);
  EXPECT_EQ(n_rose(s), 0);
  EXPECT_EQ(array_of(s.state, audit + "last_eps_eq_p")[1], 0.02);
}

TEST(HistoryAudit, APointWhosePlasticStrainFellIsMarkedForGood)
{
  Simulation s = four_points();
  for (const Real eps : {0.01, 0.009, 0.03}) {
    set_value(s.state, 1, Rows::state, eps);
    keep_ledger(s.model, s.state, s.work);
  }
  const Summary summary = summarise(s.model, s.state);
  EXPECT_EQ(summary.points_eps_eq_p_fell, 1);
  EXPECT_EQ(summary.points_su_rose, 1);  // its strength rose with it
  EXPECT_EQ(summary.max_eps_eq_p, 0.03);
}

TEST(HistoryAudit, RoundOffIsNoViolation)
{
  Simulation s = four_points();
  for (const Real eps : {0.01, 0.01 * (1.0 - 1e-13)}) {
    set_value(s.state, 1, Rows::state, eps);
    keep_ledger(s.model, s.state, s.work);
  }
  EXPECT_EQ(n_fell(s), 0);
}

TEST(HistoryAudit, AColumnViolatesItsHistoryInMixedAndNotInGp)
{
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) {
    Simulation s = followed(column(scheme));
    while (s.state.time < 1.0) {
      make_steps(s, 3);
      keep_ledger(s.model, s.state, s.work);
    }
    const bool mixed = scheme == std::string("mpm_mixed");
    EXPECT_EQ(n_fell(s) > 10, mixed) << scheme;
    EXPECT_EQ(n_rose(s) > 10, mixed) << scheme;
    if (!mixed) {
      EXPECT_EQ(n_fell(s), 0);
      EXPECT_EQ(n_rose(s), 0);
    }
  }
}

TEST(HistoryAudit, KnowsNoPlasticStrainOfALibraryThatDoesNotSayWhichItIs)
{
  LibraryCase library = wrong_umat(elastic_law).library;
  const auto largest = [&](const MaterialCase& soil) {
    const Simulation s = followed(moving_box("mpm_gp", soil));
    return summarise(s.model, s.state).max_eps_eq_p;
  };
  EXPECT_EQ(largest(of_library(library)), std::nullopt);
  EXPECT_EQ(largest(of_library(library, {.plastic_strain = "state_1"})), std::optional<Real>(0.0));
  EXPECT_EQ(largest(elastic(shear, poisson, 1900.0)), std::optional<Real>(0.0)) << "elastic soil has none";
}

}  // namespace history_audit_test
