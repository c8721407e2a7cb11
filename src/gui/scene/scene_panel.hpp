#pragma once

#include <QWidget>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gui/common/session.hpp"
#include "picture/scene/drawing.hpp"
#include "picture/scene/snapshot.hpp"
#include "picture/scene/snapshot_maker.hpp"
#include "radar/earth/earth_frame.hpp"
#include "scene/edit/path_edits.hpp"

class QBoxLayout;
class QLabel;
class QMenu;

namespace sarsim::gui {

class CameraBar;
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

  /// How the view moves as time runs.
  enum class Ride {
    none,    ///< It stays where it is.
    follow,  ///< It keeps its way to an object. Panning changes that way.
    beam     ///< It looks along a radar's beam, from its antenna. Turning, panning and zooming by hand end it.
  };
  [[nodiscard]] Ride ride() const { return ride_; }
  /// What is followed, or whose beam it is; nothing for Ride::none.
  [[nodiscard]] std::optional<scene::ObjectId> rides_on() const { return rides_on_; }
  /// The view keeps an object in its middle as time runs; nothing: it stays where it is.
  void follow(std::optional<scene::ObjectId> object);
  [[nodiscard]] std::optional<scene::ObjectId> followed() const {
    return ride_ == Ride::follow ? rides_on_ : std::nullopt;
  }
  /// Follows the selected object, from where it is seen now; ends that where it is followed already. False where
  /// nothing is selected.
  bool follow_selection();
  /// Looks along the beam of a radar: this one, the selected one or the first. False where there is none.
  bool look_along_beam(std::optional<scene::ObjectId> radar = std::nullopt);
  /// Puts every view into a menu, by its name: the fixed ones, along each beam, following each platform, those that
  /// were kept.
  void fill_cameras(QMenu& menu);
  /// Keeps the view as it is under the next free name, "View 2", until the scene is closed.
  void keep_view();
  /// Measures between two places of the scene, or ends that.
  void measure(bool on);
  /// Clicks put points behind the path of the selected platform, until Enter or Escape; or ends that.
  void draw_path(bool on);
  /// Puts a point into the line of a selected path under the pointer, or under the one where a menu was asked for.
  void add_point_here();
  /// Takes the selected point out of its path.
  void delete_point();
  /// What hands can do at the pointer, for menus of the scene.
  void add_hand_entries(QMenu& menu);
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

  /// Shows the scene at the present time, after what is asked of its picture has changed.
  void show_time();

 signals:
  void ride_changed();                                  ///< The view moves in another way as time runs.
  void own_axes_changed(bool own);                      ///< The handles lie along other axes.
  void edit_requested(sarsim::scene::ObjectId object);  ///< The properties of an object are wanted.
  void delete_wanted();                                 ///< The selected objects are to go.
  /// At a place of the screen; for nothing: that of the scene.
  void menu_requested(std::optional<sarsim::scene::ObjectId> object, QPoint global);

 protected:
  /// Space in the scene plays and stops the time.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  // How a document is seen that is not at hand.
  struct View {
    picture::Camera camera;
    Ride ride = Ride::none;
    std::optional<scene::ObjectId> rides_on;
    core::Vec3 way_to_focus_m;
    std::vector<picture::Camera> kept;
    double step_s = 0.0;
  };

  void connect_gestures();
  void take_scene(const scene::SceneChange& change);
  void show_marks();
  void show_camera();
  void place_direction();
  void take_camera();
  void set_ride(Ride ride, std::optional<scene::ObjectId> on);
  void follow_ride(const scene::SceneChange& change);
  void leave_document();
  void show_first();
  void show_again(const View& view);
  void move_camera();
  [[nodiscard]] std::optional<picture::Camera> beam_camera() const;
  void show_handles();
  void show_what_came(const scene::SceneChange& change);
  [[nodiscard]] std::set<scene::ObjectId> with_carried(const std::set<scene::ObjectId>& objects) const;
  void select_point(const std::optional<picture::PathPointId>& point);
  void take_back();
  void take_tool();
  void show_path_end();
  [[nodiscard]] bool holds_state() const;
  [[nodiscard]] std::optional<scene::ObjectId> platform_to_draw() const;
  [[nodiscard]] core::Vec3 in_path_frame(const scene::Platform& platform, const core::Vec3& world_m) const;
  [[nodiscard]] core::Vec3 rounded_place(const core::Vec3& world_m) const;
  void add_point_behind(const core::Vec3& world_m);
  void divide_path(const picture::PathPlace& place);
  void change_path(scene::ObjectId platform, scene::PathEdit edit, const char* what);
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
  CameraBar* cameras_ = nullptr;
  QBoxLayout* top_ = nullptr;  // buttons of views and where the scene is seen from
  QLabel* direction_ = nullptr;
  QLabel* place_ = nullptr;
  std::optional<radar::EarthFrame> earth_;
  Ride ride_ = Ride::none;
  std::optional<scene::ObjectId> rides_on_;
  core::Vec3 way_to_focus_m_;  // from what is followed
  std::vector<picture::Camera> kept_views_;
  bool moves_camera_ = false;                // the view is changed by the ride, not by a hand
  std::optional<scene::AnyObject> dragged_;  // as it was when the drag began
  scene::ObjectId held_;
  scene::AnyObject written_;        // as the drag last wrote it
  core::Mat3 platform_from_world_;  // of what carries it
  core::Vec3 held_m_;               // of a path's point that is dragged: where it was, in the path's frame
  std::optional<picture::PathPointId> selected_point_;
  std::optional<scene::ObjectId> drawn_platform_;    // whose path is drawn
  std::optional<picture::PathPlace> place_of_menu_;  // of a path, where the last menu was asked for
  bool own_axes_ = false;
  bool new_document_ = true;
  std::map<int, View> views_;  // by the numbers of documents
  int shown_ = 0;              // the document that is seen
};

}  // namespace sarsim::gui
