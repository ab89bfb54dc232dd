#include "records/estimate/blow.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"
#include "records/estimate/measured_frfs.hpp"

namespace jointid::records {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double blow_rate = 1000.0;

/// Half a sine of 5 samples from `at` on.
void add_pulse(std::vector<double>& force, std::size_t at, double peak) {
  for (std::size_t i = 0; i < 5; ++i) force[at + i] += peak * std::sin(M_PI * (static_cast<double>(i) + 1.0) / 6.0);
}

/// A force with the given pulses and a motion that follows it.
Record record_of(std::size_t samples, const std::vector<std::pair<std::size_t, double>>& pulses) {
  Record record{"a",
                blow_rate,
                {{"F", frf::Dof::parse("1:+Z"), ChannelKind::force, std::vector<double>(samples)},
                 {"a", frf::Dof::parse("2:+Z"), ChannelKind::acceleration, std::vector<double>(samples)}}};
  for (const auto& [at, peak] : pulses) add_pulse(record.channels[0].samples, at, peak);
  for (std::size_t i = 1; i < samples; ++i) {
    record.channels[1].samples[i] = 0.9 * record.channels[1].samples[i - 1] + record.channels[0].samples[i];
  }
  return record;
}

TEST(Blows, AreFoundWithTheirPretriggerInALongRecord) {
  const Record record = record_of(2000, {{100, 50.0}, {700, 40.0}, {1300, -45.0}, {1900, 48.0}});
  const auto blows = find_blows(record, 3, {.block_s = 0.3, .pretrigger_s = 0.01});
  ASSERT_EQ(blows.size(), 3u);  // the one of the other sign is no blow of this hammer
  EXPECT_THAT((std::vector{blows[0].first, blows[1].first, blows[2].first}), ElementsAre(90u, 690u, 1890u));
  EXPECT_EQ(blows[1].peak, 702u);
  EXPECT_EQ(blows[1].force, 40.0);
  EXPECT_EQ(blows[1].record, 3u);
  EXPECT_EQ(blows[1].rejected, "");
  EXPECT_EQ(blows[2].rejected, "the record ends too early after it");
}

TEST(Blows, OneThatComesBeforeItsPretriggerIsRejected) {
  const auto blows = find_blows(record_of(500, {{5, 50.0}}), 0, {.block_s = 0.3, .pretrigger_s = 0.02});
  EXPECT_EQ(blows.at(0).rejected, "the record begins too late before it");
}

TEST(Blows, ABlockBeyondTheRecordIsAnError) {
  EXPECT_THROW(find_blows(record_of(500, {{5, 50.0}}), 0, {.block_s = 0.6}), InputError);
  EXPECT_THROW(find_blows(record_of(500, {{5, 50.0}}), 0, {.block_s = 0.2, .pretrigger_s = 0.2}), InputError);
}

std::string fault(const Record& record) { return fault_of(record, find_blows(record, 0, {}).front(), {}); }

TEST(Faults, OfAGoodBlowThereAreNone) {
  EXPECT_EQ(fault(record_of(500, {{50, 50.0}})), "");
  EXPECT_EQ(fault(record_of(500, {{50, -50.0}})), "");
  EXPECT_EQ(fault(record_of(500, {{50, 50.0}, {200, 4.0}})), "");
}

TEST(Faults, ASecondBlowIsSeenBeforeAndAfterTheStrongest) {
  EXPECT_EQ(fault(record_of(500, {{50, 50.0}, {80, 20.0}})), "double impact: 28 ms after the first hit");
  EXPECT_EQ(fault(record_of(500, {{50, 20.0}, {80, 50.0}})), "double impact: 28 ms before the first hit");
}

TEST(Faults, AnOverloadIsAFlatTopOfAnyChannel) {
  Record record = record_of(500, {{50, 50.0}});
  for (double& sample : record.channels[1].samples) sample = std::min(sample, 60.0);
  EXPECT_THAT(fault(record), HasSubstr("overload of a at 60"));
  record = record_of(500, {{50, 50.0}});
  for (double& sample : record.channels[0].samples) sample = std::min(sample, 40.0);
  EXPECT_THAT(fault(record), HasSubstr("overload of F at 40"));
}

TEST(Faults, TheRoundTopOfASignalOfFewBitsIsNoOverload) {
  Record record = record_of(2000, {{50, 50.0}});
  std::vector<double>& motion = record.channels[1].samples;
  for (std::size_t t = 0; t < motion.size(); ++t) motion[t] = std::round(1000.0 * std::sin(0.02 * static_cast<double>(t)));
  EXPECT_EQ(fault(record), "");
  for (double& sample : motion) sample = std::min(sample, 900.0);
  EXPECT_EQ(fault(record), "overload of a at 1000");
}

TEST(Faults, DeadAndBrokenChannelsAreNamed) {
  Record record = record_of(500, {{50, 50.0}});
  record.channels[1].samples.assign(500, 0.0);
  EXPECT_EQ(fault(record), "no signal in a");
  record.channels[1].samples[7] = std::nan("");
  EXPECT_EQ(fault(record), "a has a sample that is no number");
}

TEST(Segments, OverlapAndEndWithTheLastWholeOne) {
  const auto segments = find_segments(record_of(1000, {{50, 50.0}}), 0, 256, 0.5);
  ASSERT_EQ(segments.size(), 6u);
  EXPECT_EQ(segments.back().first, 640u);
  EXPECT_EQ(find_segments(record_of(1000, {{50, 50.0}}), 0, 256, 0.0).size(), 3u);
}

TEST(MeasuredFrfs, LeaveOutWhatIsRejectedAndSayWhy) {
  const std::vector<Record> records = {record_of(512, {{50, 50.0}}), record_of(512, {{60, 40.0}, {90, 30.0}}),
                                       record_of(512, {{55, 45.0}}), record_of(512, {{50, 30.0}})};
  FrfOptions options;
  options.reject = {3};
  const MeasuredFrfs made = make_frfs(records, options);
  EXPECT_EQ(made.averages.at(0).kept, 2u);
  EXPECT_EQ(made.averages.at(0).found, 4u);
  EXPECT_THAT(made.blows[1].rejected, HasSubstr("double impact"));
  EXPECT_EQ(made.blows[2].rejected, "by the user");
  EXPECT_EQ(made.set.header.noise, frf::NoiseRecord::variance);
  EXPECT_EQ(made.set.header.quantity, frf::Quantity::accelerance);
  EXPECT_TRUE(made.set.covariance.empty());  // of one response
  EXPECT_EQ(make_frfs(std::span(records).first(1), {}).set.header.noise, frf::NoiseRecord::none);
  options.keep_faulty = true;
  EXPECT_EQ(make_frfs(records, options).averages.at(0).kept, 3u);
}

TEST(MeasuredFrfs, EveryForceDofIsAReference) {
  std::vector<Record> records = {record_of(512, {{50, 50.0}}), record_of(512, {{60, 40.0}}), record_of(512, {{50, 50.0}})};
  records[1].channels[0].dof = frf::Dof::parse("7:+X");
  const MeasuredFrfs made = make_frfs(records, {});
  EXPECT_EQ(frf::names(made.set.header.reference), (std::vector<std::string>{"1:+Z", "7:+X"}));
  EXPECT_EQ(made.averages[0].kept, 2u);
  EXPECT_TRUE(std::isnan(made.set.variance[made.set.index(5, 0, 1)].real()));  // of one blow
  EXPECT_FALSE(std::isnan(made.set.variance[made.set.index(5, 0, 0)].real()));
}

template <class Act>
std::string message_of(Act&& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(MeasuredFrfs, RecordsThatDoNotAgreeAreAnError) {
  const Record good = record_of(512, {{50, 50.0}});
  Record other = good;
  other.file = "b";
  other.rate_hz = 2000.0;
  EXPECT_THAT(message_of([&] { make_frfs(std::vector{good, other}, {}); }), HasSubstr("b: was sampled at 2000 Hz, a at 1000 Hz"));
  other = good;
  other.channels[1].dof.node = 9;
  EXPECT_THAT(message_of([&] {
                make_frfs(std::vector{good, other}, {});
              }),
              HasSubstr("has the channels acceleration 9:+Z; a has acceleration 2:+Z"));
  EXPECT_THAT(message_of([&] { make_frfs(std::vector{good, record_of(500, {{50, 50.0}})}, {}); }), HasSubstr("give --block"));
  other = good;
  other.channels[0].kind = ChannelKind::velocity;
  EXPECT_THAT(message_of([&] { make_frfs(std::vector{other}, {}); }), HasSubstr("has no channel that is a force"));
  other.channels[0].kind = other.channels[1].kind = ChannelKind::force;
  EXPECT_THAT(message_of([&] { make_frfs(std::vector{other}, {}); }), HasSubstr("has no response beside the force"));
  other.channels.push_back(good.channels[1]);
  EXPECT_THAT(message_of([&] { make_frfs(std::vector{other}, {}); }), HasSubstr("has two forces, F and a"));
  EXPECT_THAT(message_of([&] {
                make_frfs(std::vector{record_of(512, {{50, 50.0}, {90, 40.0}})}, {});
              }),
              HasSubstr("all 1 segments with the force at 1:+Z are rejected: double impact"));
}

TEST(MeasuredFrfs, OptionsOutOfRangeAreAnError) {
  const std::vector<Record> records = {record_of(512, {{50, 50.0}})};
  const auto said = [&](auto change) {
    FrfOptions options;
    change(options);
    return message_of([&] { make_frfs(records, options); });
  };
  EXPECT_THAT(said([](FrfOptions& o) { o.hammer.trigger = 1.5; }), HasSubstr("trigger: 1.5 is no share"));
  EXPECT_THAT(said([](FrfOptions& o) { o.decay_time_s = -1.0; }), HasSubstr("exponential window: -1 s is not above 0"));
  EXPECT_THAT(said([](FrfOptions& o) { o.segments = {.block_s = 0.1, .overlap = 1.0}; }),
              HasSubstr("overlap: 1 is not from 0 to below 1"));
  EXPECT_THAT(said([](FrfOptions& o) { o.segments = {.block_s = 10.0}; }), HasSubstr("10 s are 10000 samples; a has 512"));
  EXPECT_THAT(said([](FrfOptions& o) { o.reject = {2}; }), HasSubstr("there is no segment 2 of 1"));
}

}  // namespace
}  // namespace jointid::records
