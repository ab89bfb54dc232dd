#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "frf/hdf5_module/files.hpp"
#include "frf/hdf5_module/hdf5_line_reader.hpp"
#include "frf/hdf5_module/hdf5_object.hpp"
#include "frf/set/line_scale.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/located.hpp"

namespace jointid::frf {
namespace {

using hdf5::Dataset;
using hdf5::Object;

constexpr const char *layout_name = "jointid-frf", *factor_name = "covariance_factor", *diagonal_name = "covariance_diagonal",
                     *correlation_name = "reference_correlation";

void require_layout(const Object& file) {
  const auto format = hdf5::text_attribute(file, "format");
  if (!format) fail(file, "has no root attribute format", "jointid-frf files carry format = \"jointid-frf\"");
  if (*format != layout_name)
    fail(file, "root attribute format is '" + *format + "', not 'jointid-frf'", "give a jointid-frf file, or UFF, MATLAB or CSV");
  const auto version = hdf5::number_attribute(file, "version");
  if (!version) fail(file, "has no root attribute version", "this program reads versions 1 and 2");
  if (*version != 1.0 && *version != 2.0) {
    fail(file, "is of jointid-frf version " + fmt::format("{}", *version), "this program reads versions 1 and 2");
  }
}

void require_rank(const Dataset& dataset, std::size_t rank) {
  if (dataset.dims.size() == rank) return;
  fail(dataset,
       "has " + std::to_string(dataset.dims.size()) + " dimensions instead of " + std::to_string(rank));
}

/// Also where the attribute is called units, or is written in capitals.
std::optional<std::string> unit_text(const Dataset& dataset) {
  auto text = hdf5::any_text_attribute(dataset, "unit");
  return text ? text : hdf5::any_text_attribute(dataset, "units");
}

std::vector<double> read_frequency(const Object& file) {
  const Dataset dataset = open_dataset(file, "frequency");
  require_rank(dataset, 1);
  const std::string unit = unit_text(dataset).value_or("Hz");
  const double hz = located(dataset.file, dataset.place, [&] { return hertz_per(unit).value_or(1.0); });
  if (hz != 1.0) fail(dataset, "is in '" + shown_label(unit) + "'", "store frequencies in Hz");
  return hdf5::read_doubles(dataset);
}

std::vector<Dof> read_dofs(const Object& file, const char* name) {
  const Dataset dataset = open_dataset(file, name);
  require_rank(dataset, 1);
  std::vector<Dof> dofs;
  for (const std::string& text : hdf5::read_texts(dataset)) {
    dofs.push_back(located(dataset.file, dataset.place, [&] { return Dof::parse(text); }));
  }
  return dofs;
}

/// Of all nodes; empty where the file has none.
std::vector<double> read_axes(const Object& file, std::size_t nodes) {
  if (!hdf5::has(file, "node_axes")) return {};
  const Dataset dataset = open_dataset(file, "node_axes");
  if (dataset.dims != std::vector<std::size_t>{nodes, 3, 3}) {
    fail(dataset, "is not [" + std::to_string(nodes) + ",3,3] as node_id asks");
  }
  return hdf5::read_doubles(dataset);
}

std::vector<Node> read_nodes(const Object& file) {
  if (!hdf5::has(file, "node_id")) return {};
  const Dataset id_dataset = open_dataset(file, "node_id");
  require_rank(id_dataset, 1);
  const Dataset position_dataset = open_dataset(file, "node_position");
  if (position_dataset.dims != std::vector<std::size_t>{id_dataset.dims[0], 3}) {
    fail(position_dataset, "is not [" + std::to_string(id_dataset.dims[0]) + ",3] as node_id asks");
  }
  const std::vector<double> ids = hdf5::read_doubles(id_dataset);
  const std::vector<double> positions = hdf5::read_doubles(position_dataset);
  const std::vector<double> axes = read_axes(file, ids.size());
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!(ids[i] >= 0.0 && ids[i] <= 9'999'999'999.0) || ids[i] != std::floor(ids[i])) {
      fail(id_dataset, fmt::format("{}", ids[i]) + " is not a node number");
    }
    nodes.push_back({static_cast<std::int64_t>(ids[i]), {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]}, {}});
    if (axes.empty()) continue;
    Axes own{};
    for (std::size_t k = 0; k < 9; ++k) own[k / 3][k % 3] = axes[9 * i + k];
    if (own != global_axes) nodes.back().axes = own;
  }
  return nodes;
}

