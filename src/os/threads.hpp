// Threads and the one parallel loop. Work is cut into chunks that do not depend on the number of threads; whoever
// does a chunk, it gives the same bits. Each thread starts in its own part of the chunks, so that it meets the
// same memory in every step, and helps out elsewhere when it is done; a thread that another process keeps from
// running delays the others by one chunk at most. Who waits soon sleeps, and so leaves its processor to a thread that
// has been displaced from another.
// Not for: sums over chunks (the caller adds partial results in the order of chunks).
#pragma once

#include "math/types.hpp"

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace terp {

/// Processors that this process may use: the smaller of its affinity mask and its control group's share, at least 1.
int available_processors();

class Threads {
 public:
  /// n threads in all, the calling one included; fewer where the system grants fewer: see count().
  explicit Threads(int n);
  ~Threads();
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  int count() const { return static_cast<int>(workers_.size()) + 1; }

  /// Calls f(chunk, thread) once for each chunk in 0 ... n_chunks-1 and returns when all are done; thread: 0 ...
  /// count()-1, who does it. f must not throw.
  template <class F>
  void for_each_chunk(Index n_chunks, F&& f)
  {
    using Function = std::remove_reference_t<F>;
    run(
        n_chunks, [](void* context, Index chunk, int thread) { (*static_cast<Function*>(context))(chunk, thread); },
        const_cast<void*>(static_cast<const void*>(&f)));
  }

  /// Calls f(begin, end, chunk, thread) over 0 ... n-1 in chunks of fixed size.
  template <class F>
  void for_each_range(Index n, Index chunk_size, F&& f)
  {
    for_each_chunk(n_chunks(n, chunk_size), [&](Index chunk, int thread) {
      const Index begin = chunk * chunk_size;
      f(begin, begin + chunk_size < n ? begin + chunk_size : n, chunk, thread);
    });
  }

  static constexpr Index n_chunks(Index n, Index chunk_size) { return (n + chunk_size - 1) / chunk_size; }

 private:
  using Task = void (*)(void*, Index, int);
  struct alignas(64) Share {
    std::atomic<std::uint64_t> next{0};  // job number << 32 | next chunk of this thread's part
  };

  void run(Index n_chunks, Task task, void* context);
  void work(int thread, std::uint32_t job);
  void wait_for_jobs(int thread);
  void wait_until_done(Index n_chunks);

  std::vector<std::thread> workers_;
  std::unique_ptr<Share[]> shares_;
  std::atomic<Task> task_{nullptr};
  std::atomic<void*> context_{nullptr};
  std::atomic<Index> n_chunks_{0};
  alignas(64) std::atomic<std::uint32_t> job_{0};  // number of the newest job; the top bit tells workers to leave
  alignas(64) std::atomic<Index> done_{0};         // chunks finished of the newest job
  std::atomic<int> sleepers_{0};
  std::atomic<bool> caller_sleeps_{false};
};

}  // namespace terp
