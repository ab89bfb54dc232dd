#include "laws/data/level_states.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "frf/set/frf_system.hpp"
#include "ident/plan/data_source.hpp"
#include "laws/data/level_records.hpp"
#include "weighting/line_selection.hpp"

namespace jointid::laws {
namespace {

using frf::Dof;

[[noreturn]] void fail(std::string file, std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = std::move(file),
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

/// Files of responses may hold spectra instead of FRFs.
ident::DataFile of_motions(ident::DataFile file) {
  file.options.spectra = frf::OpenOptions::Spectra::motions;
  return file;
}

/// Records of each level that has some.
using Recordings = std::map<const ForceLevel*, LevelRecordings>;

Recordings recordings_of(const LawScene& scene) {
  Recordings all;
  for (const ForceLevel& level : scene.levels) {
    if (level.records) all.emplace(&level, LevelRecordings(level));
  }
  return all;
}

/// Those of the scene, or all that the parts and every file of responses have.
std::vector<Dof> responses_of(const LawScene& scene, const frf::FrfSystem& parts, PhasorFiles& files,
                              const Recordings& recordings) {
  if (!scene.responses.empty()) return scene.responses;
  std::vector<Dof> common = parts.responses();
  for (const ForceLevel& level : scene.levels) {
    if (level.planned) continue;
    if (level.records) {
      const std::vector<Dof>& own = recordings.at(&level).dofs();
      std::erase_if(common, [&](const Dof& dof) { return !frf::has(own, dof); });
      continue;
    }
    for (const HarmonicFiles& each : level.harmonics) {
      const std::vector<Dof>& own = files.dofs(of_motions(each.responses));
      std::erase_if(common, [&](const Dof& dof) { return !frf::has(own, dof); });
    }
  }
  if (common.empty()) {
    fail(scene.file.string(), "[[data.levels]] responses", "no response is in the parts and in the files of every level",
         "`jointid info` shows the DOFs of a file");
  }
  return common;
}

std::vector<Dof> forces_of(const LawScene& scene) {
  std::vector<Dof> all;
  for (const ForceLevel& level : scene.levels) {
    for (const Dof& dof : level.force_dofs) {
      if (!frf::has(all, dof)) all.push_back(dof);
    }
  }
  return all;
}

/// One harmonic of a level, with the lines of its files that belong to the lines of the force.
struct HarmonicData {
  int harmonic = 1;
  std::shared_ptr<const Phasors> responses, forces;  ///< no forces where an amplitude is told
  std::vector<std::size_t> response_line, force_line;
};

/// Force files hold N, whatever their header calls them.
ident::DataFile in_newton(ident::DataFile file) {
  if (!file.options.quantity) file.options.quantity = frf::Quantity::receptance;
  file.options.spectra = frf::OpenOptions::Spectra::forces;
  return file;
}

weighting::LineSelection selection_of(const LawScene& scene) {
  return {.range_hz = scene.frequency.range_hz, .step_hz = scene.frequency.step_hz, .exclude_hz = scene.frequency.exclude_hz};
}

/// As [errors] says.
Eigen::RowVectorXd deviations_of_force(const LawScene& scene, const Eigen::RowVectorXcd& force) {
  return (scene.errors ? scene.errors->force / std::numbers::sqrt2 : 0.0) * force.cwiseAbs();
}

/// The states of one level.
class LevelReader {
 public:
  LevelReader(const LawScene& scene, const ForceLevel& level, const std::vector<Dof>& forces, PhasorFiles& files,
              Recordings& recordings, LevelStates& to)
      : scene_(scene), level_(level), forces_(forces), to_(to) {
    if (level.records) {
      LevelRecordings& own = recordings.at(&level);
      const auto phasors = own.phasors(to.responses, to.structure->frequency_hz());
      for (std::size_t n = 0; n < phasors.size(); ++n)
        harmonics_.push_back({level.harmonics[n].harmonic, phasors[n].responses, phasors[n].forces, {}, {}});
      to.notes.insert(to.notes.end(), own.notes().begin(), own.notes().end());
      find_lines();
      return;
    }
    for (const HarmonicFiles& each : level.harmonics) {
      harmonics_.push_back({each.harmonic, files.read(of_motions(each.responses), to.responses), {}, {}, {}});
      if (each.forces) harmonics_.back().forces = files.read(in_newton(*each.forces), level.force_dofs);
    }
    find_lines();
  }

  void read() {
    for (const std::size_t line : weighting::select_lines(lines_hz_, selection_of(scene_))) add_line(line);
  }

  /// How often each thing was left out.
  const std::map<std::string, std::size_t>& left_out() const { return left_out_; }

 private:
  void find_lines() {
    const HarmonicData& first = harmonics_.front();
    for (const double hz : first.responses->frequency_hz) {
      if (hz > 0.0) lines_hz_.push_back(hz / first.harmonic);
    }
    structure_line_ = frf::match_lines(lines_hz_, to_.structure->frequency_hz());
    for (HarmonicData& each : harmonics_) {
      std::vector<double> wanted = lines_hz_;
      for (double& hz : wanted) hz *= each.harmonic;
      each.response_line = frf::match_lines(wanted, each.responses->frequency_hz);
      if (each.forces) each.force_line = frf::match_lines(wanted, each.forces->frequency_hz);
    }
  }

  void add_line(std::size_t line) {
    if (structure_line_[line] == frf::npos) {
      ++left_out_["lines that the parts do not have"];
      return;
    }
    response::MeasuredState state;
    state.omega = angular(to_.structure->frequency_hz()[structure_line_[line]]);
    state.harmonics.clear();
    state.force.harmonics.clear();
    state.force.amplitudes.resize(0, at(forces_.size()));
    const Eigen::Index most = at(harmonics_.size()), responses = at(to_.responses.size());
    state.response.resize(most, responses);
    state.deviation.resize(most, responses);
    for (const HarmonicData& each : harmonics_) add_harmonic(each, line, state);
    if (state.harmonics.empty() || state.force.harmonics.empty()) return;
    state.response.conservativeResize(at(state.harmonics.size()), Eigen::NoChange);
    state.deviation.conservativeResize(at(state.harmonics.size()), Eigen::NoChange);
    to_.states.push_back(std::move(state));
    to_.level.push_back(static_cast<std::size_t>(&level_ - scene_.levels.data()));
  }

  void add_harmonic(const HarmonicData& data, std::size_t line, response::MeasuredState& state) {
    const std::string name = "harmonic " + std::to_string(data.harmonic);
    if (!add_force(data, line, state)) {
      ++left_out_[name + " without its force"];
      return;
    }
    const std::size_t own = data.response_line[line];
    if (own == frf::npos || !data.responses->values.row(at(own)).allFinite()) {
      ++left_out_[name + " where it was not measured"];
      return;
    }
    if (!to_.structure->covers(data.harmonic * state.omega)) {
      ++left_out_[name + " where the parts have no line"];
      return;
    }
    const Eigen::Index row = at(state.harmonics.size());
    const Complex factor = level_.per_force ? state.force.amplitudes(0, column_of(level_.force_dofs.front()))
                                            : Complex(level_.rms ? std::numbers::sqrt2 : 1.0);
    state.response.row(row) = factor * data.responses->values.row(at(own));
    for (Eigen::Index r = 0; r < state.response.cols(); ++r) {
      state.deviation(row, r) = deviation(*data.responses, at(own), r, std::abs(factor), std::abs(state.response(row, r)));
    }
    state.harmonics.push_back(data.harmonic);
  }

  Eigen::Index column_of(const Dof& dof) const { return at(frf::find_coordinate(forces_, dof)); }

  /// Whether the harmonic's force is known: measured, or none above the first with an amplitude.
  bool add_force(const HarmonicData& data, std::size_t line, response::MeasuredState& state) const {
    Eigen::RowVectorXcd row = Eigen::RowVectorXcd::Zero(at(forces_.size()));
    const double peak = level_.rms ? std::numbers::sqrt2 : 1.0;
    if (level_.amplitude) {
      if (!state.force.harmonics.empty()) return true;
      row(column_of(level_.force_dofs.front())) = *level_.amplitude;
    } else {
      if (data.force_line[line] == frf::npos) return false;
      for (std::size_t i = 0; i < level_.force_dofs.size(); ++i) {
        const Dof& dof = level_.force_dofs[i];
        const double sign = forces_[static_cast<std::size_t>(column_of(dof))] == dof ? 1.0 : -1.0;
        row(column_of(dof)) = sign * peak * data.forces->values(at(data.force_line[line]), at(i));
      }
    }
    if (!row.allFinite()) return false;
    state.force.harmonics.push_back(level_.amplitude ? 1 : data.harmonic);
    state.force.amplitudes.conservativeResize(state.force.amplitudes.rows() + 1, Eigen::NoChange);
    state.force.amplitudes.bottomRows(1) = row;
    if (level_.per_force) return true;  // the responses would move with the force: its errors are not counted
    state.force_deviation.conservativeResize(state.force.amplitudes.rows(), row.size());
    state.force_deviation.bottomRows(1) = force_deviations(data, line, row, peak);
    return true;
  }

  /// Of Re and Im of each force: its file's, or those of [errors].
  Eigen::RowVectorXd force_deviations(const HarmonicData& data, std::size_t line, const Eigen::RowVectorXcd& force,
                                      double peak) const {
    Eigen::RowVectorXd out = deviations_of_force(scene_, force);
    if (!data.forces || data.forces->variances.size() == 0) return out;
    for (std::size_t i = 0; i < level_.force_dofs.size(); ++i) {
      const double variance = data.forces->variances(at(data.force_line[line]), at(i));
      if (variance > 0.0) out(column_of(level_.force_dofs[i])) = peak * std::sqrt(variance);
    }
    return out;
  }

  double deviation(const Phasors& phasors, Eigen::Index line, Eigen::Index r, double factor, double size) const {
    if (phasors.variances.size() > 0 && phasors.variances(line, r) > 0.0) return factor * std::sqrt(phasors.variances(line, r));
    if (scene_.errors && scene_.errors->of_responses())
      return std::sqrt(0.5 * std::pow(scene_.errors->relative * size, 2) + std::pow(scene_.errors->floor, 2));
    fail(phasors.file, "responses", "nothing states how exact they are",
         "give [errors] relative = 0.01 (or floor, m), or a file with variances or coherences");
  }

  const LawScene& scene_;
  const ForceLevel& level_;
  const std::vector<Dof>& forces_;
  LevelStates& to_;
  std::vector<HarmonicData> harmonics_;
  std::vector<double> lines_hz_;
  std::vector<std::size_t> structure_line_;
  std::map<std::string, std::size_t> left_out_;
};

void add_planned(const LawScene& scene, const ForceLevel& level, const std::vector<Dof>& forces, LevelStates& to) {
  const std::vector<double>& lines = to.structure->frequency_hz();
  for (const std::size_t line : weighting::select_lines(lines, selection_of(scene))) {
    response::MeasuredState state;
    state.omega = angular(lines[line]);
    if (!(state.omega > 0.0)) continue;
    state.harmonics.clear();
    for (const HarmonicFiles& each : level.harmonics) {
      if (to.structure->covers(each.harmonic * state.omega)) state.harmonics.push_back(each.harmonic);
    }
    if (state.harmonics.size() < level.harmonics.size()) continue;
    state.force.harmonics = {1};
    state.force.amplitudes = Eigen::MatrixXcd::Zero(1, at(forces.size()));
    const Dof& dof = level.force_dofs.front();
    const std::size_t column = frf::find_coordinate(forces, dof);
    state.force.amplitudes(0, at(column)) = (forces[column] == dof ? 1.0 : -1.0) * *level.amplitude;
    state.force_deviation = deviations_of_force(scene, state.force.amplitudes.row(0));
    state.response = Eigen::MatrixXcd::Zero(at(state.harmonics.size()), at(to.responses.size()));
    state.deviation = Eigen::MatrixXd::Ones(state.response.rows(), state.response.cols());
    to.states.push_back(std::move(state));
    to.level.push_back(static_cast<std::size_t>(&level - scene.levels.data()));
  }
}

}  // namespace

LevelStates read_level_states(const LawScene& scene, PhasorFiles files) {
  frf::FrfSystem parts("[data] parts", ident::open_all(scene.parts), frf::Composition::uncoupled, scene.reciprocity);
  LevelStates out;
  Recordings recordings = recordings_of(scene);
  out.responses = responses_of(scene, parts, files, recordings);
  const std::vector<Dof> forces = forces_of(scene);
  std::vector<response::JointEnds> joints;
  for (const FrictionJoint& joint : scene.joints) joints.push_back({joint.positive, joint.negative});
  out.structure = std::make_shared<response::FrfReceptance>(parts, joints, out.responses, forces);
  for (const ForceLevel& level : scene.levels) {
    if (level.planned) {
      add_planned(scene, level, forces, out);
      continue;
    }
    LevelReader reader(scene, level, forces, files, recordings, out);
    reader.read();
    for (const auto& [what, count] : reader.left_out()) {
      out.notes.push_back(level.name + ": left out: " + what + " (" + std::to_string(count) +
                          (count == 1 ? " line)" : " lines)"));
    }
  }
  if (out.states.empty()) {
    std::string why;
    for (const std::string& note : out.notes) why += (why.empty() ? "" : "; ") + note;
    fail(scene.file.string(), "[[data.levels]]", "no line of any level can be used" + (why.empty() ? "" : ": " + why),
         "the parts have " + frf::range_text(out.structure->frequency_hz()) + "; see [frequency] range");
  }
  if (!out.structure->knows_errors()) {
    out.notes.push_back("the FRFs of the parts are taken as exact: their files have neither variances nor coherences");
  }
  response::require_valid(out.states, *out.structure);
  return out;
}

}  // namespace jointid::laws
