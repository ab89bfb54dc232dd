#include "response/identify/law_unknowns.hpp"

#include <cmath>
#include <stdexcept>
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
  for (std::size_t i = 0; i < units.size(); ++i) {
    const std::size_t place = all.size();
    all.push_back({names[place], units[i], values[place], 0.0, friction::infinity, false});
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

}  // namespace

LawUnknowns::LawUnknowns(std::vector<Joint> joints) : LawUnknowns(joints, all_of_laws(joints)) {}

LawUnknowns::LawUnknowns(std::vector<Joint> joints, std::vector<JointParameter> free)
    : joints_(std::move(joints)), free_(std::move(free)) {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const auto [joint, place] = free_[i];
    if (joint >= joints_.size()) fail_unknown(joint, "there is no such joint", "");
    const std::vector<friction::Parameter> all = parameters_of(joints_[joint]);
    if (place >= all.size()) fail_unknown(joint, "it has no parameter " + std::to_string(place + 1), "");
    for (std::size_t before = 0; before < i; ++before) {
      if (free_[before].joint == joint && free_[before].parameter == place)
        fail_unknown(joint, "its parameter " + all[place].name + " is unknown twice", "name it once");
    }
    const friction::Parameter& own = all[place];
    if (!(own.value > own.lower && own.value < own.upper))
      fail_unknown(joint, own.name + " = " + std::to_string(own.value) + " is at a bound", "start an unknown inside its bounds");
    parameters_.push_back(own);
  }
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
  const Eigen::VectorXd unknown = values(numbers);
  if (!unknown.allFinite()) return std::nullopt;
  std::vector<Joint> joints = joints_;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    std::vector<double> own = joints[j].values();
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (free_[i].joint == j) own[free_[i].parameter] = unknown(at(i));
    }
    try {
      joints[j] = joints[j].with(own);
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  }
  return joints;
}

}  // namespace jointid::response
