#include "workflow/focus/edge_remark.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "signal/compress/sampling_loss.hpp"

namespace sarsim::workflow {

namespace {

constexpr double max_loss_db = 0.2;
constexpr double max_shift_cells = 0.1;

std::string rate_text(const radar::Pulse& pulse, double rate_hz) {
  const std::string rate = core::with_prefix(rate_hz, "Hz", 4);
  if (pulse.kind == radar::Pulse::Kind::code)
    return fmt::format("{:.3g} samples a chip at {}", rate_hz * pulse.width_s / static_cast<double>(pulse.code.size()),
                       rate);
  if (pulse.kind == radar::Pulse::Kind::chirp)
    return fmt::format("a time-bandwidth product of {:.3g} at {}", std::abs(pulse.sweep_hz) * pulse.width_s, rate);
  return fmt::format("{:.3g} samples a pulse at {}", rate_hz * pulse.width_s, rate);
}

}  // namespace

core::Problems diagnose_edges(const simulate::Acquisition& acquisition) {
  if (acquisition.reception.pulse.band_limited) return {};
  const radar::Pulse& pulse = acquisition.link.pulse;
  const double rate_hz = 1.0 / acquisition.reception.raw_grid.interval_s;
  const signal::SamplingLoss loss = signal::sampling_loss(pulse, rate_hz);
  const bool loses = loss.max_db > max_loss_db;
  const bool shifts = loss.max_shift_s * radar::bandwidth_hz(pulse) > max_shift_cells;
  if (!loses && !shifts) return {};
  std::string found = rate_text(pulse, rate_hz);
  if (loses) found += fmt::format(", a loss of {:.2g} dB on average and up to {:.2g} dB", loss.mean_db, loss.max_db);
  if (shifts) {
    const double shift_m = radar::range_of(loss.max_shift_s, acquisition.light_speed_mps());
    found += fmt::format(", range errors up to {}", core::with_prefix(shift_m, "m", 3));
  }
  return {core::warning("focus.pulse-edges", "the pulse has hard edges, and the sampling rate is too low for them")
              .found(std::move(found))
              .expected(fmt::format("a loss up to {:g} dB and range errors up to {:g} of a range cell", max_loss_db,
                                    max_shift_cells))
              .hint("confine the pulse to the sampled band with pulse = \"band-limited\" in [options] (or --pulse "
                    "band-limited), or sample faster")};
}

}  // namespace sarsim::workflow
