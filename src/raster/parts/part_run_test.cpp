#include "raster/parts/part_run.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "core/report/retryable.hpp"
#include "raster/format/data_test_support.hpp"

namespace sarsim::raster {
namespace part_run_test {

using data_test::contents;
using data_test::TestFolder;
using testing::ElementsAre;
using testing::HasSubstr;

namespace fs = std::filesystem;

constexpr std::size_t rows = 12;
constexpr std::size_t columns = 5;
constexpr int bits = 12;

StoredProduct stored_as(scene::FileFormat format, bool counts = false) {
  StoredProduct stored;
  stored.product = data_test::test_product(rows, columns, bits);
  stored.product.lsb_v = 2.5e-9;
  stored.options.format = format;
  stored.options.counts = counts;
  stored.engine_reason = "because";
  return stored;
}

PartTask task_for(const fs::path& output, const StoredProduct& product, const std::string& name, RowRange range) {
  PartTask task;
  task.output = output;
  task.name = name;
  task.words = name;
  task.range = range;
  task.identity = {{"seed", "1"}};
  task.product = product;
  task.pace.seconds = 0.0;
  return task;
}

// Rows of the test's recording as their file holds them.
EncodedRows encoded(const StoredProduct& stored, RowRange range) {
  const auto sink = make_discarding_sink(stored.product, stored.options);
  const auto counts = data_test::test_counts(rows * columns, bits);
  const auto volts = data_test::test_volts(rows * columns);
  Block block{range.first, range.count, columns, {}, {}};
  if (sink->wants_counts())
    block.counts = std::span(counts).subspan(2 * range.first * columns, 2 * range.count * columns);
  else
    block.volts = std::span(volts).subspan(range.first * columns, range.count * columns);
  return {range, sink->encode(block), {1e-6 * static_cast<double>(range.end()), range.count, 1}};
}

PartOutcome make(PartRun& part, const StoredProduct& stored) {
  for (const RowRange& range : part.missing())
    for (std::size_t row = range.first; row < range.end(); ++row) part.writer().take(encoded(stored, {row, 1}));
  return part.finish(false, {});
}

class PartRunOfFormats : public testing::TestWithParam<std::pair<scene::FileFormat, bool>> {};

TEST_P(PartRunOfFormats, MakesTheFileThatASinkMakes) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(GetParam().first, GetParam().second);
  data_test::write_test_file(folder / "whole", stored.product, stored.options);
  PartRun last(task_for(folder / "out", stored, "b", {7, 5}), {});
  PartRun first(task_for(folder / "out", stored, "a", {0, 7}), {});
  EXPECT_FALSE(make(last, stored).joined.has_value());
  EXPECT_FALSE(fs::exists(folder / "out"));
  const PartOutcome outcome = make(first, stored);
  ASSERT_TRUE(outcome.joined.has_value());
  EXPECT_EQ(contents(folder / "out"), contents(folder / "whole"));
  EXPECT_EQ(outcome.joined->report.saturated, rows);
  EXPECT_EQ(outcome.joined->report.maximum_v, 12e-6);
  EXPECT_EQ(folder.entries(), 3U);  // The two files and the receipt.
  const auto receipt = read_receipt(folder / "out", stored);
  ASSERT_TRUE(receipt.has_value());
  EXPECT_THAT(receipt->identity, ElementsAre(std::pair<std::string, std::string>("seed", "1")));
  EXPECT_EQ(receipt->report.maximum_v, 12e-6);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, PartRunOfFormats,
    testing::Values(std::pair(scene::FileFormat::binary, false), std::pair(scene::FileFormat::ascii, false),
                    std::pair(scene::FileFormat::csv, false), std::pair(scene::FileFormat::npy, false),
                    std::pair(scene::FileFormat::npy, true), std::pair(scene::FileFormat::hdf5, false),
                    std::pair(scene::FileFormat::hdf5, true), std::pair(scene::FileFormat::zarr, false),
                    std::pair(scene::FileFormat::zarr, true)));

TEST(PartRun, GoesOnWithWhatItsJournalVouchesFor) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  PartTask task = task_for(folder / "out", stored, "all", {0, rows});
  {
    PartRun early(task, {});
    early.writer().take(encoded(stored, {0, 2}));
    early.writer().take(encoded(stored, {5, 3}));
  }
  EXPECT_THROW(PartRun(task, {}), core::InvalidRequest);
  task.resume = true;
  PartRun late(task, {});
  EXPECT_THAT(late.missing(), ElementsAre(RowRange{2, 3}, RowRange{8, 4}));
  EXPECT_TRUE(make(late, stored).joined.has_value());
  data_test::write_test_file(folder / "whole", stored.product, stored.options);
  EXPECT_EQ(contents(folder / "out"), contents(folder / "whole"));
}

