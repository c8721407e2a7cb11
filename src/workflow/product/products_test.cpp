#include "workflow/product/products.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace sarsim::workflow::products_test {

namespace {

// Calls `look(product)` for each of the table.
template <class Look>
void for_each_product(const Look& look) {
  std::apply([&look](const auto&... product) { (look(product), ...); }, products);
}

}  // namespace

TEST(Products, HaveNamesOfTheirOwnAndOptionsThatNameTheOutput) {
  std::set<std::string> names;
  for_each_product([&names](const auto& product) {
    EXPECT_TRUE(names.insert(product.name).second) << product.name;
    bool output = false;
    for (const auto& option : product.options()) output = output || option.name == "--out";
    EXPECT_TRUE(output) << product.name;
  });
  EXPECT_EQ(names.size(), 5U);
}

TEST(Products, TakeTheirInputAndTheirOptions) {
  for_each_product([](const auto& product) {
    const auto request = product.request("scene.toml", {{"--out", "a.npy"}});
    EXPECT_EQ(request.input.path, "scene.toml") << product.name;
    EXPECT_EQ(request.output, "a.npy") << product.name;
    EXPECT_THROW(static_cast<void>(product.request("scene.toml", {{"--threads", "many"}})), core::InvalidRequest);
  });
}

TEST(Products, StayInMemoryWhereNoNameIsGiven) {
  FocusRequest focus = focus_request("scene.toml", {});
  EXPECT_EQ(focus.output, "scene.img");
  keep_unnamed(focus, {});
  EXPECT_TRUE(focus.output.empty());
  FocusRequest named = focus_request("scene.toml", {{"--out", "a.img"}});
  keep_unnamed(named, {{"--out", "a.img"}});
  EXPECT_EQ(named.output, "a.img");
  IsarRequest isar;
  keep_unnamed(isar, {});
  EXPECT_TRUE(isar.keep);
}

TEST(Products, GiveTheirImagesAway) {
  IsarReport report;
  report.images.resize(2);
  report.images[0].kept.emplace();
  report.images[1].file = "b.img";
  const auto images = take_images(report, {});
  ASSERT_EQ(images.size(), 2U);
  EXPECT_TRUE(images[0].kept);
  EXPECT_FALSE(images[1].kept);
  EXPECT_EQ(images[1].file, "b.img");
  EXPECT_FALSE(report.images[0].kept);
  DopplerRequest detections;
  detections.image = false;
  DopplerReport pulses;
  EXPECT_TRUE(take_images(pulses, detections).empty());
}

TEST(Products, HaveTablesOfWhatWasLookedFor) {
  DopplerReport pulses;
  pulses.kept_table = "interval\n1\n";
  EXPECT_EQ(tables_of(pulses), std::vector<std::string>{"interval\n1\n"});
  pulses.options.detect = false;
  EXPECT_TRUE(tables_of(pulses).empty());
  EXPECT_EQ(tables_of(ProfilesReport{}).size(), 1U);
}

}  // namespace sarsim::workflow::products_test
