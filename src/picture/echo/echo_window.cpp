#include "picture/echo/echo_window.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "simulate/plan/plan.hpp"

namespace sarsim::picture {

namespace {

double chosen_rate_hz(const EchoWindow& window, double bandwidth_hz) {
  return window.sampling.kind == Sampling::Kind::rate ? window.sampling.rate_hz
                                                      : core::tidy(window.sampling.multiple * bandwidth_hz);
}

// Rate at which a window holds `count` samples.
double rate_for(const scene::Simulation& simulation, double count, double light_speed_mps) {
  return radar::frequency_of_turns(count, simulation.range_end_m - simulation.range_start_m, light_speed_mps);
}

double span_of(double start, double end) { return end - start; }

// Moved so that it does not begin below 0.
void keep_above_zero(EchoView& view) {
  if (view.range_start_m >= 0.0) return;
  view.range_end_m -= view.range_start_m;
  view.range_start_m = 0.0;
}

double finite(double value) { return std::isfinite(value) ? value : 0.0; }

}  // namespace

EchoWindow new_echo_window(std::string radar, scene::Processing processing) {
  EchoWindow window;
  window.recording.radar = std::move(radar);
  window.recording.processing = processing;
  if (processing != scene::Processing::raw) window.sampling.kind = Sampling::Kind::multiple;
  return window;
}

EchoWindow window_of(const scene::Simulation& simulation) {
  EchoWindow window;
  window.recording = simulation;
  window.sampling = {Sampling::Kind::rate, simulation.sample_rate_hz, 1.0};
  return window;
}

scene::Simulation simulation_of(const EchoWindow& window, double bandwidth_hz) {
  scene::Simulation simulation = window.recording;
  simulation.sample_rate_hz =
      window.sampling.kind == Sampling::Kind::screen ? core::tidy(bandwidth_hz) : chosen_rate_hz(window, bandwidth_hz);
  return simulation;
}

scene::Simulation shown_simulation(const EchoWindow& window, double bandwidth_hz, std::size_t width_px,
                                   const simulate::Conventions& conventions) {
  scene::Simulation simulation = window.recording;
  const double c = conventions.light_speed_mps;
  const auto pixels = static_cast<double>(std::max<std::size_t>(width_px, 1));
  if (window.sampling.kind == Sampling::Kind::screen) {
    simulation.sample_rate_hz = rate_for(simulation, pixels, c);
    return simulation;
  }
  simulation.sample_rate_hz = chosen_rate_hz(window, bandwidth_hz);
  const double count = simulate::sample_count(simulation, c);
  if (simulation.processing != scene::Processing::raw || !(count >= 1.0) || count >= pixels) return simulation;
  // A whole multiple, so that the recording's own samples are among those that are shown.
  const double times = std::ceil(pixels / count);
  simulation.sample_rate_hz = conventions.spacing == simulate::Conventions::SampleSpacing::sampling_rate
                                  ? times * simulation.sample_rate_hz
                                  : rate_for(simulation, times * count, c);
  return simulation;
}

bool needs_computing(const EchoWindow& before, const EchoWindow& after) {
  return before.recording != after.recording || before.sampling != after.sampling ||
         before.pixel_rule != after.pixel_rule;
}

std::string sampling_warning(const EchoWindow& window, double sample_rate_hz, double bandwidth_hz) {
  constexpr double smooth = 3.0;
  constexpr double rounding = 1e-9;
  if (window.recording.processing != scene::Processing::matched_filter) return {};
  if (!(sample_rate_hz < smooth * bandwidth_hz * (1.0 - rounding))) return {};
  return fmt::format("{} is {:.3g} times the bandwidth; below 3 times compressed curves look jagged",
                     core::with_prefix(sample_rate_hz, "Hz", 4), sample_rate_hz / bandwidth_hz);
}

EchoView view_of(const EchoWindow& window) {
  const scene::Simulation& s = window.recording;
  return {s.range_start_m, s.range_end_m, s.time_start_s, s.time_end_s};
}

void set_view(EchoWindow& window, const EchoView& view) {
  window.recording.range_start_m = view.range_start_m;
  window.recording.range_end_m = view.range_end_m;
  window.recording.time_start_s = view.time_start_s;
  window.recording.time_end_s = view.time_end_s;
}

EchoView mended(EchoView view) {
  view = {finite(view.range_start_m), finite(view.range_end_m), finite(view.time_start_s), finite(view.time_end_s)};
  if (view.range_start_m > view.range_end_m) std::swap(view.range_start_m, view.range_end_m);
  if (view.time_start_s > view.time_end_s) std::swap(view.time_start_s, view.time_end_s);
  view.range_start_m = std::max(0.0, view.range_start_m);
  view.range_end_m = std::max(0.0, view.range_end_m);
  if (view.range_start_m == view.range_end_m) view.range_end_m += 1.0;
  if (view.time_start_s == view.time_end_s) view.time_end_s += 1.0;
  return view;
}

double range_at(const EchoView& view, const PlotSize& size, double x_px) {
  return view.range_start_m + x_px / static_cast<double>(size.width_px) * span_of(view.range_start_m, view.range_end_m);
}

double x_of_range(const EchoView& view, const PlotSize& size, double range_m) {
  const double span = span_of(view.range_start_m, view.range_end_m);
  return span > 0.0 ? (range_m - view.range_start_m) / span * static_cast<double>(size.width_px) : 0.0;
}

double time_at(const EchoView& view, const PlotSize& size, double y_px) {
  if (size.height_px < 2) return view.time_start_s;
  const auto last = static_cast<double>(size.height_px - 1);
  return view.time_start_s + (last - y_px) / last * span_of(view.time_start_s, view.time_end_s);
}

double y_of_time(const EchoView& view, const PlotSize& size, double time_s) {
  const double span = span_of(view.time_start_s, view.time_end_s);
  const auto last = static_cast<double>(std::max<std::size_t>(size.height_px, 1) - 1);
  return span > 0.0 ? last - (time_s - view.time_start_s) / span * last : last;
}

std::optional<EchoView> zoomed_to(const EchoView& view, const PlotSize& size, double x0_px, double y0_px, double x1_px,
                                  double y1_px) {
  const auto within = [](double from, double to, std::size_t length) {
    const auto end = static_cast<double>(length);
    return std::pair(std::clamp(std::min(from, to), 0.0, end), std::clamp(std::max(from, to), 0.0, end));
  };
  const auto [left, right] = within(x0_px, x1_px, size.width_px);
  const auto [top, bottom] = within(y0_px, y1_px, std::max<std::size_t>(size.height_px, 1) - 1);
  if (right - left < 1.0 || bottom - top < 1.0) return std::nullopt;
  return EchoView{range_at(view, size, left), range_at(view, size, right), time_at(view, size, bottom),
                  time_at(view, size, top)};
}

EchoView scaled_about(const EchoView& view, const PlotSize& size, double x_px, double y_px, double range_factor,
                      double time_factor) {
  const double range = range_at(view, size, x_px);
  const double time = time_at(view, size, y_px);
  EchoView scaled{range + range_factor * (view.range_start_m - range),
                  range + range_factor * (view.range_end_m - range), time + time_factor * (view.time_start_s - time),
                  time + time_factor * (view.time_end_s - time)};
  keep_above_zero(scaled);
  return scaled;
}

EchoView zoomed_out(const EchoView& view, const PlotSize& size, double x_px, double y_px) {
  const double range = range_at(view, size, x_px);
  const double time = time_at(view, size, y_px);
  const double range_span = span_of(view.range_start_m, view.range_end_m);
  const double time_span = span_of(view.time_start_s, view.time_end_s);
  EchoView wider{range - range_span, range + range_span, time - time_span, time + time_span};
  keep_above_zero(wider);
  return wider;
}

EchoView panned(const EchoView& view, const PlotSize& size, double dx_px, double dy_px) {
  const double range = range_at(view, size, 0.0) - range_at(view, size, dx_px);
  const double time = time_at(view, size, 0.0) - time_at(view, size, dy_px);
  EchoView moved{view.range_start_m + range, view.range_end_m + range, view.time_start_s + time,
                 view.time_end_s + time};
  keep_above_zero(moved);
  return moved;
}

EchoView showing_targets(const EchoView& view, double nearest_m, double farthest_m, double pulse_width_s,
                         double light_speed_mps) {
  constexpr double nothing_there_m = 10e3;
  EchoView all = view;
  if (!(nearest_m <= farthest_m) || !std::isfinite(nearest_m) || !std::isfinite(farthest_m)) {
    all.range_start_m = 0.0;
    all.range_end_m = nothing_there_m;
    return all;
  }
  const double margin_m = 2.0 * radar::range_of(pulse_width_s, light_speed_mps);  // two pulses
  all.range_start_m = std::max(0.0, nearest_m - margin_m);
  all.range_end_m = farthest_m + margin_m;
  return mended(all);
}

EchoView linked(const EchoView& own, const EchoView& leader, const AxisLink& link) {
  EchoView view = own;
  if (link.range) {
    view.range_start_m = leader.range_start_m;
    view.range_end_m = leader.range_end_m;
  }
  if (link.time) {
    view.time_start_s = leader.time_start_s;
    view.time_end_s = leader.time_end_s;
  }
  return view;
}

}  // namespace sarsim::picture