TEST(PartRun, IsRefusedWhileItsRowsAreBeingMade) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  const PartRun busy(task_for(folder / "out", stored, "a", {0, 7}), {});
  PartTask task = task_for(folder / "out", stored, "b", {6, 6});
  task.resume = true;
  try {
    const PartRun other(task, {});
    FAIL() << "two parts share row 6";
  } catch (const core::RetryableError& unfit) {
    EXPECT_THAT(unfit.problems.at(0).message, HasSubstr("part b overlaps part a, which is being made"));
  }
  task.range = {7, 5};
  EXPECT_NO_THROW(PartRun(task, {}));
}

TEST(PartRun, ThatIsDealtRowsNeedsTheJournalOfWhoDealsThem) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  PartTask dealt = task_for(folder / "out", stored, "rank-1", {});
  dealt.dealt = true;
  EXPECT_THROW(PartRun(dealt, {}), core::InvalidRequest);
  PartRun leader(task_for(folder / "out", stored, "all", {0, rows}), {});
  PartRun follower(dealt, {});
  EXPECT_TRUE(follower.missing().empty());
  follower.writer().take(encoded(stored, {3, 4}));
  follower.writer().settle();
  leader.writer().take(encoded(stored, {0, 3}));
  leader.writer().take(encoded(stored, {7, 5}));
  EXPECT_TRUE(leader.finish(false, {}).joined.has_value());
}

TEST(PartRun, ThatComesLateFindsTheRecordingComplete) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  PartRun first(task_for(folder / "out", stored, "a", {0, 7}), {});
  PartRun second(task_for(folder / "out", stored, "b", {7, 5}), {});
  for (std::size_t row = 0; row < 7; ++row) first.writer().take(encoded(stored, {row, 1}));
  for (std::size_t row = 7; row < rows; ++row) second.writer().take(encoded(stored, {row, 1}));
  first.writer().settle();
  EXPECT_TRUE(second.finish(false, {}).joined.has_value());
  EXPECT_TRUE(first.finish(false, {}).elsewhere);
  EXPECT_EQ(folder.entries(), 2U);
}

// Rows 0 to 6 were made, and vouched for, by a process that ended.
StoredProduct begun_recording(const TestFolder& folder) {
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  PartRun early(task_for(folder / "out", stored, "a", {0, 7}), {});
  EXPECT_FALSE(make(early, stored).joined.has_value());
  return stored;
}

void expect_refused(PartRun& last, const StoredProduct& stored, const TestFolder& folder) {
  try {
    static_cast<void>(make(last, stored));
    FAIL() << "rows that are not there were published";
  } catch (const core::InvalidRequest& unfit) {
    EXPECT_THAT(unfit.problems.at(0).message, HasSubstr("are not what part a wrote"));
  }
  EXPECT_FALSE(fs::exists(folder / "out"));
  // The part that is to blame can be made again, and then it is the last.
  PartTask again = task_for(folder / "out", stored, "a", {0, 7});
  again.resume = true;
  PartRun repaired(again, {});
  EXPECT_GT(repaired.rejected_rows(), 0U);
  EXPECT_TRUE(make(repaired, stored).joined.has_value());
  data_test::write_test_file(folder / "whole", stored.product, stored.options);
  EXPECT_EQ(contents(folder / "out"), contents(folder / "whole"));
}

