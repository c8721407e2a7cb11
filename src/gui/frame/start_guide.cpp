#include "gui/frame/start_guide.hpp"

#include <QAction>
#include <QDir>
#include <QLabel>
#include <QMainWindow>

#include <cmath>
#include <utility>

#include "gui/common/session.hpp"
#include "gui/common/text.hpp"
#include "gui/echo/simulation_windows.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/help_key.hpp"
#include "gui/frame/help_window.hpp"
#include "gui/frame/tool_windows.hpp"
#include "gui/objects/property_panel.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/start/help_headings.hpp"
#include "gui/start/search_box.hpp"
#include "gui/start/tour_panel.hpp"
#include "gui/start/welcome_page.hpp"
#include "scene/edit/edit.hpp"
#include "scene/edit/starting_scenes.hpp"
#include "scene/language/keys.hpp"
#include "scene/schema/fields.hpp"
#include "scene/schema/trade_words.hpp"

namespace sarsim::gui {

namespace {

constexpr scene::ObjectKind kinds_with_fields[] = {
    scene::ObjectKind::radar, scene::ObjectKind::target,     scene::ObjectKind::platform, scene::ObjectKind::surface,
    scene::ObjectKind::cloud, scene::ObjectKind::simulation, scene::ObjectKind::geometry};

bool has_nothing(const scene::Scene& scene) {
  for (const scene::ObjectKind kind : kinds_with_fields)
    if (scene::count_of(scene, kind) > 0) return false;
  return true;
}

QString title_of(scene::ObjectKind kind) {
  QString name = text_of(scene::name_of(kind));
  name[0] = name[0].toUpper();
  return kind == scene::ObjectKind::simulation ? StartGuide::tr("Stored simulation") : name;
}

// "Menu: words", as the list of commands shows it.
QString words_of_command(const QAction& action) {
  QString text = action.text().remove('&').remove(QString::fromUtf8("…"));
  const QString group = action.property("menu").toString();
  return group.isEmpty() ? text : group + ": " + text;
}

// Types into a field of the newest object of a kind.
void type_into_field(Session& session, scene::ObjectKind kind, const char* field, const char* text) {
  const std::size_t count = scene::count_of(session.scene(), kind);
  if (count == 0) return;
  const scene::ObjectId id{kind, count - 1};
  scene::AnyObject object = scene::object_of(session.scene(), id);
  if (!scene::set_field(object, field, text).empty()) return;
  session.perform(scene::replace_object(session.scene(), id, std::move(object), "Tour"));
  session.select_only(id);
}

bool is_about(double value, double wanted) { return std::abs(value - wanted) <= 1e-9 * std::abs(wanted); }

const scene::Radar* last_radar(const Session& session) {
  const auto& radars = session.scene().radars;
  return radars.empty() ? nullptr : &radars.back();
}

const scene::Target* last_target(const Session& session) {
  const auto& targets = session.scene().targets;
  return targets.empty() ? nullptr : &targets.back();
}

}  // namespace

StartGuide::StartGuide(const Workbench& parts, ToolWindows& tools, QMainWindow& window)
    : QObject(&window), parts_(parts), tools_(tools), window_(window) {
  make_welcome();
}

void StartGuide::make_welcome() {
  welcome_ = new WelcomePage(window_.centralWidget());
  connect(welcome_, &WelcomePage::example_wanted, this, [this](const QString& name) {
    const QDir folder(text_of(DocumentKeeper::examples_folder()));
    parts_.commit_typed();
    parts_.documents.open_example(folder.filePath(name));
  });
  connect(welcome_, &WelcomePage::template_wanted, this, [this](int index) {
    parts_.commit_typed();
    parts_.documents.begin_with(scene::starting_scenes()[static_cast<std::size_t>(index)]);
  });
  connect(welcome_, &WelcomePage::file_wanted, this, &StartGuide::file_wanted);
  connect(welcome_, &WelcomePage::open_wanted, this, [this] {
    parts_.commit_typed();
    parts_.documents.open();
  });
  connect(welcome_, &WelcomePage::tour_wanted, this, &StartGuide::show_tour);
  connect(&parts_.session, &Session::document_replaced, this, &StartGuide::leave_welcome);
  connect(&parts_.session, &Session::scene_changed, welcome_, [this] {
    if (!has_nothing(parts_.session.scene())) leave_welcome();
  });
  const auto show_recent = [this] { welcome_->set_recent(parts_.documents.recent()); };
  connect(&parts_.documents, &DocumentKeeper::recent_changed, welcome_, show_recent);
  show_recent();
  welcome_->setVisible(WelcomePage::wanted_at_start());
}

void StartGuide::show_welcome() {
  welcome_->show();
  welcome_->setFocus();
}

// The keyboard goes on in the scene, not in whatever follows the page.
void StartGuide::leave_welcome() {
  const QWidget* const focus = window_.focusWidget();
  if (focus != nullptr && (focus == welcome_ || welcome_->isAncestorOf(focus))) parts_.scene.scene().setFocus();
  welcome_->hide();
}

namespace {

// What the trade calls a field.
QStringList trade_names_of(scene::ObjectKind kind, const scene::Field& field) {
  if (field.spec == nullptr || field.spec->key.empty()) return {};
  const std::string path = std::string(scene::language::header_of(kind)) + "." + std::string(field.spec->key);
  QStringList names;
  for (const scene::TradeWord& word : scene::trade_words())
    if (word.field == path) names += text_of(word.names).split(' ', Qt::SkipEmptyParts);
  return names;
}

}  // namespace

void StartGuide::go_to_field(scene::ObjectKind kind, const QString& field) {
  const auto current = parts_.session.current();
  if (scene::count_of(parts_.session.scene(), kind) > 0) {
    if (!current || current->kind != kind) parts_.session.select_only({kind, 0});
    parts_.bring("properties");
    if (parts_.panel.focus_field(field)) return;
  }
  // No such object, or as it is the field means nothing: what it is says the reference.
  const QString word = kind == scene::ObjectKind::simulation ? "recording" : text_of(scene::name_of(kind));
  tools_.show_help({"formats/scene.md", "[[" + word + "]]"});
}

std::vector<SearchEntry> StartGuide::search_entries() {
  std::vector<SearchEntry> entries;
  using Kind = SearchEntry::Kind;
  for (QAction* action : window_.findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly))
    if (action->isEnabled() && !action->isSeparator() && !action->text().isEmpty())
      entries.push_back({Kind::command, words_of_command(*action),
                         action->shortcut().toString(QKeySequence::NativeText), action->toolTip(),
                         [action] { action->trigger(); }});
  for (const scene::ObjectKind kind : kinds_with_fields)
    for (const scene::Field& field : scene::fields_of(kind)) {
      const QString id = text_of(field.id);
      entries.push_back({Kind::field, title_of(kind) + ": " + text_of(field.label), text_of(field.group),
                         text_of(field.tooltip), [this, kind, id] { go_to_field(kind, id); },
                         trade_names_of(kind, field)});
    }
  for (const HelpHeading& found : help_headings(HelpWindow::folder())) {
    const QString words = found.heading.isEmpty() ? found.title : found.heading;
    entries.push_back(
        {Kind::help, words, found.heading.isEmpty() ? tr("Guide") : found.title, found.page, [this, found] {
           tools_.show_help({found.page, found.heading});
         }});
  }
  return entries;
}

