#include "math/fft.hpp"

#include <mutex>
#include <new>
#include <vector>

#include <fftw3.h>

namespace sarsim {

namespace {

// FFTW's planner keeps tables of its own and must not run twice at once.
std::mutex& planner_lock() {
  static std::mutex lock;
  return lock;
}

fftw_complex* as_fftw(std::complex<double>* data) { return reinterpret_cast<fftw_complex*>(data); }

}  // namespace

struct Fft::Plans {
  fftw_plan forward = nullptr;
  fftw_plan inverse = nullptr;

  explicit Plans(std::size_t size) {
    std::vector<std::complex<double>> scratch(size);
    const std::scoped_lock hold(planner_lock());
    const int length = static_cast<int>(size);
    forward = fftw_plan_dft_1d(length, as_fftw(scratch.data()), as_fftw(scratch.data()), FFTW_FORWARD,
                               FFTW_ESTIMATE | FFTW_UNALIGNED);
    inverse = fftw_plan_dft_1d(length, as_fftw(scratch.data()), as_fftw(scratch.data()), FFTW_BACKWARD,
                               FFTW_ESTIMATE | FFTW_UNALIGNED);
    if (forward == nullptr || inverse == nullptr) throw std::bad_alloc();
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;
  ~Plans() {
    const std::scoped_lock hold(planner_lock());
    fftw_destroy_plan(forward);
    fftw_destroy_plan(inverse);
  }
};

Fft::Fft(std::size_t size) : size_(size), plans_(std::make_unique<Plans>(size)) {}
Fft::~Fft() = default;
Fft::Fft(Fft&&) noexcept = default;
Fft& Fft::operator=(Fft&&) noexcept = default;

void Fft::forward(std::span<std::complex<double>> data) const {
  fftw_execute_dft(plans_->forward, as_fftw(data.data()), as_fftw(data.data()));
}
void Fft::inverse(std::span<std::complex<double>> data) const {
  fftw_execute_dft(plans_->inverse, as_fftw(data.data()), as_fftw(data.data()));
}

std::size_t good_fft_size(std::size_t minimum) {
  std::size_t best = 1;
  while (best < minimum) best *= 2;
  for (std::size_t fives = 1; fives < best; fives *= 5)
    for (std::size_t threes = fives; threes < best; threes *= 3) {
      std::size_t size = threes;
      while (size < minimum) size *= 2;
      if (size < best) best = size;
    }
  return best;
}

}  // namespace sarsim
