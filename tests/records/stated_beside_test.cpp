// What other programs state beside the columns of a record (tests/records/foreign/make.py): rates and factors as attributes, a
// unit for each channel, labels of axes.
#include <gmock/gmock.h>

#include "base/error.hpp"
#include "frf/set/unit_label.hpp"
#include "records/file/read_record.hpp"
#include "records/file/record_options.hpp"

namespace jointid::records {
namespace {

using testing::HasSubstr;

std::vector<Record> read(const std::string& name, const std::vector<std::string>& channels, std::optional<double> rate_hz = {}) {
  RecordOptions options;
  for (const std::string& channel : channels) options.channels.push_back(parse_channel(channel));
  options.rate_hz = rate_hz;
  return read_records(std::filesystem::path(JOINTID_FOREIGN_RECORDS) / name, options);
}

std::string error(const std::string& name, const std::vector<std::string>& channels, std::optional<double> rate_hz = {}) {
  try {
    read(name, channels, rate_hz);
  } catch (const InputError& refused) {
    return refused.what();
  }
  return "accepted";
}

TEST(StatedBeside, AttributesGiveTheRateAndAUnitForEachChannel) {
  const std::vector<Record> records = read("attributes.h5", {"data(1)=1:+Z", "data(2)=1:+Z"});
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].rate_hz, 1000.0);
  EXPECT_THAT(records[0].channels[0].samples, testing::ElementsAre(0.0, 5.0, 1.0));
  EXPECT_NEAR(records[0].channels[1].samples[1], 9.80665, 1e-12);
  EXPECT_THAT(error("attributes.h5", {"data(1)=1:+Z N", "data(2)=1:+Z m/s^2"}),
              HasSubstr("the file states g, and m/s^2 is given"));
  EXPECT_THAT(error("attributes.h5", {"data(1)=1:+Z", "data(2)=1:+Z"}, 2000.0), HasSubstr("states 1000 samples per second"));
}

TEST(StatedBeside, AFactorThatNothingAppliesIsAnError) {
  EXPECT_THAT(error("scaled.h5", {"F=1:+Z N", "a=1:+Z g"}), HasSubstr("states a factor, 'scale = 0.1', which is not applied"));
}

TEST(StatedBeside, LabelsOfAxesAreNotLost) {
  EXPECT_THAT(error("labels.mat", {"F=1:+Z N", "a=1:+Z g"}), HasSubstr("xlabel states the unit 'ms', and column t states none"));
  EXPECT_THAT(error("labels.mat", {"F=1:+Z N", "a=1:+Z m/s^2"}, 1000.0), HasSubstr("ylabel states 'g', and m/s^2 is given"));
  EXPECT_EQ(read("labels.mat", {"F=1:+Z N", "a=1:+Z g"}, 1000.0)[0].samples(), 3u);
}

}  // namespace
}  // namespace jointid::records
