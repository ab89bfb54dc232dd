#include "models/modes_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include "base/eigen.hpp"
#include "base/temporary_file.hpp"
#include "base/text.hpp"
#include "frf/file/unit_suffix.hpp"
#include "frf/file/variables.hpp"
#include "frf/mat/mat_column.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/text/located.hpp"
#include "frf/text/unit_names.hpp"
#include "frf/uff/uff55.hpp"
#include "frf/uff/uff_file.hpp"
#include "frf/uff/uff_geometry.hpp"
#include "frf/uff/uff_scan.hpp"
#include "models/files/failure.hpp"

namespace jointid::models {
namespace {

using Path = std::filesystem::path;

/// Whether imaginary parts are more than rounding.
bool has_phases(const std::vector<Complex>& shape) {
  constexpr double of_six_digits = 1e-6;
  double largest = 0.0, imaginary = 0.0;
  for (const Complex& each : shape) {
    largest = std::max(largest, std::abs(each));
    imaginary = std::max(imaginary, std::abs(each.imag()));
  }
  return imaginary > of_six_digits * largest;
}

void require_usable(const Path& file, const frf::Uff55Mode& mode, const frf::Uff55Mode& first) {
  const std::string place = "mode " + std::to_string(mode.number);
  const auto fail = [&](std::string problem, std::string remedy) {
    refuse_file(file, place, std::move(problem), std::move(remedy));
  };
  if (mode.dofs != first.dofs)
    fail("its DOFs are not those of mode " + std::to_string(first.number), "export all modes at the same nodes");
  if (mode.quantity != frf::Quantity::receptance)
    fail(mode.quantity == frf::Quantity::mobility ? "its shape is one of velocities" : "its shape is one of accelerations",
         "export shapes of displacements, scaled with the modal masses");
  if (mode.is_complex) {
    if (mode.modal_a == Complex(0.0)) fail("its modal A is 0", "export the modes with modal A");
    if (mode.eigenvalue.real() > 0.0) fail("its eigenvalue has a real part above 0: it is not damped", "correct its sign");
    return;
  }
  if (has_phases(mode.shape))
    fail("it is a normal mode, and its shape is complex",
         "export it as a complex mode with eigenvalue and modal A, or with a real shape");
  if (!(mode.modal_mass > 0.0))
    fail("its modal mass is " + scene::number_text(mode.modal_mass), "export the modes with modal masses");
  if (!(mode.frequency_hz >= 0.0)) fail("its frequency is " + scene::number_text(mode.frequency_hz) + " Hz", "it is at least 0");
  if (mode.viscous_damping < 0.0 || mode.hysteretic_damping < 0.0) fail("its damping is below 0", "correct its sign");
  const double damping = std::max(mode.viscous_damping, mode.hysteretic_damping);
  if (!(damping < 1.0)) fail("its damping is " + scene::number_text(damping), "it is no percentage: 0.02 is 2 %");
}

/// The same frequency, damping and shape: a mode that was exported twice would count twice.
void require_once(const Path& file, const std::vector<frf::Uff55Mode>& modes) {
  const auto same = [](const frf::Uff55Mode& a, const frf::Uff55Mode& b) {
    return a.is_complex == b.is_complex && a.eigenvalue == b.eigenvalue && a.frequency_hz == b.frequency_hz && a.shape == b.shape;
  };
  for (std::size_t i = 0; i < modes.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (same(modes[i], modes[k]))
        refuse_file(file, "mode " + std::to_string(modes[i].number), "is mode " + std::to_string(modes[k].number) + " again",
                    "export each mode once");
    }
  }
}

/// The places of DOFs that some mode moves.
std::vector<std::size_t> moving(const std::vector<frf::Uff55Mode>& modes) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < modes.front().dofs.size(); ++i) {
    if (std::ranges::any_of(modes, [&](const frf::Uff55Mode& mode) { return mode.shape[i] != Complex(0.0); }))
      places.push_back(i);
  }
  return places;
}

std::vector<frf::Node> nodes_of(const Path& path) {
  frf::uff::ByteFile file(path);
  const std::vector<frf::uff::Dataset> datasets = frf::uff::scan(file);
  return frf::uff::read_nodes(file, datasets, frf::uff::UnitTable(file, datasets));
}

/// A variable of numbers, first index fastest.
struct Array {
  Eigen::MatrixXd values;
  bool of_matlab = false;
  std::string unit{};  ///< that the file states, or its name ends in
};

