#include "scene/schema/field_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "scene/model/object.hpp"

namespace sarsim::scene {

namespace field_table_test {

// Every field of every kind and of the options, with an initial object.
template <class Visit>
void for_each_field(const Visit& visit) {
  for_each_kind([&]<class Object>(const Kind<Object>& kind) {
    for (const FieldOf<Object>& field : table_of(kind).fields()) visit(kind.name, field, Object{});
  });
  for (const FieldOf<RunOptions>& field : table_of<RunOptions>().fields()) visit("options", field, RunOptions{});
}

TEST(FieldTable, IsAskedForTheFieldOfAMember) {
  EXPECT_EQ(field_of<&Radar::prf_hz>().spec.id, "prf_hz");
  EXPECT_EQ((field_of<&Radar::receive_antenna, &Antenna::azimuth_beamwidth>().spec.id),
            "receive_antenna.azimuth_beamwidth");
  EXPECT_EQ((field_of<&Surface::corner_m, 2>().spec.id), "corner_m[2]");
}

TEST(FieldTable, TypesFollowFromTheMembers) {
  EXPECT_EQ(field_of<&Radar::losses>().spec.type, FieldType::number);
  EXPECT_EQ(field_of<&Radar::carrier_steps>().spec.type, FieldType::number);
  EXPECT_EQ(field_of<&Radar::barker_code>().spec.type, FieldType::choice);
  EXPECT_EQ(field_of<&GeometryTable::columns>().spec.type, FieldType::flags);
  EXPECT_EQ(field_of<&Platform::rotation>().spec.type, FieldType::vector);
  EXPECT_EQ(field_of<&Target::platform>().spec.type, FieldType::name);
  EXPECT_EQ(field_of<&RunOptions::seed>().spec.type, FieldType::seed);
  EXPECT_EQ(field_of<&Radar::pri_s>().spec.type, FieldType::function);
}

TEST(FieldTable, ValuesGoInAndOut) {
  Radar radar;
  field_of<&Radar::losses>().put(radar, 3.0);
  EXPECT_EQ(radar.losses.db(), 3.0);
  field_of<&Radar::beam>().put(radar, static_cast<int>(Radar::Beam::spot));
  EXPECT_EQ(radar.beam, Radar::Beam::spot);
  EXPECT_EQ(chosen(field_of<&Radar::beam>().get(radar)), static_cast<int>(Radar::Beam::spot));
  field_of<&Radar::beam>().reset(radar);
  EXPECT_EQ(radar.beam, Radar::Beam::fixed);
  for_each_field([](std::string_view, const auto& field, const auto& initial) {
    auto object = initial;
    field.put(object, field.get(object));
    EXPECT_EQ(object, initial) << field.spec.id;
  });
}

TEST(FieldTable, ACountedNumberIsWhole) {
  Radar radar;
  field_of<&Radar::carrier_steps>().put(radar, 12.0);
  EXPECT_EQ(radar.carrier_steps, 12);
}

// A pattern of the receive antenna means something where that is no other, its beam width where the pattern has one.
TEST(FieldTable, ConditionsHoldThroughTheChoicesBeforeThem) {
  const auto& table = table_of<Radar>();
  const auto& width = field_of<&Radar::receive_antenna, &Antenna::azimuth_beamwidth>();
  Radar radar;
  radar.receive_antenna.pattern = Antenna::Pattern::sinx;
  EXPECT_FALSE(table.applies(radar, width));
  radar.same_antenna = false;
  EXPECT_TRUE(table.applies(radar, width));
  radar.receive_antenna.pattern = Antenna::Pattern::user;
  EXPECT_FALSE(table.applies(radar, width));
}

TEST(FieldTable, AChoiceStandsBeforeWhatDependsOnIt) {
  for_each_kind([]<class Object>(const Kind<Object>& kind) {
    const auto& fields = table_of(kind).fields();
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const Condition& when = fields[i].spec.when;
      if (when.among.empty()) continue;
      ASSERT_LT(when.field, i) << fields[i].spec.id;
      const FieldType type = fields[when.field].spec.type;
      EXPECT_TRUE(type == FieldType::choice || type == FieldType::check) << fields[i].spec.id;
    }
  });
}

TEST(FieldTable, EveryFieldIsNamedOnceAndSaidInWords) {
  std::set<std::pair<std::string_view, std::string_view>> ids;
  for_each_field([&](std::string_view kind, const auto& field, const auto&) {
    EXPECT_TRUE(ids.insert({kind, field.spec.id}).second) << field.spec.id;
    EXPECT_FALSE(field.spec.words.empty()) << field.spec.id;
    EXPECT_EQ(field.spec.type == FieldType::function, field.spec.block != nullptr) << field.spec.id;
    EXPECT_EQ(field.spec.type == FieldType::flags, !field.spec.flags.empty()) << field.spec.id;
  });
  EXPECT_GT(ids.size(), 80U);
}

TEST(FieldTable, WhatIsLikelyCanBeSaid) {
  for_each_field([](std::string_view, const auto& field, const auto&) {
    const Range& likely = field.spec.likely;
    EXPECT_LT(likely.low, likely.high) << field.spec.id;
    EXPECT_TRUE(!std::isfinite(likely.high) || field.spec.range.holds(likely.high)) << field.spec.id;
    EXPECT_TRUE(!std::isfinite(likely.low) || likely.low_excluded || field.spec.range.holds(likely.low))
        << field.spec.id;
  });
}

TEST(FieldTable, AMemberWithoutAFieldIsAMistake) {
  EXPECT_THROW(static_cast<void>(FieldTable<Radar>().field<&Radar::prf_hz>()), std::logic_error);
}

TEST(FieldSpec, UnitsOfAScriptAreThoseOfTheQuantity) {
  EXPECT_EQ(script_unit(field_of<&Radar::carrier_hz>().spec), "GHz");
  EXPECT_EQ(script_shift(field_of<&Radar::carrier_hz>().spec), 9);
  EXPECT_EQ(script_shift(field_of<&Radar::pulse_width_s>().spec), -9);
  EXPECT_EQ(script_unit(field_of<&Target::rcs_m2>().spec), "m^2");
  EXPECT_EQ(script_unit(field_of<&Radar::hanning_pedestal>().spec), "");
}

TEST(Kinds, AreThoseOfAScene) {
  std::size_t objects = 0;
  Scene scene;
  for_each_kind([&]<class Object>(const Kind<Object>& kind) {
    EXPECT_EQ(kind.name, name_of(kind.kind));
    EXPECT_EQ(static_cast<std::size_t>(kind.kind), objects++);
    (scene.*kind.list).emplace_back();
    EXPECT_EQ(count_of(scene, kind.kind), 1U);
  });
  EXPECT_EQ(objects, std::variant_size_v<AnyObject>);
}

}  // namespace field_table_test

}  // namespace sarsim::scene
