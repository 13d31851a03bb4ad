// The first call counts all that the store holds, later ones only the newest realisation. The mean time of a
// realisation comes only from those that were shown here as newest, fine and coarse ones apart. The time that is left
// is that of one thread, divided by how many are solved at once. An adaptive method shows none, as its end is not
// known.

#include "cli/study_progress.hpp"

#include "batch/study_text.hpp"

#include <fmt/format.h>

#include <utility>

namespace terp {

StudyProgress::StudyProgress(const Study& study, const StudyPart& part, int n_at_a_time, bool quiet)
    : study_(study),
      part_(part),
      n_at_a_time_(n_at_a_time),
      quiet_(quiet),
      shows_p_(info_of(study.settings.estimator).counts_alike && !study.settings.fragility),
      sample_(study.settings)
{
  for (Index n = 0; n < study.n_realisations; ++n)
    if (part.has(study.share_of(n))) ++n_all_, ++levels_[study.is_coarse(n) ? 1 : 0].left;
}

void StudyProgress::count(const Realisation& r)
{
  if (!part_.has(study_.share_of(r.number))) return;
  ++done_, --levels_[study_.is_coarse(r.number) ? 1 : 0].left;
  sample_.take(r, study_.is_coarse(r.number));
}

/// Of one thread; a level of which nothing is made yet takes as long as the other.
double StudyProgress::seconds_left() const
{
  double seconds = 0.0;
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    const Level& from = levels_[k].made > 0 ? levels_[k] : levels_[1 - k];
    seconds += from.spent / static_cast<double>(from.made) * static_cast<double>(levels_[k].left);
  }
  return seconds;
}

void StudyProgress::show(const Realisation& newest, const Realisations& all)
{
  if (!std::exchange(begun_, true))
    for (const auto& [number, r] : all) count(r);
  else
    count(newest);
  Level& level = levels_[study_.is_coarse(newest.number) ? 1 : 0];
  level.spent += newest.wall_s, ++level.made;
  const double now = std::chrono::duration<double>(Clock::now() - start_).count();
  if (quiet_ || now < next_) return;
  next_ = now + (line_.renews() ? 0.2 : 10.0);
  const std::int64_t n_failed = (sample_.counts() + sample_.coarse()).failed;
  const bool adaptive = info_of(study_.settings.estimator).adaptive;  // its end is not known before
  std::string line = adaptive ? fmt::format("[{}] {} failed", done_, n_failed)
                              : fmt::format("[{}/{}] {} failed", done_, n_all_, n_failed);
  if (shows_p_) {
    line += "  so far P(I) " + estimate_text(sample_.slide());
    if (newest.judges_flood) line += "  P(F) " + estimate_text(sample_.flood());
  }
  if (!adaptive)
    line += fmt::format("  ETA {}{}", study_.settings.stop.cov > 0.0 ? "at most " : "",
        readable_duration(seconds_left() / n_at_a_time_));
  line_.show(line);
}

}  // namespace terp
