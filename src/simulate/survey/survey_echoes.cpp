#include "simulate/survey/survey_echoes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "core/report/expect.hpp"
#include "core/task/stop_points.hpp"
#include "radar/path/path.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/survey/beam_passes.hpp"
#include "simulate/survey/behind_earth.hpp"
#include "simulate/survey/noise_energy.hpp"

namespace sarsim::simulate {

namespace {

constexpr std::size_t max_candidates = 64;

// A target and, of the sampled pulses, the one at which it is nearest.
struct Candidate {
  std::size_t target = 0;
  std::size_t nearest = 0;  // among the sampled pulses
  double distance_m = std::numeric_limits<double>::infinity();
  bool possible_at_first = true;
};

class MeetingSearch {
 public:
  MeetingSearch(const Acquisition& acquisition, const EchoSurvey& survey, std::span<const std::int64_t> pulses,
                const core::WorkControl& control)
      : acquisition_(acquisition),
        survey_(survey),
        pulses_(pulses),
        control_(control),
        geometry_(*acquisition.scene, acquisition.link) {}

  std::vector<ImpossiblePulse> run() {
    choose();
    if (candidates_.empty()) return {};
    look_at_samples();
    std::vector<ImpossiblePulse> found;
    for (const Candidate& candidate : candidates_) {
      core::end_if_asked(control_.stop);
      if (!candidate.possible_at_first) continue;
      const std::int64_t pulse = nearest_pulse(candidate);
      geometry_.set_pulse(pulse);
      const EchoExtremes echo = echo_of(candidate.target);
      if (possible_echo(echo, acquisition_.light_speed_mps())) continue;
      found.push_back({candidate.target, pulse, acquisition_.link.repetition.send_time_s(pulse), echo});
    }
    std::ranges::sort(found, {}, &ImpossiblePulse::target);
    return found;
  }

 private:
  void choose() {
    double gap_s = 0.0;
    for (std::size_t i = 1; i < pulses_.size(); ++i)
      gap_s = std::max(gap_s, acquisition_.link.repetition.send_time_s(pulses_[i]) -
                                  acquisition_.link.repetition.send_time_s(pulses_[i - 1]));
    constexpr double reach = 2.0;  // Speeds change between two samples.
    for (std::size_t i = 0; i < survey_.targets.size(); ++i) {
      const TargetSurvey& target = survey_.targets[i];
      if (!(target.nearest_m > reach * gap_s * target.largest_speed_mps)) candidates_.push_back({.target = i});
    }
    const auto nearer = [&](const Candidate& a, const Candidate& b) {
      const double a_m = survey_.targets[a.target].nearest_m;
      const double b_m = survey_.targets[b.target].nearest_m;
      return a_m < b_m || (a_m == b_m && a.target < b.target);
    };
    std::ranges::sort(candidates_, nearer);
    candidates_.resize(std::min(candidates_.size(), max_candidates));
  }

  void look_at_samples() {
    for (std::size_t p = 0; p < pulses_.size(); ++p) {
      geometry_.set_pulse(pulses_[p]);
      for (Candidate& candidate : candidates_) {
        const EchoExtremes echo = echo_of(candidate.target);
        if (p == 0) candidate.possible_at_first = possible_echo(echo, acquisition_.light_speed_mps());
        if (!(echo.distance_m < candidate.distance_m)) continue;
        candidate.distance_m = echo.distance_m;
        candidate.nearest = p;
      }
    }
  }

  // Between the samples around the nearest one the distance falls and rises again.
  std::int64_t nearest_pulse(const Candidate& candidate) {
    std::int64_t low = pulses_[candidate.nearest - std::min<std::size_t>(candidate.nearest, 1)];
    std::int64_t high = pulses_[std::min(candidate.nearest + 1, pulses_.size() - 1)];
    while (high - low > 2) {
      const std::int64_t third = (high - low) / 3;
      if (distance_m(candidate.target, low + third) < distance_m(candidate.target, high - third))
        high -= third;
      else
        low += third;
    }
    std::int64_t best = low;
    for (std::int64_t pulse = low + 1; pulse <= high; ++pulse)
      if (distance_m(candidate.target, pulse) < distance_m(candidate.target, best)) best = pulse;
    return best;
  }

  double distance_m(std::size_t target, std::int64_t pulse) {
    geometry_.set_pulse(pulse);
    return geometry_.view(target).distance_m;
  }

