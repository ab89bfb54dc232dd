#include "problems/solid/solid_blocks.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/temporary_file.hpp"
#include "base/text.hpp"
#include "dense/lu.hpp"
#include "frf/noise/noise.hpp"
#include "models/matrix_model.hpp"
#include "problems/case/set_format.hpp"
#include "problems/solid/solid_matrices.hpp"

namespace jointid::problems {
namespace {

constexpr Solid steel = {.youngs_modulus = 2.1e11, .poissons_ratio = 0.3, .density = 7850.0};
constexpr double loss_of_steel = 0.004, loss_of_bolts = 0.03, noise_level = 0.01;
constexpr std::array<double, 3> bolt = {4.0e8, 1.5e8, 1.5e8};  ///< N/m along x, y, z
constexpr Block block_a = {.origin = {0.0, 0.0, 0.0}, .size = {0.40, 0.08, 0.08}, .elements = {20, 4, 4}};
constexpr Block block_b = {.origin = {0.4, 0.0, 0.0}, .size = {0.35, 0.08, 0.08}, .elements = {20, 5, 4}};
constexpr std::array directions = {frf::Direction::x, frf::Direction::y, frf::Direction::z};

/// A node of the mesh that has a name.
struct Named {
  std::int64_t id;
  std::array<int, 3> at;  ///< elements from the lowest corner
};

/// The corners of an end of a block, and one at its other end.
std::vector<Named> named_nodes(const Block& block, int end, std::int64_t first_id) {
  const int other = block.elements[0] - end, y = block.elements[1], z = block.elements[2];
  return {{first_id, {end, 0, 0}}, {first_id + 1, {end, y, 0}}, {first_id + 2, {end, 0, z}}, {first_id + 3, {end, y, z}},
          {first_id + 4, {other, y, 0}}};
}

frf::Node placed(const Block& block, const Named& node) {
  frf::Node out{node.id, block.origin};
  for (std::size_t i = 0; i < 3; ++i) out.position[i] += block.size[i] * node.at[i] / block.elements[i];
  return out;
}

SolidPart part_of(const std::string& name, const Block& block, const std::vector<Named>& nodes) {
  SolidPart out{name, solid_matrices(steel, block), {}, {}};
  out.matrices.loss_factor = loss_of_steel;
  for (const Named& node : nodes) {
    const auto first = static_cast<std::size_t>(3 * (block.node(node.at[0], node.at[1], node.at[2]) - block.first_node));
    for (std::size_t i = 0; i < directions.size(); ++i) {
      out.dofs.push_back({.node = node.id, .direction = directions[i]});
      out.coordinates.push_back(first + i);
    }
  }
  return out;
}

/// Receptances of both parts between all named DOFs, [2 parts' DOFs, the same], by lines.
std::vector<Eigen::MatrixXcd> free_receptances(const std::vector<SolidPart>& parts, const std::vector<double>& omega) {
  std::vector<Eigen::MatrixXcd> out;
  Eigen::Index begin = 0, size = 0;
  for (const SolidPart& part : parts) size += at(part.dofs.size());
  out.assign(omega.size(), Eigen::MatrixXcd::Zero(size, size));
  for (const SolidPart& part : parts) {
    models::MatrixModel model(part.matrices);
    model.expect({omega, omega.front(), omega.back(), part.coordinates});
    const Eigen::Index count = at(part.dofs.size());
    for (std::size_t line = 0; line < omega.size(); ++line)
      out[line].block(begin, begin, count, count) = *model.receptance(omega[line], part.coordinates, part.coordinates);
    begin += count;
  }
  return out;
}

/// H − HS(Z⁻¹ + SᵀHS)⁻¹SᵀH, of springs Z along the columns of S.
Eigen::MatrixXcd bolted(const Eigen::MatrixXcd& h, const Eigen::MatrixXd& s, const Eigen::VectorXcd& z) {
  const Eigen::MatrixXcd hs = h * s.cast<Complex>();
  Eigen::MatrixXcd inner = s.transpose().cast<Complex>() * hs;
  inner.diagonal() += z.cwiseInverse();
  return h - hs * dense::solve(inner, hs.transpose());
}

frf::FrfSet assembly_of(const SolidBlocks& problem, const std::vector<frf::Node>& nodes) {
  constexpr int lines = 73;
  constexpr double first_hz = 200.0, step_hz = 50.0;
  frf::FrfSet set;
  set.header.file = problem.name + "_assembly.h5";
  set.header.quantity = frf::Quantity::accelerance;
  set.header.nodes = nodes;
  std::vector<double> omega;
  for (int i = 0; i < lines; ++i) {
    set.header.frequency_hz.push_back(first_hz + step_hz * i);
    omega.push_back(angular(set.header.frequency_hz.back()));
  }
  for (const SolidPart& part : problem.parts) {
    set.header.response.insert(set.header.response.end(), part.dofs.begin(), part.dofs.end());
    set.header.reference.insert(set.header.reference.end(), part.dofs.end() - 3, part.dofs.end());
  }
  const std::vector<frf::Dof>& all = set.header.response;
  const auto place = [&](const frf::Dof& dof) { return at(frf::find_coordinate(all, dof)); };
  Eigen::MatrixXd s = Eigen::MatrixXd::Zero(at(all.size()), at(problem.springs.size()));
  Eigen::VectorXcd z(s.cols());
  for (Eigen::Index k = 0; k < s.cols(); ++k) {
    const SolidSpring& spring = problem.springs[static_cast<std::size_t>(k)];
    s(place(spring.first), k) = 1.0;
    s(place(spring.second), k) = -1.0;
    z(k) = spring.stiffness * Complex(1.0, spring.loss);
  }
  for (const Eigen::MatrixXcd& h : free_receptances(problem.parts, omega)) {
    const Eigen::MatrixXcd whole = bolted(h, s, z);
    for (Eigen::Index i = 0; i < whole.rows(); ++i) {
      for (const frf::Dof& reference : set.header.reference) set.values.push_back(whole(i, place(reference)));
    }
  }
  return set;
}

/// The lower triangle as a Matrix Market file.
std::string market(const Eigen::SparseMatrix<double>& matrix) {
  std::string entries;
  std::size_t count = 0;
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry) {
      if (entry.row() < j || entry.value() == 0.0) continue;
      entries += std::to_string(entry.row() + 1) + " " + std::to_string(j + 1) + " " + digits(entry.value(), "%.17g") + "\n";
      ++count;
    }
  }
  const std::string size = std::to_string(matrix.rows());
  return "%%MatrixMarket matrix coordinate real symmetric\n" + size + " " + size + " " + std::to_string(count) + "\n" + entries;
}