TEST(PartRun, PublishesNothingWhereTheSharedFileWasLost) {
  const TestFolder folder;
  const StoredProduct stored = begun_recording(folder);
  fs::remove(shared_rows_of(parts_folder_of(folder / "out")));
  PartRun last(task_for(folder / "out", stored, "b", {7, 5}), {});
  expect_refused(last, stored, folder);
}

TEST(PartRun, PublishesNothingWhereRowsOfOthersWereChanged) {
  const TestFolder folder;
  const StoredProduct stored = begun_recording(folder);
  const fs::path samples = shared_rows_of(parts_folder_of(folder / "out"));
  std::string bytes = contents(samples);
  bytes[3] = static_cast<char>(bytes[3] ^ 1);
  data_test::put(samples, bytes);
  PartRun last(task_for(folder / "out", stored, "b", {7, 5}), {});
  expect_refused(last, stored, folder);
}

TEST(PartRun, WhoseFolderIsDeletedSaysSo) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  PartRun part(task_for(folder / "out", stored, "all", {0, rows}), {});
  fs::remove_all(parts_folder_of(folder / "out"));
  try {
    static_cast<void>(make(part, stored));
    FAIL() << "a recording that is not there is called complete";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("were taken out of the folder"));
  }
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(PartRun, WhoseRowsAreTakenAwaySaysSo) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  PartRun part(task_for(folder / "out", stored, "all", {0, rows}), {});
  fs::remove(shared_rows_of(parts_folder_of(folder / "out")));
  EXPECT_THROW(static_cast<void>(make(part, stored)), std::runtime_error);
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(PartRun, ThatComesLateIsNotCompletedByAFileOfAnotherRun) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  PartTask task = task_for(folder / "out", stored, "all", {0, rows});
  PartRun part(task, {});
  fs::remove_all(parts_folder_of(folder / "out"));
  task.identity = {{"seed", "2"}};
  {
    PartRun other(task, {});
    ASSERT_TRUE(make(other, stored).joined.has_value());
  }
  EXPECT_THROW(static_cast<void>(part.finish(false, {})), std::runtime_error);
}

TEST(PartRun, WorksBesideTheFileThatALinkMeans) {
  const TestFolder folder;
  const data_test::SmallDisk disk(folder / "disk", "size=1m");
  if (!disk.mounted()) GTEST_SKIP() << "a second file system cannot be mounted here";
  fs::create_symlink(folder / "disk" / "real", folder / "out");
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  PartRun part(task_for(folder / "out", stored, "all", {0, rows}), {});
  EXPECT_TRUE(fs::exists(folder / "disk" / "real.parts"));
  EXPECT_TRUE(make(part, stored).joined.has_value());
  EXPECT_TRUE(fs::is_symlink(folder / "out"));
  data_test::write_test_file(folder / "whole", stored.product, stored.options);
  EXPECT_EQ(contents(folder / "disk" / "real"), contents(folder / "whole"));
  EXPECT_TRUE(read_receipt(folder / "out", stored).has_value());
}

TEST(PartRun, DoesNotReplaceAFileThatAppearedMeanwhile) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  PartRun part(task_for(folder / "out", stored, "all", {0, rows}), {});
  data_test::put(folder / "out", "precious");
  EXPECT_THROW(static_cast<void>(make(part, stored)), std::system_error);
  EXPECT_EQ(contents(folder / "out"), "precious");
  EXPECT_TRUE(fs::exists(folder / "out.parts" / "all.journal"));
  EXPECT_FALSE(fs::exists(folder / "out.journal"));  // A receipt would be for a file that is not there.
}

