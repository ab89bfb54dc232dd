#include "models/model_file.hpp"

#include <array>
#include <utility>

#include "base/eigen.hpp"
#include "models/labelled_structure.hpp"
#include "models/matrix_model.hpp"
#include "models/matrix_value.hpp"
#include "models/model_units.hpp"
#include "models/modes_file.hpp"
#include "scene/text.hpp"

namespace jointid::models {
namespace {

using Path = std::filesystem::path;

/// What holds the structure: matrices, modes of a universal file, or modes in arrays. Each key begins one of them.
constexpr std::array structure_keys = {"mass", "modes", "shapes"};
/// Keys whose text names a file.
constexpr std::array file_keys = {"mass",        "stiffness",    "viscous_damping",      "hysteretic_damping", "modes", "shapes",
                                  "frequencies", "modal_masses", "residual_flexibility", "dofs"};

/// Keeps what its tables refer to.
class ModelFile {
 public:
  explicit ModelFile(const Path& file)
      : file_(file),
        name_(file.string()),
        document_(scene::parse_toml(scene::read_text(file), file)),
        root_(document_, name_, {}, {}) {}

  std::vector<Path> files() const {
    std::vector<Path> out;
    const scene::Table table = root_.open_table();
    for (const char* key : file_keys) {
      const auto item = table.find(key);
      if (item && item->is_text()) out.push_back(read_file_variable(*item, folder()).file);
    }
    return out;
  }

  NamedModel read() {
    const std::string kind = structure_key();
    if (kind == "mass") return read_matrices();
    return kind == "modes" ? read_modes() : read_arrays();
  }

 private:
  Path folder() const { return file_.parent_path(); }

  std::string structure_key() const {
    const scene::Table table = root_.open_table();
    std::string found;
    for (const char* key : structure_keys) {
      if (!table.find(key)) continue;
      if (!found.empty()) root_.fail("the model has both " + found + " and " + key, "remove one of them");
      found = key;
    }
    if (found.empty()) root_.fail("it describes no model", "give mass and stiffness, modes, or shapes and frequencies");
    return found;
  }

  NamedModel read_matrices() {
    const scene::Table table = root_.table(
        {"mass", "stiffness", "viscous_damping", "hysteretic_damping", "loss_factor", "units", "dofs", "keep", "noise"});
    for (const char* key : {"mass", "stiffness"}) table.require(key);
    LabelledStructure read = read_structure(table, folder());
    StructureMatrices& matrices = read.matrices;
    if (const auto item = table.find("loss_factor")) matrices.loss_factor = share(*item);
    const bool names_rows = table.find("dofs").has_value() || read.coordinates.dofs.empty();
    const auto size = static_cast<std::size_t>(matrices.mass.rows());
    NamedCoordinates all = names_rows ? read_model_dofs(table.require("dofs"), folder(), size) : std::move(read.coordinates);
    if (const auto item = table.find("units")) read_model_units(*item).apply(matrices, all);
    return named(table, std::make_unique<MatrixModel>(std::move(matrices)), std::move(all), {});
  }

  NamedModel read_modes() {
    const scene::Table table = root_.table({"modes", "damping_ratio", "loss_factor", "keep", "noise"});
    UffModes read = read_uff_modes(read_file_variable(table.require("modes"), folder()).file);
    NamedCoordinates all{read.dofs, {}};
    for (std::size_t i = 0; i < read.dofs.size(); ++i) all.coordinates.push_back(i);
    damp(table, read.modes);
    return named(table, std::make_unique<ModalModel>(std::move(read.modes)), std::move(all), std::move(read.nodes));
  }

  NamedModel read_arrays() {
    const scene::Table table = root_.table({"shapes", "frequencies", "modal_masses", "residual_flexibility", "damping_ratio",
                                            "loss_factor", "units", "dofs", "keep", "noise"});
    FileVariable masses;
    if (const auto item = table.find("modal_masses")) masses = read_file_variable(*item, folder());
    Modes modes = read_mode_arrays(read_file_variable(table.require("shapes"), folder()),
                                   read_file_variable(table.require("frequencies"), folder()), masses);
    damp(table, modes);
    if (const auto item = table.find("residual_flexibility")) read_residual(table, *item, modes);
    NamedCoordinates all = read_model_dofs(table.require("dofs"), folder(), modes.coordinates());
    if (const auto item = table.find("units")) read_model_units(*item).apply(modes, all);
    return named(table, std::make_unique<ModalModel>(std::move(modes)), std::move(all), {});
  }

  /// Stiffness that is lossy makes the flexibility of what is left out R/(1 + iη).
  void read_residual(const scene::Table& table, const scene::Item& item, Modes& modes) const {
    const Eigen::SparseMatrix<double> residual = read_matrix_value(item, folder(), at(modes.coordinates()));
    const auto loss = table.find("loss_factor");
    modes.residual = Eigen::MatrixXd(residual).cast<Complex>() / Complex(1.0, loss ? share(*loss) : 0.0);
  }

  /// The damping of all normal modes, in place of what the file says.
  static void damp(const scene::Table& table, Modes& modes) {
    const auto ratio = table.find("damping_ratio"), loss = table.find("loss_factor");
    for (const auto& item : {ratio, loss}) {
      if (item && !modes.complex.empty()) item->fail("complex modes have their damping in their eigenvalues", "remove it");
    }
    for (NormalMode& mode : modes.normal) {
      if (ratio) mode.damping_ratio = share(*ratio);
      if (loss) mode.loss_factor = share(*loss);
    }
  }

  /// A damping ratio or loss factor. From 1 on it is in per cent: nothing would vibrate.
  static double share(const scene::Item& item) {
    const double value = item.not_negative();
    if (!(value < 1.0)) item.fail(scene::number_text(value) + " is not below 1", "it is no percentage: 0.02 is 2 %");
    return value;
  }

  /// `all`: the coordinates that have names.
  NamedModel named(const scene::Table& table, std::unique_ptr<Model> model, NamedCoordinates all,
                   std::vector<frf::Node> nodes) const {
    if (const auto keep = table.find("keep")) all = select(*keep, all, keep->dofs());
    NamedModel out{
        .file = name_, .model = std::move(model), .coordinates = std::move(all), .noise = 0.0, .nodes = std::move(nodes)};
    if (const auto noise = table.find("noise")) {
      out.noise = noise->not_negative();
      if (!(out.noise < 1.0)) noise->fail(scene::number_text(out.noise) + " is not below 1", "it is relative: 0.01 is 1 %");
    }
    return out;
  }

  Path file_;
  std::string name_;
  scene::Value document_;
  scene::Item root_;
};

}  // namespace

bool is_model_file(const Path& file) { return file.extension() == ".toml"; }

std::vector<Path> files_of_model(const Path& file) { return ModelFile(file).files(); }

NamedModel read_model(const Path& file) { return ModelFile(file).read(); }

std::unique_ptr<ModelSource> open_model(const Path& file, std::vector<double> frequency_hz) {
  return std::make_unique<ModelSource>(read_model(file), std::move(frequency_hz));
}

}  // namespace jointid::models
