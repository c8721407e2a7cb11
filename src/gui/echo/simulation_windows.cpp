#include "gui/echo/simulation_windows.hpp"

#include <QWidget>

#include "gui/common/screen_size.hpp"
#include "gui/echo/simulation_window.hpp"
#include "gui/runs/stored_simulations.hpp"

namespace sarsim::gui {

SimulationWindows::SimulationWindows(Session& session, QWidget* owner)
    : QObject(owner), session_(session), owner_(owner) {
  connect(&session_, &Session::document_replaced, this, [this] {
    for (SimulationWindow* window : windows_) window->put_aside(window->document() != session_.number());
  });
  connect(&session_, &Session::document_closed, this, [this](int number) {
    for (SimulationWindow* window : QList(windows_))
      if (window->document() == number) window->close();
  });
}

std::vector<SimulationWindow*> SimulationWindows::windows() const {
  std::vector<SimulationWindow*> at_hand;
  for (SimulationWindow* window : windows_)
    if (window->document() == session_.number()) at_hand.push_back(window);
  return at_hand;
}

SimulationWindow* SimulationWindows::open_new(scene::Processing processing) {
  const scene::Scene& scene = session_.scene();
  if (scene.radars.empty()) return nullptr;
  const auto current = session_.current();
  const bool on_radar = current && current->kind == scene::ObjectKind::radar && current->index < scene.radars.size();
  const std::size_t radar = on_radar ? current->index : 0;
  picture::EchoWindow window = picture::new_echo_window(scene.radars[radar].name, processing);
  if (processing != scene::Processing::raw) {
    window.quantity = picture::DisplayQuantity::decibels;
    window.map = picture::ColourMap::ocean;
  }
  const scene::Simulation suitable = suitable_simulation(scene, radar);
  window.recording.time_start_s = suitable.time_start_s;
  window.recording.time_end_s = suitable.time_end_s;
  return open(window, true);
}

SimulationWindow* SimulationWindows::open_stored(scene::ObjectId simulation) {
  const scene::Scene& scene = session_.scene();
  if (simulation.kind != scene::ObjectKind::simulation || simulation.index >= scene.simulations.size()) return nullptr;
  return open(picture::window_of(scene.simulations[simulation.index]), false);
}

SimulationWindow* SimulationWindows::open(const picture::EchoWindow& state, bool show_all) {
  auto* const window = new SimulationWindow(session_, state, show_all, owner_);
  window->setWindowFlag(Qt::Window);
  window->setAttribute(Qt::WA_DeleteOnClose);
  window->resize(size_on_screen(*owner_, {1100, 760}));
  windows_.append(window);
  connect(window, &QObject::destroyed, this, [this, window] { windows_.removeAll(window); });
  connect(window, &SimulationWindow::view_changed, this,
          [this, window](const picture::EchoView& view, picture::AxisLink link) {
            for (SimulationWindow* other : windows())
              if (other != window) other->follow(view, link);
          });
  connect(window, &SimulationWindow::save_data_wanted, this,
          [this, window](const scene::Simulation& simulation) { emit save_data_wanted(simulation, window); });
  emit opened(window);
  window->show();
  return window;
}

}  // namespace sarsim::gui