TEST(PartRun, DoesNotWriteFilesThatHaveOtherNames) {
  for (const bool apart : {false, true}) {
    const TestFolder folder;
    const StoredProduct stored = stored_as(scene::FileFormat::binary);
    const fs::path parts = parts_folder_of(folder / "out");
    fs::create_directory(parts);
    data_test::put(folder / "victim", "precious");
    fs::create_hard_link(folder / "victim", parts / (apart ? "all.rows" : "samples"));
    PartTask task = task_for(folder / "out", stored, "all", {0, rows});
    task.apart = apart;
    EXPECT_THROW(PartRun(task, {}), core::InvalidRequest);
    EXPECT_EQ(contents(folder / "victim"), "precious");
  }
}

// What is made for a moment beside the parts: "joined" of texts, "frame" of HDF5.
TEST(PartRun, IsNotLedElsewhereByNamesOfScratchFiles) {
  for (const auto format : {scene::FileFormat::csv, scene::FileFormat::hdf5}) {
    const TestFolder folder;
    const StoredProduct stored = stored_as(format);
    const fs::path parts = parts_folder_of(folder / "out");
    fs::create_directory(parts);
    data_test::put(folder / "victim", "precious");
    for (const char* name : {"joined", "frame"}) fs::create_symlink("../victim", parts / name);
    ASSERT_EQ(::mkfifo((parts / "all.frame").c_str(), 0600), 0);
    PartRun part(task_for(folder / "out", stored, "all", {0, rows}), {});
    EXPECT_TRUE(make(part, stored).joined.has_value());
    EXPECT_EQ(contents(folder / "victim"), "precious");
    EXPECT_FALSE(fs::is_symlink(folder / "out"));
    data_test::write_test_file(folder / "whole", stored.product, stored.options);
    EXPECT_EQ(contents(folder / "out"), contents(folder / "whole"));
  }
}

TEST(Receipt, IsOfNoUseForAFileThatWasChanged) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  PartRun part(task_for(folder / "out", stored, "all", {0, rows}), {});
  ASSERT_TRUE(make(part, stored).joined.has_value());
  ASSERT_TRUE(read_receipt(folder / "out", stored).has_value());
  data_test::put(folder / "out", "something else");
  EXPECT_FALSE(read_receipt(folder / "out", stored).has_value());
}

TEST(StoredProduct, ComesBackWhole) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(scene::FileFormat::hdf5, true);
  store_product(folder / "product", stored);
  const StoredProduct back = load_product(folder / "product");
  const Product& a = stored.product;
  const Product& b = back.product;
  EXPECT_EQ(std::tie(b.radar, b.rows, b.columns, b.sample_rate_hz, b.bits, b.lsb_v, b.options, b.engine, b.script),
            std::tie(a.radar, a.rows, a.columns, a.sample_rate_hz, a.bits, a.lsb_v, a.options, a.engine, a.script));
  EXPECT_EQ(b.row_time_s(rows - 1), a.row_time_s(rows - 1));
  EXPECT_EQ(b.row_carrier_hz(3), a.row_carrier_hz(3));
  EXPECT_EQ(b.row_pose(3).position_m, a.row_pose(3).position_m);
  EXPECT_EQ(b.row_pose(rows - 1).velocity_mps, a.row_pose(rows - 1).velocity_mps);
  EXPECT_EQ(b.row_pose(rows - 1).rotation_rad, a.row_pose(rows - 1).rotation_rad);
  EXPECT_EQ(b.column_range_m(columns - 1), a.column_range_m(columns - 1));
  EXPECT_EQ(back.options.format, scene::FileFormat::hdf5);
  EXPECT_TRUE(back.options.counts);
  EXPECT_EQ(back.engine_reason, "because");
}

TEST(StoredProduct, IsThatOfItsRunAlone) {
  const TestFolder folder;
  StoredProduct stored = stored_as(scene::FileFormat::binary);
  stored.identity = {{"seed", "1"}, {"LSB", "2.5e-09 V"}};
  store_product(folder / "product", stored);
  const StoredProduct back = load_product(folder / "product");
  EXPECT_EQ(back.identity, stored.identity);
  Journal journal;
  journal.head.identity = stored.identity;
  journal.head.part = "1/2";
  EXPECT_TRUE(product_problems(back, folder / "product", journal).empty());
  Journal other = journal;
  other.head.identity[1].second = "1e-05 V";
  const core::Problems problems = product_problems(back, folder / "product", other);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].message, HasSubstr("LSB is 2.5e-09 V in the description, 1e-05 V in part 1/2"));
  EXPECT_EQ(problems[0].place.file, (folder / "product").string());
}

