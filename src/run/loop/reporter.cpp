// A time is due at the step nearest to it: the multiple nearest to the step is sought, then the step nearest to that,
// so each multiple has one step. At a step the ledger comes first, as a fault of the balance stops the run before a
// frame is written. The checkpoint comes last: it counts the rows and frames that were reported.

#include "run/loop/reporter.hpp"

#include "math/errors.hpp"
#include "run/report/frame.hpp"
#include "run/loop/guards.hpp"
#include "run/report/history.hpp"
#include "run/report/ledger.hpp"
#include "run/loop/stages.hpp"
#include "run/report/state_image.hpp"

#include <cmath>

namespace terp {

bool due(std::int64_t step, Real dt, Real every, Real from)
{
  if (every <= 0.0) return false;
  const Real multiple = std::round((from + static_cast<Real>(step) * dt) / every);
  return std::llround((multiple * every - from) / dt) == step;
}

std::string Reporter::report_due(bool last)
{
  const OutputCase& output = model_.description.output;
  const auto is_due = [&](Real every) {
    return due(state_.step - model_.first_step, model_.dt, every, model_.first_time);
  };
  const auto now = [&](Real every) { return last || state_.step == 0 || is_due(every); };
  if (now(output.ledger_every))
    if (std::string fault = report_ledger(); !fault.empty()) return fault;
  if (now(output.history_every)) report_rows(make_history(model_, state_, history_places_));
  if (now(output.fields_every)) report_frame();
  if (last || (state_.step > 0 && is_due(output.checkpoint_every))) report_checkpoint();
  return {};
}

void Reporter::report_rows(const std::vector<TableRow>& rows)
{
  if (rows.empty()) return;
  state_.rows_reported[std::string(rows[0].table->name)] += std::ssize(rows);
  tell([&](Observer& o) { o.rows(rows); });
}

std::string Reporter::report_ledger()
{
  const TableRow row = keep_ledger(model_, state_, work_);
  report_rows({row});
  if (!std::isfinite(row["kinetic"] + row["elastic"])) return describe_not_finite(model_, state_, work_, row["v_999"]);
  if (std::string fault = find_fault_in_balance(model_, state_, row); !fault.empty()) return fault;
  for (const ActiveFollower& active : state_.followers) report_rows(active.follower->rows(model_, state_));
  return {};
}

void Reporter::report_rows_between()
{
  for (const ActiveFollower& active : state_.followers)
    if (active.type->table != nullptr && active.type->table->between_ledger_rows)
      report_rows(active.follower->rows(model_, state_));
}

void Reporter::report_frame()
{
  for (const ActiveFollower& active : state_.followers) active.follower->frame(model_, state_);
  ++state_.frames_reported;
  if (observers_.empty()) return;
  const std::int64_t n = state_.n_ids(), step = n > most_points_at_once ? points_per_part : n;
  for (std::int64_t first = 0; first < n; first += step)
    tell([part = std::make_shared<const Frame>(make_frame(model_, state_, first, std::min(step, n - first)))](
             Observer& o) { o.frame(part); });
}

void Reporter::report_checkpoint()
{
  if (observers_.empty()) return;
  report_rows_between();
  const bool ended = !model_.stage.name.empty() && std::ssize(state_.stages_done) > state_.stage;
  for_each_part(state_, most_values_of_part(state_), [&](StateImage part) {
    if (ended) part.stage = stage_file(model_.stage.number, model_.stage.name);
    tell([image = std::make_shared<const StateImage>(std::move(part))](Observer& o) { o.checkpoint(image); });
  });
}

void Reporter::report(const Progress& progress) const
{
  tell([&](Observer& o) { o.progress(progress); });
}

std::string Reporter::keep_evidence(std::string message)
{
  report_rows_between();
  for (Observer* observer : observers_) {
    const std::string saved = observer->save_failed(make_image(state_));
    if (!saved.empty()) message += "\n  saved    " + saved;
  }
  return message;
}

void Reporter::stop_run(std::string message) { throw RunError(keep_evidence(std::move(message))); }

}  // namespace terp
