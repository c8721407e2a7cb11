#pragma once

#include "workflow/record/team.hpp"

namespace sarsim::mpi {

/// The processes of an MPI job. MPI must be initialised before and is used from the main thread alone.
class MpiTeam final : public workflow::Team {
 public:
  MpiTeam();

  [[nodiscard]] bool leads() const override { return rank_ == 0; }
  [[nodiscard]] std::string name() const override;
  [[nodiscard]] unsigned processes_here() const override { return processes_here_; }
  [[nodiscard]] workflow::StepEnd agree(workflow::StepEnd here) override;
  [[nodiscard]] bool failure_is_known() const override { return speaker_ >= 0; }
  [[nodiscard]] bool speaks() const override { return speaker_ == rank_; }
  [[nodiscard]] std::string from_leader(const std::string& text) override;
  /// The leader's main thread answers whoever asks for work, while another thread of it computes as well.
  void deal(const std::vector<raster::RowRange>& todo, const std::function<void(raster::RowRange)>& work,
            const core::ProgressReport& progress) override;

 private:
  class Desk;

  void lead(Desk& desk, const std::function<void(raster::RowRange)>& work, const core::ProgressReport& progress);
  void follow(const std::function<void(raster::RowRange)>& work);

  int rank_ = 0;
  int size_ = 1;
  unsigned processes_here_ = 1;
  int speaker_ = -1;  // The first process that told of a failure.
};

}  // namespace sarsim::mpi