std::string required_text(const Dataset& dataset, const char* name, const char* remedy) {
  auto text = hdf5::text_attribute(dataset, name);
  if (!text) fail(dataset, std::string("has no attribute ") + name, remedy);
  return std::move(*text);
}

/// Blocks of an open jointid-frf file.
class Hdf5Source final : public FrfSource {
 public:
  explicit Hdf5Source(const std::filesystem::path& path) {
    const hdf5::Silence silence;
    file_ = hdf5::open_file(path);
    require_layout(file_);
    header_.file = file_.file;
    header_.frequency_hz = read_frequency(file_);
    header_.response = read_dofs(file_, "response_dof");
    header_.reference = read_dofs(file_, "reference_dof");
    header_.nodes = read_nodes(file_);
    validate(header_);
    open_frf();
    open_noise();
    close_early();
  }

 private:
  /// A file of FRFs and variances alone that are read past HDF5 is closed there.
  void close_early() {
    if (coherence_ || covariance_ || factor_ || !frf_->stand_alone()) return;
    if (!variance_ || variance_->stand_alone()) file_.id.close();
  }

  void open_frf() {
    frf_.emplace(file_, "frf", header_);
    const Dataset dataset = open_dataset(file_, "frf");
    const std::string quantity =
        required_text(dataset, "quantity", "write receptance, mobility or accelerance");
    header_.quantity = located(file_.file, dataset.place, [&] { return parse_quantity(quantity); });
    const std::optional<std::string> stated = unit_text(dataset);
    const std::string label = stated ? *stated : required_text(dataset, "unit", "write it, e.g. m/N, as part of the layout");
    si_ = located(file_.file, dataset.place, [&] { return si_factor(label, header_); });
  }

  void open_noise() {
    const bool has_coherence = hdf5::has(file_, "coherence");
    if (hdf5::has(file_, "variance")) {
      if (has_coherence) fail(file_, "has both variance and coherence", "keep the one that was measured");
      variance_.emplace(file_, "variance", header_);
      header_.noise = NoiseRecord::variance;
      header_.averages = read_averages("variance");
      open_covariances();
    } else if (has_coherence) {
      coherence_.emplace(file_, "coherence", header_);
      header_.averages = read_averages("coherence");
      header_.noise = NoiseRecord::coherence;
    }
    if (!variance_) require_no_factor();
  }

  double read_averages(const char* name) {
    const Dataset dataset = open_dataset(file_, name);
    const std::optional<double> averages = hdf5::number_attribute(dataset, "averages");
    if (averages && !(*averages >= 1.0)) {
      fail(dataset, fmt::format("attribute averages is {}", *averages),
           fmt::format("write the number of averages behind the {}, or leave it out", name));
    }
    return averages.value_or(0.0);
  }

  /// Nothing of them is read before it is asked for.
  void open_covariances() {
    const bool pairs = hdf5::has(file_, "covariance"), factor = hdf5::has(file_, factor_name), diagonal = hdf5::has(file_, diagonal_name);
    if (pairs && (factor || diagonal)) {
      fail(file_, std::string("has both covariance and ") + (factor ? factor_name : diagonal_name),
           "keep the pairs, or the factor with its diagonal");
    }
    if (diagonal && !factor) {
      fail(file_, std::string("has a dataset ") + diagonal_name + " without " + factor_name,
           "write both, or neither: variance has what errors of their own are");
    }
    if (pairs || factor) require_version_two(pairs ? "covariance" : factor_name);
    if (pairs) open_pairs();
    if (factor) open_factor(diagonal);
    if (!hdf5::has(file_, correlation_name)) return;
    if (!pairs && !factor) {
      fail(file_, std::string("has a dataset ") + correlation_name + " without covariances", "write the covariances, too");
    }
    reference_correlation_.emplace(file_, correlation_name,
                                   std::array{header_.lines(), header_.reference.size(), header_.reference.size()});
  }

  void require_no_factor() const {
    for (const char* name : {factor_name, diagonal_name, correlation_name}) {
      if (hdf5::has(file_, name)) fail(file_, std::string("has a dataset ") + name + " without variance", "write the variances, too");
    }
  }

  void require_version_two(const char* name) const {
    if (hdf5::number_attribute(file_, "version") == 2.0) return;
    fail(file_, std::string("has a dataset ") + name + " and is of version 1", "write version = 2 where there are covariances");
  }

