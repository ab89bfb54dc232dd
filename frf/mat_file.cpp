#include "frf/mat_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <numbers>
#include <numeric>

#include "frf/error.hpp"
#include "frf/line_scale.hpp"
#include "frf/located.hpp"
#include "frf/mat_variable.hpp"
#include "frf/units.hpp"

namespace jointid::frf {
namespace {

struct AxisName {
  std::string_view name;
  double to_hz;
};
constexpr double from_rad_per_s = 0.5 / std::numbers::pi;
constexpr std::array<AxisName, 9> axis_names = {{{"frequency_hz", 1.0},
                                                 {"frequency", 1.0},
                                                 {"freq", 1.0},
                                                 {"f", 1.0},
                                                 {"freq_hz", 1.0},
                                                 {"frequencies", 1.0},
                                                 {"freq_domain", 1.0},
                                                 {"w", from_rad_per_s},
                                                 {"omega", from_rad_per_s}}};

/// One letter must match in case too: f is a frequency and F may be a force.
bool same_name(std::string_view a, std::string_view b) {
  if (a.size() == 1) return a == b;
  return std::ranges::equal(
      a, b, {}, [](unsigned char c) { return std::tolower(c); },
      [](unsigned char c) { return std::tolower(c); });
}

std::string place_of(std::string_view name) { return "variable " + std::string(name); }

std::string shape(const MatInfo& info) {
  std::string text;
  for (const std::size_t extent : info.dims) text += (text.empty() ? "" : "x") + std::to_string(extent);
  return text;
}

std::size_t size(const MatInfo& info) {
  return std::accumulate(info.dims.begin(), info.dims.end(), std::size_t{1}, std::multiplies<>());
}

/// Finds and reads what the conventions name.
class Reader {
 public:
  Reader(MatFile& file, const OpenOptions& options) : file_(file), options_(options) {}

  FrfSet read() {
    FrfHeader& header = set_.header;
    header.file = file_.file();
    header.frequency_hz = read_axis();
    const MatInfo& frf = choose_frf();
    header.response = read_dofs("response_dof", options_.response);
    header.reference = read_dofs("reference_dof", options_.reference);
    if (header.reference.empty()) header.reference = header.response;
    header.quantity = read_quantity();
    if (header.response.empty()) {
      fail({}, "does not say at which DOFs " + frf.name + " was measured",
           "give the response and reference DOFs, or add cell arrays response_dof and reference_dof");
    }
    validate(header);
    set_.values = ordered(frf);
    read_noise(frf);
    to_receptance();
    return std::move(set_);
  }

