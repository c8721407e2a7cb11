#include "workflow/focus/method_choice.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/reference_track.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/motion_residual.hpp"
#include "workflow/focus/sar_rows.hpp"
#include "workflow/focus/scene_grid.hpp"
#include "workflow/focus/swath_remark.hpp"

namespace sarsim::workflow {

namespace {

// Samples of the image times pulses beyond which back-projection is proposed, not chosen: some ten minutes of a core.
constexpr double max_projections = 2e11;

// Why back-projection is not affordable where the user has not asked for it; empty where it is.
std::string too_much(const FocusPipeline& work) {
  const signal::FocusedImage image = signal::image_of(work.input.echoes, work.options);
  const double samples = static_cast<double>(image.azimuth.count) * static_cast<double>(image.range.count);
  const auto pulses = static_cast<double>(work.input.echoes.track.size());
  const double bytes = 8.0 * (samples + pulses * static_cast<double>(work.input.echoes.columns));
  const auto memory = static_cast<double>(work.options.memory_bytes);
  if (!(samples * pulses <= max_projections))
    return fmt::format("that takes {:.2g} samples times pulses, more than {:.1g}", samples * pulses, max_projections);
  if (!(memory == 0.0 || bytes <= memory))
    return fmt::format("that needs {:.2g} GB of memory, {:.2g} are allowed", 1e-9 * bytes, 1e-9 * memory);
  return {};
}

// Part of what an image may have that may be left where back-projection leaves less: the rest of it is for what is not
// computed here, as interpolation and the ends of spectra.
constexpr double max_excess = 0.5;

class Chooser {
 public:
  Chooser(FocusRequest& request, FocusPipeline& work, const core::WorkControl& control)
      : request_(request),
        work_(work),
        control_(control),
        line_(signal::fitted_track(work.input.echoes.track)),
        scene_m_(scene_middle_m(*work.input.acquisition)) {
    if (request.ground_m) scene_m_.z = *request.ground_m;
  }

  void in_time() {
    const auto left = residual(TakenFlight::Kind::flown);
    core::append(work_.input.problems, diagnose_residual(left, TakenFlight::Kind::flown));
  }

  void in_frequency(bool free) {
    auto kind = work_.motion == MotionOrder::none ? TakenFlight::Kind::even : TakenFlight::Kind::compensated;
    auto left = residual(kind);
    if (kind == TakenFlight::Kind::even && !request_.motion && excess_of(left) > max_excess) {
      expect_one_way(work_.input.echoes);
      work_.motion = MotionOrder::second;
      kind = TakenFlight::Kind::compensated;
      left = residual(kind);
    }
    const bool open = free && !request_.motion && !request_.autofocus;
    const std::optional<MethodLoss> lost = open ? lost_of_omega_k() : std::nullopt;
    if (open && (kind == TakenFlight::Kind::compensated || excess_of(lost) > max_excess))
      compare({kind, left, lost});
    else
      core::append(work_.input.problems, diagnose_residual(left, kind));
  }

 private:
  void note(std::string text) { core::append(work_.input.problems, {core::note("focus.method", std::move(text))}); }

  // What omega-k does to an image.
  struct OmegaK {
    TakenFlight::Kind kind;              // compensated, or even
    std::optional<MotionResidual> left;  // by the flight
    std::optional<MethodLoss> lost;      // whatever the flight

    [[nodiscard]] double excess() const { return std::max(excess_of(left), excess_of(lost)); }
    // "motion compensation would leave 0.240 rad and 0.10 dB at target 3, and omega-k would lose ..."
    [[nodiscard]] std::string would() const {
      std::string words;
      if (kind == TakenFlight::Kind::compensated)
        words = fmt::format("motion compensation would leave {}", text_of(left));
      else if (left)
        words = fmt::format("the straight line would leave {}", text_of(left));
      if (!(excess_of(lost) > max_excess)) return words;
      return fmt::format("{}{}omega-k would lose {}", words, words.empty() ? "" : ", and ", text_of(*lost));
    }
  };

  [[nodiscard]] std::optional<MethodLoss> lost_of_omega_k() const {
    return worst_method_loss(*work_.input.acquisition, work_.input.echoes, work_.options, control_);
  }

  // Compares what omega-k leaves with what back-projection does.
  void compare(const OmegaK& by_line) {
    const auto flown = residual(TakenFlight::Kind::flown);
    const std::string on_grid = text_of(flown);
    const bool better = by_line.excess() > max_excess && excess_of(flown) < by_line.excess();
    const std::string unaffordable = work_.input.echoes.columns < 2 ? "a row has one sample only" : too_much(work_);
    if (better && unaffordable.empty()) {
      request_.algorithm = FocusAlgorithm::back_projection;
      work_.motion = MotionOrder::none;
      note(fmt::format("back-projection instead of omega-k: {}; back-projection on its grid leaves {}", by_line.would(),
                       on_grid));
      core::append(work_.input.problems, diagnose_residual(flown, TakenFlight::Kind::flown));
      return;
    }
    const std::string but = better ? ", but " + unaffordable : std::string();
    if (by_line.kind == TakenFlight::Kind::compensated)
      note(
          fmt::format("omega-k with motion compensation, which leaves {}; back-projection on its grid would leave {}{}",
                      text_of(by_line.left), on_grid, but));
    else if (better)
      note(fmt::format("omega-k; back-projection on its grid would leave {}{}", on_grid, but));
    core::append(work_.input.problems, diagnose_residual(by_line.left, by_line.kind));
  }

