#include "scene/ephemeris/state_consistency.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sarsim::scene::ephemeris {

namespace {

using core::Vec3;
using radar::OrbitState;
using radar::StateView;

constexpr std::size_t max_compared = 1'000'000;
constexpr std::size_t max_odd = 20;
constexpr std::size_t max_searches = 60;
constexpr std::size_t no_state = static_cast<std::size_t>(-1);
constexpr double min_off_m = 5e-3;

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// States that are left out of all predictions: those that were found odd, and a run that is on trial.
struct LeftOut {
  const std::vector<char>* odd = nullptr;
  std::size_t first = no_state;
  std::size_t count = 0;

  [[nodiscard]] bool has(std::size_t i) const { return (*odd)[i] != 0 || (first <= i && i - first < count); }
};

// What a state is off its prediction, and how uncertain that is; both of positions, in metres.
struct Residual {
  double position_m = 0.0;
  double position_doubt_m = 0.0;
  double velocity_m = 0.0;  ///< What the velocity moves the path within a step.
  double velocity_doubt_m = 0.0;
  double velocity_mps = 0.0;
};

class Comparer {
 public:
  explicit Comparer(const StateView& states)
      : states_(states),
        count_(std::min(states.time_s.size(), max_compared)),
        max_(states.velocity_mps.empty() ? 8 : 6),
        fewest_(states.velocity_mps.empty() ? 4 : 3) {}

  std::vector<OddState> odd_states() {
    if (count_ < fewest_ + 2) return {};
    odd_.assign(count_, 0);
    std::vector<char> unexplained(count_, 0);
    std::vector<Residual> all(count_);
    std::vector<double> off;
    for (std::size_t i = 0; i < count_; ++i) {
      all[i] = residual(i, {&odd_});
      off.push_back(std::max(all[i].position_m, all[i].velocity_m));
    }
    noise_m_ = 8.0 * median(off) + min_off_m;
    std::vector<OddState> found;
    for (std::size_t search = 0; search < max_searches && found.size() < max_odd; ++search) {
      const std::size_t worst = worst_of(all, unexplained);
      if (worst == no_state) break;
      const LeftOut culprit = culprit_around(worst);
      for (std::size_t i = low(worst); i < high(worst); ++i) unexplained[i] = culprit.count == 0 ? 1 : unexplained[i];
      if (culprit.count == 0) {
        const Residual& r = all[worst];
        if (!could_be_flown(worst, r)) found.push_back({worst, r.position_m, r.velocity_mps});
        continue;
      }
      for (std::size_t i = culprit.first; i < culprit.first + culprit.count; ++i) odd_[i] = 1;
      for (std::size_t i = culprit.first; i < culprit.first + culprit.count; ++i) {
        const Residual r = residual(i, {&odd_});
        if (excess(r) > 1.0 && !could_be_flown(i, r)) found.push_back({i, r.position_m, r.velocity_mps});
      }
      for (std::size_t i = low(worst) > reach ? low(worst) - reach : 0; i < std::min(count_, high(worst) + reach); ++i)
        all[i] = residual(i, {&odd_});
    }
    std::ranges::sort(found, {}, &OddState::index);
    return found;
  }

 private:
  static constexpr std::size_t reach = 6;  // states on either side that a state may have a part in

  [[nodiscard]] std::size_t low(std::size_t i) const { return i > reach ? i - reach : 0; }
  [[nodiscard]] std::size_t high(std::size_t i) const { return std::min(count_, i + reach + 1); }

  // The states around one, near to far, without it.
  [[nodiscard]] std::vector<std::size_t> around(std::size_t i, const LeftOut& without) const {
    std::vector<std::size_t> order;
    std::size_t below = i, above = i + 1;
    while (order.size() < max_ && (below > 0 || above < count_)) {
      const bool take_below = above >= count_ || (below > 0 && i - below <= above - i - 1);
      const std::size_t next = take_below ? --below : above++;
      if (!without.has(next)) order.push_back(next);
    }
    return order;
  }

