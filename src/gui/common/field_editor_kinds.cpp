#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QStyleOptionButton>
#include <QStylePainter>
#include <QWheelEvent>

#include <utility>

#include "core/maths/rounding.hpp"
#include "gui/common/field_editor.hpp"
#include "gui/common/palette_colours.hpp"
#include "gui/common/problem_line.hpp"
#include "gui/common/text.hpp"

namespace sarsim::gui {

namespace {

QString different_text() { return FieldEditor::tr("(different)"); }

// A value in few digits: "9.003 km".
QString rounded_text(const QString& value, scene::Quantity quantity) {
  constexpr int digits = 5;
  const scene::QuantityReading reading = scene::read_quantity(value.toStdString(), quantity);
  if (!reading.value) return value;
  return read_out(scene::quantity_text(core::tidy(*reading.value, digits), quantity));
}

// The values that keys may step to: magnitudes do not become nothing, nor negative, because an arrow was pressed once
// more. Typed values know no such limit.
scene::Range range_of_steps(const scene::Field& field) {
  scene::Range range = field.spec == nullptr ? scene::any_value : field.spec->range;
  if (field.spec != nullptr && field.spec->usable) range = scene::both(range, *field.spec->usable);
  const bool magnitude = field.quantity == scene::Quantity::area || field.quantity == scene::Quantity::power;
  if (magnitude) return range.low < 0.0 ? scene::both(range, scene::above_zero) : range;
  return field.quantity == scene::Quantity::time ? scene::both(range, scene::zero_or_more) : range;
}

// A step that stays within such values: of "1 m2" down it is one of the next digit, "0.9 m2". Where none does, the text
// as it was; from outside of them any step is taken.
QString step_within(const QString& text, int steps, const scene::Field& field) {
  constexpr int max_digits = 3;
  const scene::Range range = range_of_steps(field);
  const auto holds = [&](const QString& of) {
    const scene::QuantityReading reading = scene::read_quantity(of.toStdString(), field.quantity);
    return !reading.value || (range.low_excluded ? *reading.value > range.low : *reading.value >= range.low);
  };
  QString from = text;
  QString stepped = stepped_text(from, steps);
  if (steps > 0 || stepped.isEmpty() || !holds(from)) return stepped;
  const bool finer = range.low_excluded && field.quantity != scene::Quantity::count;
  for (int i = 0; i < max_digits && finer && !holds(stepped); ++i) {
    from = upsampled_text(from);
    stepped = stepped_text(from, steps);
  }
  return holds(stepped) ? stepped : text;
}

// A line of text: quantities and names. Below an expression stands its value.
class LineField : public FieldEditor {
 public:
  LineField(const scene::Field& field, QWidget* parent)
      : FieldEditor(field, parent), edit_(new QLineEdit(parent)), result_(new QLabel(parent)) {
    describe(edit_, true);
    result_->setObjectName("result_" + id());
    result_->setForegroundRole(QPalette::PlaceholderText);
    result_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    result_->setFocusPolicy(Qt::NoFocus);
    result_->hide();
    connect(edit_, &QLineEdit::textChanged, this, [this] { show_result(); });
    error_mark_ = edit_->addAction(severity_icon(core::Severity::error, *edit_), QLineEdit::TrailingPosition);
    error_mark_->setVisible(false);
    connect(edit_, &QLineEdit::editingFinished, this, [this] { commit(); });
    connect(edit_, &QLineEdit::textEdited, this, [this](const QString& text) {
      end_steps();
      if (refused()) emit retyped(text);
    });
  }

  [[nodiscard]] QWidget* widget() const override { return edit_; }
  [[nodiscard]] QWidget* result() const override { return result_; }
  [[nodiscard]] bool pending() const override { return !refused() && !committing_ && edit_->text() != displayed_; }

  void commit() override {
    const QString text = edit_->text();
    if (text == displayed_) {
      if (refused()) restore();
      return;
    }
    if (text == refused_text_ && refused()) return;
    clear_failure();
    QScopedValueRollback committing(committing_, true);
    emit entered(text);
    if (!refused()) display();
  }

  void restore() override {
    stepping_ = false;
    FieldEditor::restore();
  }

  void show_failure(const QString& sentence) override {
    refused_text_ = edit_->text();
    FieldEditor::show_failure(sentence);
  }

 protected:
  void display() override {
    displayed_ = different_ ? QString() : content_.expression.isEmpty() ? value_text() : content_.expression;
    edit_->setPlaceholderText(different_ ? different_text() : QString());
    if (edit_->text() == displayed_) return show_result();
    edit_->setText(displayed_);
    // Of a long text the beginning matters; the caret stays where somebody types.
    if (!edit_->hasFocus()) edit_->setCursorPosition(0);
  }

  [[nodiscard]] QString value_text() const {
    return field().kind == scene::FieldKind::quantity ? display_of(content_.value.toStdString()) : content_.value;
  }

