#include "signal/sar/sar_echoes.hpp"

#include <atomic>
#include <span>
#include <thread>

#include "core/report/expect.hpp"

namespace sarsim::signal {

EchoRows rows_of(const SarEchoes& echoes) {
  return {core::rows_in_memory(std::span(echoes.volts), echoes.track.size(), echoes.samples),
          echoes.waveform,
          echoes.track,
          echoes.first_delay_s,
          false,
          echoes.carriers_hz};
}

SarEchoes sar_echoes(const EchoRows& rows, const core::WorkControl& control, const core::ProgressReport& progress) {
  CORE_EXPECT(rows.rows == rows.track.size());
  constexpr std::size_t grain = 8;
  SarEchoes echoes{rows.waveform, rows.track, rows.columns, rows.first_delay_s, {}, rows.carriers_hz};
  echoes.volts.resize(rows.rows * rows.columns);
  const std::thread::id owner = std::this_thread::get_id();
  std::atomic<std::size_t> done{0};
  core::parallel_ranges(rows.rows, grain, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      rows.read(p, std::span(echoes.volts).subspan(p * rows.columns, rows.columns));
    const std::size_t sum = done.fetch_add(end - begin) + end - begin;
    if (progress && std::this_thread::get_id() == owner) progress({sum, rows.rows, rows.columns});
  });
  return echoes;
}

}  // namespace sarsim::signal
