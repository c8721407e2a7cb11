#include "gui/start/welcome_page.hpp"

#include <QCheckBox>
#include <QEvent>
#include <QFileInfo>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <iterator>

#include "gui/common/icons.hpp"
#include "gui/start/card_list.hpp"
#include "scene/edit/starting_scenes.hpp"

namespace sarsim::gui {

namespace {

constexpr char at_start_key[] = "welcome/at_start";
constexpr int max_recent = 3;

struct ExampleCard {
  const char* file;
  const char* picture;
  const char* title;
  const char* sentence;
};

constexpr ExampleCard example_cards[] = {
    {"thesis_chapter3.toml", "figure_3_5", QT_TRANSLATE_NOOP("WelcomePage", "One echo"),
     QT_TRANSLATE_NOOP("WelcomePage", "A radar and a target 3 km away: the radar equation, sample by sample.")},
    {"sar_r.toml", "figure_7_2", QT_TRANSLATE_NOOP("WelcomePage", "The letter R"),
     QT_TRANSLATE_NOOP("WelcomePage", "An aircraft maps 24 points; focused, they are bright dots.")},
    {"stripmap_motion.toml", "motion", QT_TRANSLATE_NOOP("WelcomePage", "A flight in wind"),
     QT_TRANSLATE_NOOP("WelcomePage", "An aircraft that deviates from its track, with motion compensation.")},
    {"spotlight.toml", "spotlight", QT_TRANSLATE_NOOP("WelcomePage", "Spotlight"),
     QT_TRANSLATE_NOOP("WelcomePage", "The beam is held on one point, for a finer resolution.")},
    {"satellite.toml", "satellite", QT_TRANSLATE_NOOP("WelcomePage", "From orbit"),
     QT_TRANSLATE_NOOP("WelcomePage", "Three corner reflectors on the Earth, seen from 703 km.")},
    {"turning_ship.toml", "turning_ship", QT_TRANSLATE_NOOP("WelcomePage", "A turning ship"),
     QT_TRANSLATE_NOOP("WelcomePage", "The radar is stationary; the ship's own rotation forms the image.")},
    {"ship_in_waves.toml", "ship_in_waves", QT_TRANSLATE_NOOP("WelcomePage", "A ship in waves"),
     QT_TRANSLATE_NOOP("WelcomePage", "Roll, pitch and yaw of the sea smear and shape the image.")},
    {"stepped_aircraft.toml", "aircraft", QT_TRANSLATE_NOOP("WelcomePage", "Range profiles"),
     QT_TRANSLATE_NOOP("WelcomePage", "Stepped-frequency bursts resolve an aircraft in range.")},
    {"search_radar.toml", "search", QT_TRANSLATE_NOOP("WelcomePage", "Search radar"),
     QT_TRANSLATE_NOOP("WelcomePage", "A rotating beam, and two targets on its PPI.")},
    {"mti.toml", "moving", QT_TRANSLATE_NOOP("WelcomePage", "Moving targets"),
     QT_TRANSLATE_NOOP("WelcomePage", "A car beside a building, separated by its Doppler frequency.")},
    {"helicopter.toml", "helicopter_doppler", QT_TRANSLATE_NOOP("WelcomePage", "A rotor"),
     QT_TRANSLATE_NOOP("WelcomePage", "The blades of a helicopter come and go in Doppler and time.")},
    {"barker_chirp.toml", "barker_chirp", QT_TRANSLATE_NOOP("WelcomePage", "Pulses compared"),
     QT_TRANSLATE_NOOP("WelcomePage", "A Barker code against chirps: main lobes and side lobes.")},
    {"surface.toml", "surface_ridge", QT_TRANSLATE_NOOP("WelcomePage", "Surfaces"),
     QT_TRANSLATE_NOOP("WelcomePage", "Triangles that reflect towards the radar.")},
    {"gusts.toml", "gusts", QT_TRANSLATE_NOOP("WelcomePage", "Turbulence"),
     QT_TRANSLATE_NOOP("WelcomePage", "Gusts, and how well the navigation tracks them.")},
};

struct TemplateLook {
  std::string_view purpose;
  const char* icon;
  const char* title;
};

constexpr TemplateLook template_looks[] = {
    {"tutorial", "target", QT_TRANSLATE_NOOP("WelcomePage", "A first echo")},
    {"sar-strip", "strip", QT_TRANSLATE_NOOP("WelcomePage", "SAR strip map")},
    {"spotlight", "spotlight", QT_TRANSLATE_NOOP("WelcomePage", "Spotlight")},
    {"search-radar", "sweep", QT_TRANSLATE_NOOP("WelcomePage", "Search radar")},
    {"stepped-frequency", "steps", QT_TRANSLATE_NOOP("WelcomePage", "Range profiles")},
    {"isar", "ship", QT_TRANSLATE_NOOP("WelcomePage", "ISAR of a turning ship")},
    {"moving-targets", "moving", QT_TRANSLATE_NOOP("WelcomePage", "Moving targets")},
    {"satellite", "satellite", QT_TRANSLATE_NOOP("WelcomePage", "Satellite")},
};

TemplateLook look_of(std::string_view purpose) {
  for (const TemplateLook& look : template_looks)
    if (look.purpose == purpose) return look;
  return {purpose, "new", ""};
}

// A first capital and a full stop.
QString sentence_of(std::string_view meaning) {
  QString text = QString::fromUtf8(meaning.data(), static_cast<qsizetype>(meaning.size()));
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text + ".";
}

}  // namespace

WelcomePage::WelcomePage(QWidget* over) : QWidget(over) {
  setObjectName("welcome_page");
  setAutoFillBackground(true);
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setSpacing(fontMetrics().height());
  column->addWidget(make_head());
  column->addWidget(make_templates());
  column->addWidget(make_examples());
  auto* at_start = new QCheckBox(tr("&Show this page when the program starts"));
  at_start->setObjectName("welcome_at_start");
  at_start->setToolTip(tr("Help, Welcome shows it at any time"));
  at_start->setChecked(wanted_at_start());
  connect(at_start, &QCheckBox::toggled, this, [](bool on) { QSettings().setValue(at_start_key, on); });
  column->addWidget(at_start);
  column->addStretch();
  auto* scroll = new QScrollArea;
  scroll->setObjectName("welcome_scroll");
  scroll->setAccessibleName(tr("Welcome"));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidgetResizable(true);
  scroll->setWidget(page);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
  setFocusProxy(first_);
  over->installEventFilter(this);
  setGeometry(over->rect());
}

QWidget* WelcomePage::make_head() {
  auto* head = new QWidget;
  auto* grid = new QGridLayout(head);
  grid->setContentsMargins(0, 0, 0, 0);
  auto* icon = new QLabel;
  icon->setPixmap(program_icon().pixmap(fontMetrics().height() * 4));
  auto* words =
      new QLabel(tr("<h2>Welcome to Sarsim</h2>Put a radar and targets into a scene, and see the echoes "
                    "while you change it. New here? Take the tour: one radar, one target, one echo."));
  words->setObjectName("welcome_words");
  words->setWordWrap(true);
  grid->addWidget(icon, 0, 0, Qt::AlignTop);
  grid->addWidget(words, 0, 1);
  grid->setColumnStretch(1, 1);
  auto* buttons = new QHBoxLayout;
  const auto button = [&](const QString& text, const char* name, const char* icon_name, const QString& tip) {
    auto* made = new QPushButton(icon_of(icon_name), text);
    made->setObjectName(name);
    made->setToolTip(tip);
    buttons->addWidget(made);
    return made;
  };
  first_ = button(tr("Take the &Tour"), "welcome_tour", "tour", tr("The first example of the thesis, step by step"));
  connect(first_, &QPushButton::clicked, this, &WelcomePage::tour_wanted);
  connect(button(tr("&Open…"), "welcome_open", "open", tr("A scene, or a file of samples")), &QPushButton::clicked,
          this, &WelcomePage::open_wanted);
  connect(button(tr("E&mpty Scene"), "welcome_close", "new", tr("Leaves this page; Escape does so, too")),
          &QPushButton::clicked, this, &QWidget::hide);
  buttons->addStretch();
  grid->addLayout(buttons, 1, 1);
  recent_box_ = new QWidget;
  recent_ = new QVBoxLayout(recent_box_);
  recent_->setContentsMargins(0, 0, 0, 0);
  recent_->setSpacing(0);
  grid->addWidget(recent_box_, 2, 1);
  return head;
}

QWidget* WelcomePage::make_templates() {
  auto* box = new QGroupBox(tr("New Scene for …"));
  auto* list = new CardList(false);
  list->setObjectName("welcome_templates");
  list->setAccessibleName(tr("Scenes to begin with"));
  for (const scene::StartingScene& scene : scene::starting_scenes()) {
    const TemplateLook look = look_of(scene.purpose);
    list->add_card(tr(look.title), sentence_of(scene.meaning));
    list->set_icon(list->count() - 1, icon_of(look.icon));
  }
  connect(list, &CardList::chosen, this, &WelcomePage::template_wanted);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->addWidget(list);
  return box;
}

QWidget* WelcomePage::make_examples() {
  auto* box = new QGroupBox(tr("Examples"));
  examples_ = new CardList(true);
  examples_->setObjectName("welcome_examples");
  examples_->setAccessibleName(tr("Examples"));
  for (const ExampleCard& card : example_cards) examples_->add_card(tr(card.title), tr(card.sentence));
  connect(examples_, &CardList::chosen, this, [this](int row) { emit example_wanted(example_cards[row].file); });
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->addWidget(examples_);
  return box;
}

void WelcomePage::set_recent(const QStringList& paths) {
  qDeleteAll(recent_box_->findChildren<QToolButton*>());
  recent_box_->setVisible(!paths.isEmpty());
  for (const QString& path : paths.first(std::min<qsizetype>(paths.size(), max_recent))) {
    auto* button = new QToolButton;
    button->setObjectName(QString("welcome_recent_%1").arg(recent_->count()));
    button->setAutoRaise(true);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIcon(icon_of("open"));
    button->setText(QFileInfo(path).fileName());
    button->setToolTip(path);
    button->setAccessibleName(tr("Open %1").arg(path));
    connect(button, &QToolButton::clicked, this, [this, path] { emit file_wanted(path); });
    recent_->addWidget(button);
  }
}

bool WelcomePage::wanted_at_start() { return QSettings().value(at_start_key, true).toBool(); }

void WelcomePage::load_pictures() {
  if (pictures_ == static_cast<int>(std::size(example_cards))) return;
  examples_->set_picture(pictures_, gallery_picture(example_cards[pictures_].picture));
  ++pictures_;
  QTimer::singleShot(0, this, &WelcomePage::load_pictures);
}

bool WelcomePage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parent() && event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
  return QWidget::eventFilter(watched, event);
}

void WelcomePage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return hide();
  QWidget::keyPressEvent(event);
}

void WelcomePage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  setGeometry(parentWidget()->rect());
  raise();
  if (pictures_ == 0) QTimer::singleShot(0, this, &WelcomePage::load_pictures);
}

}  // namespace sarsim::gui
