// A page has no second thread: a task is done at once.
#include "os/background.hpp"

#include <utility>

namespace terp {

Background::Background(std::size_t most_waiting) : most_waiting_(most_waiting) {}

Background::~Background() = default;

void Background::add(std::function<void()> task)
{
  throw_error();
  try {
    task();
  } catch (...) {
    error_ = std::current_exception();
  }
}

void Background::finish() { throw_error(); }

void Background::throw_error()
{
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

}  // namespace terp
