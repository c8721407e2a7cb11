#pragma once

#include <QString>

#include <functional>
#include <limits>

#include "scene/schema/quantity.hpp"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLineEdit;
class QSlider;
class QVBoxLayout;
class QWidget;

namespace sarsim::gui {

class ProblemLine;

/// Makes the rows of a form whose choices count at once: each hands what was chosen or typed to a function, and what is
/// wrong with a text is told on a line of problems.
class FormRows {
 public:
  /// What a row is called: for people, for tests and scripts, and what it means.
  struct Words {
    QString label;
    QString name;  ///< Of the field as an object: "echo_radar".
    QString tip;
  };

  /// A number that can be typed, with its unit.
  struct Number {
    std::function<scene::Quantity()> kind;  ///< Asked when the text is read.
    double above = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    QString otherwise = {};  ///< What is said of a number outside these limits.
  };

  /// @param owner    parent of the fields; it outlives this object's functions
  /// @param problem  where it is said what is wrong
  FormRows(QWidget& owner, ProblemLine& problem) : owner_(owner), problem_(problem) {}

  /// A list; `take` gets the index that was chosen.
  QComboBox* add_choice(QFormLayout* form, const Words& words, std::function<void(int)> take);
  /// A text of a number; `take` gets its value in SI units (degrees, decibels) where it is within the limits.
  QLineEdit* add_number(QFormLayout* form, const Words& words, Number number, std::function<void(double)> take);
  /// A slider of the original's display, 0 to 255.
  QSlider* add_slider(QFormLayout* form, const QString& label, const QString& name, std::function<void(int)> take);
  /// A mark that is on or off, with its words beside it.
  QCheckBox* add_mark(QFormLayout* form, const Words& words, std::function<void(bool)> take);

  /// Calls `show`, within which fields that are set take nothing: they show what is, and nobody chose it.
  void while_showing(const std::function<void()>& show);

 private:
  void take(const std::function<void()>& taken);

  QWidget& owner_;
  ProblemLine& problem_;
  int showing_ = 0;
};

/// Adds a box with a title and a form in it at the end of a layout.
QFormLayout* add_form_group(QVBoxLayout* layout, const QString& title);

/// Shows or hides a field together with its label.
void show_row(QFormLayout* form, QWidget* field, bool shown);

/// Shows a value in a field with its unit; what is being typed there stays.
void show_number(QLineEdit* field, double value, scene::Quantity kind);

}  // namespace sarsim::gui