  // During a run of steps the unit stays as it was: 999 MHz is followed by 1000 MHz, not by 1 GHz and 2 GHz.
  [[nodiscard]] bool keeps(const QString& new_value) const override {
    if (!stepping_) return false;
    const scene::QuantityReading reading = scene::read_quantity(edit_->text().toStdString(), field().quantity);
    return reading.value && scene::quantity_text(*reading.value, field().quantity) == new_value.toStdString();
  }

  void mark(bool failed) override {
    error_mark_->setVisible(failed);
    FieldEditor::mark(failed);
    edit_->setContextMenuPolicy(Qt::DefaultContextMenu);  // which holds the entries for text
    show_result();
  }

  [[nodiscard]] QPalette::ColorRole text_role() const override { return QPalette::Text; }

  // What is being typed has no value yet; rows below do not move for that.
  void show_result() override {
    const bool shows = shown() && !content_.expression.isEmpty() && !different_;
    result_->setVisible(shows);
    if (!shows) return;
    const bool is_value = edit_->text() == displayed_;
    result_->setText("= " + (is_value ? rounded_text(content_.value, field().quantity) : QStringLiteral("…")));
  }

  bool eventFilter(QObject* watched, QEvent* event) override {
    switch (event->type()) {
      case QEvent::ShortcutOverride:
        // Escape is the field's as long as there is something to restore.
        if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && to_restore()) event->accept();
        return undo_of_scene(*static_cast<QKeyEvent*>(event));
      case QEvent::KeyPress: return key_pressed(*static_cast<QKeyEvent*>(event));
      case QEvent::Wheel: return wheel_turned(*static_cast<QWheelEvent*>(event));
      case QEvent::FocusOut: end_steps(); break;
      case QEvent::ContextMenu: return open_menu(static_cast<QContextMenuEvent*>(event)->globalPos());
      default: break;
    }
    return FieldEditor::eventFilter(watched, event);
  }

 private:
  bool open_menu(QPoint at) {
    QMenu* menu = edit_->createStandardContextMenu();
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addSeparator();
    menu->addAction(reset_action());
    menu->popup(at);
    return true;
  }

  [[nodiscard]] bool to_restore() const { return refused() || edit_->text() != displayed_; }

  // Undo and redo are those of typing while something is typed; else those of the scene, which lines of text would
  // keep for themselves.
  [[nodiscard]] bool undo_of_scene(QKeyEvent& key) const {
    if (to_restore() || !(key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo))) return false;
    key.ignore();
    return true;
  }

  bool key_pressed(const QKeyEvent& key) {
    if (key.key() == Qt::Key_Escape) {
      if (!to_restore()) return false;
      restore();
      edit_->selectAll();
      return true;
    }
    switch (key.key()) {
      case Qt::Key_Up: return step(1);
      case Qt::Key_Down: return step(-1);
      case Qt::Key_PageUp: return step(10);
      case Qt::Key_PageDown: return step(-10);
      default: return false;
    }
  }

  bool wheel_turned(const QWheelEvent& wheel) {
    if (!wheel.modifiers().testFlag(Qt::ControlModifier) || !edit_->hasFocus()) return false;
    wheel_angle_ += wheel.angleDelta().y();
    const int notches = wheel_angle_ / QWheelEvent::DefaultDeltasPerStep;
    wheel_angle_ -= notches * QWheelEvent::DefaultDeltasPerStep;
    return notches == 0 || step(notches);
  }

  bool step(int steps) {
    if (field().kind != scene::FieldKind::quantity) return false;
    // The Tab key marks all of a text. Whoever has not put the caret into it does not mean to change it yet.
    if (edit_->hasSelectedText() && edit_->selectedText() == edit_->text()) {
      edit_->end(false);
      return true;
    }
    const bool is_expression = edit_->text() == displayed_ && !content_.expression.isEmpty();
    const QString text =
        step_within(is_expression ? rounded_text(content_.value, field().quantity) : edit_->text(), steps, field());
    if (text.isEmpty() || text == edit_->text()) return true;
    clear_failure();
    stepping_ = true;
    edit_->setText(text);
    QScopedValueRollback committing(committing_, true);
    emit stepped(text);
    if (!refused()) displayed_ = edit_->text();
    return true;
  }

  void end_steps() {
    if (!std::exchange(stepping_, false)) return;
    if (edit_->text() == displayed_) display();
    emit left();
  }

  QLineEdit* edit_;
  QLabel* result_;
  QAction* error_mark_;
  QString displayed_;
  QString refused_text_;
  bool committing_ = false;
  bool stepping_ = false;
  int wheel_angle_ = 0;
};

// One of several: choices, platforms, radars.
class ChoiceField : public FieldEditor {
 public:
  ChoiceField(const scene::Field& field, QWidget* parent) : FieldEditor(field, parent), box_(new QComboBox(parent)) {
    describe(box_, true);
    box_->setPlaceholderText(different_text());
    box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box_->setMinimumContentsLength(8);
    box_->setFocusPolicy(Qt::StrongFocus);
    for (const std::string& choice : field.choices) choices_ += QString::fromStdString(choice);
    box_->addItems(choices_);
    connect(box_, &QComboBox::currentIndexChanged, this, [this](int index) {
      if (!showing_ && index >= 0) emit entered(box_->itemText(index));
    });
  }

