#include "gui/data/loaded_file.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/control.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/statistics.hpp"
#include "frf/file/file_head.hpp"
#include "frf/uff/uff_lines.hpp"
#include "ident/plan/data_source.hpp"

namespace jointid::gui {
namespace {

using Indices = std::vector<std::size_t>;

Indices all_of(std::size_t count) {
  Indices all(count);
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

Indices some_of(std::size_t count, std::size_t most) {
  Indices some;
  const std::size_t taken = std::min(count, most);
  for (std::size_t i = 0; i < taken; ++i) some.push_back(taken == 1 ? 0 : i * (count - 1) / (taken - 1));
  return some;
}

/// Nodes of a file without FRFs; none of one that is no universal file.
std::vector<frf::Node> nodes_alone(const std::filesystem::path& path) {
  if (!frf::is_universal_file(path)) return {};
  try {
    return frf::read_uff_nodes(path);
  } catch (const InputError&) {
    return {};  // the error of the FRFs says what is wrong
  }
}

LoadedFile open_file(const ident::DataFile& file, bool is_assembly) {
  LoadedFile loaded;
  loaded.name = file.path.filename().string();
  loaded.is_assembly = is_assembly;
  try {
    loaded.source = std::move(ident::open_all({file}).front());
    loaded.header = loaded.source->header();
  } catch (const InputError& error) {
    loaded.error = error.what();
    loaded.header.nodes = nodes_alone(file.path);
  }
  return loaded;
}

double usable(double value) { return std::isfinite(value) ? value : 0.0; }

/// The values of some lines of a file, and what tells their noise.
struct Sample {
  std::size_t lines = 0, responses = 0, references = 0;
  std::vector<Complex> values, variances;
  std::vector<double> coherences;

  std::size_t at(std::size_t line, std::size_t r, std::size_t c) const { return (line * responses + r) * references + c; }
};

Sample sample_of(const LoadedFile& file, std::size_t most_lines, const std::function<bool()>& interrupted) {
  const frf::FrfHeader& header = file.header;
  const Indices lines = some_of(header.lines(), most_lines), responses = all_of(header.response.size()),
                references = all_of(header.reference.size());
  Sample sample{lines.size(), responses.size(), references.size(), {}, {}, {}};
  const frf::Block block{lines, responses, references};
  sample.values.resize(block.size());
  file.source->read(block, sample.values);
  stop_if(interrupted);
  if (header.noise == frf::NoiseRecord::coherence) {
    sample.coherences.resize(block.size());
    file.source->read_coherence(block, sample.coherences);
  } else if (header.noise == frf::NoiseRecord::variance) {
    sample.variances.resize(block.size());
    file.source->read_variance(block, sample.variances);
  }
  stop_if(interrupted);
  return sample;
}

std::optional<double> mean_coherence(const Sample& sample, std::size_t r, std::size_t c) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t line = 0; line < sample.lines && !sample.coherences.empty(); ++line) {
    const double value = sample.coherences[sample.at(line, r, c)];
    sum += usable(value);
    count += std::isfinite(value) ? 1U : 0U;
  }
  return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

std::optional<double> median_deviation(const Sample& sample, std::size_t r, std::size_t c) {
  std::vector<double> all;
  for (std::size_t line = 0; line < sample.lines && !sample.variances.empty(); ++line) {
    const std::size_t at = sample.at(line, r, c);
    const double deviation = std::sqrt(sample.variances[at].real() + sample.variances[at].imag()) / std::abs(sample.values[at]);
    if (std::isfinite(deviation)) all.push_back(deviation);
  }
  return all.empty() ? std::nullopt : std::optional(median(all));
}

/// Against the FRF with the roles exchanged, where that is measured; signs of the sensors count.
std::optional<double> reciprocity_error(const Sample& sample, const frf::FrfHeader& header, std::size_t r, std::size_t c) {
  const std::size_t row = frf::find_coordinate(header.response, header.reference[c]);
  const std::size_t column = frf::find_coordinate(header.reference, header.response[r]);
  if (row == frf::npos || column == frf::npos || (row == r && column == c)) return std::nullopt;
  const double sign =
      header.response[r].sign * header.reference[c].sign * header.response[row].sign * header.reference[column].sign;
  double difference = 0.0, sum = 0.0;
  for (std::size_t line = 0; line < sample.lines; ++line) {
    const Complex one = sample.values[sample.at(line, r, c)], other = sign * sample.values[sample.at(line, row, column)];
    difference += usable(std::norm(one - other));
    sum += usable(std::norm(one) + std::norm(other));
  }
  return sum > 0.0 ? std::optional(std::sqrt(2.0 * difference / sum)) : std::nullopt;
}

}  // namespace

std::vector<LoadedFile> open_files(const ident::DataSection& data, const std::function<bool()>& interrupted) {
  std::vector<const ident::DataFile*> all;
  for (const auto* list : {&data.substructures, &data.assembly}) {
    for (const ident::DataFile& file : *list) all.push_back(&file);
  }
  std::vector<LoadedFile> files(all.size());
  for_each_index(all.size(), threads_or_cores(0), [&](std::size_t i) {
    stop_if(interrupted);
    files[i] = open_file(*all[i], i >= data.substructures.size());
  });
  return files;
}

std::vector<EntryFigures> figures_of(const LoadedFile& file, const std::function<bool()>& interrupted, std::size_t most_lines) {
  const Sample sample = sample_of(file, most_lines, interrupted);
  std::vector<EntryFigures> all;
  for (std::size_t r = 0; r < sample.responses; ++r) {
    for (std::size_t c = 0; c < sample.references; ++c) {
      EntryFigures figures;
      for (std::size_t line = 0; line < sample.lines; ++line) {
        const bool there = std::isfinite(std::abs(sample.values[sample.at(line, r, c)]));
        figures.missing += there ? 0.0 : 1.0 / static_cast<double>(sample.lines);
      }
      figures.coherence = mean_coherence(sample, r, c);
      figures.deviation = median_deviation(sample, r, c);
      figures.reciprocity = reciprocity_error(sample, file.header, r, c);
      all.push_back(figures);
    }
  }
  return all;
}

Curve read_curve(const LoadedFile& file, std::size_t response, std::size_t reference) {
  const frf::FrfHeader& header = file.header;
  Curve curve;
  curve.response = header.response[response];
  curve.reference = header.reference[reference];
  curve.name = file.name + "  " + curve.response.name() + " / " + curve.reference.name();
  curve.frequency_hz = header.frequency_hz;
  curve.file = file.name;
  const Indices lines = all_of(header.lines()), responses = {response}, references = {reference};
  const frf::Block block{lines, responses, references};
  curve.values.resize(block.size());
  file.source->read(block, curve.values);
  if (header.noise == frf::NoiseRecord::coherence) {
    curve.coherence.resize(block.size());
    file.source->read_coherence(block, curve.coherence);
  }
  return curve;
}

}  // namespace jointid::gui
