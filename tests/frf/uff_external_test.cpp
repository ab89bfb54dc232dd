#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "frf/uff/uff_file.hpp"
#include "tests/require.hpp"
#include "uff_samples.hpp"

namespace jointid::frf {
namespace {

using samples::error_of;
using testing::AllOf;
using testing::HasSubstr;

/// Measured files and format samples by others; see the README beside them.
class UffExternal : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(folder_)) JOINTID_SKIP(folder_ << " is missing: no external data");
  }

  std::filesystem::path file(const std::string& file_name) const { return folder_ / file_name; }

 private:
  std::filesystem::path folder_ = std::filesystem::path(JOINTID_EXTERNAL_DATA) / "uff";
};

/// Lines such as (-0.17515115491765987-0.12042372070051006j).
std::vector<Complex> read_python_complex(const std::filesystem::path& path) {
  std::vector<Complex> values;
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) {
    const char* text = line.c_str() + (line[0] == '(' ? 1 : 0);
    char* end = nullptr;
    const double real = std::strtod(text, &end);
    values.emplace_back(real, std::strtod(end, &end));
  }
  return values;
}

TEST_F(UffExternal, MeasuredAccelerancesAgreeWithTheirTextCopies) {
  const auto source = open_uff(file("measurement.uff"));
  const FrfHeader& header = source->header();
  EXPECT_EQ(header.quantity, Quantity::accelerance);
  EXPECT_EQ(header.lines(), 1001u);
  EXPECT_EQ(header.frequency_hz[279], 279.0);
  ASSERT_EQ(header.entries(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto expected = read_python_complex(file("meas_point_" + std::to_string(k + 1) + ".txt"));
    ASSERT_EQ(expected.size(), 1001u);
    const Uff58 record = read_uff58(file("measurement.uff"), k);
    std::vector<Complex> values(1001);
    std::vector<std::size_t> lines(1001), response = {header.response.size() == 3 ? k : 0},
                                          reference = {header.reference.size() == 3 ? k : 0};
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = i;
    source->read({lines, response, reference}, values);
    EXPECT_TRUE(std::isnan(values[0].real()));
    for (std::size_t i = 1; i < lines.size(); ++i) {
      EXPECT_LE(std::abs(record.values[i] - expected[i]), 1e-11 * std::abs(expected[i]));
      const Complex accelerance = values[i] * from_receptance(Quantity::accelerance, header.frequency_hz[i]);
      EXPECT_LE(std::abs(accelerance - expected[i]), 1e-11 * std::abs(expected[i]));
    }
  }
}

TEST_F(UffExternal, TextAndBinaryOfOneRecord) {
  const Uff58 text = read_uff58(file("Sample_UFF58_ascii.uff"), 0);
  const Uff58 binary = read_uff58(file("Sample_UFF58b_bin.uff"), 0);
  EXPECT_EQ(text.description.function, "time response");
  EXPECT_EQ(text.description.response, "0:+X");
  EXPECT_EQ(binary.description.quantity, "type 21");
  EXPECT_EQ(binary.description.unit, "Pa");
  ASSERT_EQ(text.values.size(), 79292u);
  ASSERT_EQ(binary.values.size(), 79292u);
  for (std::size_t i = 0; i < text.values.size(); ++i) {
    ASSERT_LE(std::abs(text.values[i] - binary.values[i]), 6e-6 * std::abs(binary.values[i])) << i;
  }
  EXPECT_NEAR(text.abscissa[1], 1.52588e-5, 1e-18);
}

TEST_F(UffExternal, RealDoublesOfASine) {
  const Uff58 record = read_uff58(file("binary8byte.uff"), 0);
  ASSERT_EQ(record.values.size(), 250u);
  EXPECT_EQ(record.description.unit, "g");
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(record.values[i].real(), std::sin(2.0 * std::acos(-1.0) * 5.0 * record.abscissa[i]),
                5e-8);  // made from singles
  }
}