  [[nodiscard]] QWidget* widget() const override { return box_; }

  void set_choices(const QStringList& choices) override {
    if (choices == choices_) return;
    choices_ = choices;
    refill();
  }

 protected:
  void display() override {
    const QScopedValueRollback showing(showing_, true);
    const bool listed = different_ || choices_.contains(content_.value);
    if (box_->count() != choices_.size() + (listed ? 0 : 1) || !listed) refill();
    box_->setCurrentIndex(different_ ? -1 : box_->findText(content_.value, Qt::MatchExactly | Qt::MatchCaseSensitive));
  }

  [[nodiscard]] QPalette::ColorRole text_role() const override { return QPalette::ButtonText; }

  bool eventFilter(QObject* watched, QEvent* event) override {
    // A panel that is scrolled must not change what the pointer passes over, nor what was chosen from last.
    if (event->type() == QEvent::Wheel) {
      event->ignore();
      return true;
    }
    if (event->type() == QEvent::KeyPress && moves(static_cast<QKeyEvent*>(event)->key())) {
      box_->showPopup();
      return true;
    }
    return FieldEditor::eventFilter(watched, event);
  }

 private:
  // Keys that would choose the next entry unseen; they open the list, from which Enter chooses.
  static bool moves(int key) {
    return key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown ||
           key == Qt::Key_Home || key == Qt::Key_End;
  }

  // A value that is none of the choices, a platform that does not exist, is shown behind them.
  void refill() {
    const QScopedValueRollback showing(showing_, true);
    box_->clear();
    box_->addItems(choices_);
    if (!different_ && !choices_.contains(content_.value)) box_->addItem(content_.value);
    box_->setCurrentIndex(different_ ? -1 : box_->findText(content_.value, Qt::MatchExactly | Qt::MatchCaseSensitive));
  }

  QComboBox* box_;
  QStringList choices_;
  bool showing_ = false;
};

class CheckField : public FieldEditor {
 public:
  CheckField(const scene::Field& field, QWidget* parent)
      : FieldEditor(field, parent), box_(new QCheckBox(QString::fromStdString(field.label), parent)) {
    describe(box_, false);
    connect(box_, &QCheckBox::stateChanged, this, [this](int state) {
      if (!showing_ && state != Qt::PartiallyChecked)
        emit entered(state == Qt::Checked ? QStringLiteral("yes") : QStringLiteral("no"));
    });
  }

  [[nodiscard]] QWidget* widget() const override { return box_; }

 protected:
  void display() override {
    const QScopedValueRollback showing(showing_, true);
    box_->setTristate(different_);
    box_->setCheckState(different_ ? Qt::PartiallyChecked : content_.value == "yes" ? Qt::Checked : Qt::Unchecked);
  }

  [[nodiscard]] QPalette::ColorRole text_role() const override { return QPalette::WindowText; }

 private:
  QCheckBox* box_;
  bool showing_ = false;
};

// A button whose text gives way at its end where there is too little room.
class ElidingButton : public QPushButton {
 public:
  using QPushButton::QPushButton;

 protected:
  void paintEvent(QPaintEvent*) override {
    QStyleOptionButton option;
    initStyleOption(&option);
    const int room = style()->subElementRect(QStyle::SE_PushButtonContents, &option, this).width();
    option.text = fontMetrics().elidedText(option.text, Qt::ElideRight, room);
    QStylePainter(this).drawControl(QStyle::CE_PushButton, option);
  }
};

// A summary that opens the function editor.
class FunctionField : public FieldEditor {
 public:
  FunctionField(const scene::Field& field, QWidget* parent)
      : FieldEditor(field, parent), button_(new ElidingButton(parent)) {
    describe(button_, true);
    button_->setAutoDefault(false);
    button_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // A long summary widens no panel.
    connect(button_, &QPushButton::clicked, this, [this] { emit opened(); });
  }

  [[nodiscard]] QWidget* widget() const override { return button_; }

 protected:
  void display() override {
    const QString text = different_ ? different_text() : content_.value;
    button_->setText(QString(text).replace('&', QStringLiteral("&&")) + QStringLiteral(" ..."));
    button_->setAccessibleName(tr("%1: %2, edit").arg(QString::fromStdString(field().label), text));
  }

  [[nodiscard]] QPalette::ColorRole text_role() const override { return QPalette::ButtonText; }

 private:
  QPushButton* button_;
};

}  // namespace

FieldEditor* make_field_editor(const scene::Field& field, QWidget* parent) {
  switch (field.kind) {
    case scene::FieldKind::quantity:
    case scene::FieldKind::text: return new LineField(field, parent);
    case scene::FieldKind::choice:
    case scene::FieldKind::platform:
    case scene::FieldKind::radar: return new ChoiceField(field, parent);
    case scene::FieldKind::check: return new CheckField(field, parent);
    case scene::FieldKind::function: return new FunctionField(field, parent);
    case scene::FieldKind::list: break;  // gui/objects/list_field.hpp
  }
  return nullptr;
}

}  // namespace sarsim::gui
