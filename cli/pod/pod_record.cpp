#include "cli/pod/pod_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <thread>

#include "base/error.hpp"
#include "frf/file/columns.hpp"

namespace jointid::cli {
namespace {

using frf::Columns;
using frf::NumberColumn;

std::vector<const NumberColumn*> chosen_channels(const Columns& columns, const std::vector<std::string>& wanted) {
  std::vector<const NumberColumn*> out;
  for (const std::string& name : wanted) out.push_back(&columns.column(name));
  if (!wanted.empty()) return out;
  const NumberColumn* time = columns.find({"time", "t"}, {"rate"});
  for (const NumberColumn& column : columns.columns) {
    if (&column != time) out.push_back(&column);
  }
  return out;
}

/// The samples that all channels have.
std::size_t common_length(const std::vector<const NumberColumn*>& channels) {
  std::size_t shortest = channels.front()->values.size();
  for (const NumberColumn* channel : channels) shortest = std::min(shortest, channel->values.size());
  return shortest;
}

series::NextSamples reader(const std::vector<const NumberColumn*>& channels, std::size_t length) {
  return [channels, length, next = std::size_t{0}](series::Samples& block) mutable {
    const std::size_t count = std::min(static_cast<std::size_t>(block.rows()), length - next);
    for (std::size_t k = 0; k < channels.size(); ++k) {
      for (std::size_t i = 0; i < count; ++i) block(at(i), at(k)) = channels[k]->values[next + i];
    }
    next += count;
    return count;
  };
}

void check_same(const PodRecord& record, const std::vector<const NumberColumn*>& channels, const std::string& file) {
  if (channels.size() != record.names.size()) {
    throw InputError({ErrorKind::data, file, "",
                      fmt::format("has {} channels, the files before {}", channels.size(), record.names.size()),
                      "name the channels with --channels; several files are further samples of the same ones"});
  }
  for (std::size_t k = 0; k < channels.size(); ++k) {
    if (channels[k]->name != record.names[k] || channels[k]->unit != record.units[k]) {
      throw InputError({ErrorKind::data, file, "",
                        fmt::format("channel {} is '{}' [{}], in the files before '{}' [{}]", k + 1, channels[k]->name,
                                    channels[k]->unit, record.names[k], record.units[k]),
                        "name the channels in one order with --channels"});
    }
  }
}

}  // namespace

PodRecord read_pod_record(const PodArguments& arguments) {
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t threads = arguments.threads > 0 ? arguments.threads : cores;
  std::optional<PodRecord> out;
  for (const auto& file : arguments.files) {
    const Columns columns = frf::read_columns(file);
    const auto channels = chosen_channels(columns, arguments.channels);
    if (channels.empty()) {
      throw InputError(
          {ErrorKind::data, columns.file, "", "has no channel beside the time", "name the channels with --channels"});
    }
    if (!out) {
      out.emplace(PodRecord{{}, {}, 0, series::RecordTriangle(channels.size())});
      for (const NumberColumn* channel : channels) out->names.push_back(channel->name), out->units.push_back(channel->unit);
    }
    check_same(*out, channels, columns.file);
    const std::size_t length = common_length(channels);
    for (const NumberColumn* channel : channels) out->cut += channel->values.size() - length;
    out->triangle.join(series::record_triangle(channels.size(), reader(channels, length), threads));
  }
  return std::move(*out);
}

Eigen::MatrixXd read_pod_matrix(const std::filesystem::path& file, std::size_t rows, const std::string& option) {
  const Columns columns = frf::read_columns(file);
  Eigen::MatrixXd out(at(rows), at(columns.columns.size()));
  for (std::size_t k = 0; k < columns.columns.size(); ++k) {
    const std::vector<double>& values = columns.columns[k].values;
    const auto column = Eigen::Map<const Eigen::VectorXd>(values.data(), at(values.size()));
    if (values.size() != rows || !column.allFinite()) {
      throw InputError({ErrorKind::data, columns.file, "column " + columns.columns[k].name,
                        fmt::format("has {} rows, or gaps, where there are {} channels", values.size(), rows),
                        option + " needs a row for every channel, in the order of the channels"});
    }
    out.col(at(k)) = column;
  }
  return out;
}

}  // namespace jointid::cli
