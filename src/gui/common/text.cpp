#include "gui/common/text.hpp"

#include <QCoreApplication>

#include "core/text/number_text.hpp"

namespace sarsim::gui {

QString with_time_left(const QString& done, double seconds_left) {
  if (seconds_left < 0.0) return done;
  return QCoreApplication::translate("Progress", "%1, about %2 left")
      .arg(done, text_of(core::duration_text(seconds_left)));
}

QString share_with_time_left(double fraction, double seconds_left) {
  return with_time_left(QCoreApplication::translate("Progress", "%1 %").arg(100.0 * fraction, 0, 'f', 0), seconds_left);
}

}  // namespace sarsim::gui
