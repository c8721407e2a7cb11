#include "raster/cphd/cphd_file.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <random>

#include <fmt/format.h>

#include "raster/cphd/cphd_test_support.hpp"

namespace sarsim::raster::vector_check_test {

using namespace cphd_test;
using testing::HasSubstr;
using Change = std::function<void(PhaseVector&)>;

constexpr std::size_t vectors = 9;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A file of nine vectors, the fifth of them changed.
Opened changed(const CphdScratch& scratch, const Change& change, SignalEncoding encoding = SignalEncoding::cf8) {
  const CphdDescription d = small_description(vectors, 6, encoding);
  {
    CphdWriter writer(scratch.path, d, true);
    for (std::size_t i = 0; i < vectors; ++i) {
      PhaseVector v = small_vector(d, i);
      if (i == 5) change(v);
      writer.append(encode_vector(v, small_samples(d, i), d.encoding));
    }
    writer.finish();
  }
  return opened_of(scratch.path);
}

struct Case {
  const char* name;  // Of the parameter, which the message has to say.
  Change change;
};

TEST(CphdVectors, AreLeftWhereAStopIsRequested) {
  const CphdScratch scratch("vectors_stopped");
  const Opened opened = changed(scratch, [](PhaseVector&) {});
  ASSERT_TRUE(opened.file) << opened.text();
  core::StopFlag stop;
  stop.request();
  core::Problems problems;
  EXPECT_THROW(check_vectors(*opened.file, problems, &stop), core::Interrupted);
}

TEST(CphdVectors, RefusesWhatNoCollectionHasByTheNameOfItsParameter) {
  const CphdScratch scratch("vectors_refused");
  const Case cases[] = {
      {"SC0", [](PhaseVector& v) { v.first = 1e300; }},
      {"SC0", [](PhaseVector& v) { v.first = -1e9; }},
      {"SC0", [](PhaseVector& v) { v.first = nan; }},
      {"SCSS", [](PhaseVector& v) { v.step = 0.0; }},
      {"SCSS", [](PhaseVector& v) { v.step = -1e6; }},
      {"SCSS", [](PhaseVector& v) { v.step = 1e200; }},
      {"SCSS", [](PhaseVector& v) { v.step *= 1000.0; }},
      {"SCSS", [](PhaseVector& v) { v.step = 2e6; }},  // 0.5 us are told apart, 0.6 us are kept
      {"SCSS", [](PhaseVector& v) { std::swap(v.first, v.step); }},
      {"SCSS", [](PhaseVector& v) { v.toa1_s *= 1000.0; }},
      {"TxTime", [](PhaseVector& v) { v.tx_time_s = 1e30; }},
      {"RcvTime", [](PhaseVector& v) { v.rcv_time_s = v.tx_time_s - 1e-3; }},
      {"RcvTime", [](PhaseVector& v) { v.rcv_time_s = nan; }},
      {"RcvTime", [](PhaseVector& v) { v.rcv_time_s += 1e4; }},
      {"SRPPos",
       [](PhaseVector& v) {
         v.srp_m = {1e30, 0.0, 0.0};
       }},
      {"SRPPos",
       [](PhaseVector& v) {
         v.srp_m = {6300000.0, 0.0, 0.0};
       }},
      {"TxPos", [](PhaseVector& v) { v.tx_m.y = nan; }},
      {"RcvPos", [](PhaseVector& v) { v.rcv_m.z = std::numeric_limits<double>::infinity(); }},
      {"TxVel",
       [](PhaseVector& v) {
         v.tx_mps = {3e8, 0.0, 0.0};
       }},
      {"RcvVel",
       [](PhaseVector& v) {
         v.rcv_mps = {0.0, nan, 0.0};
       }},
      {"aFDOP", [](PhaseVector& v) { v.doppler = 10.0; }},
      {"aFRR1", [](PhaseVector& v) { v.rate1 = nan; }},
      {"aFRR2", [](PhaseVector& v) { v.rate2 = nan; }},
      {"FX1", [](PhaseVector& v) { std::swap(v.fx1_hz, v.fx2_hz); }},
      {"FX1", [](PhaseVector& v) { v.fx1_hz = -1.0; }},
      {"FX2", [](PhaseVector& v) { v.fx2_hz = 1e300; }},
      {"TOA1", [](PhaseVector& v) { std::swap(v.toa1_s, v.toa2_s); }},
      {"TOA2", [](PhaseVector& v) { v.toa2_s = nan; }},
      {"TDTropoSRP", [](PhaseVector& v) { v.tropo_s = 1.0; }},
      {"SIGNAL", [](PhaseVector& v) { v.signal = 0x7ff8000000000000; }},
      {"SIGNAL", [](PhaseVector& v) { v.signal = -1; }},
  };
  for (const Case& c : cases) {
    const Opened opened = changed(scratch, c.change);
    EXPECT_FALSE(opened.file) << c.name;
    EXPECT_THAT(opened.text(), HasSubstr(fmt::format("vector 5 (from 0): {} cannot be", c.name)));
  }
}

// What is said of a channel names no vector.
bool is_of_channel(std::string_view name) { return name.starts_with("TOASaved"); }

// Places at random heights: below the deepest sea, and so far out that the echo would take another time.
TEST(CphdVectors, RefusesPlacesWhereNoneIs) {
  const CphdScratch scratch("vectors_places");
  std::mt19937 random(21);
  std::uniform_real_distribution<double> angle(-1.0, 1.0), exponent(4.1, 6.6), far(6.0, 9.0);
  core::Vec3 PhaseVector::*const places[] = {&PhaseVector::tx_m, &PhaseVector::rcv_m, &PhaseVector::srp_m};
  const char* const names[] = {"TxPos", "RcvPos", "SRPPos"};
  for (int draw = 0; draw < 60; ++draw) {
    const double depth_m = std::pow(10.0, exponent(random));
    const double latitude = 1.5 * angle(random), longitude = 3.0 * angle(random);
    const core::Vec3 deep_m = radar::ecef_of({latitude, longitude, -depth_m});
    const Opened deep = changed(scratch, [&](PhaseVector& v) { v.*places[draw % 3] = deep_m; });
    EXPECT_FALSE(deep.file);
    EXPECT_THAT(deep.text(), HasSubstr(fmt::format("{} cannot be", names[draw % 3])));
    EXPECT_THAT(deep.text(), HasSubstr(fmt::format("{:.6g} m below the ellipsoid", depth_m)));
    const core::Vec3 out_m = radar::ecef_of({latitude, longitude, std::pow(10.0, far(random))});
    const Opened out = changed(scratch, [&](PhaseVector& v) { v.*places[draw % 3] = out_m; });
    EXPECT_FALSE(out.file);
    EXPECT_THAT(out.text(), HasSubstr("the way from TxPos over SRPPos to RcvPos cannot be"));
  }
  CphdDescription d = small_description(3, 4, SignalEncoding::cf8);
  d.scene.origin_m = {5378137.0, 0.0, 0.0};
  write_small(scratch.path, d);
  EXPECT_THAT(opened_of(scratch.path).text(), HasSubstr("IARP/ECF lies inside the Earth; found '1e+06 m below"));
}

TEST(CphdVectors, WarnsOfWhatContradictsItself) {
  const CphdScratch scratch("vectors_warned");
  const Case cases[] = {
      {"times do not ascend", [](PhaseVector& v) { v.tx_time_s -= 2e-3, v.rcv_time_s -= 2e-3; }},
      {"the time of reception contradicts the places", [](PhaseVector& v) { v.rcv_time_s += 1e-5; }},
      {"the velocities contradict the places", [](PhaseVector& v) { v.rcv_m.y += 10.0; }},
      {"the band lies beyond the samples", [](PhaseVector& v) { v.fx2_hz += 1e9; }},
      {"they differ although the XML says that they do not", [](PhaseVector& v) { v.toa1_s *= 0.5; }},
      {"the times of arrival lie beyond those of the XML", [](PhaseVector& v) { v.toa1_s -= 1e-8; }},
      {"TOASaved of the XML is not that of the vectors", [](PhaseVector& v) { v.toa2_s += 1e-8; }},
      {"the band lies beyond that of the XML", [](PhaseVector& v) { v.fx1_hz -= 1e6, v.first -= 1e6; }},
  };
  for (const Case& c : cases) {
    const Opened opened = changed(scratch, c.change);
    EXPECT_TRUE(opened.file) << c.name << opened.text();
    EXPECT_THAT(opened.text(), HasSubstr(c.name));
    if (!is_of_channel(c.name)) {
      EXPECT_THAT(opened.text(), HasSubstr("vector 5 (from 0)"));
    }
  }
}

TEST(CphdVectors, LeavesOutVectorsWithoutASignal) {
  const CphdScratch scratch("vectors_silent");
  const Opened opened = changed(scratch, [](PhaseVector& v) {
    v = {};
    v.signal = 0;
    v.first = nan;
  });
  EXPECT_TRUE(opened.file) << opened.text();
  EXPECT_EQ(opened.text(), "");
}

TEST(CphdVectors, RefusesAnAmplitudeThatIsNone) {
  const CphdScratch scratch("vectors_amplitude");
  for (const double amplitude : {0.0, -1.0, nan, 1e300}) {
    const CphdDescription d = small_description(3, 4, SignalEncoding::ci2);
    CphdWriter writer(scratch.path, d, true);
    for (std::size_t i = 0; i < 3; ++i) {
      EncodedVector encoded = encode_vector(small_vector(d, i), small_samples(d, i), d.encoding);
      const auto [slots, bytes] = pvp_slots(d.encoding);
      PhaseVector other;
      other.amplitude = amplitude;
      for (const PvpSlot& slot : slots)
        if (slot.field->name == "AmpSF") put_pvp(*slot.field, other, encoded.pvp.data() + slot.offset);
      writer.append(encoded);
    }
    writer.finish();
    EXPECT_THAT(opened_of(scratch.path).text(), HasSubstr("AmpSF cannot be")) << amplitude;
  }
}

// Any bit of any parameter: what the file says afterwards is refused or warned of, or what was not touched is as it was
// and no number lies beyond the bounds.
TEST(CphdVectors, ChangedBitsGiveRefusalsOrFiniteNumbers) {
  const CphdScratch scratch("vectors_bits");
  const CphdDescription d = small_description(vectors, 6, SignalEncoding::cf8);
  write_small(scratch.path, d);
  const std::string bytes = bytes_of(scratch.path);
  const auto block = read_block_header(opened_of(scratch.path).file->file())->block("PVP").value();
  std::mt19937_64 random(54);
  std::size_t refused = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::string other = bytes;
    const std::uint64_t at = block.offset + random() % block.bytes;
    other[at] = static_cast<char>(static_cast<unsigned char>(other[at]) ^ (1U << random() % 8));
    const Opened opened = opened_of(other, scratch.path);
    if (!opened.file) {
      ++refused;
      EXPECT_THAT(opened.text(), HasSubstr("cannot be"));
      continue;
    }
    std::vector<PhaseVector> read(vectors);
    opened.file->read_vectors(0, 0, read);
    for (std::size_t i = 0; i < vectors; ++i) {
      if (read[i].signal == 0) continue;
      for (const PvpField& field : pvp_fields()) {
        if (field.number != nullptr) {
          EXPECT_LE(std::abs(read[i].*field.number), 1e30) << field.name;
        }
        if (field.place != nullptr) {
          EXPECT_LE(core::norm(read[i].*field.place), 4e9) << field.name;
        }
      }
    }
  }
  EXPECT_GT(refused, 20U);
}

