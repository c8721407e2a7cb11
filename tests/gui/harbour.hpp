#pragma once

#include <QFile>
#include <QString>
#include <utility>

/// The scene of the pictures, with something of every kind.
namespace sarsim::test {

/// Writes harbour.scr into a folder with roofs of 20 m instead of 500, whose echoes take long, and returns its path;
/// nothing where it cannot be written.
inline QString small_harbour(const QString& folder) {
  QFile scene(QStringLiteral(SARSIM_SOURCE_DIR "/tests/gui/harbour.scr"));
  QFile copy(folder + "/harbour.scr");
  if (!scene.open(QIODevice::ReadOnly) || !copy.open(QIODevice::WriteOnly)) return {};
  QByteArray text = scene.readAll();
  for (const auto& [roof, small_roof] :
       {std::pair{"-600, 900, 0\n-100, 900, 0\n-350, 1000, 260\n", "-600, 900, 0\n-580, 900, 0\n-590, 904, 10\n"},
        std::pair{"0, 900, 40\n500, 900, 40\n250, 1200, 40\n", "0, 900, 40\n20, 900, 40\n10, 912, 40\n"}}) {
    if (!text.contains(roof)) return {};
    text.replace(roof, small_roof);
  }
  return copy.write(text) == text.size() ? copy.fileName() : QString();
}

}  // namespace sarsim::test
