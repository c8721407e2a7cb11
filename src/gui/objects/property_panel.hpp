#pragma once

#include <QScrollArea>
#include <QTimer>

#include <map>
#include <set>
#include <vector>

#include "gui/common/session.hpp"
#include "gui/objects/list_field.hpp"
#include "gui/objects/property_panel_subject.hpp"
#include "picture/facts/derived_figures.hpp"

class QGridLayout;
class QGroupBox;
class QLabel;
class QTableWidget;
class QToolButton;
class QVBoxLayout;

namespace sarsim::gui {

class FieldEditor;
class ProblemLine;
struct FieldContent;

/// All fields of what is selected, to be read and changed; the run options of the script where nothing is. Several
/// objects of one kind are changed together, in one step. Widgets are called "field_<id>".
class PropertyPanel : public QScrollArea {
  Q_OBJECT

 public:
  explicit PropertyPanel(Session& session, QWidget* parent = nullptr);
  ~PropertyPanel() override;

  /// Applies what was typed and not entered yet; what cannot be taken stays in its field.
  void commit();
  /// Puts the keyboard into a field, unfolding its group; false where the panel shows no such field.
  bool focus_field(const QString& id);
  /// Puts the keyboard into the first field that can be edited.
  void focus_first();

 signals:
  /// The user wants to edit a function of an object.
  void function_requested(scene::ObjectId object, const QString& field_id);

 private:
  // One titled box of fields.
  struct Group {
    QString name;
    QGroupBox* box = nullptr;
    QGridLayout* grid = nullptr;
    QToolButton* more = nullptr;  // null where no field of the group is rare
    std::vector<FieldEditor*> editors;
  };

  void refresh();
  void refresh_soon();
  [[nodiscard]] bool is_stale() const;
  void follow(const scene::SceneChange& change);
  [[nodiscard]] bool shows(const scene::SceneChange& change) const;
  void fill_outlook();
  void commit_pending();
  [[nodiscard]] PanelSubject wanted_subject() const;
  void rebuild();
  void build_group(Group& group);
  Group& group_named(const QString& name);
  void align_labels();
  void order_tabs();
  void add_row(Group& group, FieldEditor* editor);
  void connect_editor(FieldEditor* editor);
  void fill();
  void fill_choices(FieldEditor* editor);
  void fill_problems();
  void arrange();
  void fill_derived();
  void show_figures(const std::vector<picture::DerivedFigure>& figures);
  void fold(Group& group, bool open);
  void apply(FieldEditor* editor, const QString& text, bool step);
  void apply_entries(ListField* editor, const EntryChange& change);
  void reset(FieldEditor* editor);
  [[nodiscard]] FieldContent content_of(const scene::Field& field, const std::string& value) const;
  void judge(FieldEditor* editor, const QString& text);
  [[nodiscard]] FieldEditor* editor_of(const QString& id) const;

  Session& session_;
  PanelSubject subject_;
  QLabel* title_ = nullptr;
  QLabel* remark_ = nullptr;
  ProblemLine* problems_ = nullptr;
  QVBoxLayout* layout_ = nullptr;
  QWidget* page_ = nullptr;
  QVBoxLayout* page_layout_ = nullptr;
  std::vector<Group> groups_;
  std::map<QString, FieldEditor*> editors_;
  std::set<QString> unfolded_;  // "radar/Pulse"
  QGroupBox* derived_box_ = nullptr;
  QTableWidget* derived_ = nullptr;
  QTimer derived_timer_;
  QTimer debounce_;  // many objects are selected, or have changed, which is not shown yet
  bool committing_ = false;
};

}  // namespace sarsim::gui