  [[nodiscard]] EchoExtremes echo_of(std::size_t target) const {
    const ScattererView view = geometry_.view(target);
    return {view.distance_m > closest_echo_m ? view.distance_m : 0.0, view.speed_mps, view.amplitude_sqrt_w};
  }

  const Acquisition& acquisition_;
  const EchoSurvey& survey_;
  std::span<const std::int64_t> pulses_;
  const core::WorkControl& control_;
  PulseGeometry geometry_;
  std::vector<Candidate> candidates_;
};

// Pulses at which targets have echoes that cannot be computed although those of the first pulse can: most of all where
// the radar comes to the place of a target. Examined are the targets whose distance at the sampled pulses and speed
// let the radar reach them between two of these, at most 64, the nearest first: in each case at the pulse with the
// least distance between the neighbours of the nearest sampled pulse.
// @param pulses  that the survey has examined, ascending
// @return        at most one for each target, by target
// @throw         Interrupted
std::vector<ImpossiblePulse> impossible_pulses(const Acquisition& acquisition, const EchoSurvey& survey,
                                               std::span<const std::int64_t> pulses, const core::WorkControl& control) {
  if (pulses.size() < 2) return {};
  return MeetingSearch(acquisition, survey, pulses, control).run();
}

constexpr std::size_t max_pulses = 64;      // decisions: "at most 64 pulses x all targets, labelled as an estimate"
constexpr std::size_t max_views = 400'000;  // targets times pulses: a look takes some hundredths of a second
constexpr double infinity = std::numeric_limits<double>::infinity();

// Targets that one thread looks at together, and pulses of which all poses are kept at once. They decide the order in
// which amplitudes are summed.
constexpr std::size_t range_targets = 2048;
constexpr std::size_t max_poses = 100'000;
constexpr std::size_t range_poses = 2000;  // that are worth a thread

std::size_t batch_pulses(std::size_t platforms) {
  return std::clamp<std::size_t>(max_poses / std::max<std::size_t>(platforms, 1), 1, max_pulses);
}

// Pulse numbers to look at: all, or an even choice that includes the first and the last.
std::vector<std::int64_t> sampled_pulses(const radar::PulseRange& range, std::size_t targets) {
  std::vector<std::int64_t> pulses;
  const std::int64_t count = range.count();
  const std::size_t affordable = std::clamp<std::size_t>(max_views / std::max<std::size_t>(targets, 1), 3, max_pulses);
  const std::int64_t looks = std::min<std::int64_t>(count, static_cast<std::int64_t>(affordable));
  for (std::int64_t i = 0; i < looks; ++i) {
    const double share = looks > 1 ? static_cast<double>(i) / static_cast<double>(looks - 1) : 0.0;
    pulses.push_back(range.first + std::llround(share * static_cast<double>(count - 1)));
  }
  return pulses;
}

// Pulse numbers to look at: an even choice and, of a rotating beam, those that meet the targets; as they were sent.
std::vector<std::int64_t> pulses_to_look_at(const Acquisition& acquisition) {
  const std::size_t targets = acquisition.scene->scatterers.size();
  std::vector<std::int64_t> pulses = sampled_pulses(acquisition.timing.pulses, targets);
  const bool all = static_cast<std::int64_t>(pulses.size()) == acquisition.timing.pulses.count();
  if (all || targets == 0 || !is_scanning(acquisition.link.beam)) return pulses;
  const std::size_t views = max_views / targets;
  const std::size_t poses = max_poses / std::max<std::size_t>(acquisition.scene->platforms.size(), 1);
  const std::size_t most = std::min(views, poses);
  if (most <= pulses.size()) return pulses;
  std::ranges::copy(pulses_on_targets(acquisition, most - pulses.size()), std::back_inserter(pulses));
  std::ranges::sort(pulses);
  const auto doubles = std::ranges::unique(pulses);
  pulses.erase(doubles.begin(), doubles.end());
  return pulses;
}

// A plane shows the same side to the radar at all of its points.
bool faces_radar(const ScattererSheet& sheet, const PulseGeometry& geometry) {
  if (sheet.points_m.empty()) return false;
  const radar::Pose& pose = geometry.pose(sheet.platform);
  const core::Vec3 look_world_m =
      radar::world_position_m(pose, sheet.points_m.front()) - geometry.radar_pose().position_world_m;
  return core::dot(pose.world_from_platform * sheet.normal_platform, look_world_m) < 0.0;
}

void take_in(TargetSurvey& target, const ScattererView& view, double range_m, double doppler_hz, bool in_window) {
  target.nearest_m = std::min(target.nearest_m, range_m);
  target.farthest_m = std::max(target.farthest_m, range_m);
  target.lowest_doppler_hz = std::min(target.lowest_doppler_hz, doppler_hz);
  target.highest_doppler_hz = std::max(target.highest_doppler_hz, doppler_hz);
  target.largest_amplitude_v = std::max(target.largest_amplitude_v, std::abs(view.amplitude_sqrt_w));
  target.largest_speed_mps = std::max(target.largest_speed_mps, std::abs(view.speed_mps));
  target.in_window = target.in_window || in_window;
}

void take_in_amplitude(SurveyTotals& totals, std::size_t strongest, double strongest_v, std::size_t weakest,
                       double weakest_v) {
  if (strongest_v > totals.strongest_v) {
    totals.strongest_v = strongest_v;
    totals.strongest = strongest;
  }
  if (weakest_v < totals.weakest_v) {
    totals.weakest_v = weakest_v;
    totals.weakest = weakest;
  }
}

void take_in(SurveyTotals& totals, std::size_t index, const TargetSurvey& target, double light_speed_mps,
             double unambiguous_m) {
  totals.nearest_m = std::min(totals.nearest_m, target.nearest_m);
  totals.farthest_m = std::max(totals.farthest_m, target.farthest_m);
  if (!possible_echo(extremes_of(target), light_speed_mps)) totals.impossible.push_back(index);
  if (target.hidden && totals.hidden++ == 0) totals.first_hidden = index;
  if (!target.in_window) return;
  if (target.hidden) ++totals.hidden_in_window;
  totals.any_in_window = true;
  ++totals.in_window;
  take_in_amplitude(totals, index, target.largest_amplitude_v, index, target.largest_amplitude_v);
  if (!(target.farthest_m > unambiguous_m)) return;
  ++totals.late;
  totals.latest_m = std::max(totals.latest_m, target.farthest_m);
}

void take_in(SurveyTotals& totals, const SurveyTotals& more) {
  totals.nearest_m = std::min(totals.nearest_m, more.nearest_m);
  totals.farthest_m = std::max(totals.farthest_m, more.farthest_m);
  totals.any_in_window = totals.any_in_window || more.any_in_window;
  totals.in_window += more.in_window;
  if (more.any_in_window) take_in_amplitude(totals, more.strongest, more.strongest_v, more.weakest, more.weakest_v);
  if (totals.hidden == 0) totals.first_hidden = more.first_hidden;
  totals.hidden += more.hidden;
  totals.hidden_in_window += more.hidden_in_window;
  totals.late += more.late;
  totals.latest_m = std::max(totals.latest_m, more.latest_m);
  totals.impossible.insert(totals.impossible.end(), more.impossible.begin(), more.impossible.end());
}

// Looks at the echoes of one plan, ranges of targets on several threads.
class Look {
 public:
  Look(const Acquisition& acquisition, const core::WorkControl& control)
      : acquisition_(acquisition),
        control_(control),
        light_mps_(acquisition.light_speed_mps()),
        earth_(acquisition.scene->turning) {
    survey_.surface_faces_radar.assign(acquisition.scene->sheets.size(), false);
    core::reserve_touched(survey_.targets, acquisition.scene->scatterers.size(), control);
    survey_.targets.assign(acquisition.scene->scatterers.size(),
                           {infinity, 0.0, infinity, -infinity, 0.0, 0.0, 0.0, false, earth_.is_round()});
  }

