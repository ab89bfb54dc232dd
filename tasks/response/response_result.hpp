#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "response/continuation/peak_damping.hpp"
#include "response/continuation/response_curve.hpp"
#include "response/equivalent/equivalent_mode.hpp"
#include "response/fourier/joint_loop.hpp"
#include "response/harmonic/deviations.hpp"
#include "tasks/response/response_scene.hpp"

namespace jointid::tasks {

/// Check of a harmonic-balance solution by event-exact marching from it.
struct PointStability {
  bool known = false;  ///< an orbit was found
  bool stable = false;
  bool another = false;                            ///< the orbit found is not that of the solution
  double largest = 0.0;                            ///< largest |μ| of the multipliers
  double difference = 0.0;                         ///< distance of the exact orbit from the solution, relative to the motion
  std::vector<Complex> multipliers{};              ///< μ over a period, the largest |μ| first
  std::vector<std::string> residual_force_free{};  ///< names of joints whose mean force is not determined
};

/// The periodic responses at one force level.
struct LevelResponse {
  double level = 0.0;  ///< N
  std::vector<response::HarmonicSolution>
      points{};  ///< a solution a frequency: X [harmonics, responses] m, Q and F of the joints
  std::vector<response::ResponseDeviations> deviations{};  ///< of the points; empty if nothing is known
  std::vector<Eigen::MatrixXd>
      left_out{};  ///< of the points, error bars of dropped harmonics, [harmonics, responses] m; none when none was
  std::optional<double> peak_deviation{};            ///< standard deviation of |X| at the peak, m
  std::optional<response::HarmonicSolution> peak{};  ///< largest |X| of the first response and lowest harmonic above 0
  bool refined = false;                              ///< the peak lies between points
  std::optional<response::PeakMode> peak_mode{};     ///< ω (rad/s) and ζ of the mode that makes the peak
  double line_spacing_hz = 0.0;                      ///< at the peak, of FRFs that are known at lines only; else 0
  std::vector<PointStability> stability{};           ///< of the points; empty if not asked for, or for many points
  std::optional<PointStability> peak_stability{};
  std::vector<response::JointLoop> loops{};                  ///< of the joints at the peak
  std::vector<response::HarmonicSolution> turning_points{};  ///< where the curve turns back; of CurveMethod::arc_length
  bool complete = true;                                      ///< every point converged, the curve reached its end
};

/// Result of one of [[curves]].
struct CurveRun {
  SceneCurve curve;
  std::string name;  ///< of what it is along, with its unit
  response::ResponseCurve found;
};

/// Result of one amplitude of [equivalent].
struct EquivalentRow {
  double amplitude = 0.0;                           ///< |Q₁| of the joint asked for, m
  std::vector<response::EquivalentJoint> joints{};  ///< all at this amplitude; with a mode, at those that the mode gives them
  std::optional<response::EquivalentMode> mode{};
  std::string problem{};  ///< the reason if there is no mode
};

/// The peak over frequency under one normal load.
struct ClampedPeak {
  double load = 0.0;                        ///< over the one that the laws belong to
  std::optional<double> amplitude{};        ///< |X| of the first response and lowest harmonic above 0, m; none where nothing converged
  double frequency_hz = 0.0;
  bool complete = true;                     ///< every frequency converged
};

/// Result of [clamping] at one force level.
struct ClampingRun {
  double level = 0.0;                    ///< N
  std::optional<double> nominal{};       ///< the normal load that the laws belong to, N
  std::vector<ClampedPeak> peaks{};      ///< by load, ascending; those tried on the way to the best among them
  std::optional<ClampedPeak> best{};     ///< of least amplitude
  bool at_end = false;                   ///< of the range: the least lies beyond
  std::array<double, 2> within_tenth{};  ///< loads up to which no amplitude is more than a tenth above the least
};

/// One motion of [transient].
struct TransientRun {
  std::string name;  ///< "pulse of 5 N, 0.01 s", "1 N at 50 Hz", "record"
  response::Transient motion;
};

/// Results of run_response(), SI units: m, N, s, J; frequencies ω of response/ in rad/s. Parts that the scene does not ask for
/// are empty.
struct ResponseResult {
  std::vector<std::string> dofs, joints;     ///< names of the responses and of the joints
  std::vector<LevelResponse> levels;         ///< one for each amplitude of [force]
  std::vector<CurveRun> curves{};            ///< one for each of [[curves]]
  std::vector<EquivalentRow> equivalents{};  ///< one for each amplitude of [equivalent]
  std::vector<std::string> marched{};        ///< friction elements and cubic springs: the columns of q and f of transients
  std::vector<ClampingRun> clampings{};      ///< one for each amplitude of [force], with [clamping]
  std::vector<TransientRun> transients{};    ///< one for each pulse, record or force level of [transient]
  std::vector<std::string> doubts;           ///< of the measured parts, one phrase each
};

/// What an interrupted run has: the first levels of the scene, and the first points of the next one.
struct LevelsSoFar {
  std::vector<LevelResponse> finished{};
  std::vector<response::HarmonicSolution> begun{};
};

/// Gets the same; may throw to end the run.
using KeepLevels =
    std::function<void(const std::vector<LevelResponse>& finished, const std::vector<response::HarmonicSolution>& begun)>;

/// Row of the lowest harmonic above 0.
Eigen::Index first_row(const response::HarmonicSolution& solution);

/// Largest number of points for which all are printed and checked for stability.
inline constexpr std::size_t most_told = 40;

/// Whether the curve reached its end and every point of it converged.
bool is_complete(const LevelResponse& level);

/// Whether all requested results exist.
bool all_converged(const ResponseResult& run);

}  // namespace jointid::tasks
