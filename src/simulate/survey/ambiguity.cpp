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

class RangeAmbiguityRules {
 public:
  RangeAmbiguityRules(const Acquisition& acquisition, const RangeAmbiguities& all, const EchoSurvey& survey,
                      std::size_t index, const std::string& scope, core::Problems& problems)
      : acquisition_(acquisition), all_(all), survey_(survey), index_(index), scope_(scope), problems_(problems) {}

  // One statement of echoes that are late and of what that does to rows: of targets whose echoes arrive after the next
  // pulse, and of rows that hold echoes of other pulses.
  void check_ranges() {
    const scene::AmbiguousEchoes which = acquisition_.scene->options.ambiguous_echoes;
    const bool left_out = which == scene::AmbiguousEchoes::none;
    const RangeAmbiguities heard = left_out ? all_ : asked_for(all_, which);
    check_farther(heard);
    if (heard.pulses.empty()) return check_late();
    const bool late = survey_.totals.late > 0;
    const bool asked_for = which == scene::AmbiguousEchoes::all;
    const std::string heard_text =
        left_out ? fmt::format("echoes of {} would fall into the window and are left out", pulses_of(heard))
                 : fmt::format("rows also contain range-ambiguous echoes of {}, at false ranges", pulses_of(heard));
    add(core::ProblemBuilder(
            asked_for || (left_out && !(late && !from_afar())) ? core::Severity::note : core::Severity::warning,
            late ? core::RuleId("echoes.late") : core::RuleId("echoes.of-other-pulses"),
            late ? late_text() + ": " + heard_text + scope_ : heard_text)
            .found(late ? late_range() + "; " + level_of(heard) : level_of(heard))
            .expected(late ? unambiguous_text() : "")
            .hint(left_out ? "AMBIGUOUS_ECHOES STRONG or ALL in $OPTIONS adds them"
                           : "change the PRF or the window; set AMBIGUOUS_ECHOES ALL in $OPTIONS to keep them without "
                             "this warning, NONE to drop them"));
  }

  void check_eclipsed() {
    const std::size_t targets = static_cast<std::size_t>(
        std::ranges::count_if(survey_.targets, [this](const TargetSurvey& t) { return t.in_window && eclipsed(t); }));
    if (targets == 0) return;
    const bool blanked = acquisition_.scene->options.eclipsing == scene::Eclipsing::blanked;
    add(core::note(
            "echoes.while-sending",
            fmt::format("echoes of {} of {} targets arrive while the radar transmits{}", targets,
                        survey_.targets.size(), blanked ? " and are blanked" : "; the receiver is assumed to stay on") +
                scope_)
            .hint(blanked ? "change the PRF or the pulse width"
                          : "set ECLIPSING BLANKED in $OPTIONS to blank the receiver while the radar transmits"));
  }

 private:
  // How many pulses are under way at once.
  [[nodiscard]] double under_way() const {
    return std::floor(survey_.totals.latest_m / unambiguous_range_m(acquisition_));
  }
  [[nodiscard]] bool from_afar() const { return under_way() >= 3.0; }

  [[nodiscard]] std::string late_text() const {
    return fmt::format("echoes of {} of {} targets arrive after the next pulse has left", survey_.totals.late,
                       survey_.targets.size());
  }
  [[nodiscard]] std::string late_range() const {
    const std::string text = fmt::format("range {:.6g} m", survey_.totals.latest_m);
    return from_afar() ? text + fmt::format(", {:.0f} pulses are in flight at once", under_way()) : text;
  }
  [[nodiscard]] std::string unambiguous_text() const {
    return fmt::format("at most {:.6g} m, the unambiguous range", unambiguous_range_m(acquisition_));
  }

  // From orbit, where many pulses are under way at once, a lower PRF is not useful advice.
  void check_late() {
    if (survey_.totals.late == 0) return;
    const bool own_alone = acquisition_.scene->conventions.reception == Conventions::Reception::own_pulse;
    add(core::ProblemBuilder(
            from_afar() ? core::Severity::note : core::Severity::warning, "echoes.late",
            late_text() + (own_alone ? "; a row contains the echoes of its own pulse only" : "") + scope_)
            .found(late_range())
            .expected(unambiguous_text())
            .hint(from_afar() ? "normal from orbit; choose the PRF so that no pulse is sent while echoes arrive"
                              : "lower the PRF, or move the targets"));
  }

  void check_farther(const RangeAmbiguities& heard) {
    if (!(heard.farther > 0.0)) return;
    add(core::warning("echoes.left-out", fmt::format("range-ambiguous echoes of pulses sent more than "
                                                     "{} pulses earlier or later are received but left out",
                                                     max_pulses_away))
            .found(fmt::format("up to {:.0f} dB relative to the strongest echo, antenna patterns not applied",
                               core::amplitude_db(heard.farther)))
            .hint("lower the PRF, or move the targets"));
  }

  [[nodiscard]] static std::string level_of(const RangeAmbiguities& heard) {
    const RangeAmbiguity& strongest = *std::ranges::max_element(heard.pulses, {}, &RangeAmbiguity::strength);
    if (strongest.strength >= 1.0) return "the strongest echo is among them, antenna patterns not applied";
    return fmt::format("up to {:.0f} dB relative to the strongest echo, antenna patterns not applied",
                       core::amplitude_db(strongest.strength));
  }

  // "the 2 pulses before and the pulse after their own"
  [[nodiscard]] static std::string pulses_of(const RangeAmbiguities& heard) {
    std::int64_t before = 0;
    std::int64_t after = 0;
    for (const RangeAmbiguity& other : heard.pulses) {
      before = std::max(before, other.back);
      after = std::max(after, -other.back);
    }
    const auto sent = [](std::int64_t count, const char* where) {
      return count == 1 ? fmt::format("the pulse {}", where) : fmt::format("pulses up to {} {}", count, where);
    };
    if (after == 0) return sent(before, "before their own");
    if (before == 0) return sent(after, "after their own");
    return sent(before, "before") + " and " + sent(after, "after their own");
  }

  // Whether a pulse leaves while an echo arrives, anywhere between its nearest and its farthest place.
  [[nodiscard]] bool eclipsed(const TargetSurvey& target) const {
    const double light_mps = acquisition_.light_speed_mps();
    const radar::Repetition& repetition = acquisition_.link.repetition;
    const double width_s = acquisition_.link.pulse.width_s;
    const double first_s = radar::delay_of(target.nearest_m, light_mps) - width_s;
    const double last_s = radar::delay_of(target.farthest_m, light_mps) + width_s;
    const double sent_s = repetition.send_time_s(acquisition_.timing.pulses.first);
    return repetition.pulses_in(sent_s + first_s, sent_s + last_s).count() > 0;
  }

  void add(core::ProblemBuilder problem) { problems_.push_back(std::move(problem).at("simulation", index_, "radar")); }

  const Acquisition& acquisition_;
  const RangeAmbiguities& all_;  // that are heard, wanted or not
  const EchoSurvey& survey_;
  std::size_t index_;
  const std::string& scope_;
  core::Problems& problems_;
};

}  // namespace

void check_range_ambiguities(const Acquisition& acquisition, const RangeAmbiguities& all, const EchoSurvey& survey,
                             std::size_t index, const std::string& scope, core::Problems& problems) {
  CORE_EXPECT(acquisition.scene != nullptr);
  RangeAmbiguityRules rules(acquisition, all, survey, index, scope, problems);
  rules.check_ranges();
  rules.check_eclipsed();
}

}  // namespace sarsim::simulate
