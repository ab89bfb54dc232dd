#include "problems/lines/line_problem.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/eigen.hpp"
#include "base/temporary_file.hpp"
#include "coupling/joint_loop.hpp"
#include "frf/noise/noise.hpp"
#include "problems/case/set_format.hpp"
#include "problems/structure/beam.hpp"
#include "problems/structure/frame.hpp"
#include "problems/structure/response.hpp"

namespace jointid::problems {
namespace {

using Impedance = std::function<Eigen::MatrixXcd(double omega)>;

frf::Dof vertical(std::int64_t node) { return {.node = node, .direction = frf::Direction::y}; }

std::vector<double> axis_of(double from, double step, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(from + step * i);
  return all;
}

frf::FrfSet square_set(const Structure& structure, const std::vector<frf::Dof>& dofs, const std::vector<double>& hz,
                       const std::string& file) {
  frf::FrfSet set = frequency_response(structure, {.response = dofs, .reference = dofs, .frequency_hz = hz});
  set.header.file = file;
  return set;
}

/// Of both parts with the joint between their `joint` DOFs: H − H_:j Z (I + H_jj Z)⁻¹ H_j:.
frf::FrfSet with_impedance(const Structure& both, const std::vector<frf::Dof>& dofs, const std::vector<frf::Dof>& joint,
                           const std::vector<double>& hz, const Impedance& impedance, const std::string& file) {
  frf::FrfSet set = square_set(both, dofs, hz, file);
  const Eigen::Index n = at(dofs.size()), j = at(joint.size());
  for (std::size_t line = 0; line < hz.size(); ++line) {
    Eigen::Map<RowMatrixXc> h(set.values.data() + set.index(line, 0, 0), n, n);
    Eigen::MatrixXcd columns(n, j);
    for (Eigen::Index k = 0; k < j; ++k)
      columns.col(k) = h.col(at(frf::find_coordinate(dofs, joint[static_cast<std::size_t>(k)])));
    Eigen::MatrixXcd own(j, j);
    for (Eigen::Index k = 0; k < j; ++k)
      own.row(k) = columns.row(at(frf::find_coordinate(dofs, joint[static_cast<std::size_t>(k)])));
    const Eigen::MatrixXcd z = impedance(angular(hz[line]));
    const Eigen::MatrixXcd changed = h - columns * z * coupling::motion_with_joint(own, z, columns.transpose());
    h = 0.5 * (changed + changed.transpose());
  }
  return set;
}

Complex fractional_zener(double omega, double k0, double kinf, double tau, double alpha) {
  const Complex s = std::pow(Complex(0.0, omega * tau), alpha);
  return (k0 + kinf * s) / (1.0 + s);
}

std::vector<Complex> elements_of(const Eigen::MatrixXcd& z) {
  std::vector<Complex> out;
  for (Eigen::Index r = 0; r < z.rows(); ++r) {
    for (Eigen::Index c = r; c < z.cols(); ++c) out.push_back(z(r, c));
  }
  return out;
}

std::string dof_list(const std::vector<frf::Dof>& dofs) {
  std::string text;
  for (const frf::Dof& dof : dofs) text += (text.empty() ? "\"" : ", \"") + dof.name() + "\"";
  return "[" + text + "]";
}

std::string head_of(const LineProblem& problem) {
  std::string files;
  for (const frf::FrfSet& set : problem.substructures) files += (files.empty() ? "\"" : ", \"") + set.header.file + "\"";
  return "title = \"" + problem.name + ": " + problem.description + "\"\n\n[data]\nsubstructures = [" + files +
         "]\nassembly = [\"" + problem.assembly.front().header.file + "\"]\n\n";
}

/// Two masses on springs to each side of a rubber mount: ground–k₀–m₀–k₁–m₁ – joint – m₂–k₂–m₃–k₃–ground.
LineProblem zener_mount() {
  constexpr double k0 = 3e4, kinf = 9e4, tau = 0.00265, alpha = 0.6;
  Structure a({{1, {}}, {2, {}}}, {vertical(1), vertical(2)}), b({{3, {}}, {4, {}}}, {vertical(3), vertical(4)});
  const auto spring = [](Structure& to, frf::Dof first, std::optional<frf::Dof> second, double value) {
    to.add(Kind::stiffness, restrictions::Spring{first, second}, value);
  };
  spring(a, vertical(1), std::nullopt, 2e4);
  spring(a, vertical(1), vertical(2), 9e4);
  spring(b, vertical(3), vertical(4), 6e4);
  spring(b, vertical(4), std::nullopt, 5e3);
  for (const auto& [structure, node, mass] : {std::tuple(&a, 1, 1.2), {&a, 2, 0.8}, {&b, 3, 0.6}, {&b, 4, 0.9}}) {
    structure->add(Kind::mass, restrictions::Spring{vertical(node), std::nullopt}, mass);
  }
  a.add_proportional_damping(0.01);
  b.add_proportional_damping(0.01);
  const std::vector<double> hz = axis_of(10.0, 3.5, 41);
  const Impedance impedance = [](double omega) {
    const Complex z = fractional_zener(omega, k0, kinf, tau, alpha);
    Eigen::MatrixXcd out(2, 2);
    out << z, -z, -z, z;
    return out;
  };
  LineProblem out;
  out.name = "isolator-zener";
  out.description = "a rubber mount between two masses on each side, fractional Zener law, 1 % noise";
  out.substructures = {square_set(a, a.dofs(), hz, "isolator-zener_A.h5"), square_set(b, b.dofs(), hz, "isolator-zener_B.h5")};
  const Structure both = merged(a, b);
  out.assembly = {with_impedance(both, both.dofs(), {vertical(2), vertical(3)}, hz, impedance, "isolator-zener_AB.h5")};
  out.law = {"K0 = 30000 N/m", "Kinf = 90000 N/m", "tau = 0.00265 s", "alpha = 0.6"};
  for (const double f : hz) out.truth.push_back(elements_of(impedance(angular(f)).topLeftCorner(1, 1)));
  out.scene = head_of(out) + "[joint]\ndofs = [\"2:+Y\", \"3:+Y\"]\nlines = \"massless\"\nlaws = \"all\"\n";
  return out;
}

/// Bars round a node with six coordinates at which they meet the isolator.
Structure bars(std::int64_t first, double z, double rise, double diameter) {
  const BarSection section{.diameter = diameter, .youngs_modulus = 7e10, .density = 2700.0};
  std::vector<frf::Node> nodes;
  for (int i = 0; i < 4; ++i) nodes.push_back({first + i, {0.11 * i, 0.03 * i * i, z + rise * i}});
  Structure out = frame(section, nodes);
  out.add_proportional_damping(0.01);
  return out;
}

LineProblem six_axes() {
  constexpr double ratio = 4.0, tau = 0.00053, alpha = 0.5;
  Eigen::MatrixXd k = Eigen::VectorXd(6).asDiagonal();
  k.diagonal() << 4e5, 4e5, 1.2e6, 300.0, 300.0, 150.0;
  k(0, 4) = k(4, 0) = -1200.0;
  k(1, 3) = k(3, 1) = 1200.0;
  const Structure a = bars(1, 0.0, -0.05, 0.03), b = bars(11, 0.04, 0.07, 0.025);
  const std::vector<double> hz = axis_of(60.0, 24.0, 40);
  const Impedance impedance = [k](double omega) {
    const Eigen::MatrixXcd z = k.cast<Complex>() * fractional_zener(omega, 1.0, ratio, tau, alpha);
    Eigen::MatrixXcd out(12, 12);
    out << z, -z, -z, z;
    return out;
  };
  std::vector<frf::Dof> of_a = frame_dofs(1), of_b = frame_dofs(11), joint = of_a;
  joint.insert(joint.end(), of_b.begin(), of_b.end());
  for (const std::int64_t node : {3, 4}) {
    for (int d = 0; d < 3; ++d) {
      of_a.push_back(frame_dofs(node)[static_cast<std::size_t>(d)]);
      of_b.push_back(frame_dofs(node + 10)[static_cast<std::size_t>(d)]);
    }
  }
  std::vector<frf::Dof> all = of_a;
  all.insert(all.end(), of_b.begin(), of_b.end());
  LineProblem out;
  out.name = "isolator";
  out.description = "an isolator of six coordinates between two frames, fractional Zener law, 1 % noise";
  out.substructures = {square_set(a, of_a, hz, "isolator_A.h5"), square_set(b, of_b, hz, "isolator_B.h5")};
  out.assembly = {with_impedance(merged(a, b), all, joint, hz, impedance, "isolator_AB.h5")};
  out.law = {"Kinf/K0 = 4", "tau = 0.00053 s", "alpha = 0.5"};
  for (const double f : hz) out.truth.push_back(elements_of(impedance(angular(f)).topLeftCorner(6, 6)));
  out.scene = head_of(out) + "[joint]\ndofs = " + dof_list(joint) +
              "\nlines = \"massless\"\nlaws = [\"fractional-zener\", \"zener\", \"kelvin-voigt\", \"hysteretic\"]\n";
  return out;
}

/// Two beams joined rigidly: A is taken out of AB.
LineProblem beams_to_decouple() {
  constexpr BeamSection section = {.width = 0.03, .thickness = 0.01, .youngs_modulus = 2.07e11, .density = 7860.0};
  Structure a = beam(section, {.first_node = 1, .x = {0.0, 0.1, 0.2, 0.3}}),
            b = beam(section, {.first_node = 4, .x = {0.3, 0.4, 0.5}});
  Structure whole = beam(section, {.first_node = 1, .x = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}});
  for (Structure* each : {&a, &b, &whole}) each->add_proportional_damping(0.01);
  const std::vector<double> hz = axis_of(220.0, 25.0, 41);
  LineProblem out;
  out.name = "decoupling-beams";
  out.description = "a beam decoupled from two that are joined rigidly, 0.1 % noise";
  out.decouples = true;
  out.noise = 0.001;
  out.substructures = {square_set(a, a.dofs(), hz, "decoupling-beams_A.h5")};
  out.assembly = {square_set(whole, whole.dofs(), hz, "decoupling-beams_AB.h5")};
  const frf::FrfSet truth = square_set(b, beam_dofs(4), hz, "B.h5");
  for (std::size_t i = 0; i < hz.size(); ++i)
    out.truth.push_back({truth.values[4 * i], truth.values[4 * i + 1], truth.values[4 * i + 3]});
  out.scene = head_of(out) + "[decouple]\ninterface = " + dof_list(beam_dofs(4)) + "\nway = [\"likelihood\", \"standard\"]\n";
  return out;
}

const std::vector<std::pair<ProblemInfo, LineProblem (*)()>>& line_problems() {
  static const std::vector<std::pair<ProblemInfo, LineProblem (*)()>> all = {
      {{"isolator", "an isolator of six coordinates between two frames, fractional Zener law, 1 % noise"}, six_axes},
      {{"isolator-zener", "a rubber mount between two masses on each side, fractional Zener law, 1 % noise"}, zener_mount},
      {{"decoupling-beams", "a beam decoupled from two that are joined rigidly, 0.1 % noise"}, beams_to_decouple},
  };
  return all;
}

}  // namespace

