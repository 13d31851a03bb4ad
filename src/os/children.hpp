// This program once more, with the same command line, as processes that each do one thing of several: what befalls one
// (a fault of ours, the end of memory) ends it and no other. They share memory with the one that started them.
// Not for: other programs (process.hpp), nor for threads (os/threads.hpp).
#pragma once

#include <cstddef>
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

  /// Starts the process that does thing `number`. what: names it in the FileError if there is no process.
  void begin(std::size_t number, const std::string& what);

  /// One that has ended since the last call. Does not wait.
  std::optional<ChildEnd> next_end();

  /// As Ctrl-C does, all of them.
  void ask_to_stop();

 private:
  struct Processes;
  std::unique_ptr<Processes> state_;
};

/// What a process that `Children` started is to do.
struct OwnTask {
  std::size_t number = 0;
  void* shared = nullptr;
};

/// Nothing in a process that a user started. Throws FileError.
std::optional<OwnTask> own_task();

}  // namespace terp
