#include "support/stages.hpp"
#include "support/simulations.hpp"

#include <memory>

namespace terp::test {

Case staged(const Case& base, const std::vector<std::pair<StageCase, Change>>& stages)
{
  Case whole = base, now = base;
  whole.time.end = 0.0;
  for (const auto& [stage, change] : stages) {
    whole.time.end += stage.longest();
    whole.stages.push_back(stage);
  }
  for (std::size_t k = 0; k < stages.size(); ++k) {
    now.time.end = whole.time.end;
    if (stages[k].second) stages[k].second(now);
    whole.stages[k].changed = std::make_shared<const Case>(now);
  }
  return whole;
}

StageCase stage(const std::string& name, Real duration)
{
  StageCase made;
  made.name = name, made.duration = duration;
  return made;
}

StageCase ramped(const std::string& name, Real duration, Real ramp)
{
  StageCase made = stage(name, duration);
  made.ramp = ramp;
  return made;
}

StageCase resting(const std::string& name, Real at_most)
{
  StageCase made;
  made.name = name, made.until = Until::at_rest, made.at_most = at_most;
  return made;
}

Case settling()
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 1.0}, elastic(2e6, 0.3, 2000.0));
  c.forces.gravity = {0.0, -10.0};
  c.forces.local_damping = 0.5;
  c.sides = {side("left", SideKind::roller), side("right", SideKind::roller), side("bottom", SideKind::roller)};
  c.time.end = 5.0;
  return c;
}

Real stress_at_base(const State& state)
{
  Real sum = 0.0, n = 0.0;
  for (const Point& p : points_by_id(state))
    if (p.x[1] < 0.25) sum += p.sigma[1], n += 1.0;
  return sum / n;
}

}  // namespace terp::test
