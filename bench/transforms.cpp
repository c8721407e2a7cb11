// The Fourier transforms and the transposes that focusing needs, and nothing else, by one thread: what `bench/run
// focus` compares it with. Prints seconds of processor time, least of TRIES.
//
//     transforms PULSES RANGE_SIZE AZIMUTH_SIZE COLUMNS RANGE_PASSES [TRIES]
//
// Range transforms of PULSES rows, azimuth transforms of RANGE_SIZE columns, RANGE_PASSES range transforms of
// AZIMUTH_SIZE rows, azimuth transforms of COLUMNS columns; the matrix is transposed twice, by blocks. Plans are
// estimated, as those of sarsim are.

#include <fftw3.h>

#include <algorithm>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

namespace {

using Values = std::vector<std::complex<float>>;

class Transform {
 public:
  Transform(std::size_t size, Values& values)
      : plan_(fftwf_plan_dft_1d(static_cast<int>(size), at(values.data()), at(values.data()), FFTW_FORWARD,
                                FFTW_ESTIMATE)) {}
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;
  ~Transform() { fftwf_destroy_plan(plan_); }

  void rows(std::complex<float>* first, std::size_t count, std::size_t stride) const {
    for (std::size_t r = 0; r < count; ++r) fftwf_execute_dft(plan_, at(first + r * stride), at(first + r * stride));
  }

 private:
  static fftwf_complex* at(std::complex<float>* values) { return reinterpret_cast<fftwf_complex*>(values); }
  fftwf_plan plan_;
};

void transpose(const Values& from, std::size_t rows, std::size_t columns, Values& to) {
  constexpr std::size_t block = 16;
  for (std::size_t r0 = 0; r0 < rows; r0 += block)
    for (std::size_t c0 = 0; c0 < columns; c0 += block)
      for (std::size_t r = r0; r < std::min(r0 + block, rows); ++r)
        for (std::size_t c = c0; c < std::min(c0 + block, columns); ++c) to[c * rows + r] = from[r * columns + c];
}

double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

int main(int count, char** words) {
  if (count < 6) return 2;
  const auto number = [&](int i) { return static_cast<std::size_t>(std::stoul(words[i])); };
  const std::size_t pulses = number(1), range = number(2), azimuth = number(3), columns = number(4);
  const std::size_t passes = number(5), tries = count > 6 ? number(6) : 5;
  Values rows(azimuth * range), turned(azimuth * range);
  const Transform along_range(range, rows);
  const Transform along_azimuth(azimuth, rows);
  double min_s = 1e9;
  for (std::size_t t = 0; t < tries; ++t) {
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = {static_cast<float>(i % 7), 1.0F};
    const double begin_s = processor_s();
    along_range.rows(rows.data(), pulses, range);
    transpose(rows, azimuth, range, turned);
    along_azimuth.rows(turned.data(), range, azimuth);
    transpose(turned, range, azimuth, rows);
    for (std::size_t pass = 0; pass < passes; ++pass) along_range.rows(rows.data(), azimuth, range);
    along_azimuth.rows(rows.data(), std::min(columns, range), azimuth);
    min_s = std::min(min_s, processor_s() - begin_s);
  }
  std::printf("%.4f\n", min_s);
  return 0;
}