  EchoSurvey survey() {
    const std::vector<std::int64_t> pulses = pulses_to_look_at(acquisition_);
    survey_.pulses_sampled = pulses.size();
    survey_.all_pulses = static_cast<std::int64_t>(pulses.size()) == acquisition_.timing.pulses.count();
    if (survey_.targets.size() * pulses.size() <= max_views) looks_.resize(survey_.targets.size() * pulses.size());
    const std::size_t batch = std::min(pulses.size(), batch_pulses(acquisition_.scene->platforms.size()));
    std::vector<PulseGeometry> geometries(batch, PulseGeometry(*acquisition_.scene, acquisition_.link));
    for (std::size_t first = 0; first < pulses.size(); first += batch) {
      const std::size_t count = std::min(batch, pulses.size() - first);
      core::parallel_ranges(count, pulses_worth_a_thread(), control_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) geometries[p].set_pulse(pulses[first + p]);
      });
      look_at_pulses(std::span(geometries).first(count), first);
    }
    add_up();
    take_band();
    survey_.impossible = impossible_pulses(acquisition_, survey_, pulses, control_);
    for (const ImpossiblePulse& met : survey_.impossible) survey_.totals.impossible.push_back(met.target);
    std::ranges::sort(survey_.totals.impossible);
    const auto twice = std::ranges::unique(survey_.totals.impossible);
    survey_.totals.impossible.erase(twice.begin(), twice.end());
    return std::move(survey_);
  }

