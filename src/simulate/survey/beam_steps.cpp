#include "simulate/survey/beam_steps.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::simulate {

namespace {

constexpr std::int64_t max_examined_pulses = 262'144;

// Between the half-power points of the azimuth cut, one way; infinite where there are none.
double half_power_width_rad(const radar::AntennaPattern& pattern, radar::PatternRule rule) {
  if (pattern.kind == radar::AntennaPattern::Kind::isotropic) return INFINITY;
  constexpr double cut_step_rad = 3e-4;
  const double step_rad = pattern.kind == radar::AntennaPattern::Kind::sinx
                              ? std::min(pattern.azimuth_beamwidth_rad / 64.0, cut_step_rad)
                              : cut_step_rad;
  const auto gain = [&](double offset_rad) {
    return std::pow(radar::one_way_amplitude(pattern, offset_rad, 0.0, rule), 2);
  };
  const double half = 0.5 * gain(0.0);
  double width_rad = 0.0;
  for (const double side : {-1.0, 1.0}) {
    double offset_rad = step_rad;
    while (offset_rad < core::pi && gain(side * offset_rad) > half) offset_rad += step_rad;
    if (offset_rad >= core::pi) return INFINITY;
    width_rad += offset_rad - 0.5 * step_rad;
  }
  return width_rad;
}

class BeamAzimuths {
 public:
  explicit BeamAzimuths(const Acquisition& acquisition)
      : beam_(acquisition.link.beam),
        geometry_(*acquisition.scene, acquisition.link),
        first_(acquisition.timing.pulses.first) {}

  // Where the beam of pulse i of the recording points, from +y towards +x of the world, with whole turns: those of the
  // beam, or as near to the azimuth before as can be where its platform turns it.
  double of(std::int64_t i) {
    geometry_.set_pulse(first_ + i);
    const core::Vec3 axis = geometry_.pointing().axis_world();
    const double azimuth_rad = std::atan2(axis.x, axis.y);
    const double near_rad =
        beam_.kind == radar::Beam::Kind::rotating ? beam_.rate_rad_per_s * geometry_.send_time_s() : last_rad_;
    last_rad_ = near_rad + std::remainder(azimuth_rad - near_rad, 2.0 * core::pi);
    return last_rad_;
  }
  // Cosine of its elevation there.
  [[nodiscard]] double level() const {
    const core::Vec3 axis = geometry_.pointing().axis_world();
    return std::hypot(axis.x, axis.y);
  }

 private:
  const radar::Beam& beam_;
  PulseGeometry geometry_;
  std::int64_t first_;
  double last_rad_ = 0.0;
};

// Whether some of an even choice of pulses turns by more than the width.
bool may_jump(BeamAzimuths& azimuths, std::int64_t pulses, double width_rad) {
  constexpr std::int64_t looks = 16;
  for (std::int64_t look = 0; look < looks; ++look) {
    const std::int64_t i = look * (pulses - 2) / (looks - 1);
    const double from_rad = azimuths.of(i);
    if (std::abs(azimuths.of(i + 1) - from_rad) > width_rad) return true;
  }
  return false;
}

// The parts of a sector, in ascending directions from its beginning, that lie between illuminated ones.
double unlit_rad(std::vector<double> directions_rad, double sector_rad, double width_rad) {
  std::ranges::sort(directions_rad);
  double unlit = 0.0;
  for (std::size_t i = 0; i + 1 < directions_rad.size(); ++i)
    unlit += std::max(0.0, directions_rad[i + 1] - directions_rad[i] - width_rad);
  if (sector_rad < 2.0 * core::pi) return unlit;
  return unlit + std::max(0.0, directions_rad.front() + sector_rad - directions_rad.back() - width_rad);
}

}  // namespace

std::optional<BeamSteps> beam_steps(const Acquisition& acquisition) {
  CORE_EXPECT(acquisition.scene != nullptr);
  const radar::Beam::Kind kind = acquisition.link.beam.kind;
  const std::int64_t pulses = std::min(acquisition.timing.pulses.count(), max_examined_pulses);
  if ((kind != radar::Beam::Kind::rotating && kind != radar::Beam::Kind::fixed) || pulses < 2) return std::nullopt;
  const radar::PatternRule rule = acquisition.scene->conventions.pattern;
  const double one_way_rad = std::min(half_power_width_rad(acquisition.link.transmit, rule),
                                      half_power_width_rad(acquisition.link.receive, rule));
  if (!std::isfinite(one_way_rad)) return std::nullopt;
  BeamAzimuths azimuths(acquisition);
  azimuths.of(0);
  BeamSteps steps{.width_rad = one_way_rad / std::max(azimuths.level(), 1e-3)};
  if (!may_jump(azimuths, pulses, steps.width_rad)) return std::nullopt;
  std::vector<double> directions_rad;
  for (std::int64_t i = 0; i < pulses; ++i) {
    directions_rad.push_back(azimuths.of(i));
    if (i > 0)
      steps.step_rad =
          std::max(steps.step_rad, std::abs(directions_rad.back() - directions_rad[directions_rad.size() - 2]));
  }
  const auto [least, most] = std::ranges::minmax_element(directions_rad);
  steps.sector_rad = std::min(*most - *least, 2.0 * core::pi);
  if (steps.sector_rad >= 2.0 * core::pi)
    for (double& direction_rad : directions_rad)
      direction_rad -= 2.0 * core::pi * std::floor(direction_rad / (2.0 * core::pi));
  steps.unlit_share = unlit_rad(std::move(directions_rad), steps.sector_rad, steps.width_rad) / steps.sector_rad;
  return steps;
}

}  // namespace sarsim::simulate
