#include "ident/check/test/checked_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "base/text.hpp"
#include "frf/noise/variance_law.hpp"
#include "frf/noise/wild_values.hpp"
#include "ident/result/control.hpp"
#include "ident/variance/file_covariance.hpp"

namespace jointid::ident {
namespace {

Dofs positive(const Dofs& dofs) {
  Dofs result = dofs;
  for (frf::Dof& dof : result) dof.sign = 1;
  return result;
}

bool is_measured(const std::complex<double>& value) { return std::isfinite(value.real()) && std::isfinite(value.imag()); }

/// All of a file but its lines.
CheckedFile without_lines(const CheckedFile& file) {
  return {.name = file.name,
          .assembly = file.assembly,
          .quantity = file.quantity,
          .mass = file.mass,
          .responses = file.responses,
          .references = file.references,
          .frequency_hz = {},
          .frfs = {},
          .errors = file.errors,
          .noise = file.noise};
}

std::shared_ptr<const CovarianceLaw> kept_law(const CheckedFile& file, const std::vector<Eigen::Index>& rows) {
  if (!file.errors) return nullptr;
  return std::make_shared<const CovarianceLaw>(
      CovarianceLaw{file.errors->proportional(rows, rows), file.errors->constant(rows, rows)});
}

/// These rows and columns of all lines.
CheckedFile kept(const CheckedFile& file, const std::vector<Eigen::Index>& rows, const std::vector<Eigen::Index>& columns) {
  CheckedFile result = without_lines(file);
  result.responses.clear();
  result.references.clear();
  for (const Eigen::Index r : rows) result.responses.push_back(file.responses[static_cast<std::size_t>(r)]);
  for (const Eigen::Index c : columns) result.references.push_back(file.references[static_cast<std::size_t>(c)]);
  result.frequency_hz = file.frequency_hz;
  for (const Eigen::MatrixXcd& line : file.frfs) result.frfs.emplace_back(line(rows, columns));
  for (const Eigen::MatrixXd& line : file.recorded_over_law) result.recorded_over_law.emplace_back(line(rows, columns));
  result.errors = kept_law(file, rows);
  if (file.noise) {
    result.noise = std::make_shared<const NoiseLaws>(
        NoiseLaws{file.noise->proportional(rows, columns), file.noise->constant(rows, columns)});
  }
  return result;
}

/// Rows or columns with any measured number.
void leave_out_unmeasured(CheckedFile& file) {
  std::vector<Eigen::Index> rows, columns;
  const auto any = [&](auto is_there) { return std::ranges::any_of(file.frfs, is_there); };
  for (Eigen::Index r = 0; r < at(file.responses.size()); ++r) {
    if (any([&](const Eigen::MatrixXcd& line) { return line.row(r).unaryExpr(&is_measured).any(); })) rows.push_back(r);
  }
  for (Eigen::Index c = 0; c < at(file.references.size()); ++c) {
    if (any([&](const Eigen::MatrixXcd& line) { return line.col(c).unaryExpr(&is_measured).any(); })) columns.push_back(c);
  }
  if (rows.size() < file.responses.size() || columns.size() < file.references.size()) file = kept(file, rows, columns);
}

std::optional<double> mass_of(const Scene& scene, const std::string& file) {
  for (const auto* files : {&scene.data.substructures, &scene.data.assembly}) {
    const auto found = std::ranges::find_if(*files, [&](const DataFile& one) { return one.path.string() == file; });
    if (found != files->end()) return found->mass;
  }
  return std::nullopt;
}

/// From some lines, of one reference each in turn, for DOFs of positive sign; none where the file has no covariances, or too few lines for
/// a law.
std::shared_ptr<const CovarianceLaw> read_errors(frf::FrfSource& source, const std::vector<std::size_t>& source_lines, const Scene& scene) {
  constexpr std::size_t usual = 32, most = 128, per_response = 3;  // lines; 3 degrees of freedom a response make a law
  if (!covariances_count(source, scene)) return nullptr;
  const frf::FrfHeader& header = source.header();
  const std::size_t responses = header.response.size();
  const double freedom = freedom_of(header), degrees = static_cast<double>(per_response * responses);
  const std::size_t needed = freedom > 0.0 ? static_cast<std::size_t>(std::ceil(degrees / freedom)) + 1 : usual;
  const auto rows = all_indices(responses);
  std::vector<CovarianceSample> samples;
  for (const std::size_t l : spread_lines(source_lines.size(), std::clamp(needed, usual, most))) {
    const std::size_t reference = samples.size() % header.reference.size(), line = source_lines[l];
    samples.push_back(sample_of(read_stored(source, rows, reference, {line}), 0, header, line));
  }
  CovarianceLaw law = law_of(samples, header, responses);
  if (law.constant.size() == 0) return nullptr;
  for (std::size_t r = 0; r < responses; ++r) {
    for (std::size_t s = 0; s < responses; ++s) {
      law.constant(at(r), at(s)) *= static_cast<double>(header.response[r].sign * header.response[s].sign);
    }
  }
  return std::make_shared<const CovarianceLaw>(std::move(law));
}

Suspect wild_number(const CheckedFile& file, const frf::FrfHeader& header, const frf::WildValue& value) {
  Dofs dofs;
  std::string which = "all FRFs";
  if (value.response != frf::npos && value.reference != frf::npos) {
    dofs = {header.response[value.response], header.reference[value.reference]};
    which = "the " + frf::name(header.quantity) + " of " + dofs[0].name() + " over " + dofs[1].name();
  }
  const double first = header.frequency_hz[value.line], last = header.frequency_hz[value.last_line];
  const std::string lines = first == last ? digits(first, "%g") + " Hz" : digits(first, "%g") + " to " + digits(last, "%g") + " Hz";
  const std::string size = value.kind == frf::WildKind::infinite ? "infinite"
                           : value.kind == frf::WildKind::large
                               ? digits(value.factor, "%.2g") + " times the size of its neighbour lines"
                               : "1/" + digits(1.0 / value.factor, "%.2g") + " of the size of its neighbour lines";
  return {.kind = SuspectKind::outlier,
          .file = file.name,
          .dofs = dofs,
          .evidence = "one number: " + which + " at " + lines + " is " + size,
          .confidence = 0.9,
          .remedy = "[frequency]\nexclude = [[" + digits(first, "%.9g") + ", " + digits(last, "%.9g") + "]]"};
}

/// An FRF that is zero by symmetry, and rounding in it. `line`: all FRFs there.
bool is_negligible(const frf::WildValue& value, std::span<const Complex> line) {
  constexpr double rounding = 1e-9;
  double largest = 0.0;
  for (const Complex& each : line) {
    if (const double size = std::abs(each); std::isfinite(size)) largest = std::max(largest, size);
  }
  const double size = std::abs(value.value) / std::min(1.0, std::max(value.factor, 1e-300));
  return value.kind != frf::WildKind::infinite && size < rounding * largest;
}

/// Of each run of consecutive lines; numbers that are missing are no mistake.
std::vector<Suspect> wild_numbers(const CheckedFile& file, const frf::FrfHeader& header, const std::vector<std::size_t>& source_lines,
                                  std::span<const Complex> values) {
  constexpr std::size_t most = 5;
  std::vector<Suspect> found;
  if (header.entries() > frf::most_judged_frfs) return found;
  for (std::size_t first = 0, end = 0; first < source_lines.size(); first = end) {
    frf::FrfHeader some = header;
    some.frequency_hz.clear();
    for (end = first; end < source_lines.size() && source_lines[end] == source_lines[first] + (end - first); ++end)
      some.frequency_hz.push_back(header.frequency_hz[source_lines[end]]);
    if (end - first < 4) continue;
    frf::WildSearch search(some);
    search.add(values.subspan(first * header.entries(), (end - first) * header.entries()));
    for (const frf::WildValue& value : search.finish().found) {
      if (value.kind == frf::WildKind::not_a_number || found.size() == most) continue;
      const std::size_t line = (first + value.line) * header.entries();
      if (is_negligible(value, values.subspan(line, header.entries()))) continue;
      found.push_back(wild_number(file, some, value));
    }
  }
  return found;
}

/// Whether the variances of a file are exact; those of few averages scatter, and the law is better. A law of two numbers does not follow
/// every line: where a resonance moves what an FRF is made of (virtual points, forces that act together) its error is larger than its
/// own size says.
bool has_exact_variances(const frf::FrfHeader& header) {
  return header.noise == frf::NoiseRecord::variance && header.averages == 0.0 && header.repeats == 0;
}

void set_recorded_over_law(const std::vector<double>& squares, CheckedFile& file) {
  const Eigen::Index rows = at(file.responses.size()), columns = at(file.references.size());
  if (squares.empty()) return;
  for (std::size_t l = 0; l < file.frfs.size(); ++l) {
    Eigen::MatrixXd factors = Eigen::MatrixXd::Ones(rows, columns);
    for (Eigen::Index r = 0; r < rows; ++r) {
      for (Eigen::Index c = 0; c < columns; ++c) {
        const double recorded =
            squares[(l * static_cast<std::size_t>(rows) + static_cast<std::size_t>(r)) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(c)];
        const double factor = recorded / file.error_square(l, r, c);
        if (std::isfinite(factor)) factors(r, c) = std::max(1.0, factor);
      }
    }
    file.recorded_over_law.push_back(std::move(factors));
  }
}

CheckedFile read_file(frf::FrfSource& source, const std::vector<std::size_t>& source_lines, const Scene& scene, bool assembly) {
  const frf::FrfHeader& header = source.header();
  CheckedFile file{.name = name_in_scene(scene, header.file),
                   .assembly = assembly,
                   .quantity = header.quantity,
                   .mass = mass_of(scene, header.file),
                   .responses = positive(header.response),
                   .references = positive(header.reference),
                   .frequency_hz = {},
                   .frfs = {},
                   .errors = read_errors(source, source_lines, scene)};
  const auto rows = all_indices(header.response.size()), columns = all_indices(header.reference.size());
  const std::size_t entries = rows.size() * columns.size();
  std::vector<Complex> values(source_lines.size() * entries);
  source.read({source_lines, rows, columns}, values);
  for (std::size_t l = 0; l < source_lines.size(); ++l) {
    file.frequency_hz.push_back(header.frequency_hz[source_lines[l]]);
    Eigen::MatrixXcd line(rows.size(), columns.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
      for (std::size_t c = 0; c < columns.size(); ++c) {
        const double sign = header.response[r].sign * header.reference[c].sign;
        line(at(r), at(c)) = sign * values[l * entries + r * columns.size() + c];
      }
    }
    file.frfs.push_back(std::move(line));
  }
  file.noise = recorded_laws(source, source_lines, values, scene);
  if (has_exact_variances(header)) set_recorded_over_law(recorded_squares(source, source_lines, values, scene), file);
  file.wild = wild_numbers(file, header, source_lines, values);
  leave_out_unmeasured(file);
  return file;
}

/// Sum of |H|² of a row over lines and columns, in the quantity's ω⁴-weighted form (accelerance), so that no end of the range
/// decides.
std::vector<double> row_energies(const CheckedFile& file) {
  std::vector<double> energy(file.responses.size(), 0.0);
  for (std::size_t l = 0; l < file.frfs.size(); ++l) {
    const double weight = std::pow(std::max(file.frequency_hz[l], 1e-3), 4);
    for (std::size_t r = 0; r < energy.size(); ++r) {
      for (const std::complex<double>& value : file.frfs[l].row(at(r))) {
        if (is_measured(value)) energy[r] += weight * std::norm(value);
      }
    }
  }
  return energy;
}

double median_of_kind(const CheckedFile& file, const std::vector<double>& energy, bool rotation) {
  std::vector<double> kind;
  for (std::size_t r = 0; r < energy.size(); ++r) {
    if (file.responses[r].is_rotation() == rotation) kind.push_back(energy[r]);
  }
  return median(kind);
}

/// Largest |a − b| over largest |a| + |b|, over all lines and columns.
double row_difference(const CheckedFile& file, Eigen::Index a, Eigen::Index b) {
  double difference = 0.0, size = 0.0;
  for (const Eigen::MatrixXcd& line : file.frfs) {
    for (Eigen::Index c = 0; c < line.cols(); ++c) {
      if (!is_measured(line(a, c)) || !is_measured(line(b, c))) continue;
      difference += std::norm(line(a, c) - line(b, c));
      size += std::norm(line(a, c)) + std::norm(line(b, c));
    }
    if (difference > 1e-6 * size) return 1.0;
  }
  return size > 0.0 ? std::sqrt(difference / size) : 1.0;
}

}  // namespace

std::vector<std::size_t> all_indices(std::size_t count) {
  std::vector<std::size_t> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = i;
  return all;
}

std::vector<std::size_t> lines_in_range(const Scene& scene, const std::vector<double>& frequency_hz, std::size_t most) {
  std::vector<std::size_t> all, some;
  const auto& range = scene.frequency.range_hz;
  for (std::size_t line = 0; line < frequency_hz.size(); ++line) {
    const double f = frequency_hz[line];
    if (f > 0.0 && (!range || (f >= (*range)[0] && f <= (*range)[1]))) all.push_back(line);
  }
  const std::size_t step = (all.size() + most - 1) / most;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

std::string name_in_scene(const Scene& scene, const std::string& file) {
  const Path relative = Path(file).lexically_relative(scene.file.parent_path());
  const std::string text = relative.generic_string();
  return text.empty() || text.starts_with("..") ? file : text;
}

Eigen::MatrixXcd CheckedFile::covariance(std::size_t line, const std::vector<Eigen::Index>& some_responses, Eigen::Index reference) const {
  const Eigen::VectorXcd h = frfs[line](some_responses, reference);
  const double factor = frf::squared_factor(quantity, frequency_hz[line]);
  return (errors->proportional(some_responses, some_responses).array() * (h * h.adjoint()).array()).matrix() +
         factor * errors->constant(some_responses, some_responses);
}

double CheckedFile::variance(std::size_t line, Eigen::Index response, Eigen::Index reference) const {
  return errors->proportional(response, response).real() * std::norm(frfs[line](response, reference)) +
         errors->constant(response, response).real() * frf::squared_factor(quantity, frequency_hz[line]);
}

double CheckedFile::error_square(std::size_t line, Eigen::Index response, Eigen::Index reference) const {
  if (!has_recorded_noise()) return std::numeric_limits<double>::quiet_NaN();
  const double factor = line < recorded_over_law.size() ? recorded_over_law[line](response, reference) : 1.0;
  if (errors) return factor * variance(line, response, reference);
  return factor * (*noise)(response, reference, std::norm(frfs[line](response, reference)),
                           frf::squared_factor(quantity, frequency_hz[line]));
}

std::vector<CheckedFile> read_checked_files(const CheckedSystems& of, const CheckExtent& most,
                                            const std::function<bool()>& interrupted) {
  frf::FrfSystem* const systems[] = {&of.substructures, &of.assembly};
  std::size_t entries = 0;
  for (const frf::FrfSystem* system : systems) {
    for (std::size_t s = 0; s < system->source_count(); ++s) entries += system->source(s).header().entries();
  }
  const std::size_t count = std::max<std::size_t>(std::min(most.lines, most.values / std::max<std::size_t>(entries, 1)), 2);
  std::vector<CheckedFile> files;
  for (frf::FrfSystem* system : systems) {
    const bool assembly = system == &of.assembly;
    for (std::size_t s = 0; s < system->source_count(); ++s) {
      stop_if(interrupted);
      std::vector<std::size_t> lines;
      for (const std::size_t l : spread_lines(of.lines.size(), count)) {
        lines.push_back(system->source_line(s, assembly ? of.lines[l].assembly : of.lines[l].substructures));
      }
      files.push_back(read_file(system->source(s), lines, of.scene, assembly));
    }
  }
  return files;
}

CheckedFile at_lines(const CheckedFile& file, const std::vector<std::size_t>& lines) {
  CheckedFile result = without_lines(file);
  for (const std::size_t l : lines) {
    result.frequency_hz.push_back(file.frequency_hz[l]);
    result.frfs.push_back(file.frfs[l]);
    if (!file.recorded_over_law.empty()) result.recorded_over_law.push_back(file.recorded_over_law[l]);
  }
  return result;
}

CheckedFile part_of(const CheckedFile& file, const Dofs& responses, const Dofs& references) {
  const auto places = [](const Dofs& all, const Dofs& wanted) {
    std::vector<Eigen::Index> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (place_of(wanted, all[i]) != frf::npos) out.push_back(at(i));
    }
    return out;
  };
  return kept(file, places(file.responses, responses), places(file.references, references));
}

std::vector<Suspect> take_out_dead_and_copied(CheckedFile& file) {
  std::vector<Suspect> found;
  std::vector<Eigen::Index> rows, columns;
  const std::vector<double> energy = row_energies(file);
  const double medians[] = {median_of_kind(file, energy, false), median_of_kind(file, energy, true)};
  for (Eigen::Index r = 0; r < at(energy.size()); ++r) {
    const frf::Dof& dof = file.responses[static_cast<std::size_t>(r)];
    const double typical = medians[dof.is_rotation() ? 1 : 0], own = energy[static_cast<std::size_t>(r)];
    if (own <= 1e-8 * typical) {
      const std::string size = own == 0.0 ? "is zero at all lines" : "is below 1/10000 of what its neighbours measure";
      found.push_back({.kind = SuspectKind::dead,
                       .file = file.name,
                       .dofs = {dof},
                       .evidence = "the signal of " + dof.name() + " " + size,
                       .confidence = 0.99,
                       .remedy = ""});
      continue;
    }
    const auto twin = std::ranges::find_if(rows, [&](Eigen::Index other) { return row_difference(file, r, other) < 1e-6; });
    if (twin != rows.end()) {
      const frf::Dof& other = file.responses[static_cast<std::size_t>(*twin)];
      found.push_back({.kind = SuspectKind::copy,
                       .file = file.name,
                       .dofs = {dof, other},
                       .evidence = "the FRFs of " + dof.name() + " and " + other.name() +
                                   " are the same numbers: one signal under two labels",
                       .confidence = 0.99,
                       .remedy = ""});
      continue;
    }
    rows.push_back(r);
  }
  for (Eigen::Index c = 0; c < at(file.references.size()); ++c) columns.push_back(c);
  if (!found.empty()) file = kept(file, rows, columns);
  return found;
}

}  // namespace jointid::ident
