#pragma once

#include <QObject>
#include <QPalette>
#include <QStringList>

#include <vector>

#include "core/report/problem.hpp"
#include "scene/schema/fields.hpp"

class QAction;
class QLabel;
class QWidget;

namespace sarsim::gui {

class ProblemLine;

/// A number with its unit, moved by steps of its last shown digit: "5.6 cm", 1: "5.7 cm". Empty if the text is not a
/// number.
[[nodiscard]] QString stepped_text(const QString& text, int steps);
/// The same number with one digit more: "5 cm" becomes "5.0 cm". Empty if the text is not a number.
[[nodiscard]] QString upsampled_text(const QString& text);

/// Where the value of a field comes from.
enum class FieldOrigin {
  unknown,     ///< Nothing is known of it, or it has no default to go back to.
  by_default,  ///< The text of the scene does not say it.
  said,        ///< The text says it.
};

/// What a field shows.
struct FieldContent {
  QString value = {};
  QString expression = {};  ///< What the text says, where that is more than a number with a unit; else empty.
  FieldOrigin origin = FieldOrigin::unknown;

  friend bool operator==(const FieldContent&, const FieldContent&) = default;
};

/// One row of a form: label, widget "field_<id>" and a line for problems below. Knows texts only; whoever holds the
/// object hears `entered`, tries the text, and answers with show_value or show_failure. A value that the scene does not
/// say is grey, and one that it says can be taken back in the context menu (action "reset_<id>").
class FieldEditor : public QObject {
  Q_OBJECT

 public:
  /// @param parent  of the widgets
  FieldEditor(const scene::Field& field, QWidget* parent);

  [[nodiscard]] const scene::Field& field() const { return field_; }
  [[nodiscard]] QString id() const { return QString::fromStdString(field_.id); }
  /// Null where the widget carries its label itself.
  [[nodiscard]] QLabel* label() const { return label_; }
  /// What is typed into or chosen from.
  [[nodiscard]] virtual QWidget* widget() const = 0;
  /// The value of an expression, to stand below the widget; null where there can be none.
  [[nodiscard]] virtual QWidget* result() const { return nullptr; }
  [[nodiscard]] ProblemLine* problem_line() const { return problem_line_; }

  /// Shows the field's value; what is being typed, or was refused, stays as long as the value does.
  void show_value(const QString& text) { show(FieldContent{text}); }
  /// The same with an expression, which is shown in place of the value, and where it comes from.
  void show(const FieldContent& content);
  /// Several objects do not agree.
  void show_different(FieldOrigin origin = FieldOrigin::unknown);
  /// Names to choose from, for fields that refer to other objects.
  virtual void set_choices(const QStringList& choices);
  /// Says why the text that was entered cannot be taken; the text stays.
  virtual void show_failure(const QString& sentence);
  /// Says why a step was not taken, with the value as it was.
  void refuse_step(const QString& sentence);
  /// What was refused is right now, or gone.
  void clear_failure();
  /// Shows what the scene's check says of the field.
  void show_problems(const std::vector<core::Problem>& problems);
  /// True where a failure, an error or a warning is shown.
  [[nodiscard]] bool troubled() const;
  /// Shows or hides the whole row; what is hidden keeps its text.
  void set_shown(bool shown);
  [[nodiscard]] bool shown() const { return shown_; }

  /// What was typed and neither applied nor refused; empty where nothing was.
  [[nodiscard]] virtual bool pending() const { return false; }
  [[nodiscard]] bool refused() const { return !failure_.isEmpty(); }
  /// Applies what was typed, if anything.
  virtual void commit() {}
  /// Drops what was typed or refused.
  virtual void restore();

 signals:
  void entered(const QString& text);  ///< To be applied.
  void stepped(const QString& text);  ///< To be applied as part of a run.
  void retyped(const QString& text);  ///< A refused text was changed; to be judged without applying it.
  void left();                        ///< A run of steps ended.
  void opened();                      ///< A function wants its editor.
  void reset_wanted();                ///< The value is to be the default again.

 protected:
  /// For constructors of derived classes: names, tooltip and label of the widget.
  void describe(QWidget* widget, bool with_label);
  /// Shows `content_`, or that values differ.
  virtual void display() = 0;
  [[nodiscard]] virtual bool keeps(const QString& new_value) const;
  /// Shows whether the text was refused, and where the value comes from.
  virtual void mark(bool failed);
  /// Shows or hides the value of an expression.
  virtual void show_result() {}
  /// What colours the text of the widget.
  [[nodiscard]] virtual QPalette::ColorRole text_role() const = 0;
  bool eventFilter(QObject* watched, QEvent* event) override;
  [[nodiscard]] QAction* reset_action() const { return reset_; }

  FieldContent content_;
  bool different_ = false;

 private:
  void refresh_problem_line();
  void refresh_tooltip();

  scene::Field field_;
  QAction* reset_ = nullptr;
  QWidget* described_ = nullptr;
  bool marking_ = false;
  QLabel* label_ = nullptr;
  ProblemLine* problem_line_ = nullptr;
  QString failure_;
  std::vector<core::Problem> problems_;
  bool shown_ = true;
};

/// Makes the editor that suits a field's kind.
[[nodiscard]] FieldEditor* make_field_editor(const scene::Field& field, QWidget* parent);

}  // namespace sarsim::gui
