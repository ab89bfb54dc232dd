#include "response/continuation/response_curve.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "response/harmonic/attempts.hpp"

namespace jointid::response {
namespace {

/// The joint with one value changed. Throws InputError (usage) where the law has no such value.
Joint changed(const Joint& joint, std::size_t parameter, double value) {
  std::vector<double> values = joint.values();
  values[parameter] = value;
  try {
    return joint.with(values);
  } catch (const InputError& error) {
    refuse("the curve left the values that the law can have: " + error.parts().problem, "end the range farther from the law's bound");
  }
}

/// The condensed equations along the parameter of a request, and what follows from them.
class ParameterPath {
 public:
  ParameterPath(const HarmonicBalance& balance, const CurveRequest& request, const Harmonics& harmonics)
      : balance_(balance), request_(request), equations_(balance.joints(), harmonics) {
    if (request.along != Along::frequency) line_ = harmonic_line(balance.structure(), harmonics, balance.force(), request.omega);
  }

  CurveEquations::Value evaluate(const Eigen::VectorXd& y, double parameter) {
    move_to(parameter);
    auto [residual, by_motion] = equations_.evaluate(line_, level(parameter), y);
    return {std::move(residual), std::move(by_motion), by_parameter(y, parameter)};
  }

  /// d|X_n|²/ds of the response along the tangent.
  double slope_of_response(const CurvePoint& point) {
    move_to(point.parameter);
    const Eigen::Index n = equations_.harmonics().find(request_.harmonic);
    const HarmonicLine::One& one = line_.harmonics[static_cast<std::size_t>(n)];
    const double s = level(point.parameter);
    const Eigen::VectorXcd force = equations_.forces(line_.omega, point.unknowns).row(n).transpose();
    const Complex x = s * one.free(request_.response) - (one.to_joints.row(request_.response) * force)(0);
    Eigen::VectorXcd change =
        equations_.forces_by_motion(line_.omega, point.unknowns)[static_cast<std::size_t>(n)] * point.tangent;
    Complex dx = 0.0;
    if (request_.along == Along::frequency) {
      const HarmonicLine::One& slope = line_.slopes[static_cast<std::size_t>(n)];
      dx += point.parameter_tangent * (s * slope.free(request_.response) - (slope.to_joints.row(request_.response) * force)(0));
      for (std::size_t j = 0; j < equations_.joints().size(); ++j) {
        const Eigen::Index unknowns = equations_.harmonics().unknowns();
        const Motion motion(equations_.harmonics(),
                            equations_.harmonics().unpack(point.unknowns.segment(at(j) * unknowns, unknowns)));
        change(at(j)) += point.parameter_tangent * equations_.joints()[j].by_omega(motion, equations_.harmonics())(n);
      }
    } else if (request_.along == Along::level) {
      dx += point.parameter_tangent * one.free(request_.response);
    } else {
      const std::size_t j = request_.parameter.joint;
      const Eigen::Index unknowns = equations_.harmonics().unknowns();
      const Motion motion(equations_.harmonics(),
                          equations_.harmonics().unpack(point.unknowns.segment(at(j) * unknowns, unknowns)));
      change(at(j)) += point.parameter_tangent * equations_.joints()[j]
                                                     .evaluate(motion, line_.omega, equations_.harmonics(), true)
                                                     .by_parameters(n, at(request_.parameter.parameter));
    }
    dx -= (one.to_joints.row(request_.response) * change)(0);
    return 2.0 * std::real(std::conj(x) * dx);
  }

  HarmonicSolution describe(const CurvePoint& point) {
    move_to(point.parameter);
    HarmonicSolution solution = balance_.describe(equations_, line_, level(point.parameter), point.unknowns);
    solution.converged = true;
    solution.start = Start::neighbour;
    solution.steps = point.steps;
    return solution;
  }

  const CondensedEquations& equations() const { return equations_; }

 private:
  double level(double parameter) const { return request_.along == Along::level ? parameter : request_.level; }

  void move_to(double parameter) {
    if (request_.along == Along::frequency && line_.omega != parameter) {
      line_ = harmonic_line(balance_.structure(), equations_.harmonics(), balance_.force(), parameter, true);
    } else if (request_.along == Along::joint_parameter) {
      const std::size_t j = request_.parameter.joint;
      equations_.replace(j, changed(balance_.joints()[j], request_.parameter.parameter, parameter));
    }
  }

