#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>

/// Arithmetic of rows of float samples in SIMD, with run-time choice of the instruction set.
namespace sarsim::signal {

/// row[k] = row[k] exp(2 pi j turns[k]), for |turns| up to 1000: within 2e-7 of their float.
void turn_row(std::span<std::complex<float>> row, std::span<const float> turns);

/// row[k] = row[k] factors[k].
void multiply_row(std::span<std::complex<float>> row, std::span<const std::complex<float>> factors);

/// row[k] = row[k] scale factors[k].
void scale_row(std::span<std::complex<float>> row, std::span<const float> factors, float scale);

/// What a column of Doppler frequencies is weighted with.
struct DopplerWeights {
  std::span<const float> sine;    ///< Of the direction of each row.
  std::span<const float> weight;  ///< Of each row.
  float low = -1.0F;              ///< Sine below which nothing is seen.
  float high = 1.0F;              ///< Sine above which nothing is.
  float low_edge = 0.0F;          ///< Of the sines above `low`, over which weights rise from 0 to 1 as sin^2.
  float high_edge = 0.0F;         ///< Of those below `high`.
  float scale = 1.0F;
};

/// column[k] = scale share weight[k] column[k] exp(2 pi j turns[k]), with the share 0 beyond `low` and `high`, and
/// exactly 1 where the distance to both exceeds their edges.
void weigh_column(std::span<std::complex<float>> column, std::span<const float> turns, const DopplerWeights& weights);

/// c0 + c1 x + c2 x^2 + c3 x^3.
struct Cubic {
  float c0, c1, c2, c3;
};

/// Samples that one cubic stands for.
inline constexpr std::size_t cubic_samples = 32;

/// out[k] = cubics[k/32] of x = k mod 32.
void evaluate_cubics(std::span<const Cubic> cubics, std::span<float> out);

/// Where samples are taken from: a whole number and a step of so many to the next one.
struct SamplePlaces {
  std::span<std::int32_t> whole;
  std::span<std::int32_t> step;
};

/// Splits cubics + bases[k/32], of x = k mod 32, into whole numbers and the nearest of `steps` between them.
void place_cubics(std::span<const Cubic> cubics, std::span<const std::int32_t> bases, int steps,
                  const SamplePlaces& places);

/// out[k] = factors[k] sum over i < 16 of weights[32 step[k] + 2 i] samples[whole[k] + i], both of two equal weights
/// being read; 0, and nothing is read, where whole[k] is not in [first, last).
struct Interpolation {
  const std::complex<float>* samples = nullptr;
  const float* weights = nullptr;
  std::int32_t first = 0;
  std::int32_t last = 0;
};
void interpolate_row(const Interpolation& from, std::span<const std::int32_t> whole, std::span<const std::int32_t> step,
                     std::span<const float> factors, std::span<std::complex<float>> out);

/// to[c to_stride + r] = from[r from_stride + c] for r < rows, c < columns.
void transpose(const std::complex<float>* from, std::size_t from_stride, std::size_t rows, std::size_t columns,
               std::complex<float>* to, std::size_t to_stride);

}  // namespace sarsim::signal