 private:
  [[noreturn]] void fail(std::string place, std::string problem, std::string remedy) const {
    throw InputError({.kind = ErrorKind::data,
                      .file = file_.file(),
                      .place = std::move(place),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  }

  const MatInfo* find(std::string_view name) const {
    const auto& all = file_.variables();
    const auto found =
        std::ranges::find_if(all, [&](const MatInfo& info) { return same_name(info.name, name); });
    return found == all.end() ? nullptr : &*found;
  }

  std::string listed(const std::function<bool(const MatInfo&)>& keep) const {
    std::string text;
    for (const MatInfo& info : file_.variables()) {
      if (keep(info)) text += (text.empty() ? "" : ", ") + info.name + " [" + shape(info) + "]";
    }
    return text.empty() ? "none" : text;
  }

  std::vector<double> read_axis() {
    for (const AxisName& axis : axis_names) {
      const MatInfo* info = find(axis.name);
      if (info == nullptr || info->kind != MatKind::real || std::ranges::max(info->dims) != size(*info))
        continue;
      std::vector<double> values;
      for (const Complex& value : file_.read(*info).values) values.push_back(axis.to_hz * value.real());
      return values;
    }
    fail({}, "has no vector of frequencies; its variables are " + listed([](const MatInfo&) { return true; }),
         "add one named frequency (Hz) or omega (rad/s)");
  }

  bool is_candidate(const MatInfo& info) const {
    return info.kind == MatKind::complex && !same_name(info.name, "variance") &&
           std::ranges::find(info.dims, set_.header.lines()) != info.dims.end();
  }

  const MatInfo& choose_frf() const {
    if (!options_.variable.empty()) return named_frf(options_.variable);
    if (find("frf") != nullptr) return named_frf("frf");
    const auto candidate = [this](const MatInfo& info) { return is_candidate(info); };
    const auto& all = file_.variables();
    const auto count = std::ranges::count_if(all, candidate);
    if (count == 1) return *std::ranges::find_if(all, candidate);
    const std::string axis = std::to_string(set_.header.lines());
    if (count > 1) fail({}, "several variables may be the FRFs: " + listed(candidate), "name one of them");
    fail({},
         "has no complex array with an axis of " + axis + " lines; its variables are " +
             listed([](const MatInfo&) { return true; }),
         "add one named frf");
  }

  const MatInfo& named_frf(const std::string& name) const {
    const MatInfo* info = find(name);
    if (info == nullptr) {
      fail({}, "has no variable " + name + "; there are " + listed([](const MatInfo&) { return true; }),
           "name one of them");
    }
    if (info->kind != MatKind::complex && info->kind != MatKind::real) {
      fail(place_of(name), "is no array of numbers",
           "name one of " + listed([this](const MatInfo& other) { return is_candidate(other); }));
    }
    return *info;
  }

  std::vector<Dof> read_dofs(const char* name, const std::vector<Dof>& otherwise) {
    const MatInfo* info = find(name);
    if (info == nullptr) return otherwise;
    if (info->kind != MatKind::text)
      fail(place_of(name), "is not text", "write a cell array such as {'4:+Y'; '5:+Y'}");
    std::vector<Dof> dofs;
    for (std::string text : file_.read(*info).texts) {
      text.resize(text.find_last_not_of(' ') + 1);  // rows of characters are padded with blanks
      dofs.push_back(located(file_.file(), place_of(name), [&] { return Dof::parse(text); }));
    }
    return dofs;
  }

  std::string read_text(const char* name) {
    const MatInfo* info = find(name);
    if (info == nullptr || info->kind != MatKind::text) return {};
    const MatVariable variable = file_.read(*info);
    return variable.texts.empty() ? std::string() : variable.texts.front();
  }

  Quantity read_quantity() {
    const std::string text = read_text("quantity");
    if (!text.empty())
      return located(file_.file(), place_of("quantity"), [&] { return parse_quantity(text); });
    if (options_.quantity) return *options_.quantity;
    fail({}, "does not say which quantity it holds",
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
      fail(place_of(info.name),
           "is [" + shape(info) + "] where " + std::to_string(header.lines()) + " lines, " +
               std::to_string(header.response.size()) + " responses and " +
               std::to_string(header.reference.size()) + " references are expected",
           "shape it [F,R,C], [R,C,F] or [F,R*C], or give other DOFs");
    }
    const std::string axes = read_text("axes");
    if (axes == "FRC" && first) return false;
    if (axes == "RCF" && last) return true;
    if (first && last && set_.header.lines() > 1 && set_.header.entries() > 1) {
      fail(place_of(info.name), "[" + shape(info) + "] may be [F,R,C] or [R,C,F]",
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
    const MatInfo* variance = find("variance");
    const MatInfo* coherence = find("coherence");
    for (const MatInfo* noise : {variance, coherence}) {
      if (noise != nullptr && noise->dims != frf.dims) {
        fail(place_of(noise->name), "is [" + shape(*noise) + "] and " + frf.name + " [" + shape(frf) + "]",
             "shape them alike");
      }
    }
    if (variance != nullptr && coherence != nullptr) {
      fail({}, "has both variance and coherence", "keep the one that was measured");
    }
    if (variance != nullptr) read_variance(*variance);
    if (coherence != nullptr) read_coherence(*coherence);
  }

  void read_variance(const MatInfo& info) {
    if (info.kind != MatKind::complex) {
      fail(place_of(info.name), "is not complex",
           "give the variances of real and imaginary part as a complex array");
    }
    set_.header.noise = NoiseRecord::variance;
    set_.variance = ordered(info);
  }

  void read_coherence(const MatInfo& info) {
    const MatInfo* averages = find("averages");
    const bool given = averages != nullptr && averages->kind == MatKind::real && size(*averages) == 1;
    set_.header.averages = given ? file_.read(*averages).values.front().real() : 0.0;
    if (info.kind != MatKind::real || !(set_.header.averages >= 1.0)) {
      fail(place_of(info.name), "is not real, or has no number of averages", "add averages = their number");
    }
    set_.header.noise = NoiseRecord::coherence;
    for (const Complex& value : ordered(info)) set_.coherence.push_back(value.real());
  }

  void to_receptance() {
    const FrfHeader& header = set_.header;
    const std::string label = read_text("unit");
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
  const OpenOptions& options_;
  FrfSet set_;
};

std::unique_ptr<FrfSource> open_mat(const std::unique_ptr<MatFile>& file, const OpenOptions& options) {
  return from_memory(Reader(*file, options).read());
}

}  // namespace

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
