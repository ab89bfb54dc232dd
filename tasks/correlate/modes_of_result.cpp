#include "tasks/correlate/modes_of_result.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "scene/text.hpp"

namespace jointid::tasks {
namespace {

using Json = nlohmann::json;

/// Reads what report::modal_json() writes, and names the key that is not as it should be.
class ModalResult {
 public:
  explicit ModalResult(const std::filesystem::path& file)
      : file_(file), json_(Json::parse(scene::read_text(file), nullptr, false)) {}

  std::vector<frf::Uff55Mode> read() const {
    if (!json_.is_object()) refuse("", "it is no JSON");
    const Json& model = member(json_, "model");
    const bool real = member(model, "real_modes") == true, hysteretic = member(model, "damping") == "hysteretic";
    const std::vector<frf::Dof> dofs = read_dofs();
    std::vector<frf::Uff55Mode> modes;
    for (const Json& each : list(json_, "modes")) {
      frf::Uff55Mode mode;
      mode.id.fill("NONE");
      mode.number = static_cast<int>(modes.size()) + 1;
      mode.is_complex = !real;
      mode.frequency_hz = number(member(each, "frequency_hz"), "frequency_hz");
      (hysteretic ? mode.hysteretic_damping : mode.viscous_damping) = number(member(each, "damping"), "damping");
      mode.dofs = dofs;
      mode.shape = read_shape(each, dofs.size());
      modes.push_back(std::move(mode));
    }
    if (modes.empty()) refuse("modes", "there is none");
    return modes;
  }

 private:
  [[noreturn]] void refuse(const std::string& key, const std::string& problem) const {
    throw InputError({.kind = ErrorKind::data,
                      .file = file_.string(),
                      .place = key.empty() ? "" : "key " + key,
                      .problem = problem,
                      .remedy = "give a universal file with dataset 55, or what `jointid modalfit --json FILE` wrote"});
  }

  const Json& member(const Json& of, const char* key) const {
    if (!of.is_object() || !of.contains(key)) refuse(key, "it is not there: this is no result of `jointid modalfit`");
    return of.at(key);
  }

  const Json& list(const Json& of, const char* key) const {
    const Json& found = member(of, key);
    if (!found.is_array()) refuse(key, "it is no list");
    return found;
  }

  double number(const Json& of, const char* key) const {
    if (!of.is_number() || !std::isfinite(of.get<double>())) refuse(key, of.dump().substr(0, 40) + " is no finite number");
    return of.get<double>();
  }

  std::vector<frf::Dof> read_dofs() const {
    std::vector<frf::Dof> dofs;
    for (const Json& name : list(json_, "dofs")) {
      if (!name.is_string()) refuse("dofs", name.dump().substr(0, 40) + " is no DOF");
      dofs.push_back(frf::Dof::parse(name.get<std::string>()));
    }
    return dofs;
  }

  std::vector<std::complex<double>> read_shape(const Json& mode, std::size_t size) const {
    std::vector<std::complex<double>> shape;
    for (const Json& value : list(mode, "shape")) {
      if (!value.is_array() || value.size() != 2) refuse("shape", value.dump().substr(0, 40) + " is no pair of real and imaginary part");
      shape.emplace_back(number(value[0], "shape"), number(value[1], "shape"));
    }
    if (shape.size() != size) refuse("shape", std::to_string(shape.size()) + " values for " + std::to_string(size) + " DOFs");
    return shape;
  }

  std::filesystem::path file_;
  Json json_;
};

}  // namespace

std::vector<frf::Uff55Mode> modes_of_result(const std::filesystem::path& file) { return ModalResult(file).read(); }

}  // namespace jointid::tasks
