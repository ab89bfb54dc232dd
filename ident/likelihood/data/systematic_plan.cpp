#include "ident/likelihood/data/systematic_plan.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "ident/scene/scene_failure.hpp"
#include "models/model_file.hpp"

namespace jointid::ident {
namespace {

/// A file of a table and its header.
struct TableFile {
  bool of_assembly;
  std::size_t number;
  const frf::FrfHeader* header;
};

std::vector<TableFile> files_of(const ErrorFiles& files, const frf::FrfSystem& substructures, const frf::FrfSystem& assembly) {
  std::vector<TableFile> all;
  for (const std::size_t i : files.substructures) all.push_back({false, i, &substructures.source(i).header()});
  for (const std::size_t i : files.assembly) all.push_back({true, i, &assembly.source(i).header()});
  return all;
}

/// The sensors of a table in its files; `dofs` empty: all.
std::vector<SensorRole> roles_of(const std::vector<frf::Dof>& dofs, bool of_reference, const std::vector<TableFile>& files) {
  std::vector<SensorRole> roles;
  for (const TableFile& file : files) {
    const std::vector<frf::Dof>& there = of_reference ? file.header->reference : file.header->response;
    for (const frf::Dof& dof : dofs.empty() ? there : dofs) {
      if (frf::has(there, dof)) roles.push_back({file.of_assembly, file.number, of_reference, dof});
    }
  }
  return roles;
}

void require_all(const Scene& scene, const GainPrior& prior, const std::vector<TableFile>& files,
                 const std::vector<SensorRole>& roles) {
  const std::string role = prior.of_reference ? "reference" : "response";
  for (const frf::Dof& dof : prior.dofs) {
    if (std::ranges::any_of(roles, [&](const SensorRole& of) { return of.dof.same_coordinate(dof); })) continue;
    std::vector<std::string> names;
    for (const TableFile& file : files) {
      for (const frf::Dof& other : prior.of_reference ? file.header->reference : file.header->response)
        names.push_back(other.name());
    }
    const std::string near = nearest_word(dof.name(), names);
    fail(scene, "[[data.gains]] dofs", "no file of the table has the " + role + " " + dof.name(),
         near.empty() ? "name one that the files have, or other files" : "did you mean " + near + "?");
  }
}

void require_driving_points(const Scene& scene, const MassPrior& prior, const std::vector<TableFile>& files) {
  for (const TableFile& file : files) {
    for (const frf::Dof& dof : prior.dofs) {
      if (frf::has(file.header->response, dof) && frf::has(file.header->reference, dof)) continue;
      fail(
          scene, "[[data.masses]] dofs",
          file.header->file + " does not have the driving point " + dof.name() + ", which determines the effect of the mass",
          "measure it (response and reference " + dof.name() + "), or leave the DOF out: the sensor then counts as without mass");
    }
  }
}

models::ModelError error_of(const DataFile& file) {
  return models::is_model_file(file.path) ? models::error_of_model(file.path) : models::ModelError{};
}

/// "stiffness of bracket.toml", "stiffness of bracket.toml from 0 to 500 Hz"
std::string scale_name(const std::string& what, const DataFile& model, const models::ModelError::Band& band) {
  const std::string name = what + " of " + model.path.filename().string();
  if (!std::isfinite(band.high_hz)) return name;
  return name + " from " + digits(band.low_hz, "%.6g") + " to " + digits(band.high_hz, "%.6g") + " Hz";
}

}  // namespace

bool are_errors_unknown(const DataSection& data) {
  const auto is_unknown = [](const GainPrior& prior) { return prior.gain > 0.0 || prior.delay > 0.0 || prior.angle > 0.0; };
  const auto is_uncertain = [](const DataFile& file) { return error_of(file).any(); };
  return !data.masses.empty() || std::ranges::any_of(data.gains, is_unknown) ||
         std::ranges::any_of(data.substructures, is_uncertain) || std::ranges::any_of(data.assembly, is_uncertain);
}

SystematicPlan SystematicPlan::of(const Scene& scene, const frf::FrfSystem& substructures, const frf::FrfSystem& assembly) {
  SystematicPlan plan;
  if (!are_errors_unknown(scene.data)) return plan;
  if (!scene.couple_first.pairs.empty()) {
    fail(scene, "[data]", "gains, masses and errors of models are of the files' FRFs, and couple_first makes new ones of them",
         "leave out one of both");
  }
  for (const GainPrior& prior : scene.data.gains) plan.add_gains(scene, prior, substructures, assembly);
  for (const MassPrior& prior : scene.data.masses) plan.add_masses(scene, prior, substructures, assembly);
  for (std::size_t part = 0; part < scene.data.substructures.size(); ++part)
    plan.add_scales(scene.data.substructures[part], part);
  for (const DataFile& file : scene.data.assembly) {
    if (!error_of(file).any()) continue;
    fail(scene, "[data] assembly", file.path.filename().string() + " states an error of the model, which only a part may have",
         "remove stiffness_error and mass_error from it, or give noise");
  }
  return plan;
}

std::size_t SystematicPlan::add(NamedSystematic systematic, const std::vector<SensorRole>& roles) {
  all_.push_back(std::move(systematic));
  for (const SensorRole& role : roles) of_[key(role)].push_back(all_.size() - 1);
  return all_.size() - 1;
}

std::vector<SystematicUnknown> SystematicPlan::unknowns() const {
  std::vector<SystematicUnknown> out;
  for (const NamedSystematic& each : all_) out.push_back(each.unknown);
  return out;
}

const std::vector<std::size_t>& SystematicPlan::of(const SensorRole& role) const {
  static const std::vector<std::size_t> none;
  const auto found = of_.find(key(role));
  return found == of_.end() ? none : found->second;
}

const std::vector<ScaleUnknown>& SystematicPlan::scales(std::size_t part) const {
  static const std::vector<ScaleUnknown> none;
  const auto found = scales_.find(part);
  return found == scales_.end() ? none : found->second;
}

void SystematicPlan::add_scales(const DataFile& model, std::size_t part) {
  const models::ModelError error = error_of(model);
  for (const bool is_mass : {false, true}) {
    for (const models::ModelError::Band& band : is_mass ? error.mass : error.stiffness) {
      const std::string name = scale_name(is_mass ? "mass" : "stiffness", model, band);
      scales_[part].push_back({add({{Systematic::scale, band.deviation}, name, ""}, {}), is_mass, band});
    }
  }
}

void SystematicPlan::add_gains(const Scene& scene, const GainPrior& prior, const frf::FrfSystem& substructures,
                               const frf::FrfSystem& assembly) {
  const std::vector<TableFile> files = files_of(prior.files, substructures, assembly);
  const std::vector<SensorRole> roles = roles_of(prior.dofs, prior.of_reference, files);
  require_all(scene, prior, files, roles);
  const std::string whose = prior.of_reference ? "reference " : "";
  if (prior.gain > 0.0) add_shared(scene, prior.shared, {{Systematic::gain, prior.gain}, "gain of " + whose, ""}, roles);
  if (prior.delay > 0.0) add_shared(scene, prior.shared, {{Systematic::delay, prior.delay}, "delay of " + whose, "s"}, roles);
  if (prior.angle > 0.0) add_angles(scene, prior, substructures, assembly, roles);
}

/// Those towards directions that are measured at the same node in the same role of the file.
void SystematicPlan::add_angles(const Scene& scene, const GainPrior& prior, const frf::FrfSystem& substructures,
                                const frf::FrfSystem& assembly, const std::vector<SensorRole>& roles) {
  const std::size_t before = all_.size();
  for (const frf::Direction towards : {frf::Direction::x, frf::Direction::y, frf::Direction::z}) {
    std::vector<SensorRole> turned;
    for (const SensorRole& role : roles) {
      const frf::FrfHeader& header = (role.of_assembly ? assembly : substructures).source(role.file).header();
      const frf::Dof other{role.dof.node, towards};
      const bool is_turned = !role.dof.is_rotation() && role.dof.direction != towards;
      if (is_turned && frf::has(role.is_reference ? header.reference : header.response, other)) turned.push_back(role);
    }
    const std::string axis(1, "XYZ"[static_cast<int>(towards) - 1]);
    const std::string name = "angle towards " + axis + " of " + (prior.of_reference ? "reference " : "");
    add_shared(scene, prior.shared, {{Systematic::angle, prior.angle}, name, "rad", 0.0, towards}, turned);
  }
  if (all_.size() > before) return;
  fail(scene, "[[data.gains]] angle", "no sensor of the table has another direction that was measured at its node",
       "measure it, or leave angle out: FRFs along other axes determine the effect of an angle");
}

void SystematicPlan::add_masses(const Scene& scene, const MassPrior& prior, const frf::FrfSystem& substructures,
                                const frf::FrfSystem& assembly) {
  const std::vector<TableFile> files = files_of(prior.files, substructures, assembly);
  require_driving_points(scene, prior, files);
  add_shared(scene, prior.shared, {{Systematic::mass, prior.deviation}, "mass at ", "kg", prior.mass},
             roles_of(prior.dofs, false, files));
}

void SystematicPlan::add_shared(const Scene& scene, Sharing shared, const NamedSystematic& systematic,
                                const std::vector<SensorRole>& roles) {
  for (const SensorRole& role : roles) {
    for (const std::size_t u : of(role)) {
      if (all_[u].unknown.kind != systematic.unknown.kind || all_[u].towards != systematic.towards) continue;
      fail(scene, "[data]", "two tables name the " + all_[u].name, "name a sensor of a file in one table");
    }
  }
  const auto is_one = [&](const SensorRole& a, const SensorRole& b) {
    return shared == Sharing::all || (shared == Sharing::files && a.dof.same_coordinate(b.dof));
  };
  std::vector<SensorRole> first;  // of each unknown
  std::vector<std::vector<SensorRole>> groups;
  for (const SensorRole& role : roles) {
    const auto found = std::ranges::find_if(first, [&](const SensorRole& other) { return is_one(other, role); });
    const auto place = static_cast<std::size_t>(found - first.begin());
    if (found == first.end()) {
      first.push_back(role);
      groups.emplace_back();
    }
    groups[place].push_back(role);
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    NamedSystematic one = systematic;
    one.name += shared == Sharing::all && groups[g].size() > 1 ? first[g].dof.name() + " and others" : first[g].dof.name();
    const bool taken = std::ranges::any_of(all_, [&](const NamedSystematic& other) { return other.name == one.name; });
    if (shared == Sharing::none || taken) {
      one.name += " in " + (first[g].of_assembly ? std::string("the assembly") : "part " + std::to_string(first[g].file + 1));
    }
    add(std::move(one), groups[g]);
  }
}

}  // namespace jointid::ident
