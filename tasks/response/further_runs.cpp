#include "tasks/response/further_runs.hpp"

#include <fmt/format.h>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "records/file/read_record.hpp"
#include "response/time/from_joints.hpp"
#include "tasks/tell.hpp"

namespace jointid::tasks {
namespace {

std::string curve_name(const SceneCurve& curve, const std::vector<std::string>& joints) {
  return curve.parameter ? curve.along + " of " + joints[curve.parameter->joint] : "force N";
}

response::CurveRequest request_of(const SceneCurve& curve) {
  response::CurveRequest request;
  request.along = curve.parameter ? response::Along::joint_parameter : response::Along::level;
  request.from = curve.range[0];
  request.to = curve.range[1];
  request.omega = angular(curve.frequency_hz);
  request.level = curve.force;
  if (curve.parameter) request.parameter = *curve.parameter;
  return request;
}

/// Samples in N of a record, from t = 0.
records::Record read_force(const SceneRecord& record) {
  records::RecordOptions options{.channels = {{record.column, {1, frf::Direction::x, 1}, record.factor, record.unit}},
                                 .time = record.time,
                                 .rate_hz = record.rate_hz,
                                 .any_dof = true,
                                 .unit_otherwise = "N"};
  const std::vector<records::Record> found = records::read_records(record.file.path, options);
  const auto fail = [&](std::string problem, std::string remedy) {
    throw InputError({.kind = ErrorKind::data,
                      .file = record.file.path.string(),
                      .place = record.file.place,
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  };
  if (found.size() != 1 || found.front().channels.size() != 1) fail("holds several records", "write one force as a column");
  if (found.front().channels.front().kind != records::ChannelKind::force)
    fail("column " + record.column + " is no force", "its unit is N");
  if (found.front().samples() < 2) fail("has fewer than two samples", "");
  return found.front();
}

/// Straight lines between the samples of all records, which must be sampled alike.
response::ForceHistory history_of(const std::vector<SceneRecord>& records, const Prepared& prepared) {
  Eigen::MatrixXd directions(prepared.responses.rows(), at(records.size())), values;
  std::vector<double> times;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const records::Record record = read_force(records[i]);
    if (i == 0) {
      values.resize(at(record.samples()), at(records.size()));
      for (std::size_t k = 0; k < record.samples(); ++k) times.push_back(static_cast<double>(k) / record.rate_hz);
    } else if (at(record.samples()) != values.rows() || times[1] != 1.0 / record.rate_hz) {
      throw InputError({.kind = ErrorKind::data,
                        .file = records[i].file.path.string(),
                        .place = records[i].file.place,
                        .problem = "has another number of samples or another rate than the first force",
                        .remedy = "give forces that were sampled together"});
    }
    values.col(at(i)) = Eigen::Map<const Eigen::VectorXd>(record.channels.front().samples.data(), values.rows());
    directions.col(at(i)) = prepared.unit_force(records[i].dof.coordinate);
  }
  return response::ForceHistory::sampled(directions, times, values);
}

/// The forces of a transient by name.
std::vector<std::pair<std::string, response::ForceHistory>> histories_of(const ResponseScene& scene, const Prepared& prepared) {
  const SceneTransient& transient = *scene.transient;
  std::vector<std::pair<std::string, response::ForceHistory>> all;
  if (!transient.records.empty()) all.emplace_back("record", history_of(transient.records, prepared));
  for (const ScenePulse& pulse : transient.pulses) {
    all.emplace_back(
        fmt::format("pulse of {:.6g} N, {:.6g} s", pulse.amplitude, pulse.length),
        response::ForceHistory::half_sine(pulse.amplitude * prepared.unit_force(pulse.dof.coordinate), pulse.length));
  }
  if (!all.empty()) return all;
  const double frequency_hz = prepared.frequency_hz.empty() ? scene.range_hz->front() : prepared.frequency_hz.front();
  for (const double level : scene.levels) {
    const response::PeriodicProblem problem =
        response::periodic_problem(*prepared.marched, scene.force, angular(frequency_hz), level);
    all.emplace_back(fmt::format("{:.6g} N at {:.6g} Hz", level, frequency_hz), problem.force());
  }
  return all;
}

/// The mode at an amplitude; where the joint stands still in it, the row says so.
void find_mode(const ResponseScene& scene, const Prepared& prepared, EquivalentRow& row) {
  const SceneEquivalent& asked = *scene.equivalent;
  try {
    row.mode.emplace(response::equivalent_mode(*scene.structure, prepared.assembly->w, prepared.assembly->joints, *asked.mode,
                                               asked.joint, row.amplitude));
  } catch (const InputError& error) {
    row.problem = error.parts().problem;
  }
}

}  // namespace

void run_curves(const response::HarmonicBalance& balance, const ResponseScene& scene, const ident::Control& control,
                ResponseResult& run) {
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    const SceneCurve& curve = scene.curves[i];
    tell(control, fmt::format("curve {}", i + 1));
    stop_if(control.interrupted);
    try {
      run.curves.push_back({curve, curve_name(curve, run.joints), response::follow_response(balance, request_of(curve))});
    } catch (const InputError& error) {
      InputError::Parts parts = error.parts();
      if (!parts.file.empty() || !parts.place.empty()) throw;
      parts.file = scene.file.string();
      parts.place = fmt::format("[[curves]] {}", i + 1);
      throw InputError(std::move(parts));
    }
  }
}

void run_equivalents(const ResponseScene& scene, const Prepared& prepared, ResponseResult& run) {
  if (!scene.equivalent) return;
  const SceneEquivalent& asked = *scene.equivalent;
  for (const double amplitude : asked.amplitudes) {
    EquivalentRow& row = run.equivalents.emplace_back();
    row.amplitude = amplitude;
    if (asked.mode) find_mode(scene, prepared, row);
    if (row.mode) {
      row.joints = row.mode->joints;
    } else {
      for (const SceneJoint& joint : scene.joints) row.joints.push_back(response::equivalent_joint(joint.joint, amplitude, 0.0));
    }
  }
}

namespace {

/// Normal loads and k_r of [[joints]] at the columns that march: joints with friction, then cubic springs.
void fill_options(const SceneTransient& asked, const std::vector<response::Joint>& joints,
                  const response::JointedStructure& structure, response::TransientRequest& request) {
  const std::vector<std::size_t> columns = response::friction_joints(joints);
  request.two = asked.two;
  if (!asked.normal.empty()) request.loads.resize(static_cast<std::size_t>(structure.joints()));
  for (const SceneNormal& normal : asked.normal)
    request.loads[static_cast<std::size_t>(std::ranges::find(columns, normal.joint) - columns.begin())] = normal.load;
  if (asked.reference_stiffness.empty()) return;
  request.two.reference_stiffness = structure.initial_stiffness();
  for (std::size_t i = 0; i < columns.size(); ++i) request.two.reference_stiffness[at(i)] = asked.reference_stiffness[columns[i]];
}

}  // namespace

void run_transients(const ResponseScene& scene, const Prepared& prepared, const ident::Control& control, ResponseResult& run) {
  if (!scene.transient) return;
  const response::JointedStructure structure =
      response::from_joints(prepared.marched->structure, prepared.marched->w, prepared.marched->joints);
  for (const std::size_t j : response::friction_joints(prepared.marched->joints)) run.marched.push_back(run.joints[j]);
  for (const std::size_t j : response::cubic_joints(prepared.marched->joints)) run.marched.push_back(run.joints[j] + " cubic");
  response::TransientRequest request = {.duration = scene.transient->duration,
                                        .step = scene.transient->step,
                                        .method = scene.transient->method,
                                        .delta = scene.transient->delta,
                                        .responses = prepared.responses};
  fill_options(*scene.transient, prepared.marched->joints, structure, request);
  for (const auto& history : histories_of(scene, prepared)) {
    request.advance = [&](double time) {
      tell(control, history.first, static_cast<std::size_t>(time / request.step),
           static_cast<std::size_t>(request.duration / request.step));
      stop_if(control.interrupted);
    };
    run.transients.push_back({history.first, response::march_transient(structure, history.second, request)});
  }
}

}  // namespace jointid::tasks
