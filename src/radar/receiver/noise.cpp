#include "radar/receiver/noise.hpp"

#include <algorithm>

#include "core/report/expect.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radar/receiver/noise.cpp"
#include <hwy/foreach_target.h>  // includes this file once per instruction set

#include "radar/simd/normals-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sarsim::radar::HWY_NAMESPACE {

// Adds the noise of as many samples as there are lanes. Numbers of samples count lane by lane.
template <class D, class VU>
HWY_INLINE void add_lanes(D d, double* samples, double stddev_v, VU key, VU pulse, VU numbers) {
  auto in_phase = hn::Zero(d);
  auto quadrature = hn::Zero(d);
  normal_pair(d, key, pulse, numbers, in_phase, quadrature);
  auto i = hn::Zero(d);
  auto q = hn::Zero(d);
  hn::LoadInterleaved2(d, samples, i, q);
  const auto stddev = hn::Set(d, stddev_v);
  hn::StoreInterleaved2(hn::Add(i, hn::Mul(stddev, in_phase)), hn::Add(q, hn::Mul(stddev, quadrature)), d, samples);
}

void noise_on_target(std::span<std::complex<double>> row, double stddev_v, std::uint64_t key, std::int64_t pulse,
                     std::int64_t first_sample) {
  const hn::ScalableTag<double> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const std::size_t lanes = hn::Lanes(d);
  const auto keys = hn::Set(du, key);
  const auto pulses = hn::Set(du, static_cast<std::uint64_t>(pulse));
  const auto step = hn::Set(du, static_cast<std::uint64_t>(lanes));
  auto numbers = hn::Iota(du, static_cast<std::uint64_t>(first_sample));
  auto* const samples = reinterpret_cast<double*>(row.data());
  std::size_t at = 0;
  for (; at + lanes <= row.size(); at += lanes, numbers = hn::Add(numbers, step))
    add_lanes(d, samples + 2 * at, stddev_v, keys, pulses, numbers);
  if (at == row.size()) return;
  HWY_ALIGN double rest[2 * hn::MaxLanes(d)] = {};
  std::copy(samples + 2 * at, samples + 2 * row.size(), rest);
  add_lanes(d, rest, stddev_v, keys, pulses, numbers);
  std::copy(rest, rest + 2 * (row.size() - at), samples + 2 * at);
}

}  // namespace sarsim::radar::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace sarsim::radar {

HWY_EXPORT(noise_on_target);

void add_noise(std::span<std::complex<double>> row, double stddev_v, const core::RandomStream& stream,
               std::int64_t pulse, std::int64_t first_sample) {
  CORE_EXPECT(stddev_v >= 0.0);
  if (stddev_v == 0.0) return;
  HWY_DYNAMIC_DISPATCH(noise_on_target)(row, stddev_v, stream.key(), pulse, first_sample);
}

}  // namespace sarsim::radar

#endif
