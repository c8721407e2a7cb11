#pragma once

#include <QWidget>

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "gui/common/session.hpp"
#include "picture/scene/drawing.hpp"
#include "picture/scene/snapshot.hpp"
#include "radar/earth/earth_frame.hpp"

class QLabel;

namespace sarsim::gui {

class SceneWidget;
class TimeBar;

/// The scene of a session at its time, with the time bar below: gestures become edits and selections.
class ScenePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ScenePanel(Session& session, QWidget* parent = nullptr);
  ~ScenePanel() override;

  [[nodiscard]] SceneWidget& scene() { return *scene_; }
  [[nodiscard]] TimeBar& time_bar() { return *time_bar_; }

  /// The view keeps this platform in its middle as time runs; nothing: it stays where it is.
  void follow(std::optional<scene::ObjectId> platform);
  [[nodiscard]] std::optional<scene::ObjectId> followed() const { return followed_; }
  /// Puts a world point into the middle.
  void focus_on(const core::Vec3& world_m);
  /// Puts the selected objects into the middle.
  void focus_on_selection();
  /// Fills the picture with the selected objects, and with what selected platforms carry; with everything where nothing
  /// is selected.
  void zoom_to_selection();
  /// Handles along the axes of a platform, or of what carries a target, instead of the world's.
  void set_own_axes(bool own);
  [[nodiscard]] bool own_axes() const { return own_axes_; }

 signals:
  void own_axes_changed(bool own);                      ///< The handles lie along other axes.
  void edit_requested(sarsim::scene::ObjectId object);  ///< The properties of an object are wanted.
  void delete_wanted();                                 ///< The selected objects are to go.
  /// At a place of the screen; for nothing: that of the scene.
  void menu_requested(std::optional<sarsim::scene::ObjectId> object, QPoint global);

 protected:
  /// Space in the scene plays and stops the time.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void connect_gestures();
  void take_scene(const scene::SceneChange& change);
  void show_time();
  void show_marks();
  void show_camera();
  void show_handles();
  void show_what_came(const scene::SceneChange& change);
  [[nodiscard]] std::set<scene::ObjectId> with_carried(const std::set<scene::ObjectId>& objects) const;
  void select_point(const std::optional<picture::PathPointId>& point);
  void take_back();
  void turn(scene::ObjectId id, std::size_t ring, double by_rad);
  void begin_drag(scene::ObjectId id);
  void begin_path_drag(const picture::PathPointId& point);
  // How the world's axes lie in a platform; as in the world where there is no such platform.
  [[nodiscard]] core::Mat3 frame_of(const std::string& platform) const;
  void drag(scene::ObjectId id, const core::Vec3& delta_world_m);
  void drag_path(const picture::PathPointId& point, const core::Vec3& delta_world_m, double resolution_m);
  // Whether what the hand holds is there as the drag left it.
  [[nodiscard]] bool still_held(scene::ObjectId id);
  void write_dragged(scene::ObjectId id, scene::AnyObject object, const char* what);
  void show_place(const std::optional<core::Vec3>& world_m);

  Session& session_;
  std::unique_ptr<picture::SnapshotMaker> maker_;
  SceneWidget* scene_ = nullptr;
  TimeBar* time_bar_ = nullptr;
  QLabel* direction_ = nullptr;
  QLabel* place_ = nullptr;
  std::optional<radar::EarthFrame> earth_;
  std::optional<scene::ObjectId> followed_;
  std::optional<scene::AnyObject> dragged_;  // as it was when the drag began
  scene::ObjectId held_;
  scene::AnyObject written_;        // as the drag last wrote it
  core::Mat3 platform_from_world_;  // of what carries it
  core::Vec3 held_m_;               // of a path's point that is dragged: where it was, in the path's frame
  std::optional<picture::PathPointId> selected_point_;
  bool own_axes_ = false;
  bool new_document_ = true;
};

}  // namespace sarsim::gui
