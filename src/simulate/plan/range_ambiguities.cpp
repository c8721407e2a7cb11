#include "simulate/plan/range_ambiguities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::simulate {

namespace {

constexpr std::int64_t max_looks = 65;
constexpr std::int64_t looks_at_many = 17;
constexpr std::int64_t min_looks = 3;
constexpr std::size_t many_scatterers = 50'000;
constexpr std::size_t max_poses = 100'000;  // kept at once
constexpr std::size_t between_stops = 4096;
constexpr double weakest_heard = 1e-3;  // -60 dB
// What a platform may move during a flight, and what a pulse may be stretched by: far more than any speed does.
constexpr double share_of_flight = 1e-3;

// From the first to the last moment of something, s.
struct Interval {
  double first_s = std::numeric_limits<double>::infinity();
  double last_s = -std::numeric_limits<double>::infinity();

  void include(double from_s, double to_s) {
    first_s = std::min(first_s, from_s);
    last_s = std::max(last_s, to_s);
  }
};

std::size_t point_count(const ResolvedScene& scene) {
  return std::transform_reduce(scene.sheets.begin(), scene.sheets.end(), scene.scatterers.size(), std::plus<>(),
                               [](const ScattererSheet& sheet) { return sheet.points_m.size(); });
}

// Amplitude of the largest cross-section that a law and random deviations may make of a target's.
double largest_root_rcs_m(const ResolvedScene& scene, const Scatterer& s) {
  constexpr double deviations = 3.0;
  double rcs_m2 = s.rcs_m2 + deviations * s.rcs_stddev_m2;
  if (s.law == radar::ReflectivityLaw::user) {
    double gain_db = 0.0;
    for (const core::Knot& knot : scene.gain_curves[s.gain_curve].knots()) gain_db = std::max(gain_db, knot.y);
    rcs_m2 *= std::pow(10.0, 0.1 * gain_db);
  }
  return std::sqrt(std::max(rcs_m2, 0.0));
}

// The largest of the values that neighbours in a row were given, whole runs of them at a time: a tree of runs, each of
// which keeps what all of its places have, so that a run takes a logarithm of its length.
class LargestInRuns {
 public:
  static constexpr double none = -1.0;  // below all strengths

  explicit LargestInRuns(std::size_t places) : places_(places), largest_(2 * places, none) {}

  // Places from `begin` to before `end`.
  void raise(std::size_t begin, std::size_t end, double value) {
    for (begin += places_, end += places_; begin < end; begin /= 2, end /= 2) {
      if (begin % 2 == 1) raise_run(begin++, value);
      if (end % 2 == 1) raise_run(--end, value);
    }
  }

  [[nodiscard]] double at(std::size_t place) const {
    double largest = none;
    for (std::size_t run = place + places_; run > 0; run /= 2) largest = std::max(largest, largest_[run]);
    return largest;
  }

 private:
  void raise_run(std::size_t run, double value) { largest_[run] = std::max(largest_[run], value); }

  std::size_t places_;
  std::vector<double> largest_;  // run n holds the runs 2 n and 2 n + 1; the last half are the places
};

// When the echoes of points arrive in rows, over a few looks.
class Hearing {
 public:
  Hearing(const Acquisition& acquisition, const core::StopFlag* stop)
      : scene_(*acquisition.scene), radar_(acquisition.link), stop_(stop) {
    const radar::EchoPulse& pulse = acquisition.reception.pulse;
    const radar::SampleGrid& grid = acquisition.reception.raw_grid;
    const radar::PulseRange& pulses = acquisition.timing.pulses;
    const double slack_s = share_of_flight * (pulse.last_s() - pulse.first_s()) + 2.0 * grid.interval_s;
    begin_s_ = grid.first_s - pulse.last_s() - slack_s;
    end_s_ = grid.time_s(grid.count) - pulse.first_s() + slack_s;
    const std::int64_t most = point_count(scene_) > many_scatterers ? looks_at_many : max_looks;
    const auto kept = static_cast<std::int64_t>(max_poses / std::max<std::size_t>(scene_.platforms.size(), 1));
    const std::int64_t looks = std::min(pulses.count(), std::clamp(kept, min_looks, most));
    for (std::int64_t n = 0; n < looks; ++n) {
      const double share = looks > 1 ? static_cast<double>(n) / static_cast<double>(looks - 1) : 0.0;
      looks_.push_back(pulses.first + std::llround(share * static_cast<double>(pulses.count() - 1)));
    }
    place_platforms();
  }

