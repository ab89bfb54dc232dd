#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "friction/joint/joint_mesh.hpp"
#include "friction/path/element.hpp"

namespace jointid::tasks {

/// The normal load along a cycle over the one that the law belongs to: max(0, 1 + Σ share · sin(nθ + phase)), θ = 2πt/T.
struct NormalLoad {
  int harmonic = 1;
  double share = 0.0;
  double phase = 0.0;  ///< rad
};

/// A scene of one joint by itself: its law or its finite-element mesh, and the history that it is moved along.
struct JointHistoryScene {
  std::string title;
  std::shared_ptr<const friction::Element> law;  ///< none where there is a mesh
  std::optional<friction::JointMesh> mesh{};
  bool by_force = false;           ///< the history is of forces, N; else of displacements, m
  std::vector<double> turns{};     ///< from rest to each of them in turn, in `points` equal steps
  std::size_t points = 50;
  double amplitude = 0.0;          ///< instead of turns: x = amplitude · sin θ, m
  std::size_t cycles = 3, steps = 720;  ///< of it, a cycle
  std::vector<NormalLoad> normal{};     ///< of sine motion
  std::vector<double> shares{};         ///< h of which u(h) is asked, 0 ≤ h < 1
  std::size_t sliders = 0;              ///< algorithm A with so many; 0: Masing paths, exact (algorithm B)
};

/// Reads a scene with [joint] or [mesh], and [history]. Throws InputError (usage).
JointHistoryScene read_joint_history(const std::filesystem::path& file);
JointHistoryScene parse_joint_history(const std::string& text, const std::filesystem::path& file);

struct HistoryPoint {
  double displacement = 0.0;  ///< m, of the loaded end
  double force = 0.0;         ///< N
  double load = 1.0;          ///< normal load over the nominal one
};

/// Displacements and interface forces of the nodes of a mesh, at the end of a part of the history.
struct NodeState {
  std::vector<double> displacement, force;
};

/// Where the initial curve T(u) has a kink: slip begins, macroslip.
struct JointHistory {
  std::vector<HistoryPoint> points;
  std::vector<std::size_t> ends;    ///< index of the point where each turn, or each cycle, ends
  std::vector<double> work{};       ///< ∫F dx up to each of the ends (over the cycle that ends there, of a sine), J
  std::vector<double> mean{};       ///< of F over the cycle, of a sine
  std::vector<NodeState> nodes{};   ///< of a mesh, at each of the ends
  double stiffness = 0.0;           ///< T′(0), N/m
  std::optional<double> limit{};    ///< N; none where there is none
  std::vector<double> slip_displacements{};  ///< u(h) of the shares, T′(u) = T′(0)(1 − h); infinite where it is nowhere so flat
  std::vector<HistoryPoint> kinks{};  ///< T at the displacements where it is not analytic
};

/// Forces along the history. Throws InputError (usage) for a force that no displacement reaches.
JointHistory run_joint_history(const JointHistoryScene& scene);

}  // namespace jointid::tasks
