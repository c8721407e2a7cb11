#include "simulate/survey/ambiguity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/maths/decibels.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::simulate {

namespace {

class OtherPulseRules {
 public:
  OtherPulseRules(const Plan& plan, const EchoSurvey& survey, std::size_t index, const std::string& scope,
                  core::Problems& problems)
      : plan_(plan), survey_(survey), index_(index), scope_(scope), problems_(problems) {}

  // From orbit, where many pulses are under way at once, a lower PRF is not useful advice: a real receiver listens
  // between later pulses.
  void check_late() {
    if (survey_.totals.late == 0) return;
    const double unambiguous_m = unambiguous_range_m(plan_);
    const double under_way = std::floor(survey_.totals.latest_m / unambiguous_m);
    const bool from_afar = under_way >= 3.0;
    const bool own_alone = plan_.scene->conventions.reception == Conventions::Reception::own_pulse;
    add(from_afar ? core::Severity::note : core::Severity::warning,
        fmt::format("echoes of {} of {} targets arrive after the next pulse has left{}", survey_.totals.late,
                    survey_.targets.size(), own_alone ? "; a row holds the echoes of its own pulse only" : "") +
            scope_,
        fmt::format("range {:.6g} m", survey_.totals.latest_m),
        fmt::format("at most {:.6g} m, the unambiguous range", unambiguous_m),
        from_afar ? fmt::format("{:.0f} pulses are under way at once, as is usual from orbit: a real receiver listens "
                                "between later pulses; choose the PRF so that no pulse leaves while echoes arrive",
                                under_way)
                  : "lower the PRF if a real receiver is meant");
  }

  void check_heard() {
    const scene::AmbiguousEchoes which = plan_.scene->options.ambiguous_echoes;
    const bool left_out = which == scene::AmbiguousEchoes::none;
    const OtherPulses heard = left_out
                                  ? heard_pulses(*plan_.scene, plan_.radar, plan_.pulse, plan_.raw_grid, plan_.pulses)
                                  : plan_.other_pulses;
    if (heard.farther > 0.0)
      add(core::Severity::warning,
          fmt::format("echoes of pulses sent more than {} pulses earlier or later are received but left out",
                      most_pulses_away),
          fmt::format("up to {:.0f} dB relative to the strongest echo, antennas ignored",
                      core::amplitude_db(heard.farther)),
          "", "lower the PRF, or move the targets");
    if (heard.pulses.empty()) return;
    const OtherPulse& strongest = *std::ranges::max_element(heard.pulses, {}, &OtherPulse::strength);
    const std::string level = strongest.strength < 1.0
                                  ? fmt::format("up to {:.0f} dB relative to the strongest echo, antennas ignored",
                                                core::amplitude_db(strongest.strength))
                                  : "the strongest echo is among them, antennas ignored";
    if (left_out)
      add(core::Severity::note, fmt::format("echoes of {} would reach the window and are left out", pulses_of(heard)),
          level, "", "AMBIGUOUS_ECHOES STRONG or ALL in $OPTIONS adds them");
    else
      add(which == scene::AmbiguousEchoes::all ? core::Severity::note : core::Severity::warning,
          fmt::format("rows also hold echoes of {}, which appear at false ranges", pulses_of(heard)), level, "",
          "change the PRF or the window; AMBIGUOUS_ECHOES ALL in $OPTIONS says that they are meant, NONE leaves them "
          "out");
  }

  void check_eclipsed() {
    const std::size_t targets = static_cast<std::size_t>(
        std::ranges::count_if(survey_.targets, [this](const TargetSurvey& t) { return t.in_window && eclipsed(t); }));
    if (targets == 0) return;
    const bool blanked = plan_.scene->options.eclipsing == scene::Eclipsing::blanked;
    add(core::Severity::note,
        fmt::format("echoes of {} of {} targets arrive while the radar sends{}", targets, survey_.targets.size(),
                    blanked ? " and are cut" : "; the receiver is taken to go on") +
            scope_,
        "", "",
        blanked ? "change the PRF or the pulse width"
                : "ECLIPSING BLANKED in $OPTIONS makes samples 0 while the radar sends");
  }

 private:
  // "the 2 pulses before and the pulse after theirs"
  [[nodiscard]] static std::string pulses_of(const OtherPulses& heard) {
    std::int64_t before = 0;
    std::int64_t after = 0;
    for (const OtherPulse& other : heard.pulses) {
      before = std::max(before, other.back);
      after = std::max(after, -other.back);
    }
    const auto sent = [](std::int64_t count, const char* where) {
      return count == 1 ? fmt::format("the pulse {}", where) : fmt::format("pulses up to {} {}", count, where);
    };
    if (after == 0) return sent(before, "before theirs");
    if (before == 0) return sent(after, "after theirs");
    return sent(before, "before") + " and " + sent(after, "after theirs");
  }

  // Whether a pulse leaves while an echo arrives, anywhere between its nearest and its farthest place.
  [[nodiscard]] bool eclipsed(const TargetSurvey& target) const {
    const double light_mps = plan_.scene->conventions.light_speed_mps;
    const radar::Repetition& repetition = plan_.radar.repetition;
    const double width_s = plan_.radar.pulse.width_s;
    const double first_s = radar::delay_of(target.nearest_m, light_mps) - width_s;
    const double last_s = radar::delay_of(target.farthest_m, light_mps) + width_s;
    const double sent_s = repetition.send_time_s(plan_.pulses.first);
    return repetition.pulses_in(sent_s + first_s, sent_s + last_s).count() > 0;
  }

  void add(core::Severity severity, std::string message, std::string found, std::string expected, std::string hint) {
    core::Problem problem =
        core::problem_of(severity, std::move(message), std::move(found), std::move(expected), std::move(hint));
    problem.subject = {"simulation", index_, "radar"};
    problems_.push_back(std::move(problem));
  }

  const Plan& plan_;
  const EchoSurvey& survey_;
  std::size_t index_;
  const std::string& scope_;
  core::Problems& problems_;
};

}  // namespace

void check_other_pulses(const Plan& plan, const EchoSurvey& survey, std::size_t index, const std::string& scope,
                        core::Problems& problems) {
  CORE_EXPECT(plan.scene != nullptr);
  OtherPulseRules rules(plan, survey, index, scope, problems);
  rules.check_late();
  rules.check_heard();
  rules.check_eclipsed();
}

}  // namespace sarsim::simulate