  RangeAmbiguities heard() {
    RangeAmbiguities heard;
    find_candidates();
    if (since_.empty()) return {};
    strongest_ = LargestInRuns(since_.size());
    for (const Scatterer& s : scene_.scatterers) listen(s.platform, s.position_m, largest_root_rcs_m(scene_, s));
    for (const ScattererSheet& sheet : scene_.sheets)
      for (const core::Vec3& point_m : sheet.points_m)
        listen(sheet.platform, point_m, std::sqrt(std::max(sheet.point_rcs_m2, 0.0)));
    for (std::size_t i = 0; i < since_.size(); ++i)
      if (const double strength = strongest_.at(i); since_[i].back != 0 && strength > LargestInRuns::none)
        heard.pulses.push_back({since_[i].back, strongest_of_all_ > 0.0 ? strength / strongest_of_all_ : 0.0});
    if (farther_ > 0.0) heard.farther = farther_ / std::max(farther_, strongest_of_all_);
    return heard;
  }

 private:
  void place_platforms() {
    poses_.resize(scene_.platforms.size());
    between_m_.assign(scene_.platforms.size(), 0.0);
    radar::Track::ErrorSteps steps;
    const radar::Track& own = scene_.platforms[radar_.platform].track;
    for (const std::int64_t look : looks_)
      own_m_.push_back(own.travel_at(radar_.repetition.send_time_s(look), look, steps).position_world_m);
    for (const std::uint32_t p : reflecting_platforms(scene_)) {
      radar::Track::ErrorSteps of_platform;
      for (const std::int64_t look : looks_)
        poses_[p].push_back(scene_.platforms[p].track.at(radar_.repetition.send_time_s(look), look, of_platform));
      between_m_[p] = between_looks_m(p);
    }
  }

  // By how much the distance of a platform's points may differ from those at the looks beside.
  [[nodiscard]] double between_looks_m(std::size_t platform) const {
    const ResolvedPlatform& carrier = scene_.platforms[platform];
    double chord_m = 0.0;
    for (std::size_t n = 1; n < looks_.size(); ++n)
      chord_m = std::max(chord_m, core::norm((poses_[platform][n].position_world_m - own_m_[n]) -
                                             (poses_[platform][n - 1].position_world_m - own_m_[n - 1])));
    const double turning_m = carrier.track.turns() ? core::norm(carrier.middle_m) + carrier.radius_m : 0.0;
    return 0.5 * chord_m + 2.0 * turning_m;
  }

  [[nodiscard]] double light_mps() const { return scene_.conventions.light_speed_mps; }
  [[nodiscard]] double distance_m(std::size_t platform, std::size_t look, const core::Vec3& point_m) const {
    return core::norm(radar::world_position_m(poses_[platform][look], point_m) - own_m_[look]);
  }
  // When an echo from so far may arrive after its pulse was sent.
  [[nodiscard]] Interval arrival(double distance_m, double either_way_m) const {
    const double delay_s = radar::delay_of(distance_m, light_mps());
    const double off_s = share_of_flight * delay_s + radar::delay_of(either_way_m, light_mps());
    return {delay_s - off_s, delay_s + off_s};
  }

  // How long before pulse n pulse n - back left, shortest and longest of a cycle of intervals.
  [[nodiscard]] Interval since(std::int64_t back) const {
    Interval interval;
    for (std::int64_t n = 0; n < radar_.repetition.cycle_pulses(); ++n) {
      const double since_s = radar_.repetition.send_time_s(n) - radar_.repetition.send_time_s(n - back);
      interval.include(since_s, since_s);
    }
    return interval;
  }
  [[nodiscard]] bool meets(const Interval& arrival, const Interval& since) const {
    return arrival.last_s - since.first_s >= begin_s_ && arrival.first_s - since.last_s <= end_s_;
  }

  // The pulses of which any platform's ball may be heard.
  void find_candidates() {
    Interval all;
    for (std::size_t p = 0; p < poses_.size(); ++p)
      for (std::size_t n = 0; n < poses_[p].size(); ++n) {
        const ResolvedPlatform& carrier = scene_.platforms[p];
        const Interval ball = arrival(distance_m(p, n, carrier.middle_m), carrier.radius_m + between_m_[p]);
        all.include(std::max(ball.first_s, 0.0), ball.last_s);
      }
    if (!(all.first_s <= all.last_s) || !std::isfinite(all.last_s)) return;
    bool some_farther = false;
    for (const std::int64_t step : {-1, 1})
      for (std::int64_t back = step;; back += step) {
        const Interval since = this->since(back);
        const bool beyond = step > 0 ? all.last_s - since.first_s < begin_s_ : all.first_s - since.last_s > end_s_;
        if (beyond) break;
        if (std::abs(back) > max_pulses_away) {
          some_farther = true;
          (step > 0 ? before_s_ : after_s_) = step > 0 ? since.first_s : since.last_s;
          break;
        }
        if (meets(all, since)) since_.push_back({back, since});
      }
    if (!since_.empty() || some_farther) since_.push_back({0, {0.0, 0.0}});
    std::ranges::sort(since_, {}, &SentPulse::back);
  }

