// The slots of the features (features.def) in the model, the state and the scratch of a step: of each NAMEModel,
// NAMEState and NAMEScratch, which its own files alone know. A feature that lacks one of them leaves that slot empty.
// Not for: what is called of a feature (feature.hpp).
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace terp {

/// Owns a T that may be unknown here. Empty: the feature has none in this run. A copy has a T of its own.
template <class T>
class Slot {
 public:
  Slot() = default;
  Slot(Slot&&) noexcept = default;
  Slot(const Slot& other) : value_(other.value_ ? other.copy_(*other.value_) : nullptr), copy_(other.copy_) {}
  Slot& operator=(Slot other) noexcept
  {
    std::swap(value_, other.value_), std::swap(copy_, other.copy_);
    return *this;
  }

  /// Takes a value. T must be known, and be one that can be copied if the slot is.
  T& set(T value)
  {
    if constexpr (std::is_copy_constructible_v<T>) copy_ = [](const T& of) { return std::make_shared<T>(of); };
    value_ = std::make_shared<T>(std::move(value));
    return *value_;
  }
  /// The value, a default one where there was none.
  T& made() { return value_ ? *value_ : set({}); }
  void clear() { value_.reset(); }

  explicit operator bool() const { return value_ != nullptr; }
  T* get() { return value_.get(); }
  const T* get() const { return value_.get(); }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_.get(); }
  const T* operator->() const { return value_.get(); }

 private:
  std::shared_ptr<T> value_;  // which knows how to delete what is unknown here
  std::shared_ptr<T> (*copy_)(const T&) = nullptr;
};

#define TERP_FEATURE(slot, Name) \
  struct Name##Model;            \
  struct Name##State;            \
  struct Name##Scratch;
#include "mpm/features/features.def"
#undef TERP_FEATURE

/// What a step reads; copies of a model share it.
struct ModelSlots {
#define TERP_FEATURE(slot, Name) std::shared_ptr<const Name##Model> slot = {};
#include "mpm/features/features.def"
#undef TERP_FEATURE
};

/// What changes and must survive a run.
struct StateSlots {
#define TERP_FEATURE(slot, Name) Slot<Name##State> slot = {};
#include "mpm/features/features.def"
#undef TERP_FEATURE
};

/// What every step writes anew.
struct ScratchSlots {
#define TERP_FEATURE(slot, Name) Slot<Name##Scratch> slot = {};
#include "mpm/features/features.def"
#undef TERP_FEATURE
};

}  // namespace terp
