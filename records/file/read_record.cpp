#include "records/file/read_record.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/file/columns.hpp"
#include "frf/file/file_format.hpp"
#include "frf/uff/uff_file.hpp"
#include "records/file/file_head.hpp"
#include "records/file/limits.hpp"
#include "records/file/npy_file.hpp"
#include "records/file/time_axis.hpp"
#include "records/file/uff_record.hpp"

namespace jointid::records {
namespace {

[[noreturn]] void fail(const std::string& file, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, file, {}, std::move(problem), std::move(remedy)});
}

/// Samples per second, by the user or by a column of times.
double rate_of_table(const frf::Columns& table, const RecordOptions& options) {
  if (options.rate_hz) return *options.rate_hz;
  const frf::NumberColumn* times = options.time.empty() ? table.find({"time", "t", "zeit", "x"}) : &table.column(options.time);
  if (times == nullptr)
    fail(table.file, "does not say when its samples were taken",
         "give --rate HZ, or --time COLUMN; in a scene rate = HZ, or time = \"COLUMN\"");
  return rate_of(times->values, table.file, "column " + times->name);
}

Channel channel_of(const frf::Columns& table, const GivenChannel& given) {
  const frf::NumberColumn& column = table.column(given.column);
  const auto unit = frf::parse_unit(given.unit);
  const auto kind = unit ? kind_of(*unit, given.dof.is_rotation()) : std::nullopt;
  if (!kind) fail(table.file, "'" + given.unit + "' is no unit of a force or a motion", "write it as N or m/s^2");
  Channel channel{column.name, given.dof, *kind, column.values};
  for (double& sample : channel.samples) sample *= given.factor * unit->si;
  return channel;
}

Record record_of(const frf::Columns& table, const RecordOptions& options) {
  if (options.channels.empty()) {
    const std::string names = comma_list(table.columns, [](const auto& column) { return column.name; });
    fail(table.file, "has columns " + names + " and does not say what they measured",
         "name each, e.g. --channel '2=1:+Z N' --channel '3=4:+Z m/s^2'");
  }
  Record record{table.file, rate_of_table(table, options)};
  for (const GivenChannel& given : options.channels) record.channels.push_back(channel_of(table, given));
  for (const Channel& channel : record.channels) {
    if (channel.samples.size() == record.samples()) continue;
    fail(table.file,
         "column " + channel.name + " has " + std::to_string(channel.samples.size()) + " samples, column " +
             record.channels.front().name + " " + std::to_string(record.samples()),
         "give channels that were sampled together");
  }
  return record;
}

}  // namespace

std::vector<Record> read_records(const std::filesystem::path& path, const RecordOptions& options) {
  const bool text = !frf::detect_binary_format(path);
  const std::uint64_t size = std::filesystem::file_size(path);
  if (size > most_file_bytes) {
    fail(path.string(), std::to_string(size >> 20) + " MiB are more than the 2048 MiB that are read into memory", "split it");
  }
  const std::string head = text ? head_of(path) : std::string();
  if (frf::looks_like_uff(head)) return read_uff_records(path);
  return {record_of(looks_like_npy(head) ? read_npy(path) : frf::read_columns(path), options)};
}

}  // namespace jointid::records
