#include "signal/sar/sar_echoes.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

#include "core/report/expect.hpp"

namespace sarsim::signal {

EchoRows rows_of(const SarEchoes& echoes) {
  const auto read = [&echoes](std::size_t pulse, std::span<std::complex<float>> out) {
    std::copy_n(echoes.volts.data() + pulse * echoes.samples, out.size(), out.data());
  };
  return {echoes.waveform, echoes.track, echoes.samples, echoes.first_delay_s, read, false};
}

SarEchoes sar_echoes(const EchoRows& rows, const core::WorkControl& control, const core::ProgressReport& progress) {
  CORE_EXPECT(rows.read);
  constexpr std::size_t grain = 8;
  SarEchoes echoes{rows.waveform, rows.track, rows.samples, rows.first_delay_s, {}};
  echoes.volts.resize(rows.track.size() * rows.samples);
  const std::thread::id owner = std::this_thread::get_id();
  std::atomic<std::size_t> done{0};
  core::parallel_ranges(rows.track.size(), grain, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      rows.read(p, std::span(echoes.volts).subspan(p * rows.samples, rows.samples));
    const std::size_t sum = done.fetch_add(end - begin) + end - begin;
    if (progress && std::this_thread::get_id() == owner) progress({sum, rows.track.size(), rows.samples});
  });
  return echoes;
}

}  // namespace sarsim::signal
