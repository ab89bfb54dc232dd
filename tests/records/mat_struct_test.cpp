#include <gmock/gmock.h>
#include <matio.h>

#include <fstream>

#include "base/error.hpp"
#include "frf/file/columns.hpp"
#include "records/file/open_samples.hpp"
#include "records/file/read_record.hpp"
#include "tests/test_folder.hpp"

namespace jointid::records {
namespace {

using ::testing::ElementsAre;

matvar_t* vector_of(const char* name, std::vector<double> numbers) {
  size_t dims[2] = {numbers.size(), 1};
  return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, numbers.data(), 0);
}

/// run.time, run.sensors.hammer, run.sensors.motion, and an array of structs, which is passed over.
void write_structs(const std::filesystem::path& path, matio_compression compression) {
  size_t one[2] = {1, 1}, two[2] = {2, 1};
  const char* inner_fields[] = {"hammer", "motion"};
  const char* fields[] = {"time", "sensors"};
  matvar_t* inner = Mat_VarCreateStruct("sensors", 2, one, inner_fields, 2);
  Mat_VarSetStructFieldByName(inner, "hammer", 0, vector_of("hammer", {0, 5, 1}));
  Mat_VarSetStructFieldByName(inner, "motion", 0, vector_of("motion", {0, 1, -2}));
  matvar_t* run = Mat_VarCreateStruct("run", 2, one, fields, 2);
  Mat_VarSetStructFieldByName(run, "time", 0, vector_of("time", {0.0, 0.001, 0.002}));
  Mat_VarSetStructFieldByName(run, "sensors", 0, inner);
  matvar_t* several = Mat_VarCreateStruct("several", 2, two, inner_fields, 2);
  mat_t* mat = Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5);
  for (matvar_t* variable : {run, several}) {
    Mat_VarWrite(mat, variable, compression);
    Mat_VarFree(variable);
  }
  Mat_Close(mat);
}

TEST(MatStruct, FieldsAreColumns) {
  const TestFolder folder;
  for (const matio_compression compression : {MAT_COMPRESSION_NONE, MAT_COMPRESSION_ZLIB}) {
    write_structs(folder / "a.mat", compression);
    const auto records = read_records(
        folder / "a.mat",
        {{parse_channel("run.sensors.hammer=1:+Z N"), parse_channel("run.sensors.motion=2:+Z m/s")}, {}, std::nullopt});
    EXPECT_EQ(records[0].rate_hz, 1000.0);
    EXPECT_THAT(records[0].channels[0].samples, ElementsAre(0, 5, 1));
    EXPECT_THAT(records[0].channels[1].samples, ElementsAre(0, 1, -2));
    EXPECT_EQ(records[0].channels[1].kind, ChannelKind::velocity);
  }
}

/// What `pod` and `series` read of MATLAB files: the vectors as channels, without that of times, in parts as well.
TEST(MatStruct, VectorsAreChannelsOfAStream) {
  const TestFolder folder;
  write_structs(folder / "a.mat", MAT_COMPRESSION_ZLIB);
  std::vector<double> rows(8, -1.0);
  const auto stream = open_samples(folder / "a.mat");
  ASSERT_EQ(stream->channels().size(), 2u);
  EXPECT_EQ(stream->channels()[0].name, "run.sensors.hammer");
  EXPECT_EQ(stream->time_column(), "run.time");
  EXPECT_EQ(stream->read(rows), 3u);
  EXPECT_THAT(rows, ElementsAre(0, 0, 5, 1, 1, -2, -1, -1));
  EXPECT_EQ(stream->read(rows), 0u);
  const auto part = open_samples(folder / "a.mat", {.channels = {"run.sensors.motion"}, .part = 1, .parts = 2});
  EXPECT_EQ(part->read(rows), 1u);
  EXPECT_EQ(rows[0], -2.0);
}

/// Every seventh byte of both files set to two values: an answer or an InputError.
TEST(MatStruct, DamageAnywhereIsAnErrorOrAnAnswer) {
  const TestFolder folder;
  for (const matio_compression compression : {MAT_COMPRESSION_NONE, MAT_COMPRESSION_ZLIB}) {
    write_structs(folder / "a.mat", compression);
    std::ifstream in(folder / "a.mat", std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    for (std::size_t at = 124; at < whole.size(); at += 7) {
      for (const char change : {'\x02', '\xff'}) {
        std::string damaged = whole;
        damaged[at] = change;
        std::ofstream(folder / "b.mat", std::ios::binary) << damaged;
        try {
          for (const auto& column : frf::read_columns(folder / "b.mat").columns) EXPECT_LE(column.values.size(), whole.size());
        } catch (const InputError&) {
        }
      }
    }
  }
}

}  // namespace
}  // namespace jointid::records