  // Nothing of a flight that is straight and even to a thousandth of a cycle.
  [[nodiscard]] std::optional<MotionResidual> residual(TakenFlight::Kind kind) const {
    constexpr double straight = 1e-3;
    const signal::SarWaveform& wave = work_.input.echoes.waveform;
    const signal::StraightTrack fit = signal::fit_straight(work_.input.echoes.track);
    const double strays_m = fit.worst_position_m + fit.speed_mps * fit.worst_interval_s;
    if (strays_m < 0.5 * straight * radar::wavelength_of(wave.carrier_hz, wave.light_speed_mps)) return std::nullopt;
    TakenFlight flight;
    flight.kind = kind;
    if (kind == TakenFlight::Kind::compensated) {
      flight.how = compensation_of(work_.input, work_.motion, request_.ground_m, work_.options);
    } else {
      flight.how.reference = line_;
      flight.how.scene_m = scene_m_;
      if (!(signal::distance_from(line_, scene_m_) > 0.0)) flight.how.scene_m.z -= 1.0;
    }
    flight.on_grid = kind == TakenFlight::Kind::flown && !flies_along_a_line(work_.input.echoes);
    const double speed_mps = core::norm(line_.velocity_mps);
    const signal::FocusedImage image = signal::image_of(work_.input.echoes, work_.options);
    flight.carrier_per_m = image.azimuth.spectrum_centre_per_m;
    flight.range_carrier_per_m = image.range.spectrum_centre_per_m;
    // In the frequency domain what lies beyond half the repetition frequency is taken for something else.
    double kept_hz = work_.options.doppler_bandwidth_hz;
    if (kind != TakenFlight::Kind::flown && !(kept_hz > 0.0)) kept_hz = 1.0 / fit.interval_s;
    if (kept_hz > 0.0) {
      const double half_per_m = 0.5 * kept_hz / speed_mps;
      flight.kept = {flight.carrier_per_m - half_per_m, flight.carrier_per_m + half_per_m};
    }
    return worst_motion_residual(*work_.input.acquisition, work_.input.echoes, flight, control_);
  }

  FocusRequest& request_;
  FocusPipeline& work_;
  const core::WorkControl& control_;
  signal::ReferenceTrack line_;
  core::Vec3 scene_m_;
};

// Why only back-projection can focus a flight; empty where others can.
std::string why_in_time(const signal::EchoRows& echoes) {
  if (!flies_along_a_line(echoes))
    return "the antenna flies around the scene, not along a line as all other algorithms require; the image is a "
           "ground-range grid around the targets";
  const double uneven = signal::unevenness(echoes.track, signal::fitted_track(echoes.track));
  if (std::isinf(uneven))
    return "the antenna reverses along its track, so that its pulses cannot be put in azimuth order";
  if (uneven > max_uneven)
    return fmt::format(
        "the along-track pulse spacing changes by up to {:.3g} % from one to the next, too much for motion "
        "compensation to resample",
        100.0 * uneven);
  return {};
}

}  // namespace

void choose_beforehand(FocusRequest& request, FocusInput& input) {
  const signal::EchoRows& echoes = input.echoes;
  const bool moves = echoes.track.size() >= 2 && core::norm(signal::fitted_track(echoes.track).velocity_mps) > 0.0;
  const bool open = request.algorithm == FocusAlgorithm::automatic;
  if (open && !echoes.carriers_hz.empty()) {
    request.algorithm = FocusAlgorithm::back_projection;
  } else if (open && moves && !request.motion && !request.autofocus) {
    const std::string why = why_in_time(echoes);
    if (!why.empty()) request.algorithm = FocusAlgorithm::back_projection;
    if (!why.empty())
      input.problems.push_back(core::note("focus.method", "back-projection instead of omega-k: " + why));
  }
  if (request.grid) return;
  const bool around = moves && request.algorithm == FocusAlgorithm::back_projection && !flies_along_a_line(echoes);
  request.grid = around ? FocusGrid::ground : FocusGrid::slant;
}

void choose_method(FocusRequest& request, FocusPipeline& work, const core::WorkControl& control) {
  const bool free = request.algorithm == FocusAlgorithm::automatic;
  if (free) request.algorithm = FocusAlgorithm::omega_k;
  const signal::EchoRows& echoes = work.input.echoes;
  if (echoes.track.size() < 2 || !(signal::fit_straight(echoes.track).speed_mps > 0.0)) return;
  Chooser chooser(request, work, control);
  if (request.algorithm == FocusAlgorithm::back_projection)
    chooser.in_time();
  else
    chooser.in_frequency(free);
}

}  // namespace sarsim::workflow
