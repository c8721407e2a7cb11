#pragma once

#include <QString>

#include <map>

class QDockWidget;

namespace sarsim::gui {

class DataSaver;
class DocumentKeeper;
class ImageViewers;
class ObjectTree;
class PropertyPanel;
class ScenePanel;
class ScriptEditor;
class Session;
class SimulationWindows;
class StoredSimulations;

/// What the main window is made of, for those that work with several parts of it, which they must not outlive.
struct Workbench {
  Session& session;
  DocumentKeeper& documents;
  ScenePanel& scene;
  ObjectTree& tree;
  PropertyPanel& panel;
  ScriptEditor& script;
  StoredSimulations& simulations;
  SimulationWindows& simulation_windows;
  ImageViewers& image_viewers;
  DataSaver& saver;
  const std::map<QString, QDockWidget*>& docks;  ///< "objects", "properties" ...

  /// What is typed and not yet entered belongs to what is saved, run or left.
  void commit_typed() const;
  /// Shows a panel, in front of those that share its place.
  void bring(const QString& dock) const;
};

}  // namespace sarsim::gui