 private:
  [[nodiscard]] std::size_t pulses_worth_a_thread() const {
    return std::max<std::size_t>(range_poses / std::max<std::size_t>(acquisition_.scene->platforms.size(), 1), 1);
  }
  template <class Body>
  void over_targets(const Body& body) const {
    core::parallel_ranges(survey_.targets.size(), range_targets, control_, body);
  }
  [[nodiscard]] std::size_t ranges() const { return (survey_.targets.size() + range_targets - 1) / range_targets; }

  // @param first  the number of the first of them among the sampled pulses
  void look_at_pulses(std::span<const PulseGeometry> geometries, std::size_t first) {
    for (const PulseGeometry& geometry : geometries)
      for (std::size_t i = 0; i < acquisition_.scene->sheets.size(); ++i)
        if (faces_radar(acquisition_.scene->sheets[i], geometry)) survey_.surface_faces_radar[i] = true;
    std::vector<double> sum_v(ranges() * geometries.size());
    over_targets([&](std::size_t begin, std::size_t end) {
      for (std::size_t p = 0; p < geometries.size(); ++p)
        sum_v[begin / range_targets * geometries.size() + p] = look_at_targets(geometries[p], first + p, begin, end);
    });
    for (std::size_t p = 0; p < geometries.size(); ++p) {
      double sum = 0.0;
      for (std::size_t r = 0; r < ranges(); ++r) sum += sum_v[r * geometries.size() + p];
      survey_.largest_sum_v = std::max(survey_.largest_sum_v, sum);
    }
  }

