#include "core/maths/fft.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>
#include <optional>
#include <stdexcept>
#include <vector>

namespace sarsim::core {

namespace {

// FFTW's planner keeps tables of its own and must not run twice at once.
std::mutex& planner_lock() {
  static std::mutex lock;
  return lock;
}

// FFTW ends the process where it gets no memory (`alloc.c`: "assertion failed"). So what the planner may need is asked
// for before, and given back: tables of half a transform to two of them, and some hundred kB of its own.
void expect_memory(std::size_t size, std::size_t sample_bytes) {
  constexpr std::size_t transforms = 4, own_bytes = std::size_t{1} << 20U;
  void* volatile room = std::malloc(transforms * size * sample_bytes + own_bytes);  // not to be left out as useless
  if (room == nullptr) throw std::bad_alloc();
  std::free(room);
}

// The two precisions of FFTW under common names.
template <class Real>
struct Fftw;

template <>
struct Fftw<double> {
  using Plan = fftw_plan;
  static fftw_complex* data(std::complex<double>* x) { return reinterpret_cast<fftw_complex*>(x); }
  static Plan make(int size, std::complex<double>* from, std::complex<double>* to, int sign) {
    return fftw_plan_dft_1d(size, data(from), data(to), sign, FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  }
  static void run(Plan plan, std::complex<double>* from, std::complex<double>* to) {
    fftw_execute_dft(plan, data(from), data(to));
  }
  static bool aligned(std::complex<double>* x) { return fftw_alignment_of(reinterpret_cast<double*>(x)) == 0; }
  static void destroy(Plan plan) { fftw_destroy_plan(plan); }
};

template <>
struct Fftw<float> {
  using Plan = fftwf_plan;
  static fftwf_complex* data(std::complex<float>* x) { return reinterpret_cast<fftwf_complex*>(x); }
  static Plan make(int size, std::complex<float>* from, std::complex<float>* to, int sign) {
    return fftwf_plan_dft_1d(size, data(from), data(to), sign, FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  }
  static void run(Plan plan, std::complex<float>* from, std::complex<float>* to) {
    fftwf_execute_dft(plan, data(from), data(to));
  }
  static bool aligned(std::complex<float>* x) { return fftwf_alignment_of(reinterpret_cast<float*>(x)) == 0; }
  static void destroy(Plan plan) { fftwf_destroy_plan(plan); }
};

template <class Real>
void expect_aligned(std::span<std::complex<Real>> data) {
  if (!Fftw<Real>::aligned(data.data()))
    throw std::invalid_argument("the data of a Fourier transform must begin at a multiple of 16 bytes");
}

// A transform in one direction, in place or to another array.
template <class Real>
class Plan {
 public:
  enum class To { same, other };

  Plan(std::size_t size, int sign, To to) {
    std::vector<std::complex<Real>> from(size);
    std::vector<std::complex<Real>> other(to == To::other ? size : 0);
    const std::scoped_lock hold(planner_lock());
    expect_memory(size, sizeof(std::complex<Real>));
    plan_ = Library::make(static_cast<int>(size), from.data(), to == To::other ? other.data() : from.data(), sign);
    if (plan_ == nullptr) throw std::bad_alloc();
  }
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;
  ~Plan() {
    const std::scoped_lock hold(planner_lock());
    Library::destroy(plan_);
  }

  void run(std::span<std::complex<Real>> from, std::span<std::complex<Real>> to) const {
    expect_aligned(from);
    expect_aligned(to);
    Library::run(plan_, from.data(), to.data());
  }

 private:
  using Library = Fftw<Real>;
  typename Library::Plan plan_ = nullptr;
};

}  // namespace

template <class Real>
struct BasicFft<Real>::Plans {
  using Direction = Plan<Real>;
  Direction forward;
  Direction inverse;
  std::once_flag planned;
  std::optional<Direction> forward_to_other;

  explicit Plans(std::size_t size)
      : forward(size, FFTW_FORWARD, Direction::To::same), inverse(size, FFTW_BACKWARD, Direction::To::same) {}
};

template <class Real>
BasicFft<Real>::BasicFft(std::size_t size) : size_(size), plans_(std::make_unique<Plans>(size)) {}
template <class Real>
BasicFft<Real>::~BasicFft() = default;
template <class Real>
BasicFft<Real>::BasicFft(BasicFft&&) noexcept = default;
template <class Real>
BasicFft<Real>& BasicFft<Real>::operator=(BasicFft&&) noexcept = default;

template <class Real>
void BasicFft<Real>::forward(std::span<std::complex<Real>> data) const {
  plans_->forward.run(data, data);
}
template <class Real>
void BasicFft<Real>::inverse(std::span<std::complex<Real>> data) const {
  plans_->inverse.run(data, data);
}
template <class Real>
void BasicFft<Real>::forward(std::span<std::complex<Real>> data, std::span<std::complex<Real>> out) const {
  std::call_once(plans_->planned,
                 [&] { plans_->forward_to_other.emplace(size_, FFTW_FORWARD, Plan<Real>::To::other); });
  plans_->forward_to_other->run(data, out);
}

template class BasicFft<float>;
template class BasicFft<double>;

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

std::size_t fast_fft_size(std::size_t minimum) {
  std::size_t best = 16;
  while (best < minimum) best *= 2;
  for (std::size_t fives = 16; fives < best; fives *= 5)
    for (const std::size_t odd : {fives, 3 * fives}) {
      std::size_t size = odd;
      while (size < minimum) size *= 2;
      best = std::min(best, size);
    }
  return best;
}

}  // namespace sarsim::core