  void open_factor(bool diagonal) {
    const Dataset dataset = open_dataset(file_, factor_name);
    const std::size_t responses = header_.response.size();
    if (dataset.dims.size() == 3 && (dataset.dims[1] == 0 || dataset.dims[1] % responses != 0)) {
      fail(dataset, fmt::format("has {} rows, which {} responses do not divide", dataset.dims[1], responses),
           "store it as [lines, responses · K, references], column k of the factor at response r in row r · K + k");
    }
    shape_ = {dataset.dims.size() == 3 ? dataset.dims[1] / responses : 1, diagonal};
    factor_.emplace(file_, factor_name, std::array{header_.lines(), responses * shape_.rank, header_.reference.size()});
    if (diagonal) diagonal_.emplace(file_, diagonal_name, header_);
  }

  void open_pairs() {
    covariance_.emplace(file_, "covariance",
                        std::array{header_.lines(), pair_count(header_.response.size()), header_.reference.size()});
  }

  /// Applies `scale(line scale, value)` line by line.
  template <class T, class Scale>
  void to_receptance(const Block& block, std::span<T> values, Scale scale) const {
    const std::size_t entries = block.responses.size() * block.references.size();
    for (std::size_t i = 0; i < block.lines.size(); ++i) {
      const LineScale of_line =
          LineScale::to_receptance(header_.quantity, si_, header_.frequency_hz[block.lines[i]]);
      if (of_line.is_identity()) continue;
      for (T& value : values.subspan(i * entries, entries)) value = scale(of_line, value);
    }
  }

  void do_read(const Block& block, std::span<Complex> out) override {
    frf_->read(block, out);
    to_receptance(block, out, [](const LineScale& scale, Complex h) { return scale.value(h); });
  }

  void do_read_variance(const Block& block, std::span<Complex> out) override {
    variance_->read(block, out);
    to_receptance(block, out, [](const LineScale& scale, Complex v) { return scale.variance(v); });
  }

  void do_read_coherence(const Block& block, std::span<double> out) override { coherence_->read(block, out); }

  bool has_covariance() const override { return covariance_ || factor_; }
  FactorShape factor_shape() const override { return shape_; }
  bool has_reference_correlation() const override { return reference_correlation_.has_value(); }

  void do_read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                     std::span<Complex> out) override {
    reference_correlation_->read({lines, references, references}, out);
  }

  void do_read_factor(const Block& block, std::span<Complex> rows, std::span<double> diagonal) override {
    std::vector<std::size_t> stored;
    for (const std::size_t r : block.responses) {
      for (std::size_t k = 0; k < shape_.rank; ++k) stored.push_back(r * shape_.rank + k);
    }
    const Block of_factor{block.lines, stored, block.references};
    factor_->read(of_factor, rows);
    to_receptance(of_factor, rows, [](const LineScale& scale, Complex v) { return scale.factor(v); });
    if (diagonal.empty()) return;
    diagonal_->read(block, diagonal);
    to_receptance(block, diagonal, [](const LineScale& scale, double v) { return scale.diagonal(v); });
  }

  void do_read_covariance(const Block& pairs, std::span<Complex> out) override {
    if (factor_) return FrfSource::do_read_covariance(pairs, out);
    covariance_->read(pairs, out);
    to_receptance(pairs, out, [](const LineScale& scale, Complex v) { return scale.covariance(v); });
  }

  Object file_;
  double si_ = 1.0;
  std::optional<hdf5::LineReader<Complex>> frf_;
  std::optional<hdf5::LineReader<Complex>> variance_;
  std::optional<hdf5::LineReader<double>> coherence_;
  std::optional<hdf5::LineReader<Complex>> covariance_;
  FactorShape shape_;
  std::optional<hdf5::LineReader<Complex>> factor_;
  std::optional<hdf5::LineReader<double>> diagonal_;
  std::optional<hdf5::LineReader<Complex>> reference_correlation_;
};

}  // namespace

bool hdf5::has_format_attribute(const std::filesystem::path& path) {
  const hdf5::Silence silence;
  return hdf5::text_attribute(hdf5::open_file(path), "format").has_value();
}

std::unique_ptr<FrfSource> hdf5::open_source(const std::filesystem::path& path) {
  return std::make_unique<Hdf5Source>(path);
}

}  // namespace jointid::frf