TEST_F(UffExternal, LineEndBeforeTheClosingDelimiter) {
  const UffSummary summary = summarize_uff(file("MPSTD#Set001_2024_10_08_10_27_07.uff"));
  ASSERT_EQ(summary.functions.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(summary.functions[i].points, 222400u);
  EXPECT_EQ(read_uff58(file("MPSTD#Set001_2024_10_08_10_27_07.uff"), 3).values.size(), 222400u);
}

TEST_F(UffExternal, UnevenSpectralDensity) {
  const Uff58 record = read_uff58(file("sample_dataset58_psd.uff"), 0);
  ASSERT_EQ(record.values.size(), 3201u);
  EXPECT_EQ(record.abscissa[3], 3.0);
  EXPECT_EQ(record.values[3], Complex(3.803099e-6, 0.0));
  EXPECT_EQ(record.description.unit, "g\xC2\xB2/Hz");
}

TEST_F(UffExternal, DeclaresMillionsOfPointsAndHoldsFew) {
  EXPECT_EQ(summarize_uff(file("dataset_milestone_in_header.uff")).functions[0].points, 2'508'876u);
  EXPECT_THAT(error_of([&] { read_uff58(file("dataset_milestone_in_header.uff"), 0); }),
              HasSubstr("of 2508876 values were found"));
}

TEST_F(UffExternal, LastLineNotFilled) {
  const Uff58 record = read_uff58(file("time-history-not-all-columns-filled.uff"), 0);
  ASSERT_EQ(record.values.size(), 13u);
  EXPECT_EQ(record.values[12], Complex(-5.84096, 0.0));
  EXPECT_EQ(record.abscissa[2], 1e-4);
  EXPECT_EQ(record.description.unit, "m/s\xC2\xB2");
}

TEST_F(UffExternal, Latin1HeaderOfAnFrfWithoutDofs) {
  const Uff58 record = read_uff58(file("non_ascii_header.uff"), 0);
  EXPECT_EQ(record.description.unit, "(1/N)*(m/s\xC2\xB2)");
  EXPECT_EQ(record.values[5], Complex(3.75037, 2.93363));
  EXPECT_THAT(error_of([&] { open_uff(file("non_ascii_header.uff")); }),
              HasSubstr("direction code 0 is not a DOF"));
}

TEST_F(UffExternal, FilesWithoutFrfsSayWhatTheyHold) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"1858.uff", "2 x dataset 1858"},
      {"2411 and 2414.uff", "2414"},
      {"Artemis export - Geometry RPBC_setup_05_14102016_105117.uff", "2 x dataset 82"},
      {"MPSTD#Set001_2024_10_08_10_27_07.uff", "4 x time response"},
      {"Sample_UFF58_ascii.uff", "1 x time response"},
      {"Sample_UFF58b_bin.uff", "1 x time response"},
      {"TestLab 161 164 18 15 82.uff", "3 x dataset 82"},
      {"binary8byte.uff", "1 x time response"},
      {"dataset_milestone_in_header.uff", "1 x time response"},
      {"groups_test.uff", "1 x dataset 2467"},
      {"heat_engine_housing.uff", "1 x dataset 2411"},
      {"mesh_Oros-modal_uff15_uff2412.uff", "1 x dataset 15"},
      {"sample_dataset58_psd.uff", "1 x power spectral density"},
      {"time-history-not-all-columns-filled.uff", "1 x time response"},
      {"uff55 sample_test record10.uff", "1 x dataset 55"},
      {"uff55_translation.uff", "3 x dataset 55"},
      {"uff55_translation_rotation.uff", "1 x dataset 55"}};
  for (const auto& [file_name, holds] : files) {
    EXPECT_THAT(error_of([&, &file_name = file_name] { open_uff(file(file_name)); }),
                AllOf(HasSubstr(file_name), HasSubstr("no frequency response functions"), HasSubstr(holds)));
    EXPECT_FALSE(summarize_uff(file(file_name)).datasets.empty()) << file_name;
  }
}

/// The geometry files hold no FRF; with one behind them their nodes can be seen.
TEST_F(UffExternal, Nodes) {
  struct Expected {
    std::string file;
    std::size_t nodes;
    std::size_t index;
    Node node;
  };
  const std::vector<Expected> files = {
      {"heat_engine_housing.uff", 10, 0, {1, {-0.1711755676269531, 0.1036403427124023, 0.1384829101562500}}},
      {"2411 and 2414.uff", 441, 1, {2, {0.95, 0.0, 0.0}}},
      {"Artemis export - Geometry RPBC_setup_05_14102016_105117.uff", 74, 1, {17, {1.53, 0.0, 0.0}}},
      {"mesh_Oros-modal_uff15_uff2412.uff", 96, 1, {6, {-36.5, 63.22, 50.0}}},
      {"groups_test.uff", 74, 1, {2, {200.0, 10.0, 50.0}}},
      {"TestLab 161 164 18 15 82.uff", 36, 2, {3, {2.6, 2.05, 0.0}}}};
  for (const Expected& expected : files) {
    std::ifstream stream(file(expected.file), std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(stream), {});
    const samples::TemporaryUff with_frf(bytes + "\n" + samples::simple_record().str());
    const auto nodes = open_uff(with_frf)->header().nodes;
    ASSERT_EQ(nodes.size(), expected.nodes) << expected.file;
    EXPECT_EQ(nodes[expected.index].id, expected.node.id) << expected.file;
    EXPECT_THAT(nodes[expected.index].position,
                testing::Pointwise(testing::DoubleEq(), expected.node.position));
  }
}

TEST_F(UffExternal, EveryFileIsRecognised) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(file("."))) {
    if (entry.path().extension() != ".uff") continue;
    std::string bytes(200, '\0');
    std::ifstream stream(entry.path(), std::ios::binary);
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    EXPECT_TRUE(looks_like_uff({bytes.data(), static_cast<std::size_t>(stream.gcount())})) << entry.path();
    ++files;
  }
  EXPECT_EQ(files, 19u);
}

}  // namespace
}  // namespace jointid::frf
