#include "core/maths/fft.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <new>
#include <random>
#include <vector>

#include "core/maths/constants.hpp"

namespace sarsim::core {
namespace fft_test {

using Signal = std::vector<std::complex<double>>;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

Signal random_signal(std::size_t size) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  Signal signal(size);
  for (auto& s : signal) s = {part(random), part(random)};
  return signal;
}

// A stage of the transform costs a few roundings; log2 N stages of numbers up to N in all.
double rounding(std::size_t size) {
  return 4.0 * epsilon * static_cast<double>(size) * (1.0 + std::log2(static_cast<double>(size)));
}

TEST(Fft, InverseOfForwardIsTheSizeTimesTheSignal) {
  for (const std::size_t size : {1u, 2u, 7u, 60u, 1024u, 3001u}) {
    const Signal signal = random_signal(size);
    Signal data = signal;
    const Fft fft(size);
    ASSERT_EQ(fft.size(), size);
    fft.forward(data);
    fft.inverse(data);
    for (std::size_t i = 0; i < size; ++i)
      EXPECT_LT(std::abs(data[i] - static_cast<double>(size) * signal[i]), rounding(size)) << size;
  }
}

TEST(Fft, OfADeltaTurnsClockwise) {
  constexpr std::size_t size = 30;
  Signal data(size);
  data[3] = 1.0;
  Fft(size).forward(data);
  for (std::size_t k = 0; k < size; ++k)
    EXPECT_LT(std::abs(data[k] - std::polar(1.0, -2.0 * pi * 3.0 * static_cast<double>(k) / size)), rounding(size));
}

TEST(Fft, PutsAPositiveFrequencyIntoItsBin) {
  constexpr std::size_t size = 48;
  Signal data(size);
  for (std::size_t n = 0; n < size; ++n) data[n] = std::polar(1.0, 2.0 * pi * 5.0 * static_cast<double>(n) / size);
  Fft(size).forward(data);
  for (std::size_t k = 0; k < size; ++k) EXPECT_LT(std::abs(data[k] - (k == 5 ? 48.0 : 0.0)), rounding(size));
}

TEST(Fft, KeepsTheEnergy) {
  constexpr std::size_t size = 500;
  Signal data = random_signal(size);
  double before = 0.0, after = 0.0;
  for (const auto& s : data) before += std::norm(s);
  Fft(size).forward(data);
  for (const auto& s : data) after += std::norm(s);
  EXPECT_NEAR(after, static_cast<double>(size) * before, rounding(size) * before);
}

TEST(Fft, GivesTheSameBytesForUnalignedData) {
  constexpr std::size_t size = 128;
  Signal one = random_signal(size);
  Signal shifted(size + 1);
  std::copy(one.begin(), one.end(), shifted.begin() + 1);
  Fft fft(size);
  fft.forward(one);
  const Fft moved = std::move(fft);
  moved.forward(std::span(shifted).subspan(1));
  for (std::size_t i = 0; i < size; ++i) EXPECT_EQ(one[i], shifted[i + 1]);
}

// The same signal in float: a stage costs a few roundings of the sum so far.
TEST(SingleFft, IsTheDoubleTransformToItsPrecision) {
  for (const std::size_t size : {1u, 2u, 45u, 1024u, 3001u}) {
    Signal exact = random_signal(size);
    std::vector<std::complex<float>> data(exact.begin(), exact.end());
    std::copy(data.begin(), data.end(), exact.begin());
    const BasicFft<float> fft(size);
    ASSERT_EQ(fft.size(), size);
    fft.forward(data);
    Fft(size).forward(exact);
    const double bound = 2.0 * static_cast<double>(std::numeric_limits<float>::epsilon()) *
                         std::sqrt(static_cast<double>(size)) * (1.0 + std::log2(static_cast<double>(size)));
    for (std::size_t i = 0; i < size; ++i) EXPECT_LT(std::abs(std::complex<double>(data[i]) - exact[i]), bound) << size;
    fft.inverse(data);
    Fft(size).inverse(exact);
    for (std::size_t i = 0; i < size; ++i)
      EXPECT_LT(std::abs(std::complex<double>(data[i]) - exact[i]), bound * std::sqrt(static_cast<double>(size)) * 2.0);
  }
}

// Every 16 bytes will do: the bytes do not depend on where an allocator puts the data.
TEST(SingleFft, GivesTheSameBytesWhereverTheDataBegin) {
  const Signal signal = random_signal(128);
  std::vector<std::complex<float>> one(signal.begin(), signal.end());
  BasicFft<float> fft(128);
  fft.forward(one);
  const BasicFft<float> moved = std::move(fft);
  for (const std::size_t shift : {2u, 4u, 6u, 8u}) {
    std::vector<std::complex<float>> shifted(128 + shift);
    std::copy(signal.begin(), signal.end(), shifted.begin() + static_cast<std::ptrdiff_t>(shift));
    moved.forward(std::span(shifted).subspan(shift));
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i], shifted[i + shift]);
  }
}