/// MATLAB writes its name into the first bytes of files v7.3, too.
bool is_of_matlab(const Path& file) {
  std::string head(6, '\0');
  std::ifstream(file, std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == "MATLAB";
}

bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// Of a text of the file that is of no other variable, "frequency_unit"; empty where there is none.
std::string unread_unit(const frf::ColumnUnits& units) {
  for (const auto& [name, text] : units.unread()) {
    const std::string own = frf::lower_case(name);
    if (has(own, "freq") && has(own, "unit")) return text;
  }
  return {};
}

Array read_array(const FileVariable& named) {
  const auto file = frf::open_variables(named.file);
  if (!file) refuse_file(named.file, {}, "it is no MATLAB, HDF5 or numpy file", "store shapes and frequencies in one");
  const auto found = std::ranges::find(file->variables(), named.variable, &frf::MatInfo::name);
  if (found == file->variables().end() || found->kind != frf::MatKind::real || found->dims.size() > 2 || found->dims.empty()) {
    refuse_file(named.file, "variable " + named.variable, "there is no such real matrix",
                "name one: \"FILE:VARIABLE\"; there are " + comma_list(file->variables(), &frf::MatInfo::name));
  }
  const frf::MatVariable variable = file->read(*found);
  const Eigen::Index rows = at(found->dims[0]);
  Array out{Eigen::MatrixXd(rows, found->dims.size() == 2 ? at(found->dims[1]) : 1), is_of_matlab(named.file)};
  const frf::ColumnUnits units(*file);
  out.unit = units.of(*found).front();
  if (out.unit.empty()) out.unit = frf::suffixed_name(found->name).unit;
  if (out.unit.empty()) out.unit = unread_unit(units);
  for (Eigen::Index i = 0; i < out.values.size(); ++i) out.values.data()[i] = variable.values[static_cast<std::size_t>(i)].real();
  if (!out.values.allFinite())
    refuse_file(named.file, "variable " + named.variable, "it has an element that is no number", "store it again");
  return out;
}

/// As a column; `count`: its length, 0: any.
Eigen::VectorXd read_vector(const FileVariable& named, const Eigen::MatrixXd& values, Eigen::Index count) {
  const bool vector = values.rows() == 1 || values.cols() == 1;
  if (!vector || (count > 0 && values.size() != count)) {
    refuse_file(named.file, "variable " + named.variable,
                "it is " + std::to_string(values.rows()) + " × " + std::to_string(values.cols()),
                count > 0 ? "give one number for each of the " + std::to_string(count) + " frequencies"
                          : "give one number for each mode");
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}

/// Of angular frequencies by their names, "omega" and "wn".
bool is_angular(const std::string& name) {
  const std::string own = frf::lower_case(name.substr(name.rfind('.') + 1));
  constexpr std::array<std::string_view, 8> names = {"omega", "w", "wn", "w_n", "omega_n", "omegan", "om", "w0"};
  return std::ranges::find(names, own) != names.end();
}

/// "lambda", which may be ω² or iω.
bool is_eigenvalue(const std::string& name) {
  const std::string own = frf::lower_case(name.substr(name.rfind('.') + 1));
  constexpr std::array<std::string_view, 4> parts = {"lam", "eigenval", "omega2", "squared"};
  return std::ranges::any_of(parts, [&](std::string_view part) { return has(own, part); });
}

/// In Hz, by the unit that the file or the name states.
Eigen::VectorXd read_frequencies(const FileVariable& named) {
  const std::string place = "variable " + named.variable;
  if (is_eigenvalue(named.variable))
    refuse_file(named.file, place, "eigenvalues are no frequencies", "give the frequencies in Hz");
  const Array array = read_array(named);
  const std::string unit = array.unit.empty() && is_angular(named.variable) ? "rad/s" : array.unit;
  const Eigen::VectorXd values = read_vector(named, array.values, 0);
  return values * frf::located(named.file.string(), place, [&] { return frf::hertz_per(unit).value_or(1.0); });
}

/// In kg, by the unit that the file or the name states.
Eigen::VectorXd read_masses(const FileVariable& named, Eigen::Index count) {
  const Array array = read_array(named);
  const auto unit = frf::parse_unit(array.unit);
  if (!array.unit.empty() && !(unit && unit->same_dimension({1.0, -1, 2, 1})))
    refuse_file(named.file, "variable " + named.variable, "'" + frf::shown_label(array.unit) + "' is no unit of a mass",
                "give kg");
  return read_vector(named, array.values, count) * (unit ? unit->si : 1.0);
}

/// [coordinate, mode] of n modes.
Eigen::MatrixXd read_shapes(const FileVariable& named, Eigen::Index n) {
  const Array array = read_array(named);
  const Eigen::MatrixXd& m = array.values;
  const bool square = m.rows() == n && m.cols() == n;
  if (m.cols() == n && (!square || array.of_matlab)) return m;
  if (m.rows() == n) return m.transpose();
  refuse_file(named.file, "variable " + named.variable,
              "it is " + std::to_string(m.rows()) + " × " + std::to_string(m.cols()) + ", and there are " + std::to_string(n) +
                  " frequencies",
              "give a column for each mode");
}

void require_universal(const Path& file) {
  require_regular_file(file);
  std::string head(4096, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  if (!frf::looks_like_uff(head))
    refuse_file(file, "", "is no universal file",
                "export the modes as dataset 55, or give arrays of MATLAB, HDF5 or numpy: shapes, frequencies and modal_masses");
}

/// Shapes whose largest number is 1 in every mode are scaled to it, and not to modal masses of 1.
void require_unit_masses(const FileVariable& named, const Eigen::MatrixXd& shapes) {
  constexpr double of_rounding = 1e-9;
  if (shapes.cols() < 2 || shapes.rows() < 2) return;
  const Eigen::ArrayXd largest = shapes.cwiseAbs().colwise().maxCoeff().transpose().array();
  if (((largest - 1.0).abs() < of_rounding).all())
    refuse_file(named.file, "variable " + named.variable,
                "the largest number of every shape is 1, so their modal masses are not 1",
                "give modal_masses, or shapes scaled to modal masses of 1 kg");
}

}  // namespace

UffModes read_uff_modes(const Path& file) {
  require_universal(file);
  std::vector<std::string> not_read;
  std::vector<frf::Uff55Mode> read = frf::read_uff55(file, &not_read);
  if (!not_read.empty()) {
    refuse_file(file, "dataset 55", "it holds " + not_read.front(), "export all modes with three or six components per node");
  }
  for (const frf::Uff55Mode& mode : read) require_usable(file, mode, read.front());
  std::erase_if(read, [](const frf::Uff55Mode& mode) { return mode.is_complex && mode.eigenvalue.imag() < 0.0; });
  require_once(file, read);
  if (read.empty()) refuse_file(file, "dataset 55", "all eigenvalues have an imaginary part below 0", "export those above, too");
  const std::vector<std::size_t> places = moving(read);
  UffModes out;
  for (const std::size_t place : places) out.dofs.push_back(read.front().dofs[place]);
  const auto complex = std::ranges::count(read, true, &frf::Uff55Mode::is_complex);
  out.modes.normal_shapes.resize(at(places.size()), at(read.size()) - complex);
  out.modes.complex_shapes.resize(at(places.size()), complex);
  for (const frf::Uff55Mode& mode : read) {
    const Eigen::Index k = at(mode.is_complex ? out.modes.complex.size() : out.modes.normal.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (mode.is_complex)
        out.modes.complex_shapes(at(i), k) = mode.shape[places[i]];
      else
        out.modes.normal_shapes(at(i), k) = mode.shape[places[i]].real();
    }
    if (mode.is_complex)
      out.modes.complex.push_back({mode.eigenvalue, mode.modal_a});
    else
      out.modes.normal.push_back({angular(mode.frequency_hz), mode.modal_mass, mode.viscous_damping, mode.hysteretic_damping});
  }
  out.nodes = nodes_of(file);
  return out;
}

Modes read_mode_arrays(const FileVariable& shapes, const FileVariable& frequencies, const FileVariable& masses) {
  const Eigen::VectorXd hz = read_frequencies(frequencies);
  Eigen::VectorXd mass = Eigen::VectorXd::Ones(hz.size());
  if (!masses.file.empty()) mass = read_masses(masses, hz.size());
  if (!(hz.minCoeff() >= 0.0))
    refuse_file(frequencies.file, "variable " + frequencies.variable, "a frequency is below 0", "give Hz");
  if (!(mass.minCoeff() > 0.0)) refuse_file(masses.file, "variable " + masses.variable, "a modal mass is not above 0", "give kg");
  Modes out;
  out.normal_shapes = read_shapes(shapes, hz.size());
  if (masses.file.empty()) require_unit_masses(shapes, out.normal_shapes);
  out.complex_shapes.resize(out.normal_shapes.rows(), 0);
  for (Eigen::Index k = 0; k < hz.size(); ++k) out.normal.push_back({angular(hz(k)), mass(k), 0.0, 0.0});
  return out;
}

}  // namespace jointid::models