std::vector<ProblemInfo> list_line_problems() {
  std::vector<ProblemInfo> out;
  for (const auto& [info, make] : line_problems()) out.push_back(info);
  return out;
}

LineProblem make_line_problem(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [info, make] : line_problems()) {
    if (info.name == name) return make();
    names.push_back(info.name);
  }
  refuse_problem("there is no problem '" + name + "' of a joint at every line", name, names);
}

LineProblem polluted(LineProblem problem, std::uint64_t seed) {
  const frf::NoiseModel noise{.kind = frf::NoiseKind::circular, .level = problem.noise, .record_variance = true};
  std::uint64_t number = 0;
  for (auto* sets : {&problem.substructures, &problem.assembly}) {
    for (frf::FrfSet& set : *sets) set = frf::polluted(set, noise, seed, 0, number++);
  }
  return problem;
}

std::filesystem::path write(const LineProblem& problem, const std::filesystem::path& directory, const WriteOptions& options) {
  const SetFormat& format = find_set_format(options.format);
  const LineProblem data = options.clean ? problem : polluted(problem, options.seed);
  std::error_code ignored;  // a folder that cannot be made shows when the first file is written
  std::filesystem::create_directories(directory, ignored);
  std::string scene = problem.scene;
  const bool tells_variances = !options.clean && std::string(format.name) == "h5";
  if (!tells_variances) {
    scene +=
        "\n[noise]  # what the files do not state\nmodel = \"circular\"\nlevel = " + nlohmann::json(problem.noise).dump() + "\n";
  }
  for (const auto* sets : {&data.substructures, &data.assembly}) {
    for (const frf::FrfSet& set : *sets) {
      const std::string file = std::filesystem::path(set.header.file).replace_extension(format.name).string();
      format.write(set, directory / file);
      scene.replace(scene.find(set.header.file), set.header.file.size(), file);
    }
  }
  nlohmann::ordered_json truth = {{"name", problem.name}, {"description", problem.description}, {"law", problem.law}};
  truth["frequency_hz"] = problem.assembly.front().header.frequency_hz;
  auto& lines = truth[problem.decouples ? "frf_of_b" : "z"];
  for (const std::vector<Complex>& line : problem.truth) {
    auto elements = nlohmann::ordered_json::array();
    for (const Complex z : line) elements.push_back({z.real(), z.imag()});
    lines.push_back(elements);
  }
  write_text(directory / "truth.json", truth.dump(1) + "\n");
  const std::filesystem::path path = directory / (problem.name + ".toml");
  write_text(path, scene);
  return path;
}

}  // namespace jointid::problems