QWidget* StartGuide::search_box() { return new SearchBox(search_entries(), &window_); }

void StartGuide::show_search() { SearchBox(search_entries(), &window_).exec(); }

// Chapter 3 of the thesis: what its reader does, in our words.
std::vector<TourStep> StartGuide::tour_steps() {
  const auto trigger = [this](const char* name) {
    return [this, name] { window_.findChild<QAction*>(name)->trigger(); };
  };
  const auto type = [this](scene::ObjectKind kind, const char* field, const char* text) {
    return [this, kind, field, text] { type_into_field(parts_.session, kind, field, text); };
  };
  const auto highest = [this] {
    const auto* label = window_.findChild<QLabel*>("echo_highest");
    return label != nullptr && label->text().contains("40.9566 nV");
  };
  using scene::ObjectKind;
  return {
      {tr("A radar"),
       tr("Press Radar in the tool bar, or choose Geometry, New Radar (Ctrl+3). It is at the origin and transmits 1000 "
          "pulses per second at 1 GHz with 1 kW. Its fields appear at the right."),
       [this] { return last_radar(parts_.session) != nullptr; }, trigger("new_radar")},
      {tr("A chirp"),
       tr("Among the fields of the radar, choose Chirp as the type of pulse. Its frequency runs through 50 MHz within "
          "5 µs, which will resolve 3 m."),
       [this] {
         const scene::Radar* radar = last_radar(parts_.session);
         return radar != nullptr && radar->pulse == scene::Radar::Pulse::chirp;
       },
       type(ObjectKind::radar, "pulse", "Chirp")},
      {tr("A target"),
       tr("Press Target in the tool bar, or choose Geometry, New Target (Ctrl+1). A target is a point that reflects; "
          "it begins at the origin."),
       [this] { return last_target(parts_.session) != nullptr; }, trigger("new_target")},
      {tr("3000 m away"), tr("Type 3000 into the field X of the target, and press Enter. Units may follow: 3 km."),
       [this] {
         const scene::Target* target = last_target(parts_.session);
         return target != nullptr && is_about(target->position_m.x, 3000.0);
       },
       type(ObjectKind::target, "position_m.x", "3 km")},
      {tr("How much it reflects"),
       tr("Type 3 into the field of the radar cross-section (RCS), and press Enter: 3 m², as from a small boat."),
       [this] {
         const scene::Target* target = last_target(parts_.session);
         return target != nullptr && is_about(target->rcs_m2, 3.0);
       },
       type(ObjectKind::target, "rcs_m2", "3 m2")},
      {tr("Its echo"),
       tr("Press Echoes, or choose Simulation, Raw Return (Ctrl+R). A picture shows what the radar receives: distance "
          "across, one row for each pulse. It follows whatever you change in the scene."),
       [this] { return !parts_.simulation_windows.windows().empty(); }, trigger("simulation_raw")},
      {tr("As the radar equation says"),
       tr("Read the highest magnitude below the picture: 40.9566 nV, in the thesis 40.957. The radar equation gives "
          "the same, with the power, "
          "the wavelength of 30 cm, the 3 m² and the fourth power of 3000 m."),
       highest, [this] { tools_.open_simulation(); }},
      {tr("Save it"),
       tr("Choose File, Save (Ctrl+S), and give the scene a name. The file is a text with comments: you can read it, "
          "change it, and run it with the command sarsim."),
       [this] { return !parts_.session.document().path().empty() && !parts_.documents.unsaved(); },
       trigger("file_save")}};
}

TourPanel* StartGuide::tour_panel() {
  if (tour_ == nullptr) tour_ = new TourPanel(tour_steps(), &window_);
  return tour_;
}

// It begins with an empty scene.
void StartGuide::show_tour() {
  if (!tour_panel()->isVisible()) {
    parts_.commit_typed();
    if (!has_nothing(parts_.session.scene())) parts_.documents.make_new();
    leave_welcome();
    tour_->begin();
    tour_->adjustSize();
    const QPoint corner =
        window_.mapToGlobal(QPoint(window_.width() - tour_->width(), window_.height() - tour_->height()));
    tour_->move(corner - QPoint(window_.fontMetrics().height() * 2, window_.fontMetrics().height() * 4));
  }
  tour_->show();
  tour_->raise();
}

}  // namespace sarsim::gui