  Eigen::VectorXd by_parameter(const Eigen::VectorXd& y, double parameter) const {
    if (request_.along == Along::frequency) return equations_.by_omega(line_, level(parameter), y);
    if (request_.along == Along::level) return equations_.by_level(line_);
    return equations_.by_parameter(line_, y, request_.parameter);
  }

  const HarmonicBalance& balance_;
  const CurveRequest& request_;
  CondensedEquations equations_;
  HarmonicLine line_;
};

void require(const HarmonicBalance& balance, const CurveRequest& request) {
  const auto fail = [](const std::string& problem) {
    throw InputError({.kind = ErrorKind::usage, .file = "", .place = "curve", .problem = problem, .remedy = ""});
  };
  if (!(request.from != request.to)) fail("begin and end are the same");
  if (request.response < 0 || request.response >= balance.structure().responses()) fail("there is no such response");
  if (request.along == Along::joint_parameter &&
      (request.parameter.joint >= balance.joints().size() ||
       request.parameter.parameter >= balance.joints()[request.parameter.joint].values().size())) {
    fail("there is no such joint or parameter");
  }
}

HarmonicBalance at_begin(const HarmonicBalance& balance, const CurveRequest& request) {
  if (request.along != Along::joint_parameter) return balance;
  const Joint& joint = balance.joints()[request.parameter.joint];
  return balance.with_joint(request.parameter.joint, changed(joint, request.parameter.parameter, request.from));
}

/// The curve from a known solution.
ResponseCurve follow_from(const HarmonicBalance& balance, const CurveRequest& request, const HarmonicSolution& start) {
  ParameterPath path(balance, request, Harmonics(start.harmonics));
  const CurveEquations equations = {[&](const Eigen::VectorXd& y, double parameter) { return path.evaluate(y, parameter); }};
  ArcOptions options = {.from = request.from, .to = request.to};
  options.longest_step = request.longest_step;
  options.first_step = std::min(options.first_step, request.longest_step);
  const Curve curve = follow(equations, embedded(path.equations(), start.harmonics, start.joint_motion), options,
                             {parameter_slope, [&](const CurvePoint& point) { return path.slope_of_response(point); }});
  ResponseCurve found;
  found.end = curve.end;
  for (const CurvePoint& point : curve.points) {
    found.points.push_back(path.describe(point));
    found.parameters.push_back(point.parameter);
  }
  for (const CurveEvent& event : curve.events) {
    if (event.function == 0) {
      found.turning_points.push_back(path.describe(event.point));
      found.turning_parameters.push_back(event.point.parameter);
    } else if (event.falling) {
      found.peaks.push_back(path.describe(event.point));
      found.peak_parameters.push_back(event.point.parameter);
    }
  }
  return found;
}

}  // namespace

ResponseCurve follow_response(const HarmonicBalance& balance, const CurveRequest& request) {
  require(balance, request);
  const HarmonicBalance begin = at_begin(balance, request);
  const HarmonicSolution start = begin.solve(request.along == Along::frequency ? request.from : request.omega,
                                             request.along == Along::level ? request.from : request.level);
  if (!start.converged) {
    ResponseCurve none;
    none.end = CurveEnd::start_not_converged;
    return none;
  }
  if (Harmonics(start.harmonics).find(request.harmonic) < 0) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = "",
                      .place = "curve",
                      .problem = "the harmonic asked for is not among those solved for",
                      .remedy = ""});
  }
  return follow_from(balance, request, start);
}

std::optional<HarmonicSolution> peak_near(const HarmonicBalance& balance, const HarmonicSolution& solution, double level,
                                          Eigen::Index response, int harmonic, double width) {
  const HarmonicSolution start = balance.solve(solution.omega, level, &solution);
  if (!start.converged) return std::nullopt;
  for (const double to : {(1.0 + width) * start.omega, (1.0 - width) * start.omega}) {
    CurveRequest request = {.along = Along::frequency, .from = start.omega, .to = to};
    request.level = level;
    request.response = response;
    request.harmonic = harmonic;
    ResponseCurve curve = follow_from(balance, request, start);
    if (!curve.peaks.empty()) return std::move(curve.peaks.front());
  }
  return std::nullopt;
}

std::vector<HarmonicSolution> follow_peak(const HarmonicBalance& balance, const HarmonicSolution& first,
                                          const std::vector<double>& levels, Eigen::Index response, int harmonic) {
  std::vector<HarmonicSolution> peaks;
  for (const double level : levels) {
    auto next = peak_near(balance, peaks.empty() ? first : peaks.back(), level, response, harmonic);
    if (!next) break;
    peaks.push_back(std::move(*next));
  }
  return peaks;
}

}  // namespace jointid::response
