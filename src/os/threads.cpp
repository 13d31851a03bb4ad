// The order in which a job is handed out: close all shares under its number, write its fields, open the shares, publish
// the number, wake who sleeps. A worker reads the fields first and then the number, and each claim compares the number
// in the same atomic word as the chunk. Who goes to sleep says so before it looks again, and who wakes looks after its
// own store. That needs the sequentially consistent order of the atomics: weaker ones lose a wake-up.

#include "os/threads.hpp"

#include "os/sleep.hpp"

#include <system_error>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace terp {
namespace {

constexpr std::uint32_t leave = 0x80000000u;
constexpr std::uint32_t used_up = 0xffffffffu;
constexpr int spins_before_sleep = 2000;  // about 20-60 us: longer than the gap between two passes of a step

void pause_briefly()
{
#if defined(__x86_64__)
  _mm_pause();
#endif
}

/// First chunk of a thread's part.
Index first_of_part(Index n_chunks, int thread, int n_threads)
{
  return static_cast<Index>(static_cast<std::int64_t>(n_chunks) * thread / n_threads);
}

}  // namespace

Threads::Threads(int n) : shares_(std::make_unique<Share[]>(n))
{
  workers_.reserve(n - 1);
  try {
    for (int thread = 1; thread < n; ++thread) workers_.emplace_back([this, thread] { wait_for_jobs(thread); });
  } catch (const std::system_error&) {  // the system grants no more (ulimit -u): those that run share the work
  }
}

Threads::~Threads()
{
  job_.fetch_or(leave);
  wake_all(job_);
  for (auto& worker : workers_) worker.join();
}

void Threads::run(Index n_chunks, Task task, void* context)
{
  if (n_chunks == 0) return;
  if (workers_.empty()) {
    for (Index chunk = 0; chunk < n_chunks; ++chunk) task(context, chunk, 0);
    return;
  }
  // A late worker may still be on its way through the previous job. It claims a chunk only if the share carries its own
  // job's number, so the shares are closed under the new number before the fields change, and opened after.
  const std::uint32_t job = (job_.load(std::memory_order_relaxed) + 1) & ~leave;
  const auto numbered = [job](std::uint32_t chunk) { return std::uint64_t{job} << 32 | chunk; };
  for (int t = 0; t < count(); ++t) shares_[t].next.store(numbered(used_up));
  task_.store(task);
  context_.store(context);
  n_chunks_.store(n_chunks);
  done_.store(0);
  for (int t = 0; t < count(); ++t)
    shares_[t].next.store(numbered(static_cast<std::uint32_t>(first_of_part(n_chunks, t, count()))));
  job_.store(job);
  if (sleepers_.load() > 0) wake_all(job_);
  work(0, job);
  wait_until_done(n_chunks);
}

void Threads::wait_until_done(Index n_chunks)
{
  for (int spin = 0; spin < spins_before_sleep; ++spin) {
    if (done_.load() == n_chunks) return;
    pause_briefly();
  }
  caller_sleeps_.store(true);  // before done_ is read again: who finishes the last chunk sees this, or we see its chunk
  for (Index done = done_.load(); done != n_chunks; done = done_.load()) sleep_while(done_, done);
  caller_sleeps_.store(false);
}

/// Does chunks of the job, from this thread's part first and then from the others', until none is left.
void Threads::work(int thread, std::uint32_t job)
{
  const Task task = task_.load();
  void* const context = context_.load();
  const Index n = n_chunks_.load();
  if (job_.load() != job) return;  // the fields may belong to a newer job
  for (int k = 0; k < count(); ++k) {
    const int part = (thread + k) % count();
    const auto end = static_cast<std::uint32_t>(first_of_part(n, part + 1, count()));
    std::uint64_t next = shares_[part].next.load();
    while (next >> 32 == job && static_cast<std::uint32_t>(next) < end) {
      if (!shares_[part].next.compare_exchange_weak(next, next + 1)) continue;
      task(context, static_cast<Index>(static_cast<std::uint32_t>(next)), thread);
      if (done_.fetch_add(1) + 1 == n && caller_sleeps_.load()) wake_one(done_);
      next = shares_[part].next.load();
    }
  }
}

void Threads::wait_for_jobs(int thread)
{
  std::uint32_t seen = 0;
  while (true) {
    std::uint32_t job = job_.load();
    for (int spin = 0; job == seen && spin < spins_before_sleep; ++spin) {
      pause_briefly();
      job = job_.load();
    }
    if (job == seen) {
      sleepers_.fetch_add(1);
      sleep_while(job_, seen);
      sleepers_.fetch_sub(1);
      job = job_.load();
    }
    if (job & leave) return;
    work(thread, job);
    seen = job;
  }
}

}  // namespace terp
