#include "gui/common/session.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <utility>

#include "gui/common/waiting.hpp"
#include "workflow/input/motion_input.hpp"

namespace sarsim::gui {

namespace {

// A hand that rests as long has paused.
constexpr int pause_ms = 150;

// Shorter ones are read in a moment.
constexpr std::size_t long_text_bytes = 300'000;

// Fewer are changed in a moment.
constexpr std::size_t many_objects = 10'000;

// What an edit names that came to nothing.
scene::SceneChange as_it_was(const scene::Edit& edit, const scene::Scene& scene) {
  scene::SceneChange change = scene::change_of(edit);
  change.removed.clear();
  change.inserted.clear();
  std::erase_if(change.changed,
                [&](const scene::ChangedObject& object) { return !scene::has_object(scene, object.id); });
  return change;
}

}  // namespace

Session::Session(QObject* parent) : QObject(parent) {
  problems_soon_.setSingleShot(true);
  problems_soon_.setInterval(pause_ms);
  connect(&problems_soon_, &QTimer::timeout, this, &Session::find_put_off_problems);
  connect(&search_, &LatestOnlyWork::ended, this, &Session::take_search);
  desks_.push_back(desk_with(scene::Document()));
  desk_ = desks_.front().get();
}

Session::~Session() = default;

std::size_t Session::at_hand() const {
  const auto found = std::ranges::find(desks_, desk_, &std::unique_ptr<Desk>::get);
  return static_cast<std::size_t>(found - desks_.begin());
}

std::unique_ptr<Session::Desk> Session::desk_with(scene::Document document) {
  auto desk = std::make_unique<Desk>();
  desk->number = ++last_number_;
  desk->document = std::move(document);
  desk->document.read_files_with([](scene::Scene& scene, const std::filesystem::path& folder) {
    return workflow::read_files_of(scene, folder, {core::thread_count(0)});
  });
  return desk;
}

void Session::show_desk(Desk& desk) {
  desk_ = &desk;
  ++selection_number_;
  look_for_problems();  // of one that was left they are known, but for a long text that was left in the middle
  emit document_replaced();
  scene::SceneChange change;
  change.everything = true;
  emit scene_changed(change);
  // Of this scene, which by now everybody knows.
  emit time_changed(desk.time_s);
  emit hidden_changed();
  emit selection_changed();
}

void Session::add(scene::Document document) {
  end_run();
  const auto place = desks_.begin() + static_cast<std::ptrdiff_t>(at_hand()) + 1;
  Desk& desk = **desks_.insert(place, desk_with(std::move(document)));
  emit row_changed();
  show_desk(desk);
}

void Session::take(scene::Document document) {
  problems_soon_.stop();
  const std::size_t index = at_hand();
  const std::unique_ptr<Desk> gone = std::exchange(desks_[index], desk_with(std::move(document)));
  show_desk(*desks_[index]);
  emit document_closed(gone->number);
  emit row_changed();
}

void Session::turn_to(std::size_t index) {
  if (index == at_hand()) return;
  end_run();
  show_desk(*desks_.at(index));
}

void Session::move(std::size_t from, std::size_t to) {
  if (from == to) return;
  if (to >= desks_.size()) throw std::out_of_range("there is no such position in the list of documents");
  std::unique_ptr<Desk> desk = std::move(desks_.at(from));
  desks_.erase(desks_.begin() + static_cast<std::ptrdiff_t>(from));
  desks_.insert(desks_.begin() + static_cast<std::ptrdiff_t>(to), std::move(desk));
  emit row_changed();
}

void Session::close(std::size_t index) {
  if (desks_.size() == 1) return take(scene::Document());
  if (index == at_hand()) turn_to(index + 1 < desks_.size() ? index + 1 : index - 1);
  const std::unique_ptr<Desk> gone = std::move(desks_.at(index));
  desks_.erase(desks_.begin() + static_cast<std::ptrdiff_t>(index));
  emit document_closed(gone->number);
  emit row_changed();
}

void Session::perform(scene::Edit wanted) {
  if (wanted.changes.empty() && !wanted.options_after && !wanted.world_after && !wanted.air_after) return;
  const bool in_run = !wanted.merge_key.empty();
  const std::uint64_t revision = desk_->document.revision();
  const auto edit = std::make_shared<const scene::Edit>(std::move(wanted));
  change_document(*edit, [edit](scene::Document& document) { document.perform(*edit); });
  if (in_run)
    problems_soon_.stop();
  else
    look_for_problems();
  log_replaced_expressions();
  // Also where nothing came of it: a window shows what was asked for and has to go back.
  tell(desk_->document.revision() == revision ? Followed{as_it_was(*edit, scene())} : follow_last_edit());
  if (in_run) problems_soon_.start();  // The pause counts from when the windows have followed.
}

std::string Session::make_and_perform(const QString& what, std::size_t objects, const MakeEdit& make) {
  scene::Edit edit;
  if (objects < many_objects) {
    std::string why = make(desk_->document, edit);
    if (why.empty()) perform(std::move(edit));
    return why;
  }
  // Work that is given up goes on with these.
  struct Making {
    scene::Document document;
    scene::Edit edit;
    std::string why;
  };
  const int number = desk_->number;
  const std::uint64_t revision = desk_->document.revision();
  const auto making = std::make_shared<Making>();
  making->document = desk_->document;
  const Waited waited = run_and_wait(what, [making, make](const core::StopFlag&, const BackgroundJob::Report&) {
    making->why = make(making->document, making->edit);
  });
  if (waited.end == JobEnd::cancelled) {
    log(core::Severity::note, tr("%1 was cancelled").arg(what));
    tell({});  // A window shows what was asked for and has to go back.
    return {};
  }
  if (waited.end == JobEnd::failed) return waited.failure.toStdString();
  if (desk_->number != number || desk_->document.revision() != revision) return "the scene was changed meanwhile";
  if (making->why.empty()) perform(std::move(making->edit));
  return making->why;
}

void Session::change_document(const scene::Edit& step, const Change& change) {
  if (step.changes.size() < many_objects)
    change(desk_->document);
  else
    change_beside(step.label, change);
}

// On a thread of its own. Where a timer has changed the document meanwhile it is made again, if it still fits.
void Session::change_beside(const std::string& label, const Change& change) {
  const int number = desk_->number;
  const std::uint64_t revision = desk_->document.revision();
  const auto made = std::make_shared<scene::Document>(desk_->document);
  const QString what = QString::fromStdString(label);
  const Waited waited = run_and_wait(what, [made, change](const core::StopFlag&, const BackgroundJob::Report& report) {
    // Shares of the time, roughly.
    change(*made);
    report(0.5);
    // What windows ask for at once.
    static_cast<void>(made->problems());
    report(0.9);
    static_cast<void>(made->commands());
  });
  if (waited.end == JobEnd::cancelled) return log(core::Severity::note, tr("%1 was cancelled").arg(what));
  try {
    if (desk_->number != number) throw std::runtime_error(tr("another scene was opened meanwhile").toStdString());
    if (desk_->document.revision() != revision) return change(desk_->document);
    if (waited.end == JobEnd::failed) throw std::runtime_error(waited.failure.toStdString());
    desk_->document = std::move(*made);
  } catch (const std::exception& error) {
    log(core::Severity::error, tr("%1 was not done: %2").arg(what, QString::fromUtf8(error.what())));
  }
}

void Session::end_run() {
  desk_->document.end_run();
  if (problems_soon_.isActive()) find_put_off_problems();
}

void Session::type_text(const std::string& text) {
  const std::uint64_t revision = desk_->document.revision();
  desk_->document.type_text(text);
  if (desk_->document.revision() == revision) return;
  look_for_problems();
  tell(follow_last_edit());
}

void Session::undo() {
  take_step(desk_->document.history().next_undo(), [](scene::Document& document) { document.undo(); });
}

void Session::take_back() {
  take_step(desk_->document.history().next_undo(), [](scene::Document& document) { document.take_back(); });
}

void Session::redo() {
  take_step(desk_->document.history().next_redo(), [](scene::Document& document) { document.redo(); });
}

// Backwards or forwards in the history; null where that ends.
void Session::take_step(const scene::Edit* step, const Change& change) {
  if (step == nullptr) return;
  const std::uint64_t revision = desk_->document.revision();
  change_document(*step, change);
  if (desk_->document.revision() == revision) return;
  look_for_problems();
  tell(follow_last_edit());
}

void Session::save(const std::filesystem::path& path) {
  desk_->document.save(path);
  emit document_changed();
  find_put_off_problems();  // They name the file, and data files are looked for beside it.
}

void Session::select(std::set<scene::ObjectId> objects) {
  std::erase_if(objects, [this](scene::ObjectId id) { return !scene::has_object(scene(), id); });
  if (objects == desk_->selection) return;
  take_selection(std::move(objects));
  if (!desk_->current || !desk_->selection.contains(*desk_->current))
    desk_->current = desk_->selection.empty() ? std::nullopt : std::optional(*desk_->selection.begin());
  emit selection_changed();
}

void Session::select_only(scene::ObjectId object) {
  if (desk_->current == object && desk_->selection.size() == 1) return;
  take_selection({object});
  desk_->current = object;
  emit selection_changed();
}

void Session::select_also(scene::ObjectId object) {
  ++selection_number_;
  if (desk_->selection.erase(object) > 0) {
    if (desk_->current == object)
      desk_->current = desk_->selection.empty() ? std::nullopt : std::optional(*desk_->selection.begin());
  } else {
    desk_->selection.insert(object);
    desk_->current = object;
  }
  emit selection_changed();
}

void Session::set_hidden(const std::set<scene::ObjectId>& objects, bool hide) {
  for (const scene::ObjectId& id : objects) {
    if (hide)
      desk_->hidden.insert(id);
    else
      desk_->hidden.erase(id);
  }
  emit hidden_changed();
}

void Session::set_time(double time_s) {
  if (!std::isfinite(time_s) || time_s == desk_->time_s) return;
  desk_->time_s = time_s;
  emit time_changed(desk_->time_s);
}

void Session::log(core::Severity severity, const QString& text) { emit logged(static_cast<int>(severity), text); }

void Session::log_replaced_expressions() {
  constexpr std::size_t most = 3;
  const std::vector<scene::ReplacedExpression>& replaced = desk_->document.replaced_expressions();
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
Session::Followed Session::follow_last_edit() {
  const auto& last = desk_->document.last_edit();
  if (!last) return {};
  scene::SceneChange change = scene::change_of(*last->edit, last->forwards);
  if (change.same_objects()) return {std::move(change)};
  const auto follow = [&](const std::set<scene::ObjectId>& ids) {
    std::set<scene::ObjectId> there = scene::moved(ids, *last->edit, last->forwards);
    std::erase_if(there, [&](scene::ObjectId id) { return !scene::has_object(scene(), id); });
    return there;
  };
  desk_->hidden = follow(desk_->hidden);
  const auto current = desk_->current ? scene::moved(*desk_->current, *last->edit, last->forwards) : std::nullopt;
  std::set<scene::ObjectId> selected = follow(desk_->selection);
  desk_->current = current && selected.contains(*current) ? current : std::nullopt;
  if (!desk_->current && !selected.empty()) desk_->current = *selected.begin();
  const bool differs = selected != desk_->selection;
  if (differs) take_selection(std::move(selected));
  return {std::move(change), differs};
}

// Windows know the scene before they hear of a selection in it.
void Session::tell(const Followed& followed) {
  emit scene_changed(followed.change);
  if (followed.selection_differs) emit selection_changed();
}

void Session::take_selection(std::set<scene::ObjectId> objects) {
  desk_->selection = std::move(objects);
  ++selection_number_;
}

void Session::look_for_problems() {
  problems_soon_.stop();
  search_.cancel();
  const scene::Document& document = desk_->document;
  auto search = document.text().size() > long_text_bytes ? document.search() : nullptr;
  if (!search) {
    desk_->problems = document.problems();
    return;
  }
  // Of others than the same objects they would be told.
  const auto& last = document.last_edit();
  if (!last || !scene::keeps_objects(*last->edit)) desk_->problems.clear();
  searched_ = document.revision();
  found_ = std::make_shared<scene::Document::Findings>();
  search_.run([search = std::move(search), found = found_](const core::StopFlag&, const BackgroundJob::Report&) {
    *found = search();
  });
}

// While a run goes on they are looked for again when it pauses.
void Session::take_search(bool good) {
  if (searched_ != desk_->document.revision()) return;
  if (good) desk_->document.take(std::move(*found_), searched_);
  desk_->problems = desk_->document.problems();
  emit problems_changed();
}

void Session::find_put_off_problems() {
  look_for_problems();
  emit problems_changed();
}

}  // namespace sarsim::gui