  // By the order of polynomials at which predictions change least.
  [[nodiscard]] Residual residual(std::size_t i, const LeftOut& without) const {
    const std::vector<std::size_t> order = around(i, without);
    Residual best;
    if (order.size() < fewest_) return best;
    std::array<OrbitState, radar::max_polynomial_states> sums;
    radar::polynomial_sums(states_, order, states_.time_s[i], std::span(sums).first(order.size()));
    const double step_s = 0.25 * std::abs(states_.time_s[order[0]] - states_.time_s[i]);
    const bool moving = !states_.velocity_mps.empty();
    best.position_doubt_m = best.velocity_doubt_m = std::numeric_limits<double>::infinity();
    const auto change = [&](std::size_t k, auto member) {
      return core::norm(sums[k].*member - sums[k - 1].*member) + core::norm(sums[k - 1].*member - sums[k - 2].*member);
    };
    for (std::size_t k = 2; k < order.size(); ++k) {
      const double position_doubt_m = change(k, &OrbitState::position_m);
      if (position_doubt_m < best.position_doubt_m) {
        best.position_doubt_m = position_doubt_m;
        best.position_m = core::norm(states_.position_m[i] - sums[k].position_m);
      }
      const double velocity_doubt_m = step_s * change(k, &OrbitState::velocity_mps);
      if (!moving || !(velocity_doubt_m < best.velocity_doubt_m)) continue;
      best.velocity_doubt_m = velocity_doubt_m;
      best.velocity_mps = core::norm(states_.velocity_mps[i] - sums[k].velocity_mps);
      best.velocity_m = step_s * best.velocity_mps;
    }
    return best;
  }

  // Vehicles bend their paths within a step, which looks the same where it is done by the force that they have;
  // satellites do not.
  [[nodiscard]] bool could_be_flown(std::size_t i, const Residual& r) const {
    constexpr double satellite_mps = 3000.0;
    constexpr double max_mps2 = 10.0;
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, count_ - 1);
    const double length_s = states_.time_s[after] - states_.time_s[before];
    const double step_s = length_s / static_cast<double>(after - before);
    const double moved_m = core::norm(states_.position_m[after] - states_.position_m[before]);
    if (moved_m > satellite_mps * length_s) return false;
    // The ends are predicted from one side: a bend there looks like a jump.
    const double step_m = step_s * moved_m / length_s;
    if (i < 3 || i + 3 >= count_) return r.position_m < 5.0 * step_m && r.velocity_mps * step_s < 5.0 * step_m;
    return std::max(2.0 * r.position_m / (step_s * step_s), r.velocity_mps / step_s) < max_mps2;
  }

  // Above 1 where a state does not fit.
  [[nodiscard]] double excess(const Residual& r) const {
    constexpr double doubts = 5.0;
    return std::max(r.position_m / (doubts * r.position_doubt_m + noise_m_),
                    r.velocity_m / (doubts * r.velocity_doubt_m + noise_m_));
  }

  [[nodiscard]] std::size_t worst_of(const std::vector<Residual>& all, const std::vector<char>& unexplained) const {
    std::size_t worst = no_state;
    double max_m = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      const double off_m = std::max(all[i].position_m, all[i].velocity_m);
      if (odd_[i] != 0 || unexplained[i] != 0 || !(off_m > max_m) || !(excess(all[i]) > 1.0)) continue;
      worst = i;
      max_m = off_m;
    }
    return worst;
  }

  // How badly the states around fit without a run of them, and whether the run itself does not fit.
  [[nodiscard]] double misfit_without(const LeftOut& run) const {
    double worst = 0.0;
    double off_m = 0.0;
    double of_run_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = low(run.first); i < high(run.first + run.count - 1); ++i) {
      if (odd_[i] != 0) continue;
      const Residual r = residual(i, run);
      const double one_m = std::max(r.position_m, r.velocity_m);
      if (i >= run.first && i - run.first < run.count) {
        of_run_m = std::min(of_run_m, excess(r) > 1.0 ? one_m : 0.0);
        continue;
      }
      worst = std::max(worst, excess(r));
      off_m = std::max(off_m, one_m);
    }
    // Where it is the states that bend, those around fit no better without it.
    return of_run_m > 5.0 * off_m ? worst : std::numeric_limits<double>::infinity();
  }

  // The shortest run near a state without which all others fit; no_state where there is no_state.
  [[nodiscard]] LeftOut culprit_around(std::size_t worst) const {
    for (const std::size_t length : {1U, 2U, 3U}) {
      LeftOut best{&odd_};
      double least = 1.0;
      for (std::size_t first = worst > 3 ? worst - 3 : 0; first <= worst + 3 && first + length <= count_; ++first) {
        const LeftOut run{&odd_, first, length};
        const double misfit = misfit_without(run);
        if (!(misfit < least)) continue;
        least = misfit;
        best = run;
      }
      if (best.count > 0) return best;
    }
    return {&odd_};
  }

  const StateView& states_;
  std::size_t count_;
  std::size_t max_;
  std::size_t fewest_;
  std::vector<char> odd_;
  double noise_m_ = min_off_m;
};