TEST(Part, WritesTheDescriptionOfItsRunInPlaceOfAnother) {
  const TestFolder folder;
  const StoredProduct stored = stored_as(scene::FileFormat::binary);
  { PartRun first(task_for(folder / "out", stored, "part-1", {0, 4}), {}); }
  StoredProduct other = stored;
  other.identity = {{"seed", "2"}};
  store_product(folder / "out.parts/product", other);
  PartRun second(task_for(folder / "out", stored, "part-2", {4, 4}), {});
  EXPECT_EQ(load_product(folder / "out.parts/product").identity, (Identity{{"seed", "1"}}));
}

TEST(Joins, LeaveNothingThatKeepsTheNextOneOut) {
  const TestFolder folder;
  fs::create_directories(folder / "m.parts");
  data_test::put(folder / "m.parts/.joined.partial-4711-0", "half");
  fs::create_directories(folder / "m.parts/.frame.partial-4711-1");
  EXPECT_TRUE(is_left_by_join(".joined.partial-4711-0"));
  EXPECT_FALSE(is_left_by_join("samples"));
  EXPECT_FALSE(is_left_by_join("mine.joined.partial-1"));
  {
    const core::RawFile door = open_door(folder / "m.parts");
    remove_joins(folder / "m.parts");
  }
  EXPECT_FALSE(fs::exists(folder / "m.parts"));
  // Parts, and what is somebody else's, stay.
  fs::create_directories(folder / "n.parts");
  data_test::put(folder / "n.parts/mine", "text");
  data_test::put(folder / "n.parts/joined", "half");
  remove_joins(folder / "n.parts");
  EXPECT_TRUE(fs::exists(folder / "n.parts/mine"));
  EXPECT_FALSE(fs::exists(folder / "n.parts/joined"));
}

std::string refusal_of(const fs::path& product) {
  try {
    static_cast<void>(load_product(product));
  } catch (const core::InvalidRequest& refused) {
    const core::Problem& problem = refused.problems.at(0);
    EXPECT_EQ(problem.place.file, product.string());
    EXPECT_FALSE(problem.expected.empty());
    EXPECT_FALSE(problem.hint.empty());
    return problem.message;
  }
  return "not refused";
}

TEST(StoredProduct, IsRefusedWhereAByteIsAnother) {
  const TestFolder folder;
  store_product(folder / "product", stored_as(scene::FileFormat::binary));
  const std::string text = contents(folder / "product");
  for (const std::size_t at : {std::size_t{8}, text.size() / 2, text.size() - 1}) {
    std::string other = text;
    other[at] = static_cast<char>(other[at] ^ 1);
    data_test::put(folder / "product", other);
    EXPECT_EQ(refusal_of(folder / "product"), "the description of the recording is damaged") << at;
  }
}

TEST(StoredProduct, IsRefusedByItsSizeAndBeginningBeforeAnyMemoryIsTaken) {
  const TestFolder folder;
  const fs::path product = folder / "product";
  EXPECT_EQ(refusal_of(product), "the description of the recording is missing");
  data_test::put(product, "short");
  EXPECT_EQ(refusal_of(product), "the size is not that of the description of a recording");
  fs::resize_file(product, std::uintmax_t{1} << 33U);
  EXPECT_EQ(refusal_of(product), "this is not the description of a recording");
  store_product(product, stored_as(scene::FileFormat::binary));
  fs::resize_file(product, std::uintmax_t{1} << 40U);
  EXPECT_EQ(refusal_of(product), "the size is not that of the description of a recording");
}

}  // namespace part_run_test
}  // namespace sarsim::raster
