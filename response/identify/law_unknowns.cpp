#include "response/identify/law_unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace jointid::response {
namespace {

[[noreturn]] void fail_unknown(std::size_t joint, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = "",
                    .place = "joint " + std::to_string(joint + 1),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

std::vector<friction::Parameter> parameters_of(const Joint& joint) {
  std::vector<friction::Parameter> all = joint.friction ? joint.friction->parameters() : std::vector<friction::Parameter>{};
  const std::vector<std::string> names = joint.parameter_names();
  const std::vector<double> values = joint.values();
  const std::vector<std::string> units = {"N/m", "N·s/m", "N/m³"};
  for (const std::string& unit : units) {
    const std::size_t place = all.size();
    all.push_back({names[place], unit, values[place], 0.0, friction::infinity, false});
  }
  return all;
}

std::vector<JointParameter> all_of_laws(const std::vector<Joint>& joints) {
  std::vector<JointParameter> all;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const std::size_t count = joints[j].friction ? joints[j].friction->parameters().size() : 0;
    for (std::size_t i = 0; i < count; ++i) all.push_back({j, i});
  }
  return all;
}

std::vector<Unknown> each_alone(const std::vector<JointParameter>& free) {
  std::vector<Unknown> all;
  for (const JointParameter& each : free) all.push_back({each});
  return all;
}

}  // namespace

LawUnknowns::LawUnknowns(std::vector<Joint> joints) : LawUnknowns(joints, all_of_laws(joints)) {}

LawUnknowns::LawUnknowns(std::vector<Joint> joints, const std::vector<JointParameter>& free)
    : LawUnknowns(std::move(joints), each_alone(free)) {}

LawUnknowns::LawUnknowns(std::vector<Joint> joints, std::vector<Unknown> unknowns)
    : joints_(std::move(joints)), unknowns_(std::move(unknowns)) {
  for (const Unknown& unknown : unknowns_) {
    std::vector<JointParameter> members = {unknown.parameter};
    members.insert(members.end(), unknown.ties.begin(), unknown.ties.end());
    for (const JointParameter& member : members) {
      require_new(member);
      moved_by_.push_back(at(parameters_.size()));
      moved_.push_back(member);
    }
    friction::Parameter own = parameters_of(joints_[unknown.parameter.joint])[unknown.parameter.parameter];
    if (unknown.bounds) {
      own.lower = std::max(own.lower, (*unknown.bounds)[0]);
      own.upper = std::min(own.upper, (*unknown.bounds)[1]);
    }
    if (!(own.value > own.lower && own.value < own.upper)) {
      fail_unknown(unknown.parameter.joint, own.name + " = " + std::to_string(own.value) + " is at a bound",
                   "start an unknown inside its bounds");
    }
    parameters_.push_back(own);
  }
}

void LawUnknowns::require_new(const JointParameter& member) const {
  const auto [joint, place] = member;
  if (joint >= joints_.size()) fail_unknown(joint, "there is no such joint", "");
  const std::vector<friction::Parameter> all = parameters_of(joints_[joint]);
  if (place >= all.size()) fail_unknown(joint, "it has no parameter " + std::to_string(place + 1), "");
  for (const JointParameter& before : moved_) {
    if (before.joint == joint && before.parameter == place)
      fail_unknown(joint, "its parameter " + all[place].name + " is unknown twice", "name it once");
  }
}

Eigen::Index LawUnknowns::priors() const {
  return std::ranges::count_if(unknowns_, [](const Unknown& unknown) { return unknown.prior.has_value(); });
}

Eigen::VectorXd LawUnknowns::start() const {
  Eigen::VectorXd numbers(size());
  for (Eigen::Index i = 0; i < size(); ++i) numbers(i) = friction::ParameterScale(parameter(i)).free(parameter(i).value);
  return numbers;
}

Eigen::VectorXd LawUnknowns::values(const Eigen::VectorXd& numbers) const {
  Eigen::VectorXd values(size());
  for (Eigen::Index i = 0; i < size(); ++i) values(i) = friction::ParameterScale(parameter(i)).value(numbers(i));
  return values;
}

Eigen::VectorXd LawUnknowns::slopes(const Eigen::VectorXd& numbers) const {
  Eigen::VectorXd slopes(size());
  for (Eigen::Index i = 0; i < size(); ++i) slopes(i) = friction::ParameterScale(parameter(i)).slope(numbers(i));
  return slopes;
}

std::optional<std::vector<Joint>> LawUnknowns::at_numbers(const Eigen::VectorXd& numbers) const {
  const Eigen::VectorXd found = values(numbers);
  if (!found.allFinite()) return std::nullopt;
  std::vector<Joint> joints = joints_;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    std::vector<double> own = joints[j].values();
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      if (moved_[i].joint == j) own[moved_[i].parameter] = found(moved_by_[i]);
    }
    if (!joints[j].admits(own)) return std::nullopt;
    joints[j] = joints[j].with(own);
  }
  return joints;
}

}  // namespace jointid::response
