#include "raster/cphd/cphd_file.hpp"

#include <gmock/gmock.h>

#include "raster/cphd/cphd_test_support.hpp"

namespace sarsim::raster::cphd_file_test {

using namespace cphd_test;
using testing::HasSubstr;

void expect_same(const PhaseVector& a, const PhaseVector& b) {
  for (const PvpField& field : pvp_fields()) {
    if (field.number == &PhaseVector::amplitude) continue;
    if (field.number != nullptr) {
      EXPECT_EQ(a.*field.number, b.*field.number) << field.name;
    }
    if (field.place != nullptr) {
      EXPECT_EQ(a.*field.place, b.*field.place) << field.name;
    }
    if (field.integer != nullptr) {
      EXPECT_EQ(a.*field.integer, b.*field.integer) << field.name;
    }
  }
}

TEST(CphdFile, ReadsWhatWasWrittenInEveryEncoding) {
  for (const SignalEncodingName& entry : signal_encodings) {
    const CphdDescription d = small_description(9, 6, entry.encoding);
    const CphdScratch scratch("cphd_all");
    write_small(scratch.path, d);
    const Opened opened = opened_of(scratch.path);
    ASSERT_TRUE(opened.file) << opened.text();
    EXPECT_EQ(opened.text(), "");
    const CphdDescription& read = opened.file->description();
    EXPECT_EQ(read.encoding, d.encoding);
    EXPECT_EQ(read.sign, -1);
    EXPECT_EQ(read.collector, d.collector);
    EXPECT_EQ(read.parameters, d.parameters);
    EXPECT_EQ(read.scene.origin_m, d.scene.origin_m);
    EXPECT_EQ(read.scene.area.y2, d.scene.area.y2);
    EXPECT_EQ(read.pvp_bytes, entry.largest > 0.0 ? 232U : 224U);
    EXPECT_EQ(read.channels.front().reference, 4U);
    std::vector<PhaseVector> vectors(9);
    opened.file->read_vectors(0, 0, vectors);
    std::vector<std::complex<float>> samples(6);
    for (std::size_t i = 0; i < 9; ++i) {
      expect_same(vectors[i], small_vector(d, i));
      opened.file->read_samples(0, i, vectors[i].amplitude, samples);
      const auto truth = small_samples(d, i);
      // Half a step of the largest I or Q, 1.5; of floats their rounding.
      const double step = entry.largest > 0.0 ? 1.5 / entry.largest : 2e-7;
      for (std::size_t k = 0; k < 6; ++k)
        EXPECT_LT(std::abs(std::complex<double>(samples[k]) - truth[k]), step) << entry.name << " " << i << " " << k;
    }
  }
}

TEST(CphdFile, HasTheLayoutOfTheStandard) {
  const CphdScratch scratch("cphd_layout");
  write_small(scratch.path, small_description(3, 5, SignalEncoding::cf8));
  const std::string bytes = bytes_of(scratch.path);
  EXPECT_TRUE(bytes.starts_with("CPHD/1.1.0\nXML_BLOCK_SIZE := "));
  EXPECT_EQ(bytes.substr(1024, 5), "<?xml");
  EXPECT_EQ(bytes.find("\f\n", 1024), bytes.find("</CPHD>\n") + 8);
  const Opened opened = opened_of(scratch.path);
  ASSERT_TRUE(opened.file);
  // 1 in the first word of the last vector's SIGNAL, big-endian; the signal ends the file.
  const auto header = read_block_header(opened.file->file());
  ASSERT_TRUE(header);
  const FileBlock pvp = header->block("PVP").value(), signal = header->block("SIGNAL").value();
  EXPECT_EQ(pvp.bytes, 3U * 224U);
  EXPECT_EQ(pvp.offset % 64, 0U);
  EXPECT_EQ(bytes.substr(pvp.offset + 223, 1), "\x01");
  EXPECT_EQ(signal.bytes, 3U * 5U * 8U);
  EXPECT_EQ(signal.offset + signal.bytes, bytes.size());
  EXPECT_EQ(bytes.substr(signal.offset, 4), std::string("\x3f\xc0\x00\x00", 4)) << "1.5 as a big-endian float";
}

TEST(CphdFile, AcceptsDialectsOfVendors) {
  const CphdScratch scratch("cphd_dialect");
  write_small(scratch.path, small_description(3, 5, SignalEncoding::cf8));
  const std::string bytes = bytes_of(scratch.path);
  const Opened mode = opened_of(with(bytes, "<ModeType>SPOTLIGHT<", "<ModeType>EXPERIM  <"), scratch.path);
  ASSERT_TRUE(mode.file);
  EXPECT_THAT(mode.text(), HasSubstr("warning: the mode of the radar is not one of the standard"));
  const Opened sign = opened_of(with(bytes, "<SGN>-1<", "<SGN>+1<"), scratch.path);
  ASSERT_TRUE(sign.file);
  EXPECT_EQ(sign.file->description().sign, 1);
  const Opened older = opened_of(with(bytes, "CPHD/1.1.0", "CPHD/1.0.1"), scratch.path);
  ASSERT_TRUE(older.file);
  EXPECT_EQ(older.file->description().version, "1.0.1");
  EXPECT_EQ(older.text(), "");
  const Opened newer = opened_of(with(bytes, "CPHD/1.1.0", "CPHD/1.9.0"), scratch.path);
  ASSERT_TRUE(newer.file);
  EXPECT_THAT(newer.text(), HasSubstr("this version of CPHD is not known"));
  const Opened blanks =
      opened_of(with(bytes, "CLASSIFICATION := UNCLASSIFIED", "CLASSIFICATION :=UNCLASSIFIED"), scratch.path);
  EXPECT_TRUE(blanks.file) << blanks.text();
  const Opened toa = opened_of(with(bytes, "<DomainType>FX</DomainType>", "<DomainType>TOA</DomainType"), scratch.path);
  EXPECT_FALSE(toa.file) << "that broke the XML";
}

TEST(CphdFile, ReadsSurfacesOfConstantHeight) {
  const CphdScratch scratch("cphd_height");
  CphdDescription d = small_description(3, 5, SignalEncoding::cf8);
  write_small(scratch.path, d);
  std::string bytes = bytes_of(scratch.path);
  const std::size_t begin = bytes.find("<Planar>");
  const std::size_t end = bytes.find("</Planar>") + 9;
  // 1 m to east and 1 m to north at the equator, rad.
  std::string height =
      "<HAE><uIAXLL><Lat>0</Lat><Lon>1.567855942887398e-07</Lon></uIAXLL>"
      "<uIAYLL><Lat>1.578424553e-07</Lat><Lon>0</Lon></uIAYLL></HAE>";
  ASSERT_LE(height.size(), end - begin);
  height.resize(end - begin, ' ');
  const Opened opened = opened_of(bytes.replace(begin, end - begin, height), scratch.path);
  ASSERT_TRUE(opened.file) << opened.text();
  EXPECT_FALSE(opened.file->description().scene.planar);
  EXPECT_LT(core::norm(opened.file->description().scene.x_axis - core::Vec3{0.0, 1.0, 0.0}), 1e-12);
  EXPECT_LT(core::norm(opened.file->description().scene.y_axis - core::Vec3{0.0, 0.0, 1.0}), 1e-12);
}

TEST(CphdFile, RefusesBadFilesAndSaysWhy) {
  const CphdScratch scratch("cphd_bad");
  write_small(scratch.path, small_description(3, 5, SignalEncoding::cf8));
  const std::string good = bytes_of(scratch.path);
  struct Row {
    std::string bytes;
    const char* message;
  };
  const Row rows[] = {
      {"CPHD/1.1.0\nXML", "the header of the CPHD file does not end"},
      {with(good, "CPHD/1.1.0", "CPHD/0.3.0"), "the file is not CPHD of version 1"},
      {with(good, "XML_BLOCK_SIZE :=", "XML_BLOCK_SISE :="), "does not say where the block XML is"},
      {with(good, "SIGNAL_BLOCK_SIZE := 120", "SIGNAL_BLOCK_SIZE := 999"), "SIGNAL reaches beyond the end"},
      {with(good, "PVP_BLOCK_SIZE := 672", "PVP_BLOCK_SIZE := -12"), "does not say where the block PVP is"},
      {good.substr(0, good.size() - 1), "the file is cut off"},
      {with(good, "</CPHD>", "</CPHX>"), "the XML of the file cannot be read: line"},
      {with(good, "<SGN>-1<", "<SGN>-2<"), "the sign of the phase (SGN) is not known"},
      {with(good, "<DomainType>FX<", "<DomainType>XF<"), "the domain of the samples is not known"},
      {with(good, "<SignalArrayFormat>CF8<", "<SignalArrayFormat>CF9<"), "the format of the samples is not known"},
      {with(good, "<NumVectors>3<", "<NumVectors>4<"), "parameters of channel '1' do not fit"},
      {with(good, "<NumSamples>5<", "<NumSamples>6<"), "samples of channel '1' do not fit"},
      {with(good, "<NumVectors>3<", "<NumVectors>0<"), "NumVectors is out of range; found '0'"},
      {with(good, "<SCSS>", "<SXSS>"), "start-end tags mismatch"},
      {with(good, "<SignalArrayByteOffset>0<", "<SignalArrayByteOffset>9<"), "samples of channel '1' do not fit"},
      {with(good, "<NumBytesPVP>224<", "<NumBytesPVP>216<"), "lies beyond the end of its vector"},
      {with(good, "<Format>F8</Format>", ""), ""},
      {with(good, "<X1Y1>\n        <X>-50.5<", "<X1Y1>\n        <X>+90.5<"), "the image area is empty"},
      {with(good, "<X1Y1>\n        <X>-50.5<", "<X1Y1>\n        <X>  nan<"), "is not a number"},
  };
  for (const Row& row : rows) {
    ASSERT_FALSE(row.bytes.empty()) << row.message;
    const Opened opened = opened_of(row.bytes, scratch.path);
    if (*row.message == '\0') {
      EXPECT_TRUE(opened.file) << opened.text();
      continue;
    }
    EXPECT_FALSE(opened.file) << row.message;
    EXPECT_THAT(opened.text(), HasSubstr(row.message));
  }
}

TEST(CphdFile, LeavesNothingBehindWhereVectorsAreMissing) {
  const CphdScratch scratch("cphd_missing");
  const CphdDescription d = small_description(3, 5, SignalEncoding::cf8);
  {
    CphdWriter writer(scratch.path, d, false);
    writer.append(encode_vector(small_vector(d, 0), small_samples(d, 0), d.encoding));
    EXPECT_THROW(writer.finish(), std::logic_error);
    EXPECT_THROW(writer.append({}), std::logic_error);
  }
  EXPECT_FALSE(std::filesystem::exists(scratch.path));
}

TEST(CphdFile, HoldsMoreThanFourGigabytes) {
  const CphdScratch scratch("cphd_huge");
  const CphdDescription d = small_description(std::size_t{1} << 22U, 128, SignalEncoding::cf8);
  {
    // A hole: only its two ends are written.
    core::OutputFile file(scratch.path, true);
    CphdDescription sized = d;
    sized.pvp_bytes = 224;
    const std::string xml = cphd_xml(sized);
    std::array<FileBlock, 3> blocks{
        {{"XML", xml.size(), 0}, {"PVP", (std::uint64_t{1} << 22U) * 224, 0}, {"SIGNAL", std::uint64_t{1} << 32U, 0}}};
    place_blocks(blocks);
    write_block_header(file, "CPHD/1.1.0", blocks, "UNCLASSIFIED", "", xml);
    file.resize(blocks[2].offset + blocks[2].bytes);
    const EncodedVector last = encode_vector(small_vector(d, 3), small_samples(d, 3), d.encoding);
    file.write_at(blocks[1].offset + blocks[1].bytes - 224, last.pvp);
    file.write_at(blocks[2].offset + blocks[2].bytes - 1024, last.signal);
    file.commit();
  }
  const Opened opened = opened_of(scratch.path);
  ASSERT_TRUE(opened.file) << opened.text();
  std::vector<PhaseVector> vector(1);
  const std::size_t end = (std::size_t{1} << 22U) - 1;
  opened.file->read_vectors(0, end, vector);
  expect_same(vector.front(), small_vector(d, 3));
  std::vector<std::complex<float>> samples(128);
  opened.file->read_samples(0, end, 1.0, samples);
  EXPECT_EQ(samples[0], std::complex<float>(small_samples(d, 3)[0]));
}

}  // namespace sarsim::raster::cphd_file_test