TEST(CphdXml, RefusesWhatContradictsTheStandardOrItself) {
  const CphdScratch scratch("cphd_xml");
  write_small(scratch.path, small_description(3, 5, SignalEncoding::cf8));
  const std::string bytes = bytes_of(scratch.path);
  const auto pvp_format = [&](const std::string& name, const std::string& old, const std::string& format) {
    std::string other = bytes;
    const std::size_t at = other.find(old, other.find("<" + name + ">"));
    return at == std::string::npos ? std::string() : other.replace(at, format.size(), format);
  };
  // Zeros fill the header up to the XML.
  std::string twice_in_header = bytes;
  const std::string key = "XML_BLOCK_SIZE := 5\n";
  twice_in_header.insert(twice_in_header.find("CLASSIFICATION"), key);
  twice_in_header.erase(twice_in_header.find(std::string("\f\n\0", 3)) + 2, key.size());
  const std::pair<std::string, const char*> cases[] = {
      {pvp_format("TxTime", ">F8<", ">F4<"), "PVP/TxTime are not those of the standard (Format)"},
      {pvp_format("TxPos", "X=F8;Y=F8;Z=F8", "X=F4;Y=F4;Z=F4"), "PVP/TxPos are not those of the standard"},
      {pvp_format("SIGNAL", ">I8<", ">F8<"), "PVP/SIGNAL are not those of the standard"},
      {pvp_format("TxVel", "<Offset>4<", "<Offset>3<"), "lie at one place"},
      {with(bytes, "<NumCPHDChannels>1<", "<NumCPHDChannels>2<"), "NumCPHDChannels is not the number of channels"},
      {with(bytes, "<NumVectors>3<", "<NumVectors>9<"), "do not fit into the block"},
      {pvp_format("SC0", "<Format>F8</Format>", "<Offset>3</Offset> "), "the XML has Offset twice"},
      {twice_in_header, "a key is in the header twice, with other values; found 'XML_BLOCK_SIZE'"},
  };
  for (const auto& [other, message] : cases) {
    ASSERT_FALSE(other.empty()) << message;
    const Opened opened = opened_of(other, scratch.path);
    EXPECT_FALSE(opened.file) << message;
    EXPECT_THAT(opened.text(), HasSubstr(message));
  }
  const Opened fewer = opened_of(with(bytes, "<NumVectors>3<", "<NumVectors>2<"), scratch.path);
  EXPECT_THAT(fewer.text(), HasSubstr("do not fill the block PVP"));
  EXPECT_THAT(fewer.text(), HasSubstr("do not fill the block SIGNAL"));
  const std::pair<std::string, const char*> remarks[] = {
      {with(bytes, "<RefChId>1<", "<RefChId>2<"), "Channel/RefChId is the identifier of no channel; '1' is taken"},
      {with(bytes, "CollectionStart>2000-01", "CollectionStart>2000-13"), "Timeline/CollectionStart is no time"},
      {with(bytes, "<TxTime1>0<", "<TxTime1>9<"), "Global/Timeline ends before it begins"},
      {bytes + "12345678", "bytes are left over behind the last block; found '8 bytes'"},
  };
  for (const auto& [other, message] : remarks) {
    ASSERT_FALSE(other.empty()) << message;
    const Opened opened = opened_of(other, scratch.path);
    EXPECT_TRUE(opened.file) << message << opened.text();
    EXPECT_THAT(opened.text(), HasSubstr(message));
  }
}

}  // namespace sarsim::raster::vector_check_test
