// This program once more, as processes that each do one thing of several: what befalls one (a fault of ours, the end of
// memory) ends it and no other. They share memory with the one that started them.
// Not for: calls that are waited for (own_copy.hpp), other programs (process.hpp), threads (threads.hpp).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace terp {

struct ChildEnd {
  std::size_t number = 0;
  int status = 0;
  std::string killed_by = {};  ///< "signal 9 (Killed)"; empty: it ended by itself
};

/// The processes ask themselves to stop (stop.hpp) when the one that started them ends, however that ends.
class Children {
 public:
  /// n_bytes: of the memory that all of them share, zeros at first. Throws FileError.
  explicit Children(std::size_t n_bytes);
  ~Children();
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;

  void* shared();

  /// Starts the process that does thing `number`: the task, whose value is its exit status. No thread may run here.
  /// Windows has no copies of processes: there the program is begun anew with the same command line, and own_task()
  /// says what it is for. what: names the thing in the FileError if there is no process.
  void begin(std::size_t number, const std::string& what, const std::function<int()>& task);

  /// One that has ended since the last call. Does not wait.
  std::optional<ChildEnd> next_end();

  /// As Ctrl-C does, all of them.
  void ask_to_stop();

 private:
  struct Processes;
  std::unique_ptr<Processes> state_;
};

/// What a process that `Children` began anew is to do.
struct OwnTask {
  std::size_t number = 0;
  void* shared = nullptr;
};

/// Nothing in a process that a user started, and in a copy. Throws FileError.
std::optional<OwnTask> own_task();

}  // namespace terp
