#include "tasks/pod/pod_record.hpp"

#include <fmt/format.h>

#include <optional>
#include <span>

#include "base/control.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "frf/file/columns.hpp"
#include "records/file/open_samples.hpp"

namespace jointid::tasks {
namespace {

constexpr std::size_t most_channels = 10'000;  ///< a triangle of them takes 400 MB

/// Throws InputError unless a file has the channels of the first one.
void check_same(const PodRecord& record, const records::SampleStream& stream) {
  if (stream.channels().size() != record.names.size()) {
    throw InputError({ErrorKind::data, stream.file(), "",
                      fmt::format("has {} channels, the files before {}", stream.channels().size(), record.names.size()),
                      "name the channels with --channels; several files are further samples of the same ones"});
  }
  for (std::size_t k = 0; k < record.names.size(); ++k) {
    const auto& [name, unit] = stream.channels()[k];
    if (name == record.names[k] && unit == record.units[k]) continue;
    throw InputError({ErrorKind::data, stream.file(), "",
                      fmt::format("channel {} is '{}' [{}], in the files before '{}' [{}]", k + 1, name, unit, record.names[k],
                                  record.units[k]),
                      "name the channels in one order with --channels"});
  }
}

/// This process's part of the files.
PodRecord own_part(const PodTask& task, const ident::Team& team, const std::function<void(std::size_t)>& read,
                   const std::function<bool()>& interrupted) {
  std::optional<PodRecord> out;
  std::size_t samples = 0;
  for (const auto& file : task.files) {
    const auto stream = records::open_samples(file, {task.channels, team.rank(), team.size()});
    const std::size_t channels = stream->channels().size();
    if (channels > most_channels) {
      throw InputError({ErrorKind::data, stream->file(), "",
                        fmt::format("{} channels are more than the {} that are decomposed together", channels, most_channels),
                        "name fewer with --channels; are rows and columns exchanged?"});
    }
    if (!out) {
      out.emplace(PodRecord{{}, {}, 0, oscillation::RecordTriangle(channels)});
      for (const auto& channel : stream->channels()) out->names.push_back(channel.name), out->units.push_back(channel.unit);
    }
    check_same(*out, *stream);
    out->cut += stream->cut();
    const auto next = [&](std::span<double> rows) {
      stop_if(interrupted);
      const std::size_t count = stream->read(rows);
      read(samples += count);
      return count;
    };
    out->triangle.join(oscillation::record_triangle(channels, next, threads_or_cores(task.threads, team.size())));
  }
  return std::move(*out);
}

}  // namespace

PodRecord read_pod_record(const PodTask& task, ident::Team& team, const std::function<void(std::size_t)>& read,
                          const std::function<bool()>& interrupted) {
  std::optional<PodRecord> own;
  ident::start_together(team, [&] { own = own_part(task, team, read, interrupted); });
  if (team.size() == 1) return std::move(*own);
  oscillation::RecordTriangle all(own->names.size());
  for (const std::vector<double>& part : team.gathered(own->triangle.numbers()))
    all.join(oscillation::RecordTriangle::of_numbers(own->names.size(), part));
  own->triangle = std::move(all);
  return std::move(*own);
}

Eigen::MatrixXd read_pod_matrix(const std::filesystem::path& file, std::size_t rows, const std::string& option) {
  const frf::Columns columns = frf::read_columns(file);
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

}  // namespace jointid::tasks