std::string part_text(const SolidPart& part) {
  std::string names;
  for (std::size_t i = 0; i < part.dofs.size(); ++i)
    names += (i == 0 ? "\"" : ", \"") + part.dofs[i].name() + "\" = " + std::to_string(part.coordinates[i] + 1);
  return "mass = \"" + part.name + "_mass.mtx\"\nstiffness = \"" + part.name +
         "_stiffness.mtx\"\nloss_factor = " + digits(loss_of_steel, "%g") + "\ndofs = { " + names + " }\n";
}

std::string scene_text(const SolidBlocks& problem, const std::string& assembly, bool states_noise) {
  const auto quoted = [](const std::string& text) { return "\"" + text + "\""; };
  const auto spring = [&](const SolidSpring& each) { return "[" + quoted(each.first.name()) + ", " + quoted(each.second.name()) + "]"; };
  std::vector<std::string> dofs;
  for (const SolidSpring& each : problem.springs) dofs.push_back(quoted(each.first.name()));
  for (const SolidSpring& each : problem.springs) dofs.push_back(quoted(each.second.name()));
  const std::string springs = "springs = [" + comma_list(problem.springs, spring) + "]\n\n";
  std::string text = "title = \"" + problem.name + ": " + problem.description + "\"\n\n[data]\nsubstructures = [\"" +
                     problem.parts[0].name + ".toml\", \"" + problem.parts[1].name + ".toml\"]  # models\nassembly = [\"" + assembly +
                     "\"]\n\n[frequency]\nrange = [200.0, 3800.0]  # Hz\n\n[joint]\ndofs = [" +
                     comma_list(dofs, [](const std::string& name) { return name; }) + "]\n\n[joint.stiffness]\n" + springs +
                     "[joint.hysteretic_damping]\n" + springs + "[identify]\nmethod = \"likelihood\"\n" +
                     "start = { stiffness = 1e8 }  # N/m; no force was at the joint, which equations of FRFs need\n";
  if (states_noise) text += "\n[noise]  # what the files do not state\nmodel = \"circular\"\nlevel = " + digits(noise_level, "%g") + "\n";
  return text;
}

