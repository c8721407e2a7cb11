#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <new>
#include <span>

namespace sarsim::signal {

/// Memory for samples that nothing has been written to; it begins at a multiple of 64 bytes.
class RawSamples {
 public:
  using Value = std::complex<float>;

  RawSamples() = default;
  explicit RawSamples(std::size_t count)
      : count_(count), memory_(static_cast<Value*>(::operator new (count * sizeof(Value), std::align_val_t{64}))) {}

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] Value* data() const { return memory_.get(); }
  [[nodiscard]] std::span<Value> span() const { return {data(), count_}; }

 private:
  struct Free {
    void operator()(Value* memory) const { ::operator delete (memory, std::align_val_t{64}); }
  };
  std::size_t count_ = 0;
  std::unique_ptr<Value, Free> memory_;
};

}  // namespace sarsim::signal
