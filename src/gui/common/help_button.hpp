#pragma once

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QEvent>
#include <QPushButton>

namespace sarsim::gui {

/// Adds a button Help to a dialog's buttons, which does what F1 does there.
inline void add_help_button(QDialogButtonBox& buttons) {
  QPushButton* help = buttons.addButton(QDialogButtonBox::Help);
  help->setObjectName("help_button");
  help->setAutoDefault(false);
  help->setToolTip(QDialogButtonBox::tr("The page of the guide about this window (F1)"));
  QObject::connect(help, &QPushButton::clicked, help, [help] {
    QEvent wish(QEvent::HelpRequest);
    QCoreApplication::sendEvent(help, &wish);
  });
}

}  // namespace sarsim::gui