  void listen(std::size_t platform, const core::Vec3& point_m, double root_rcs_m) {
    if (listened_++ % between_stops == 0 && stop_ != nullptr && stop_->requested()) throw core::Interrupted();
    for (std::size_t n = 0; n < looks_.size(); ++n) {
      const double far_m = distance_m(platform, n, point_m);
      if (!(far_m > 0.0)) continue;
      const Interval arrives = arrival(far_m, between_m_[platform]);
      const double strength = root_rcs_m / (far_m * far_m);
      if (arrives.last_s - before_s_ >= begin_s_ || arrives.first_s - after_s_ <= end_s_)
        farther_ = std::max(farther_, strength);
      // Pulses are in the order of the times since they left.
      const auto place = [this](auto found) { return static_cast<std::size_t>(found - since_.begin()); };
      const std::size_t first = place(std::ranges::lower_bound(
          since_, arrives.first_s - end_s_, {}, [](const SentPulse& sent) { return sent.since.last_s; }));
      const std::size_t end = place(std::ranges::upper_bound(since_, arrives.last_s - begin_s_, {},
                                                             [](const SentPulse& sent) { return sent.since.first_s; }));
      if (first >= end) continue;
      strongest_.raise(first, end, strength);
      strongest_of_all_ = std::max(strongest_of_all_, strength);
    }
  }

  // A pulse that may be heard, and how long before the row's it was sent.
  struct SentPulse {
    std::int64_t back = 0;
    Interval since;
  };

  const ResolvedScene& scene_;
  const Link& radar_;
  const core::StopFlag* stop_;
  double begin_s_ = 0.0;  // delays in [begin, end] from a row's pulse are heard
  double end_s_ = 0.0;
  std::vector<std::int64_t> looks_;
  std::vector<core::Vec3> own_m_;                // the radar at each look
  std::vector<std::vector<radar::Pose>> poses_;  // of each platform at each look; none where nothing reflects
  std::vector<double> between_m_;
  std::vector<SentPulse> since_;                               // the row's own among them, ascending
  LargestInRuns strongest_{0};                                 // of each of them
  double before_s_ = std::numeric_limits<double>::infinity();  // since the first pulse that is too far before, ...
  double after_s_ = -std::numeric_limits<double>::infinity();  // ... and after
  double farther_ = 0.0;                                       // the strongest echo of such pulses
  double strongest_of_all_ = 0.0;
  std::size_t listened_ = 0;
};

}  // namespace

RangeAmbiguities find_range_ambiguities(const Acquisition& acquisition, const core::StopFlag* stop) {
  CORE_EXPECT(acquisition.reception.raw_grid.interval_s > 0.0);
  CORE_EXPECT(acquisition.timing.pulses.count() > 0);
  if (acquisition.scene->conventions.reception == Conventions::Reception::own_pulse) return {};
  return Hearing(acquisition, stop).heard();
}

RangeAmbiguities asked_for(RangeAmbiguities heard, scene::AmbiguousEchoes which) {
  if (which == scene::AmbiguousEchoes::none) return {};
  if (which == scene::AmbiguousEchoes::strong) {
    if (heard.farther < weakest_heard) heard.farther = 0.0;
    std::erase_if(heard.pulses, [](const RangeAmbiguity& other) { return !(other.strength >= weakest_heard); });
  }
  return heard;
}

void clip_to_window(radar::EchoBatch& echoes, double since_s, const radar::EchoPulse& pulse,
                    const radar::SampleGrid& grid) {
  CORE_EXPECT(echoes.is_whole());
  const bool bends = !echoes.dilation_rate.empty();
  const bool ahead = !echoes.ahead_turns.empty();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < echoes.size(); ++i) {
    const double delay_s = echoes.delay_s[i] - since_s;
    const radar::SampleSpan touched = radar::touched_samples(pulse, grid, delay_s, pulse.clock_of(echoes, i));
    if (touched.begin >= touched.end) continue;
    echoes.delay_s[kept] = delay_s;
    echoes.amplitude_sqrt_w[kept] = echoes.amplitude_sqrt_w[i];
    echoes.doppler[kept] = echoes.doppler[i];
    if (bends) echoes.dilation_rate[kept] = echoes.dilation_rate[i];
    if (ahead) echoes.ahead_turns[kept] = echoes.ahead_turns[i];
    ++kept;
  }
  echoes.resize(kept, bends, ahead);
}

}  // namespace sarsim::simulate
