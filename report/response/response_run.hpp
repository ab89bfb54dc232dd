#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/response/response_scene.hpp"
#include "ident/result/control.hpp"
#include "response/continuation/peak_damping.hpp"
#include "response/continuation/response_curve.hpp"
#include "response/equivalent/equivalent_mode.hpp"
#include "response/fourier/joint_loop.hpp"
#include "response/harmonic/deviations.hpp"

namespace jointid::report {

/// What event-exact marching from a solution says of it.
struct PointStability {
  bool known = false;  ///< an orbit was found
  bool stable = false;
  bool another = false;     ///< the orbit that was found is not the solution's
  double largest = 0.0;     ///< |μ|
  double difference = 0.0;  ///< of the exact orbit from the solution, in parts of the motion
  std::vector<Complex> multipliers{};
  std::vector<std::string> residual_force_free{};  ///< joints
};

/// The responses to one force level.
struct LevelResponse {
  double level = 0.0;  ///< N
  std::vector<response::HarmonicSolution> points{};
  std::vector<response::ResponseDeviations> deviations{};  ///< of the points; none when nothing is known
  std::vector<Eigen::MatrixXd> left_out{};                 ///< of the points, error bars of dropped harmonics; none when none was
  std::optional<double> peak_deviation{};                  ///< of |X| at the peak
  std::optional<response::HarmonicSolution> peak{};        ///< largest |X| of the first response and lowest harmonic above 0
  bool refined = false;                                    ///< the peak lies between points
  std::optional<response::PeakMode> peak_mode{};
  double line_spacing_hz = 0.0;  ///< at the peak, of FRFs that are known at lines only; 0 where they are known between
  std::vector<PointStability> stability{};  ///< of the points; none when not asked for, or there are many
  std::optional<PointStability> peak_stability{};
  std::vector<response::JointLoop> loops{};  ///< of the joints at the peak
  std::vector<response::HarmonicSolution> turning_points{};
  bool complete = true;  ///< every point converged, the curve reached its end
};

/// One of [[curves]].
struct CurveRun {
  SceneCurve curve;
  std::string name;  ///< of what it is along, with its unit
  response::ResponseCurve found;
};

/// One amplitude of [equivalent].
struct EquivalentRow {
  double amplitude = 0.0;
  std::vector<response::EquivalentJoint> joints{};  ///< all at this amplitude; with a mode, at those that the mode gives them
  std::optional<response::EquivalentMode> mode{};
  std::string problem{};  ///< why there is no mode
};

/// One motion of [transient].
struct TransientRun {
  std::string name;  ///< "pulse 1", "1 N"
  response::Transient motion;
};

struct ResponseRun {
  std::vector<std::string> dofs, joints;
  std::vector<LevelResponse> levels;
  std::vector<CurveRun> curves{};
  std::vector<EquivalentRow> equivalents{};
  std::vector<std::string> marched{};  ///< friction elements and cubic springs: the columns of transients
  std::vector<TransientRun> transients{};
  std::vector<std::string> doubts;  ///< one phrase each
};

/// Hands on how far a run is, if anybody wants to know.
void tell(const ident::Control& control, const std::string& stage, std::size_t done = 0, std::size_t total = 0);

/// Row of the lowest harmonic above 0.
Eigen::Index first_row(const response::HarmonicSolution& solution);

/// Points up to which all of them are printed, and their stability is found.
inline constexpr std::size_t most_told = 40;

/// Whether everything that was asked for has an answer.
bool all_converged(const ResponseRun& run);

}  // namespace jointid::report
