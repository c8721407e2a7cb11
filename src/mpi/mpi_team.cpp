#include "mpi/mpi_team.hpp"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace sarsim::mpi {

namespace {

constexpr int request_tag = 1;
constexpr int answer_tag = 2;

// MPI's own waiting keeps a core busy, which others need for computing.
void rest() { std::this_thread::sleep_for(std::chrono::microseconds(300)); }

}  // namespace

// What is left to be dealt, in order: large pieces first, small ones at the end, so that all end together.
class MpiTeam::Desk {
 public:
  Desk(std::vector<raster::RowRange> todo, int processes)
      : todo_(std::move(todo)), pieces_at_a_time_(4 * static_cast<std::size_t>(processes)) {
    for (const raster::RowRange& range : todo_) left_ += range.count;
    total_ = left_;
    min_ = std::max<std::size_t>(total_ / (pieces_at_a_time_ * 64), 1);
  }

  [[nodiscard]] raster::RowRange next() {
    const std::scoped_lock hold(lock_);
    while (at_ < todo_.size() && todo_[at_].count == 0) ++at_;
    if (at_ == todo_.size()) return {};
    raster::RowRange& from = todo_[at_];
    const raster::RowRange piece{from.first, std::min(std::max(left_ / pieces_at_a_time_, min_), from.count)};
    from.first += piece.count;
    from.count -= piece.count;
    left_ -= piece.count;
    return piece;
  }

  void count_done(std::size_t rows) { done_ += rows; }
  [[nodiscard]] std::size_t done() const { return done_; }
  [[nodiscard]] std::size_t total() const { return total_; }

 private:
  std::mutex lock_;
  std::vector<raster::RowRange> todo_;
  std::size_t at_ = 0;  // The first of them that is not dealt yet.
  std::size_t left_ = 0;
  std::size_t total_ = 0;
  std::size_t pieces_at_a_time_;
  std::size_t min_ = 1;
  std::atomic<std::size_t> done_{0};
};

MpiTeam::MpiTeam() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  int count = 1;
  MPI_Comm_size(here, &count);
  MPI_Comm_free(&here);
  processes_here_ = static_cast<unsigned>(count);
}

std::string MpiTeam::name() const { return "rank-" + std::to_string(rank_); }

workflow::StepEnd MpiTeam::agree(workflow::StepEnd here) {
  using workflow::StepEnd;
  // The lowest rank that is not well, with its end in the last place.
  constexpr int ends = 3;
  const int mine = ends * (here == StepEnd::done ? size_ : rank_) + static_cast<int>(here);
  int first = mine;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  const auto end = static_cast<StepEnd>(first % ends);
  if (end != StepEnd::done) speaker_ = first / ends;
  return end;
}

std::string MpiTeam::from_leader(const std::string& text) {
  std::uint64_t size = text.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  std::string said = leads() ? text : std::string(static_cast<std::size_t>(size), '\0');
  MPI_Bcast(said.data(), static_cast<int>(size), MPI_CHAR, 0, MPI_COMM_WORLD);
  return said;
}

void MpiTeam::deal(const std::vector<raster::RowRange>& todo, const std::function<void(raster::RowRange)>& work,
                   const core::ProgressReport& progress) {
  if (!leads()) {
    follow(work);
    return;
  }
  Desk desk(todo, size_);
  lead(desk, work, progress);
}

void MpiTeam::follow(const std::function<void(raster::RowRange)>& work) {
  std::uint64_t made = 0;
  for (;;) {
    MPI_Send(&made, 1, MPI_UINT64_T, 0, request_tag, MPI_COMM_WORLD);
    std::array<std::uint64_t, 2> answer{};
    MPI_Recv(answer.data(), 2, MPI_UINT64_T, 0, answer_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    const raster::RowRange piece{static_cast<std::size_t>(answer[0]), static_cast<std::size_t>(answer[1])};
    if (piece.count == 0) return;
    work(piece);
    made = piece.count;
  }
}

void MpiTeam::lead(Desk& desk, const std::function<void(raster::RowRange)>& work,
                   const core::ProgressReport& progress) {
  std::atomic<bool> idle{false};
  std::exception_ptr failure;
  std::jthread worker([&] {
    try {
      for (raster::RowRange piece = desk.next(); piece.count > 0; piece = desk.next()) {
        work(piece);
        desk.count_done(piece.count);
      }
    } catch (...) {
      failure = std::current_exception();
    }
    idle = true;
  });
  for (int followers = size_ - 1; followers > 0 || !idle;) {
    if (idle && failure) break;
    int asked = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, request_tag, MPI_COMM_WORLD, &asked, &status);
    if (asked == 0) {
      rest();
      if (progress) progress({desk.done(), desk.total(), 0});
      continue;
    }
    std::uint64_t made = 0;
    MPI_Recv(&made, 1, MPI_UINT64_T, status.MPI_SOURCE, request_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    desk.count_done(static_cast<std::size_t>(made));
    const raster::RowRange piece = desk.next();
    const std::array<std::uint64_t, 2> answer{piece.first, piece.count};
    MPI_Send(answer.data(), 2, MPI_UINT64_T, status.MPI_SOURCE, answer_tag, MPI_COMM_WORLD);
    if (piece.count == 0) --followers;
  }
  worker.join();
  if (failure) std::rethrow_exception(failure);
  if (progress) progress({desk.done(), desk.total(), 0});
}

}  // namespace sarsim::mpi
