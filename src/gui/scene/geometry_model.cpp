#include "gui/scene/geometry_model.hpp"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "gui/common/problem_line.hpp"

namespace sarsim::gui {

namespace {

constexpr std::size_t max_kept_values = 8'000'000;  // 64 MB
constexpr std::size_t max_waiting_blocks = 16;

QString errors_of(const scene::Scene& scene, const scene::GeometryTable& table) {
  QStringList texts;
  for (const core::Problem& problem : geometry_errors(scene, table)) texts += problem_text(problem);
  return texts.join('\n');
}

}  // namespace

// Computes blocks on its thread, those asked for last before the others.
class GeometryModel::Worker {
 public:
  explicit Worker(GeometryModel& model) : model_(model), thread_([this] { work(); }) {}

  ~Worker() {
    {
      const std::scoped_lock hold(lock_);
      ended_ = true;
      changed_.notify_all();
    }
    thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void set_table(int generation, scene::Scene scene, GeometryChoice choice) {
    const std::scoped_lock hold(lock_);
    table_ = Table{generation, std::move(scene), std::move(choice)};
    wanted_.clear();
    changed_.notify_all();
  }

  void want(std::int64_t block) {
    const std::scoped_lock hold(lock_);
    if (computing_ == block || std::ranges::find(wanted_, block) != wanted_.end()) return;
    wanted_.push_front(block);
    if (wanted_.size() > max_waiting_blocks) wanted_.pop_back();
    changed_.notify_all();
  }

 private:
  struct Table {
    int generation = 0;
    scene::Scene scene;
    GeometryChoice choice;
  };

  void work() {
    for (;;) {
      std::optional<Table> table;
      {
        std::unique_lock hold(lock_);
        computing_ = -1;
        changed_.wait(hold, [&] { return ended_ || table_ || !wanted_.empty(); });
        if (ended_) return;
        table = std::exchange(table_, std::nullopt);
        if (!table) {
          computing_ = wanted_.front();
          wanted_.pop_front();
        }
      }
      if (table)
        prepare(std::move(*table));
      else
        compute();
    }
  }

  void prepare(Table table) {
    rows_.reset();
    const int generation = generation_ = table.generation;
    QString failure;
    try {
      failure = errors_of(table.scene, table.choice.table);
      if (failure.isEmpty()) rows_ = std::make_unique<GeometryRows>(table.scene, std::move(table.choice));
    } catch (const std::exception& error) {
      failure = QString::fromStdString(error.what());
    }
    if (!rows_) {
      post([generation, failure](GeometryModel& model) { model.take_failure(generation, failure); });
      return;
    }
    post([generation, headings = rows_->headings(), pulses = rows_->pulses()](GeometryModel& model) {
      model.take_headings(generation, headings, pulses);
    });
  }

  void compute() {
    if (!rows_) return;
    const std::int64_t block = computing_;
    Block values;
    try {
      values = rows_->values(block * block_rows, block_rows);
    } catch (const std::exception& error) {
      post([generation = generation_, text = QString::fromStdString(error.what())](GeometryModel& model) {
        model.take_failure(generation, text);
      });
      rows_.reset();
      return;
    }
    post([generation = generation_, block, values = std::move(values)](GeometryModel& model) {
      model.take_block(generation, block, values);
    });
  }

  template <class Call>
  void post(Call call) {
    QMetaObject::invokeMethod(
        &model_, [&model = model_, call = std::move(call)] { call(model); }, Qt::QueuedConnection);
  }

  GeometryModel& model_;
  std::mutex lock_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::optional<Table> table_;
  std::deque<std::int64_t> wanted_;
  std::int64_t computing_ = -1;
  int generation_ = 0;                  // of rows_; the thread's own
  std::unique_ptr<GeometryRows> rows_;  // the thread's own
  std::thread thread_;
};

GeometryModel::GeometryModel(QObject* parent) : QAbstractTableModel(parent), worker_(std::make_unique<Worker>(*this)) {}

GeometryModel::~GeometryModel() = default;

void GeometryModel::set_table(const scene::Scene& scene, const GeometryChoice& choice) {
  beginResetModel();
  ++generation_;
  pulses_ = {};
  rows_ = 0;
  kept_.clear();
  uses_.clear();
  endResetModel();
  worker_->set_table(generation_, scene, choice);
}

void GeometryModel::take_headings(int generation, std::vector<GeometryHeading> headings, radar::PulseRange pulses) {
  if (generation != generation_) return;
  beginResetModel();
  headings_ = std::move(headings);
  pulses_ = pulses;
  rows_ = static_cast<int>(std::min<std::int64_t>(pulses.count(), std::numeric_limits<int>::max()));
  endResetModel();
  emit ready();
}

void GeometryModel::take_failure(int generation, const QString& problems) {
  if (generation != generation_) return;
  beginResetModel();
  headings_.clear();
  pulses_ = {};
  rows_ = 0;
  endResetModel();
  emit failed(problems);
}

void GeometryModel::take_block(int generation, std::int64_t block, Block values) {
  if (generation != generation_ || kept_.contains(block)) return;
  const std::size_t room = std::max<std::size_t>(8, max_kept_values / std::max<std::size_t>(values.size(), 1));
  while (kept_.size() >= room) {
    kept_.erase(uses_.back());
    uses_.pop_back();
  }
  uses_.push_front(block);
  kept_[block] = {std::move(values), uses_.begin()};
  const auto first = static_cast<int>(block * block_rows);
  const auto last = static_cast<int>(std::min<std::int64_t>((block + 1) * block_rows, rows_) - 1);
  emit dataChanged(index(first, 0), index(last, columnCount() - 1));
}

const GeometryModel::Block* GeometryModel::block_of(std::int64_t block) const {
  const auto found = kept_.find(block);
  if (found == kept_.end()) {
    worker_->want(block);
    return nullptr;
  }
  uses_.splice(uses_.begin(), uses_, found->second.use);
  return &found->second.values;
}

int GeometryModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : rows_; }

int GeometryModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(headings_.size());
}

QString GeometryModel::text_of(double value, int column) const {
  const GeometryHeading& heading = headings_[static_cast<std::size_t>(column)];
  if (std::isnan(value)) return QStringLiteral("–");
  // Adding 0 turns -0 into 0.
  return QString::number(value / heading.scale + 0.0, 'g', heading.digits);
}

QVariant GeometryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rows_ || index.column() >= columnCount()) return {};
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != value_role && role != Qt::ToolTipRole) return {};
  const Block* block = block_of(index.row() / block_rows);
  const auto at =
      static_cast<std::size_t>(index.row() % block_rows) * headings_.size() + static_cast<std::size_t>(index.column());
  const bool there = block != nullptr && at < block->size();
  if (role == value_role) return there ? QVariant((*block)[at]) : QVariant();
  if (role == Qt::ToolTipRole)
    return there && std::isnan((*block)[at]) ? tr("Outside the slant range window") : QVariant();
  return there ? text_of((*block)[at], index.column()) : QStringLiteral("…");
}

QVariant GeometryModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  const GeometryHeading& heading = headings_[static_cast<std::size_t>(section)];
  QString text = QString::fromStdString(heading.quantity);
  if (!heading.unit.empty()) text += QStringLiteral(" (%1)").arg(QString::fromStdString(heading.unit));
  const QString owner = QString::fromStdString(heading.owner);
  if (role == Qt::ToolTipRole) return owner.isEmpty() ? text : owner + ": " + text;
  return owner + '\n' + text;
}

}  // namespace sarsim::gui
