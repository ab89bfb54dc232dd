#include "frf/mat/mat_file.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "frf/mat/mat_lookup.hpp"
#include "frf/set/line_scale.hpp"
#include "frf/set/units.hpp"
#include "frf/text/located.hpp"

namespace jointid::frf {
namespace {

/// Finds and reads what the conventions name.
class Reader {
 public:
  Reader(MatFile& file, const OpenOptions& options) : file_(file), lookup_(file), options_(options) {}

  FrfSet read() {
    FrfHeader& header = set_.header;
    header.file = file_.file();
    header.frequency_hz = lookup_.axis();
    const MatInfo& frf = lookup_.frf(options_.variable, header.lines());
    header.response = lookup_.dofs("response_dof", options_.response);
    header.reference = lookup_.dofs("reference_dof", options_.reference);
    if (header.reference.empty()) header.reference = header.response;
    header.quantity = read_quantity();
    if (header.response.empty()) {
      lookup_.fail({}, "does not say at which DOFs " + frf.name + " was measured",
                   "give the response and reference DOFs, or add cell arrays response_dof and reference_dof");
    }
    validate(header);
    set_.values = ordered(frf);
    read_noise(frf);
    to_receptance();
    return std::move(set_);
  }

 private:
  Quantity read_quantity() {
    const std::string text = lookup_.text("quantity");
    if (!text.empty())
      return located(file_.file(), place_of("quantity"), [&] { return parse_quantity(text, options_.quantity); });
    if (options_.quantity) return *options_.quantity;
    lookup_.fail({}, "does not say which quantity it holds",
                 "give the quantity, or add a text quantity = 'accelerance'");
  }

  /// Whether an array may be [F,R,C] or [F,N], and whether it may be [R,C,F] or [N,F].
  std::array<bool, 2> orders(const MatInfo& info) const {
    const std::size_t lines = set_.header.lines();
    const std::size_t rows = set_.header.response.size();
    const std::size_t columns = set_.header.reference.size();
    std::array<std::size_t, 3> d = {1, 1, 1};
    if (info.dims.size() > 3) return {false, false};
    std::ranges::copy(info.dims, d.begin());
    const auto is = [&](std::size_t a, std::size_t b, std::size_t c) { return d == std::array{a, b, c}; };
    return {is(lines, rows, columns) || is(lines, rows * columns, 1),
            is(rows, columns, lines) || is(rows * columns, lines, 1)};
  }

  /// Whether the lines are the last axis rather than the first.
  bool lines_last(const MatInfo& info) {
    const auto [first, last] = orders(info);
    if (!first && !last) {
      const FrfHeader& header = set_.header;
      lookup_.fail(place_of(info.name),
                   "is [" + shape(info) + "] where " + std::to_string(header.lines()) + " lines, " +
                       std::to_string(header.response.size()) + " responses and " +
                       std::to_string(header.reference.size()) + " references are expected",
                   "shape it [F,R,C], [R,C,F] or [F,R*C], or give other DOFs");
    }
    const std::string axes = lookup_.text("axes");
    if (axes == "FRC" && first) return false;
    if (axes == "RCF" && last) return true;
    if (first && last && set_.header.lines() > 1 && set_.header.entries() > 1) {
      lookup_.fail(place_of(info.name), "[" + shape(info) + "] may be [F,R,C] or [R,C,F]",
                   "add a text axes = 'FRC' or 'RCF'");
    }
    return last;
  }

  /// The values of an array in the order [line, response, reference].
  std::vector<Complex> ordered(const MatInfo& info) {
    const bool last = lines_last(info);
    const std::vector<Complex> values = file_.read(info).values;
    const std::size_t lines = set_.header.lines();
    const std::size_t rows = set_.header.response.size();
    const std::size_t entries = set_.header.entries();
    std::vector<Complex> out(values.size());
    for (std::size_t line = 0; line < lines; ++line) {
      for (std::size_t entry = 0; entry < entries; ++entry) {
        const std::size_t to = set_.index(line, entry % rows, entry / rows);
        out[to] = values[last ? entry + entries * line : line + lines * entry];
      }
    }
    return out;
  }

  void read_noise(const MatInfo& frf) {
    const MatInfo* variance = lookup_.find("variance");
    const MatInfo* coherence = lookup_.find("coherence");
    for (const MatInfo* noise : {variance, coherence}) {
      if (noise != nullptr && noise->dims != frf.dims) {
        lookup_.fail(place_of(noise->name),
                     "is [" + shape(*noise) + "] and " + frf.name + " [" + shape(frf) + "]",
                     "shape them alike");
      }
    }
    if (variance != nullptr && coherence != nullptr) {
      lookup_.fail({}, "has both variance and coherence", "keep the one that was measured");
    }
    if (variance != nullptr) read_variance(*variance);
    if (coherence != nullptr) read_coherence(*coherence);
  }

  void read_variance(const MatInfo& info) {
    if (info.kind != MatKind::complex) {
      lookup_.fail(place_of(info.name), "is not complex",
                   "give the variances of real and imaginary part as a complex array");
    }
    set_.header.noise = NoiseRecord::variance;
    set_.variance = ordered(info);
  }

  void read_coherence(const MatInfo& info) {
    if (info.kind != MatKind::real)
      lookup_.fail(place_of(info.name), "is not real", "give coherences between 0 and 1");
    if (const MatInfo* averages = lookup_.find("averages")) set_.header.averages = read_averages(*averages);
    set_.header.noise = NoiseRecord::coherence;
    for (const Complex& value : ordered(info)) set_.coherence.push_back(value.real());
  }

  double read_averages(const MatInfo& info) {
    const bool scalar = info.kind == MatKind::real && size(info) == 1;
    const double value = scalar ? file_.read(info).values.front().real() : 0.0;
    if (!(value >= 1.0)) {
      lookup_.fail(place_of(info.name), "is not a number of averages",
                   "give how many the coherences come from");
    }
    return value;
  }

  void to_receptance() {
    const FrfHeader& header = set_.header;
    const std::string label = lookup_.text("unit");
    const double si = label.empty()
                          ? 1.0
                          : located(header.file, place_of("unit"), [&] { return si_factor(label, header); });
    for (std::size_t i = 0; i < set_.values.size(); ++i) {
      const LineScale scale =
          LineScale::to_receptance(header.quantity, si, header.frequency_hz[i / header.entries()]);
      set_.values[i] = scale.value(set_.values[i]);
      if (!set_.variance.empty()) set_.variance[i] = scale.variance(set_.variance[i]);
    }
  }

  MatFile& file_;
  MatLookup lookup_;
  const OpenOptions& options_;
  FrfSet set_;
};

std::unique_ptr<FrfSource> open_mat(const std::unique_ptr<MatFile>& file, const OpenOptions& options) {
  return from_memory(Reader(*file, options).read());
}

}  // namespace

std::vector<double> MatFile::read_samples(const MatInfo& info, std::size_t, std::size_t) {
  fail(info.name, "cannot be read in parts");
}

void MatFile::fail(const std::string& variable, std::string problem) const {
  throw InputError({.kind = ErrorKind::data,
                    .file = file_,
                    .place = variable.empty() ? std::string() : place_of(variable),
                    .problem = std::move(problem),
                    .remedy = {}});
}

std::unique_ptr<FrfSource> open_mat_v5(const std::filesystem::path& path, const OpenOptions& options) {
  return open_mat(open_mat_variables_v5(path), options);
}

std::unique_ptr<FrfSource> open_mat_v73(const std::filesystem::path& path, const OpenOptions& options) {
  return open_mat(open_mat_variables_v73(path), options);
}

}  // namespace jointid::frf
