// A task is taken out of the queue before it runs, so an empty queue does not mean that all is done: `busy_` says so. A
// failed task drops the queue; its error waits for the next caller and is thrown once. The destructor lets the thread
// finish what waits, and loses an error that nobody asked for.

#include "os/background.hpp"

#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace terp {

Background::Background(std::size_t most_waiting) : most_waiting_(most_waiting)
{
  try {
    thread_ = std::thread([this] { work(); });
  } catch (const std::system_error& error) {
    throw std::runtime_error(std::string("cannot start the thread that writes results: ") + error.code().message() +
                             "\n  The system grants this user no more threads and processes (ulimit -u), or has no "
                             "memory for one.\n  End other programs of this user, or raise the limit.");
  }
}

Background::~Background()
{
  {
    const std::lock_guard lock(mutex_);
    leave_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Background::add(std::function<void()> task)
{
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return error_ || tasks_.size() < most_waiting_; });
  throw_error();
  tasks_.push_back(std::move(task));
  changed_.notify_all();
}

void Background::finish()
{
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return error_ || (tasks_.empty() && !busy_); });
  throw_error();
}

void Background::throw_error()
{
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void Background::work()
{
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return leave_ || !tasks_.empty(); });
    if (tasks_.empty()) return;  // told to leave, and all is done
    std::function<void()> task = std::move(tasks_.front());
    tasks_.pop_front();
    busy_ = true;
    lock.unlock();
    std::exception_ptr error;
    try {
      task();
      task = nullptr;  // frees what it holds
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    busy_ = false;
    if (error) {
      error_ = error;
      tasks_.clear();
    }
    changed_.notify_all();
  }
}

}  // namespace terp
