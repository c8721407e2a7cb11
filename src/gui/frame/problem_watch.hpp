#pragma once

#include <QObject>
#include <QTimer>

#include <map>
#include <memory>

#include "gui/common/latest_only_work.hpp"
#include "gui/common/session.hpp"

namespace sarsim::gui {

/// All that is wrong with the document, looked for anew once the hand rests: what the session knows, and what only a
/// survey of the echoes can tell ("the recording will be empty"), which is made in the background.
class ProblemWatch : public QObject {
  Q_OBJECT

 public:
  explicit ProblemWatch(Session& session, QObject* parent = nullptr);

  /// All of them, ranked, with their places in the script as it was when they were found.
  [[nodiscard]] const core::Problems& problems() const { return problems_; }
  /// Those that the survey found last, with their places; while the script holds errors, of the scene before.
  [[nodiscard]] const core::Problems& of_echoes() const { return of_echoes_; }
  /// What the survey says of each simulation, a line each thing (workflow/input/echo_words.hpp); empty without one.
  [[nodiscard]] QString echoes() const;

 signals:
  void changed();  ///< They were looked for; they may be the same as before.

 private:
  void begin_document();
  void wait_for_rest();
  void look();
  void look_at_echoes();
  void take_survey(bool good);
  void collect();

  Session& session_;
  QTimer rest_;
  bool fresh_ = true;  // nothing was told of this document yet
  LatestOnlyWork survey_;
  // What a survey has found.
  struct Found {
    core::Problems problems;  // without places
    QString echoes;
  };
  std::shared_ptr<Found> found_;   // by the one under way
  std::map<int, Found> surveyed_;  // by the last one of each document, by their numbers
  core::Problems of_echoes_;
  core::Problems problems_;
};

}  // namespace sarsim::gui