  // Returns the sum of the amplitudes in the window.
  double look_at_targets(const PulseGeometry& geometry, std::size_t pulse, std::size_t begin, std::size_t end) {
    const radar::Pointing pointing = geometry.pointing();
    double sum_v = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const ScattererView view = geometry.view(i, pointing);
      const bool in_window = touches_window(view);
      if (in_window) sum_v += std::abs(view.amplitude_sqrt_w);
      const double doppler_hz = radar::doppler_of(view.speed_mps, geometry.carrier_hz(), light_mps_);
      TargetSurvey& target = survey_.targets[i];
      take_in(target, view, radar::range_of(view.delay_s, light_mps_), doppler_hz, in_window);
      // Once it is seen it is not hidden.
      if (target.hidden) target.hidden = is_hidden(geometry, i);
      if (!looks_.empty()) looks_[pulse * survey_.targets.size() + i] = {doppler_hz, std::abs(view.amplitude_sqrt_w)};
    }
    return sum_v;
  }

  [[nodiscard]] bool is_hidden(const PulseGeometry& geometry, std::size_t index) const {
    const Scatterer& target = acquisition_.scene->scatterers[index];
    return earth_.hides(geometry.radar_pose().position_world_m,
                        radar::world_position_m(geometry.pose(target.platform), target.position_m));
  }

  // Well inside and well outside the window need no counting of samples.
  [[nodiscard]] bool touches_window(const ScattererView& view) const {
    const radar::SampleGrid& grid = acquisition_.reception.raw_grid;
    const double margin_s = 2.0 * grid.interval_s;
    const double begin_s = view.delay_s + acquisition_.reception.pulse.first_s();
    const double end_s = view.delay_s + acquisition_.reception.pulse.last_s();
    const double window_end_s = grid.time_s(grid.count);
    if (end_s < grid.first_s - margin_s || begin_s > window_end_s + margin_s) return false;
    if (begin_s > grid.first_s + margin_s && begin_s < window_end_s - margin_s && end_s > begin_s + margin_s)
      return true;
    const radar::SampleSpan touched = radar::touched_samples(acquisition_.reception.pulse, grid, view.delay_s,
                                                             acquisition_.reception.pulse.clock_of(view.clock));
    return touched.begin < touched.end;
  }

  void add_up() {
    const double noise_j = noise_energy_j(acquisition_.scene->conventions, acquisition_.link);
    const double unambiguous_m = unambiguous_range_m(acquisition_);
    std::vector<SurveyTotals> totals(ranges());
    over_targets([&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        TargetSurvey& t = survey_.targets[i];
        if (noise_j > 0.0)
          t.snr = t.largest_amplitude_v * t.largest_amplitude_v * acquisition_.link.pulse.width_s / noise_j;
        take_in(totals[begin / range_targets], i, t, light_mps_, unambiguous_m);
      }
    });
    for (const SurveyTotals& more : totals) take_in(survey_.totals, more);
  }

  struct Band {
    double lowest_hz = infinity;
    double highest_hz = -infinity;

    void take_in(double low_hz, double high_hz) {
      lowest_hz = std::min(lowest_hz, low_hz);
      highest_hz = std::max(highest_hz, high_hz);
    }
  };

  // The Doppler band of the echoes that matter: those in the window and within 40 dB of the strongest one, while they
  // are within 20 dB of their own strongest, that is while the beam rests on them. Of very many targets, always.
  void take_band() {
    std::vector<Band> bands(ranges());
    over_targets([&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const TargetSurvey& t = survey_.targets[i];
        if (!t.in_window || t.largest_amplitude_v < 0.01 * survey_.totals.strongest_v) continue;
        take_in_looks(bands[begin / range_targets], i);
      }
    });
    Band all;
    for (const Band& band : bands) all.take_in(band.lowest_hz, band.highest_hz);
    if (all.lowest_hz > all.highest_hz) return;
    survey_.lowest_doppler_hz = all.lowest_hz;
    survey_.highest_doppler_hz = all.highest_hz;
  }

  void take_in_looks(Band& band, std::size_t target) const {
    const TargetSurvey& t = survey_.targets[target];
    if (looks_.empty()) band.take_in(t.lowest_doppler_hz, t.highest_doppler_hz);
    for (std::size_t at = target; at < looks_.size(); at += survey_.targets.size())
      if (looks_[at].amplitude >= 0.1 * t.largest_amplitude_v)
        band.take_in(looks_[at].doppler_hz, looks_[at].doppler_hz);
  }

  struct OneLook {
    double doppler_hz = 0.0;
    double amplitude = 0.0;
  };

  const Acquisition& acquisition_;
  const core::WorkControl& control_;
  double light_mps_;
  BehindEarth earth_;
  EchoSurvey survey_;
  std::vector<OneLook> looks_;  // all targets of the first pulse, of the second ...; none where they are too many
};

}  // namespace

double unambiguous_range_m(const Acquisition& acquisition) {
  CORE_EXPECT(acquisition.scene != nullptr);
  return radar::range_of(acquisition.link.repetition.shortest_interval_s(), acquisition.light_speed_mps());
}

EchoExtremes extremes_of(const TargetSurvey& target) {
  return {target.nearest_m > closest_echo_m ? target.nearest_m : 0.0, target.largest_speed_mps,
          target.largest_amplitude_v};
}

EchoSurvey survey_echoes(const Acquisition& acquisition, const core::WorkControl& control) {
  CORE_EXPECT(acquisition.scene != nullptr);
  return Look(acquisition, control).survey();
}

std::vector<std::size_t> targets_in_window(const EchoSurvey& survey, std::size_t most) {
  CORE_EXPECT(most > 2);
  const std::size_t count = survey.totals.in_window;
  const std::size_t evenly = count <= most ? count : most - 2;
  std::vector<std::size_t> chosen;
  std::size_t met = 0;
  for (std::size_t i = 0; i < survey.targets.size() && chosen.size() < evenly; ++i) {
    if (!survey.targets[i].in_window) continue;
    const std::size_t next = evenly > 1 ? chosen.size() * (count - 1) / (evenly - 1) : 0;
    if (met++ == next) chosen.push_back(i);
  }
  if (count > most) chosen.insert(chosen.end(), {survey.totals.strongest, survey.totals.weakest});
  std::ranges::sort(chosen);
  const auto doubles = std::ranges::unique(chosen);
  chosen.erase(doubles.begin(), doubles.end());
  return chosen;
}

}  // namespace sarsim::simulate