TEST(SingleFft, ToAnotherArrayIsThatInPlaceAndLeavesTheData) {
  for (const std::size_t size : {1u, 2u, 45u, 1024u, 3001u}) {
    const Signal signal = random_signal(size);
    const std::vector<std::complex<float>> given(signal.begin(), signal.end());
    std::vector<std::complex<float>> data = given;
    std::vector<std::complex<float>> out(size);
    BasicFft<float> fft(size);
    fft.forward(data, out);
    EXPECT_EQ(data, given);
    const BasicFft<float> moved = std::move(fft);
    std::vector<std::complex<float>> again(size);
    moved.forward(data, again);
    EXPECT_EQ(again, out);
    moved.forward(data);
    const float bound = 2.0F * std::numeric_limits<float>::epsilon() * std::sqrt(static_cast<float>(size)) *
                        (1.0F + std::log2(static_cast<float>(size)));
    for (std::size_t i = 0; i < size; ++i) EXPECT_LT(std::abs(data[i] - out[i]), bound) << size;
  }
}

TEST(SingleFft, RefusesDataBetweenTwoMultiplesOf16Bytes) {
  std::vector<std::complex<float>> data(17);
  const BasicFft<float> fft(16);
  EXPECT_THROW(fft.forward(std::span(data).subspan(1)), std::invalid_argument);
  EXPECT_THROW(fft.inverse(std::span(data).subspan(1)), std::invalid_argument);
  std::vector<std::complex<float>> other(17);
  EXPECT_THROW(fft.forward(std::span(data).first(16), std::span(other).subspan(1)), std::invalid_argument);
  EXPECT_THROW(fft.forward(std::span(data).subspan(1), std::span(other).first(16)), std::invalid_argument);
}

TEST(GoodFftSize, IsTheSmallestProductOfTwosThreesAndFivesFromTheMinimumOn) {
  const auto good = [](std::size_t n) {
    for (const std::size_t p : {2u, 3u, 5u})
      while (n % p == 0) n /= p;
    return n == 1;
  };
  for (std::size_t minimum = 1; minimum <= 3000; ++minimum) {
    std::size_t expected = minimum;
    while (!good(expected)) ++expected;
    ASSERT_EQ(good_fft_size(minimum), expected);
  }
}

TEST(Fft, FastSizesAreMultiplesOf16WithAtMostOneFactor3) {
  const auto fast = [](std::size_t size) {
    if (size % 16 != 0) return false;
    while (size % 2 == 0) size /= 2;
    while (size % 5 == 0) size /= 5;
    return size == 1 || size == 3;
  };
  for (std::size_t minimum = 0; minimum < 7000; minimum += 7) {
    std::size_t expected = std::max<std::size_t>(minimum, 1);
    while (!fast(expected)) ++expected;
    ASSERT_EQ(fast_fft_size(minimum), expected);
  }
}

// 0: made, 3: std::bad_alloc; what a process of that memory ends with.
int end_of_process_with(rlim_t more_bytes, std::size_t size) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::ifstream statm("/proc/self/statm");
    rlim_t pages = 0;
    statm >> pages;
    const rlim_t most = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + more_bytes;
    const rlimit limit{most, RLIM_INFINITY};
    ::setrlimit(RLIMIT_AS, &limit);
    int end = 0;
    try {
      const Fft fft(size);
    } catch (const std::bad_alloc&) {
      end = 3;
    }
    ::_exit(end);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// The library ends a process that gets no memory. 46 189 and 65 521 have large prime factors.
TEST(Fft, WithoutMemoryIsAnExceptionAndNoEnd) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need the addresses themselves";
#endif
  int refused = 0;  // Small ones may find memory that was given back.
  for (const std::size_t size : {4096u, 46189u, 65521u, 65536u, 1000000u}) {
    for (rlim_t more = 0; more < 4 * size * sizeof(std::complex<double>) + (rlim_t{4} << 20U);
         more += rlim_t{1} << 18U) {
      const int end = end_of_process_with(more, size);
      ASSERT_TRUE(end == 0 || end == 3) << size << " with " << more;
      refused += end == 3 ? 1 : 0;
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace fft_test
}  // namespace sarsim::core
