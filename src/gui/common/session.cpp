#include "gui/common/session.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "workflow/input/motion_input.hpp"

namespace sarsim::gui {

namespace {

// A hand that rests as long has paused.
constexpr int pause_ms = 150;

}  // namespace

Session::Session(QObject* parent) : QObject(parent) {
  problems_soon_.setSingleShot(true);
  problems_soon_.setInterval(pause_ms);
  connect(&problems_soon_, &QTimer::timeout, this, &Session::find_put_off_problems);
  look_for_problems();
}

std::shared_ptr<const scene::Scene> Session::shared_scene() const {
  if (shared_ == nullptr) shared_ = std::make_shared<const scene::Scene>(scene());
  return shared_;
}

void Session::take(scene::Document document) {
  document_ = std::move(document);
  document_.read_files_with([](scene::Scene& scene, const std::filesystem::path& folder) {
    return workflow::read_files_of(scene, folder, {core::thread_count(0)});
  });
  shared_.reset();
  selection_.clear();
  current_.reset();
  hidden_.clear();
  time_s_ = 0.0;
  look_for_problems();
  emit document_replaced();
  emit time_changed(time_s_);
  emit hidden_changed();
  emit selection_changed();
  scene::SceneChange change;
  change.everything = true;
  emit scene_changed(change);
}

void Session::perform(scene::Edit edit) {
  if (edit.changes.empty() && !edit.options_after && !edit.world_after && !edit.air_after) return;
  const bool in_run = !edit.merge_key.empty();
  const std::uint64_t revision = document_.revision();
  scene::SceneChange change = scene::change_of(edit);
  document_.perform(std::move(edit));
  if (in_run)
    problems_soon_.stop();
  else
    look_for_problems();
  log_replaced_expressions();
  // Also where nothing came of it: a window shows what was asked for and has to go back.
  if (document_.revision() != revision) change = follow_last_edit();
  emit scene_changed(change);
  if (in_run) problems_soon_.start();  // The pause counts from when the windows have followed.
}

void Session::end_run() {
  document_.end_run();
  if (problems_soon_.isActive()) find_put_off_problems();
}

void Session::type_text(const std::string& text) {
  const std::uint64_t revision = document_.revision();
  document_.type_text(text);
  if (document_.revision() == revision) return;
  look_for_problems();
  emit scene_changed(follow_last_edit());
}

void Session::undo() {
  if (!document_.history().can_undo()) return;
  document_.undo();
  look_for_problems();
  emit scene_changed(follow_last_edit());
}

void Session::take_back() {
  if (!document_.history().can_undo()) return;
  document_.take_back();
  look_for_problems();
  emit scene_changed(follow_last_edit());
}

void Session::redo() {
  if (!document_.history().can_redo()) return;
  document_.redo();
  look_for_problems();
  emit scene_changed(follow_last_edit());
}

void Session::save(const std::filesystem::path& path) {
  document_.save(path);
  emit document_changed();
  find_put_off_problems();  // They name the file, and data files are looked for beside it.
}

void Session::select(std::set<scene::ObjectId> objects) {
  if (objects == selection_) return;
  selection_ = std::move(objects);
  if (!current_ || !selection_.contains(*current_))
    current_ = selection_.empty() ? std::nullopt : std::optional(*selection_.begin());
  emit selection_changed();
}

void Session::select_only(scene::ObjectId object) {
  if (current_ == object && selection_.size() == 1) return;
  selection_ = {object};
  current_ = object;
  emit selection_changed();
}

void Session::select_also(scene::ObjectId object) {
  if (selection_.erase(object) > 0) {
    if (current_ == object) current_ = selection_.empty() ? std::nullopt : std::optional(*selection_.begin());
  } else {
    selection_.insert(object);
    current_ = object;
  }
  emit selection_changed();
}

void Session::set_hidden(const std::set<scene::ObjectId>& objects, bool hide) {
  for (const scene::ObjectId& id : objects) {
    if (hide)
      hidden_.insert(id);
    else
      hidden_.erase(id);
  }
  emit hidden_changed();
}

void Session::set_time(double time_s) {
  if (!std::isfinite(time_s) || time_s == time_s_) return;
  time_s_ = time_s;
  emit time_changed(time_s_);
}

void Session::log(core::Severity severity, const QString& text) { emit logged(static_cast<int>(severity), text); }

void Session::log_replaced_expressions() {
  constexpr std::size_t most = 3;
  const std::vector<scene::ReplacedExpression>& replaced = document_.replaced_expressions();
  for (std::size_t i = 0; i < std::min(replaced.size(), most); ++i) {
    const auto& [object, field, expression] = replaced[i];
    const std::string value = object ? scene::field_text(scene::object_of(scene(), *object), field->id)
                                     : scene::field_text(scene().options, field->id);
    log(core::Severity::note,
        tr("%1, %2: the expression %3 was replaced by %4")
            .arg(object ? QString::fromStdString(scene::label_of(scene(), *object)) : tr("Options"),
                 QString::fromStdString(field->label), QString::fromStdString(expression),
                 QString::fromStdString(value)));
  }
  if (replaced.size() > most)
    log(core::Severity::note, tr("and %n more expression(s)", nullptr, static_cast<int>(replaced.size() - most)));
}

// Keeps pointing at the same objects where an edit moved them.
scene::SceneChange Session::follow_last_edit() {
  const auto& last = document_.last_edit();
  if (!last) return {};
  scene::SceneChange change = scene::change_of(last->edit, last->forwards);
  if (!change.empty()) shared_.reset();
  if (change.same_objects()) return change;
  const auto follow = [&](const std::set<scene::ObjectId>& ids) {
    std::set<scene::ObjectId> there = scene::moved(ids, last->edit, last->forwards);
    std::erase_if(there, [&](scene::ObjectId id) { return !scene::has_object(scene(), id); });
    return there;
  };
  hidden_ = follow(hidden_);
  const auto current = current_ ? scene::moved(*current_, last->edit, last->forwards) : std::nullopt;
  const std::set<scene::ObjectId> selected = follow(selection_);
  current_ = current && selected.contains(*current) ? current : std::nullopt;
  if (!current_ && !selected.empty()) current_ = *selected.begin();
  const bool same = selected == selection_;
  selection_ = selected;
  if (!same) emit selection_changed();
  return change;
}

void Session::look_for_problems() {
  problems_soon_.stop();
  problems_ = document_.problems();
}

void Session::find_put_off_problems() {
  look_for_problems();
  emit problems_changed();
}

}  // namespace sarsim::gui
