#pragma once

#include <pelt/model.hpp>
#include <pelt/surface.hpp>

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace pelt::python {

/// A model, and its surface once it is needed. Copies share both.
class PythonModel {
 public:
  explicit PythonModel(SkinnedModel model)
      : model_(std::move(model)), lazy_(std::make_shared<Lazy>()) {}

  const SkinnedModel& model() const { return model_; }

  /// The surface of the model. The first call makes it, in O(T log T). Safe to call from any thread
  /// that does not hold the interpreter lock.
  const Surface& surface() const {
    const std::lock_guard lock(lazy_->mutex);
    if (!lazy_->surface) lazy_->surface.emplace(model_);
    return *lazy_->surface;
  }

 private:
  struct Lazy {
    std::mutex mutex;
    std::optional<Surface> surface;
  };

  SkinnedModel model_;
  std::shared_ptr<Lazy> lazy_;
};

}  // namespace pelt::python