std::string truth_text(const SolidBlocks& problem) {
  nlohmann::ordered_json truth = {{"name", problem.name}, {"description", problem.description}};
  for (const SolidSpring& each : problem.springs) {
    truth["springs"].push_back({{"dofs", {each.first.name(), each.second.name()}},
                                {"stiffness", each.stiffness},
                                {"hysteretic_damping", each.stiffness * each.loss}});
  }
  return truth.dump(1) + "\n";
}

}  // namespace

std::vector<ProblemInfo> list_solid_blocks() {
  return {{"solid-blocks", "two steel blocks as finite-element models of 1,575 and 1,890 coordinates, bolted at four corners, 1 % noise"}};
}

SolidBlocks make_solid_blocks() {
  const std::vector<Named> of_a = named_nodes(block_a, block_a.elements[0], 1), of_b = named_nodes(block_b, 0, 11);
  SolidBlocks out{list_solid_blocks().front().name, list_solid_blocks().front().description, {}, {}, {}};
  out.parts = {part_of("block_a", block_a, of_a), part_of("block_b", block_b, of_b)};
  for (std::size_t corner = 0; corner < 4; ++corner) {
    for (std::size_t i = 0; i < directions.size(); ++i)
      out.springs.push_back({out.parts[0].dofs[3 * corner + i], out.parts[1].dofs[3 * corner + i], bolt[i], loss_of_bolts});
  }
  std::vector<frf::Node> nodes;
  for (const Named& node : of_a) nodes.push_back(placed(block_a, node));
  for (const Named& node : of_b) nodes.push_back(placed(block_b, node));
  out.assembly = assembly_of(out, nodes);
  return out;
}

std::filesystem::path write(const SolidBlocks& problem, const std::filesystem::path& directory, const WriteOptions& options) {
  const SetFormat& format = find_set_format(options.format);
  const frf::NoiseModel noise{.kind = frf::NoiseKind::circular, .level = noise_level, .record_variance = true};
  const std::string file = std::filesystem::path(problem.assembly.header.file).replace_extension(format.name).string();
  std::error_code ignored;  // a folder that cannot be made shows when the first file is written
  std::filesystem::create_directories(directory, ignored);
  for (const SolidPart& part : problem.parts) {
    write_text(directory / (part.name + "_mass.mtx"), market(part.matrices.mass));
    write_text(directory / (part.name + "_stiffness.mtx"), market(part.matrices.stiffness));
    write_text(directory / (part.name + ".toml"), part_text(part));
  }
  format.write(options.clean ? problem.assembly : frf::polluted(problem.assembly, noise, options.seed, 0, 0), directory / file);
  write_text(directory / "truth.json", truth_text(problem));
  const std::filesystem::path scene = directory / (problem.name + ".toml");
  write_text(scene, scene_text(problem, file, options.clean || std::string(format.name) != "h5"));
  return scene;
}

}  // namespace jointid::problems
