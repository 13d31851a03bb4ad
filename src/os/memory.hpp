// Memory that is taken only where it is written, and given back.
// Not for: what grows and keeps its values (std::vector).
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace terp {

namespace detail {
struct FreePages {
  std::size_t n_bytes = 0;
  void operator()(void* p) const;
};
/// Pages of zeros from the system. Throws std::bad_alloc.
std::unique_ptr<void, FreePages> zero_pages(std::size_t n_bytes);
}  // namespace detail

/// From now on large arrays go back to the system when they are freed, and threads share what is left: for a program
/// whose building of a model takes more than its run, where the allocator would keep it all. To be called first.
void return_large_arrays_when_freed();

/// Zeros whose pages take memory from the first write on: what is never written costs nothing, and who writes first
/// decides where it lies. T: a number, or a struct of numbers for which all bits zero is the default.
template <class T>
class ZeroedArray {
 public:
  ZeroedArray() = default;
  explicit ZeroedArray(std::size_t size) { make_anew(size); }

  /// Drops what there is; then all is zero.
  void make_anew(std::size_t size)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    pages_.reset();
    if (size > 0) pages_ = detail::zero_pages(size * sizeof(T));
    size_ = size;
  }

  std::size_t size() const { return size_; }
  T* data() { return static_cast<T*>(pages_.get()); }
  const T* data() const { return static_cast<const T*>(pages_.get()); }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& operator[](std::size_t k) { return data()[k]; }
  const T& operator[](std::size_t k) const { return data()[k]; }

 private:
  std::unique_ptr<void, detail::FreePages> pages_;
  std::size_t size_ = 0;
};

}  // namespace terp
