#include "records/file/read_record.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "frf/file/columns.hpp"
#include "frf/file/file_format.hpp"
#include "frf/file/file_head.hpp"
#include "frf/file/table_remarks.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/uff/uff_file.hpp"
#include "records/file/limits.hpp"
#include "records/file/npy_file.hpp"
#include "records/file/stated_unit.hpp"
#include "records/file/table_rate.hpp"
#include "records/file/uff_record.hpp"

namespace jointid::records {
namespace {

[[noreturn]] void fail(const std::string& file, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, file, {}, std::move(problem), std::move(remedy)});
}

/// A label beside the columns that states another unit of the same kind, "ylabel: Acceleration [g]".
void require_remarks_agree(const frf::Columns& table, const GivenUnit& given, const std::string& place) {
  const auto option = frf::parse_unit(given.unit);
  const auto differs = [&](const frf::Unit& unit) {
    return option && unit.same_dimension(*option) && !agree(unit.si, option->si, given.factor);
  };
  const auto unread = frf::unread_unit(table, differs);
  if (!unread) return;
  throw InputError({ErrorKind::data, table.file, place,
                    "states no unit, " + unread->place + " states '" + unread->unit + "', and " + given.unit + " is given",
                    "give the unit of the numbers, and write it into the title of the column, or remove what states another"});
}

/// Numbers of a sensor whose sensitivity is stated, and whose unit is not, may be volts.
void require_no_sensitivity(const frf::Columns& table, const GivenChannel& given, const std::string& place) {
  if (given.factor != 1.0) return;
  const auto sensor = frf::unapplied_sensitivity(table);
  if (!sensor) return;
  throw InputError(
      {ErrorKind::data, table.file, place,
       "states no unit, and " + sensor->place + " states '" + frf::shown_label(sensor->unit) + "', which nothing applies",
       "write the unit of the numbers into the title of the column; of volts give factor and unit, e.g. " + given.column + "=" +
           given.dof.name() + " 22.4 N"});
}

Channel channel_of(const frf::Columns& table, const GivenChannel& given, const RecordOptions& options) {
  const frf::NumberColumn& column = table.column(given.column);
  const std::string place = "column " + column.name;
  const std::string& otherwise = column.unit.empty() ? options.unit_otherwise : column.unit;
  const GivenUnit unit{given.unit.empty() ? otherwise : given.unit, given.factor};
  const auto parsed = frf::parse_unit(unit.unit);
  const auto kind = parsed ? kind_of(*parsed, given.dof.is_rotation()) : std::nullopt;
  if (!kind)
    throw InputError({ErrorKind::data, table.file, place,
                      unit.unit.empty() ? "the file states no unit of it"
                                        : "'" + unit.unit + "' is no unit of a force or a motion at " + given.dof.name(),
                      is_other_quantity(unit.unit)
                          ? "give factor and unit, e.g. " + given.column + "=" + given.dof.name() + " 22.4 N"
                          : "give it, e.g. " + given.column + "=" + given.dof.name() + " N, or m/s^2"});
  require_agreement(column.unit, unit, table.file, place);
  if (column.unit.empty()) {
    require_remarks_agree(table, unit, place);
    require_no_sensitivity(table, given, place);
  }
  Channel channel{column.name, given.dof, *kind, column.values};
  for (double& sample : channel.samples) sample *= given.factor * parsed->si;
  return channel;
}

/// One column is not two channels.
void require_different(const frf::Columns& table, const std::vector<GivenChannel>& channels) {
  std::map<std::size_t, std::string> used;
  for (const GivenChannel& given : channels) {
    const auto [before, is_new] = used.emplace(table.place(given.column), given.column);
    if (is_new) continue;
    fail(table.file,
         "--channel '" + before->second + "=' and '" + given.column + "=' are one column, " + table.columns[before->first].name,
         "give every channel its own column; the columns are " + table.names());
  }
}

Record record_of(const frf::Columns& table, const RecordOptions& options) {
  if (options.channels.empty()) {
    fail(table.file, "has columns " + table.names() + " and does not state what they measured",
         "name each, e.g. --channel '2=1:+Z N' --channel '3=4:+Z m/s^2'");
  }
  require_different(table, options.channels);
  Record record{table.file, rate_of_table(table, options)};
  for (const GivenChannel& given : options.channels) record.channels.push_back(channel_of(table, given, options));
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
  const std::string head = text ? frf::head_of(path) : std::string();
  if (frf::looks_like_uff(head)) return read_uff_records(path, options);
  return {record_of(looks_like_npy(head) ? read_npy(path) : frf::read_columns(path), options)};
}

}  // namespace jointid::records
