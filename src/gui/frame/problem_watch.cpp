#include "gui/frame/problem_watch.hpp"

#include "scene/script/reader.hpp"
#include "simulate/survey/survey.hpp"
#include "workflow/check/command_remarks.hpp"
#include "workflow/input/cloud_input.hpp"
#include "workflow/input/echo_words.hpp"

namespace sarsim::gui {

namespace {

// Commands that are typed half, and values on their way, are nobody's problems.
constexpr int rest_ms = 1000;

}  // namespace

ProblemWatch::ProblemWatch(Session& session, QObject* parent) : QObject(parent), session_(session) {
  rest_.setSingleShot(true);
  connect(&rest_, &QTimer::timeout, this, &ProblemWatch::look);
  connect(&survey_, &LatestOnlyWork::ended, this, [this](bool good) { take_survey(good); });
  connect(&session_, &Session::document_replaced, this, &ProblemWatch::begin_document);
  connect(&session_, &Session::document_closed, this, [this](int number) { surveyed_.erase(number); });
  connect(&session_, &Session::scene_changed, this, &ProblemWatch::wait_for_rest);
  connect(&session_, &Session::problems_changed, this, &ProblemWatch::wait_for_rest);
  wait_for_rest();
}

QString ProblemWatch::echoes() const {
  const auto found = surveyed_.find(session_.number());
  return found == surveyed_.end() ? QString() : found->second.echoes;
}

void ProblemWatch::begin_document() {
  survey_.cancel();
  fresh_ = true;
  wait_for_rest();
}

// A document that was just opened does not change under anybody's hand.
void ProblemWatch::wait_for_rest() { rest_.start(fresh_ ? 0 : rest_ms); }

void ProblemWatch::look() {
  fresh_ = false;
  if (core::has_errors(session_.problems())) {
    survey_.cancel();
  } else if (session_.scene().simulations.empty()) {
    survey_.cancel();
    surveyed_[session_.number()].problems.clear();
  } else {
    look_at_echoes();
  }
  collect();
}

void ProblemWatch::look_at_echoes() {
  auto scene = session_.shared_scene();
  found_ = std::make_shared<Found>();
  survey_.run([scene = std::move(scene), found = found_](const core::StopFlag& stop, const BackgroundJob::Report&) {
    const core::WorkControl control{1, &stop};
    const auto resolved = simulate::thinned(
        std::make_shared<const simulate::ResolvedScene>(simulate::resolve(*scene, control)), workflow::max_cloud_looks);
    simulate::SurveyReport report = simulate::survey_report(*scene, resolved, control);
    found->problems = std::move(report.problems);
    if (!core::has_errors(found->problems))
      core::append(found->problems, workflow::diagnose_commands(*scene, resolved, control));
    for (const simulate::EchoSummary& summary : report.summaries)
      found->echoes += QString::fromStdString(workflow::echo_text(*scene, summary));
  });
}

// A scene that changed meanwhile is surveyed once it rests. Where a survey fails a run fails too, and says why.
void ProblemWatch::take_survey(bool good) {
  if (rest_.isActive()) return;
  surveyed_[session_.number()] = good ? *found_ : Found{};
  collect();
}

void ProblemWatch::collect() {
  problems_ = session_.problems();
  if (!core::has_errors(problems_)) {
    of_echoes_ = surveyed_[session_.number()].problems;
    scene::locate(of_echoes_, session_.document().places());
    core::append(problems_, of_echoes_);
    problems_ = core::ranked(std::move(problems_));
  }
  emit changed();
}

}  // namespace sarsim::gui