std::optional<VelocityMismatch> mismatch_of(const StateView& states) {
  const std::size_t count = std::min(states.time_s.size(), max_compared);
  if (states.velocity_mps.empty() || count < 5) return std::nullopt;
  const StateView positions{states.time_s, states.position_m, {}};
  double moved_m = 0.0, together = 0.0, apart = 0.0;
  std::size_t wrong = 0;
  Vec3 before;
  VelocityMismatch worst;
  const std::size_t compared = count - 4;
  for (std::size_t i = 2; i + 2 < count; ++i) {
    const std::vector<std::size_t> order = radar::neighbours_of(i, i > 2 ? i - 3 : 0, std::min(count, i + 4), 7);
    std::array<OrbitState, radar::max_polynomial_states> sums;
    radar::polynomial_sums(positions, order, states.time_s[i], std::span(sums).first(order.size()));
    const Vec3& slope = sums[order.size() - 1].velocity_mps;
    const Vec3 difference = states.velocity_mps[i] - slope;
    const double one = core::norm(difference);
    const double doubt = core::norm(slope - sums[order.size() - 3].velocity_mps);
    if (one > 3.0 * doubt + 1e-3 * core::norm(slope)) ++wrong;
    moved_m += one * (states.time_s[i + 1] - states.time_s[i]) / 8.0;
    together += core::dot(difference, before);
    apart += one * core::norm(before);
    before = difference;
    if (one > worst.off_mps) worst = {i, one, core::norm(states.velocity_mps[i]), core::norm(slope)};
  }
  const bool one_way = compared < 3 || together > 0.5 * apart;
  const bool large = 2 * wrong > compared && moved_m > min_off_m * static_cast<double>(compared);
  return one_way && large ? std::optional(worst) : std::nullopt;
}

}  // namespace

SampleSteps steps_of(std::span<const double> time_s) {
  SampleSteps steps;
  if (time_s.size() < 3) return steps;
  std::vector<double> steps_s;
  steps_s.reserve(time_s.size());
  for (std::size_t i = 1; i < time_s.size(); ++i) steps_s.push_back(time_s[i] - time_s[i - 1]);
  steps.usual_s = median(steps_s);
  const auto is_usual = [&](double step_s) { return std::abs(step_s - steps.usual_s) <= 0.01 * steps.usual_s; };
  const auto equal = static_cast<std::size_t>(std::ranges::count_if(steps_s, is_usual));
  double max_s = 1.9 * steps.usual_s;
  if (equal * 10 < steps_s.size() * 8) {
    std::vector<double> sorted = steps_s;
    const auto ninth = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 9 / 10);
    std::ranges::nth_element(sorted, ninth);
    max_s = std::max(4.0 * steps.usual_s, 3.0 * *ninth);
  }
  for (std::size_t i = 0; i < steps_s.size(); ++i)
    if (steps_s[i] > max_s) steps.gaps.push_back({i, steps_s[i]});
  return steps;
}

StateFindings examine_states(const StateView& states) {
  StateFindings findings;
  findings.steps = steps_of(states.time_s);
  findings.velocities = mismatch_of(states);
  if (findings.velocities) return findings;
  findings.odd = Comparer(states).odd_states();
  return findings;
}

}  // namespace sarsim::scene::ephemeris
