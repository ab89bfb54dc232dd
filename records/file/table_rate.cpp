#include "records/file/table_rate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "frf/file/table_remarks.hpp"
#include "frf/file/unit_suffix.hpp"
#include "frf/set/unit_label.hpp"
#include "records/file/time_axis.hpp"
#include "records/file/time_title.hpp"

namespace jointid::records {
namespace {

constexpr std::array<std::string_view, 11> rate_names = {
    "fs",           "samplerate",       "samplingrate", "samplefrequency", "samplefreq",  "samplingfrequency",
    "samplingfreq", "samplespersecond", "scanrate",     "abtastrate",      "sampleratehz"};
constexpr std::array<std::string_view, 13> step_names = {
    "dt",         "deltat",       "timestep",    "sampleinterval", "samplinginterval", "sampleperiod", "samplingperiod",
    "sampletime", "samplingtime", "wfincrement", "timeincrement",  "timeinterval",     "tsample"};

[[noreturn]] void refuse_rate(const std::string& file, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, file, {}, std::move(problem), std::move(remedy)});
}

/// The column of times, or null.
const frf::NumberColumn* times_of(const frf::Columns& table, const RecordOptions& options) {
  if (!options.time.empty()) return &table.column(options.time);
  const frf::NumberColumn* found = find_times(table);
  return found != nullptr ? found : table.find({"x"});
}

/// Letters of a name behind its last dot or @, without its unit, in lower case.
std::string plain_name(const frf::NumberColumn& column) {
  const std::string_view name = frf::suffixed_name(column.name).name;
  std::string out;
  for (const char c : name.substr(name.find_last_of(".@") + 1)) {
    if (c != '_' && c != ' ') out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

/// What a number that is no channel states of the rate; none where it states nothing.
std::optional<double> rate_stated_by(const frf::NumberColumn& column) {
  if (column.values.size() != 1 || !(column.values.front() > 0.0) || !std::isfinite(column.values.front())) return std::nullopt;
  const std::string name = plain_name(column);
  const bool is_rate = std::ranges::find(rate_names, name) != rate_names.end();
  if (!is_rate && std::ranges::find(step_names, name) == step_names.end()) return std::nullopt;
  const double unit = (is_rate ? frf::hertz_per(column.unit) : frf::seconds_per(column.unit)).value_or(1.0);
  return is_rate ? unit * column.values.front() : 1.0 / (unit * column.values.front());
}

/// Of all numbers beside the columns that state it.
std::optional<double> rate_beside(const frf::Columns& table) {
  std::optional<double> out;
  std::vector<frf::NumberColumn> numbers = table.attributes;
  std::ranges::copy_if(table.columns, std::back_inserter(numbers),
                       [](const frf::NumberColumn& c) { return c.values.size() == 1; });
  for (const frf::NumberColumn& column : numbers) {
    const auto rate = rate_stated_by(column);
    if (!rate) continue;
    if (out && std::abs(*rate - *out) > 1e-3 * *out)
      refuse_rate(table.file,
           fmt::format("{} states {:.6g} samples per second, and another number of the file {:.6g}", column.name, *rate, *out),
           "correct the file, or give a column of times");
    out = rate;
  }
  return out;
}

/// The last column of even times before a column, as tables of several plots have them; the one of the table where there is none.
const frf::NumberColumn* times_before(const frf::Columns& table, std::size_t place, const frf::NumberColumn* otherwise) {
  for (std::size_t i = place; i-- > 0;) {
    if (is_time_column(table.columns[i]) && are_even(table.columns[i].values)) return &table.columns[i];
  }
  return otherwise;
}

/// Channels behind different columns of times were sampled at the same ones.
void require_same_times(const frf::Columns& table, const RecordOptions& options, const frf::NumberColumn& times) {
  const frf::NumberColumn* first = nullptr;
  for (const GivenChannel& given : options.channels) {
    const frf::NumberColumn* own = times_before(table, table.place(given.column), &times);
    if (first == nullptr) first = own;
    if (own == first) continue;
    const std::size_t count = std::min(own->values.size(), first->values.size());
    const double own_unit = seconds_per_number(*own, table.file), unit = seconds_per_number(*first, table.file);
    double apart = 0.0;
    for (std::size_t i = 0; i < count; ++i) apart = std::max(apart, std::abs(own_unit * own->values[i] - unit * first->values[i]));
    constexpr double of_step = 0.01;
    const double step = count > 1 ? unit * (first->values[count - 1] - first->values[0]) / static_cast<double>(count - 1) : 0.0;
    if (apart > of_step * std::abs(step))
      refuse_rate(table.file,
           fmt::format("columns {} and {} are times that differ by up to {:.3g} s, and channels are behind both", first->name,
                       own->name, apart),
           "export channels that were sampled together, with one column of times");
  }
}

/// Times whose unit nothing states are s, unless a remark states another.
void require_seconds(const frf::Columns& table, const frf::NumberColumn& times) {
  if (!stated_time_unit(times).empty()) return;
  const auto unread = frf::unread_unit(table, [](const frf::Unit& unit) { return unit.same_dimension({1.0, 0, 1, 0}); });
  if (unread)
    refuse_rate(table.file,
                fmt::format("{} states the unit '{}', and column {} states none", unread->place, unread->unit, times.name),
                "write the unit into the title, e.g. time [ms], or give the samples per second by --rate (in a scene: rate)");
}

}  // namespace

double rate_of_table(const frf::Columns& table, const RecordOptions& options) {
  const frf::NumberColumn* times = times_of(table, options);
  const bool used = times != nullptr && std::ranges::any_of(options.channels, [&](const GivenChannel& given) {
                      return &table.column(given.column) == times;
                    });
  if (used && !options.rate_hz)
    refuse_rate(table.file, "column " + times->name + " holds the times, and --channel names it as a signal",
         "name the column of times by --time");
  if (times != nullptr && !used) {
    if (!options.rate_hz) require_seconds(table, *times);
    require_same_times(table, options, *times);
    return stated_or_given_rate(*times, table.file, options.rate_hz);
  }
  const auto beside = rate_beside(table);
  if (beside && options.rate_hz) return agreed_rate(*beside, *options.rate_hz, table.file, "the number beside the columns");
  if (beside || options.rate_hz) return beside.value_or(options.rate_hz.value_or(0.0));
  refuse_rate(table.file, "does not state when its samples were taken",
       "give --rate HZ, or --time COLUMN; in a scene rate = HZ, or time = \"COLUMN\"");
}

}  // namespace jointid::records
