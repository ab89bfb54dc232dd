#include "gui/forms/field_hints.hpp"

#include <map>

#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

using Hints = std::map<std::string, const char*>;

const Hints& titles() {
  static const Hints all = {
      {"", QT_TRANSLATE_NOOP("Said", "Scene")},
      {"data", QT_TRANSLATE_NOOP("Said", "Data")},
      {"data.files.*", QT_TRANSLATE_NOOP("Said", "Data: missing information and corrections of a file")},
      {"data.gains", QT_TRANSLATE_NOOP("Said", "Data: uncertain gains and time delays")},
      {"data.masses", QT_TRANSLATE_NOOP("Said", "Data: mass loading by sensors")},
      {"joints", QT_TRANSLATE_NOOP("Said", "Joints")},
      {"frequency", QT_TRANSLATE_NOOP("Said", "Frequencies")},
      {"frequency.exclude_resonances", QT_TRANSLATE_NOOP("Said", "Frequencies near resonances")},
      {"joint", QT_TRANSLATE_NOOP("Said", "Joint")},
      {"joint.stiffness", QT_TRANSLATE_NOOP("Said", "Joint: stiffness K")},
      {"joint.mass", QT_TRANSLATE_NOOP("Said", "Joint: mass M")},
      {"joint.viscous_damping", QT_TRANSLATE_NOOP("Said", "Joint: viscous damping C")},
      {"joint.hysteretic_damping", QT_TRANSLATE_NOOP("Said", "Joint: hysteretic damping D")},
      {"identify", QT_TRANSLATE_NOOP("Said", "Identification")},
      {"identify.start", QT_TRANSLATE_NOOP("Said", "Identification: start")},
      {"noise", QT_TRANSLATE_NOOP("Said", "Noise")},
      {"noise.gross", QT_TRANSLATE_NOOP("Said", "Noise: outlier lines")},
      {"truth", QT_TRANSLATE_NOOP("Said", "Truth")},
      {"geometry", QT_TRANSLATE_NOOP("Said", "Geometry")},
      {"virtual_points", QT_TRANSLATE_NOOP("Said", "Virtual points")},
  };
  return all;
}

/// Of "table key", and of "* key" in the tables of matrices.
const Hints& hints() {
  static const Hints all = {
      {" title", QT_TRANSLATE_NOOP("Said", "name of the scene")},
      {" nodes", QT_TRANSLATE_NOOP("Said", "positions in m: { \"4\" = [0.9, 0, 0], … }")},
      {"geometry lines", QT_TRANSLATE_NOOP("Said", "lines of the picture between nodes: [[4, 5], [5, 12]]")},
      {"data substructures", QT_TRANSLATE_NOOP("Said", "files of the substructures, without the joint")},
      {"data assembly", QT_TRANSLATE_NOOP("Said", "files of the assembly, with the joint")},
      {"data gains", QT_TRANSLATE_NOOP("Said", "uncertain gains and time delays of sensors: { gain = 0.01 }")},
      {"data masses", QT_TRANSLATE_NOOP("Said", "mass loading by sensors, in kg, and its uncertainty")},
      {"data nodes", QT_TRANSLATE_NOOP("Said", "positions of nodes: a table node, x [mm], y [mm], z [mm], or UFF")},
      {"data reciprocity", QT_TRANSLATE_NOOP("Said", "whether reciprocity replaces a missing FRF: H_ij by H_ji")},
      {"data regenerate", QT_TRANSLATE_NOOP("Said", "FRFs to synthesise from modal models: substructures, assembly")},
      {"data files", QT_TRANSLATE_NOOP("Said", "missing information and corrections, file by file")},
      {"data.gains dofs", QT_TRANSLATE_NOOP("Said", "DOFs of the sensors. Empty: all DOFs. 4:+Y, 5:+Y")},
      {"data.gains files", QT_TRANSLATE_NOOP("Said", "files. Empty: all")},
      {"data.gains role", QT_TRANSLATE_NOOP("Said", "of sensors (response), or of hammer and shaker (reference)")},
      {"data.gains gain", QT_TRANSLATE_NOOP("Said", "standard deviation of the gain about 1: 0.01")},
      {"data.gains delay", QT_TRANSLATE_NOOP("Said", "standard deviation of the time delay about 0, in s: 1e-6")},
      {"data.gains angle", QT_TRANSLATE_NOOP("Said", "standard deviation of a sensor's misalignment, in rad: 0.02")},
      {"data.gains shared", QT_TRANSLATE_NOOP("Said", "one error is shared by: files, nothing (none) or all")},
      {"data.masses dofs", QT_TRANSLATE_NOOP("Said", "responses of the roving sensor: 4:+Y, 5:+Y")},
      {"data.masses files", QT_TRANSLATE_NOOP("Said", "files")},
      {"data.masses mass", QT_TRANSLATE_NOOP("Said", "of the sensor, in kg; its effect is removed: 0.003")},
      {"data.masses deviation", QT_TRANSLATE_NOOP("Said", "standard deviation of that mass, in kg. Empty: exactly known")},
      {"data.masses shared", QT_TRANSLATE_NOOP("Said", "one error is shared by: files, nothing (none) or all")},
      {"virtual_points name", QT_TRANSLATE_NOOP("Said", "VP and a number: VP1")},
      {"virtual_points position", QT_TRANSLATE_NOOP("Said", "in m, the centre of its rotations: [0.9, 0, 0]")},
      {"virtual_points plane", QT_TRANSLATE_NOOP("Said", "for three motions only: the plane of its two translations")},
      {"virtual_points flexible", QT_TRANSLATE_NOOP("Said", "interface deformation modes (flexible): ex, ey")},
      {"virtual_points sensors", QT_TRANSLATE_NOOP("Said", "responses around it: 11:+X, 11:+Y, 12:+Z")},
      {"virtual_points impacts", QT_TRANSLATE_NOOP("Said", "references around it: 31:+X, 31:+Y, 32:+Z")},
      {"virtual_points directions", QT_TRANSLATE_NOOP("Said", "of sensors not along an axis: { \"13:+Y\" = [0, 0.6, 0.8] }")},
      {"virtual_points impact_directions",
       QT_TRANSLATE_NOOP("Said", "of impacts not along an axis: { \"33:+Y\" = [0, 0.6, 0.8] }")},
      {"virtual_points weights", QT_TRANSLATE_NOOP("Said", "of sensors in the fit: { \"13:+Y\" = 0.5 }")},
      {"virtual_points impact_weights", QT_TRANSLATE_NOOP("Said", "of impacts in the fit: { \"33:+Y\" = 0.5 }")},
      {"virtual_points files", QT_TRANSLATE_NOOP("Said", "files. Empty: all that have its sensors")},
      {"data.files.* quantity", QT_TRANSLATE_NOOP("Said", "receptance, mobility or accelerance, in place of the file's")},
      {"data.files.* unit", QT_TRANSLATE_NOOP("Said", "of its FRFs, if missing or wrong: g/lbf")},
      {"data.files.* dofs", QT_TRANSLATE_NOOP("Said", "of its responses: 4:+Y, 5:+Y")},
      {"data.files.* reference_dofs", QT_TRANSLATE_NOOP("Said", "of its references. Empty: those of the responses")},
      {"data.files.* variable", QT_TRANSLATE_NOOP("Said", "variable of a MATLAB file with the FRFs")},
      {"data.files.* frequency_variable", QT_TRANSLATE_NOOP("Said", "variable with its frequencies")},
      {"data.files.* frequency_unit", QT_TRANSLATE_NOOP("Said", "of its frequencies, if missing or wrong: kHz, rad/s")},
      {"data.files.* mass", QT_TRANSLATE_NOOP("Said", "of the structure as weighed, hung free, in kg")},
      {"data.files.* nodes", QT_TRANSLATE_NOOP("Said", "positions of the nodes of this file: a table, or UFF")},
      {"data.files.* model", QT_TRANSLATE_NOOP("Said", "model of the same structure that the check compares: bracket.toml")},
      {"data.files.* frequency_scale", QT_TRANSLATE_NOOP("Said", "true frequency divided by that of the file: 0.5 to 2")},
      {"data.files.* rename", QT_TRANSLATE_NOOP("Said", "sensors: { \"OLD\" = \"NEW\" }, { \"4:+Y\" = \"5:+Y\" }")},
      {"data.files.* rename_reference", QT_TRANSLATE_NOOP("Said", "hammer or shaker: { \"4:+Y\" = \"5:+Y\" }")},
      {"data.files.* conjugate", QT_TRANSLATE_NOOP("Said", "whether the file has the complex conjugates")},
      {"data.files.* delay", QT_TRANSLATE_NOOP("Said", "time delay of its responses, in s: 20e-6")},
      {"data.files.* gain", QT_TRANSLATE_NOOP("Said", "true FRF divided by that of the file: 9.80665, or { \"4:+Y\" = 1.02 }")},
      {"data.files.* gain_reference", QT_TRANSLATE_NOOP("Said", "of hammer or shaker: { \"4:+Y\" = 1.02 }")},
      {"data.files.* flip", QT_TRANSLATE_NOOP("Said", "sensors with the wrong sign: 4:+Y")},
      {"data.files.* flip_reference", QT_TRANSLATE_NOOP("Said", "directions of hammer or shaker with the wrong sign: 4:+Y")},
      {"data.files.* sensor_mass", QT_TRANSLATE_NOOP("Said", "mass of the sensors, in kg: { \"4:+Y\" = 0.005 }")},
      {"data.files.* sensors", QT_TRANSLATE_NOOP("Said", "which of these masses are mounted at the same time")},
      {"joints name", QT_TRANSLATE_NOOP("Said", "of the joint, before its unknowns: left")},
      {"frequency range", QT_TRANSLATE_NOOP("Said", "lowest and highest frequency in Hz: 400, 1000")},
      {"frequency step", QT_TRANSLATE_NOOP("Said", "only the lines nearest to lo, lo + step, …, in Hz")},
      {"frequency exclude", QT_TRANSLATE_NOOP("Said", "bands left out, in Hz: [[560, 566], [700, 702]]")},
      {"frequency exclude_resonances",
       QT_TRANSLATE_NOOP("Said", "lines near resonances left out: { of = [\"assembly\"], half_width = 0.01 }")},
      {"frequency.exclude_resonances of", QT_TRANSLATE_NOOP("Said", "whose resonances: substructures, assembly")},
      {"frequency.exclude_resonances half_width", QT_TRANSLATE_NOOP("Said", "half the width left out, relative: 0.01")},
      {"joint dofs", QT_TRANSLATE_NOOP("Said", "interface DOFs of both sides: 4:+Y, 4:+RZ, 5:+Y, 5:+RZ")},
      {"joint bands", QT_TRANSLATE_NOOP("Said", "bands that are identified separately, in Hz: [[100, 200], [200, 400]]")},
      {"joint couple_first", QT_TRANSLATE_NOOP("Said", "pairs coupled rigidly beforehand: [[\"4:+X\", \"5:+X\"]]")},
      {"* pattern", QT_TRANSLATE_NOOP("Said", "which elements are unknown")},
      {"* matrix", QT_TRANSLATE_NOOP("Said", "element by element: [[\"a\", \"-a\"], [\"-a\", \"a\"]]; numbers are known")},
      {"* springs", QT_TRANSLATE_NOOP("Said", "between two DOFs, or one and ground: [[\"4:+Y\", \"5:+Y\"]]")},
      {"* definite", QT_TRANSLATE_NOOP("Said", "whether it is required to be positive semidefinite")},
      {"* stiffness", QT_TRANSLATE_NOOP("Said", "N/m, N, N·m: [[1e6, -1e6], [-1e6, 1e6]]")},
      {"* mass", QT_TRANSLATE_NOOP("Said", "kg, kg·m, kg·m²: [[0, 0], [0, 0]]")},
      {"* viscous_damping", QT_TRANSLATE_NOOP("Said", "N·s/m, N·s, N·m·s: [[10, -10], [-10, 10]]")},
      {"* hysteretic_damping", QT_TRANSLATE_NOOP("Said", "N/m, N, N·m: [[1e4, -1e4], [-1e4, 1e4]]")},
      {"identify method", QT_TRANSLATE_NOOP("Said", "method of identification")},
      {"identify equations", QT_TRANSLATE_NOOP("Said", "blocks of the assembly to explain: nn, nj, jj, jn")},
      {"identify weighting", QT_TRANSLATE_NOOP("Said", "of the equations of linear methods")},
      {"identify delta", QT_TRANSLATE_NOOP("Said", "drops equations whose sides differ by less than Δ: 0 to 2")},
      {"identify solver", QT_TRANSLATE_NOOP("Said", "numerical solver of the method")},
      {"identify start", QT_TRANSLATE_NOOP("Said", "start of iterations: { stiffness = [[1e6, -1e6], [-1e6, 1e6]] }")},
      {"identify starts", QT_TRANSLATE_NOOP("Said", "how many starts are followed")},
      {"identify variance", QT_TRANSLATE_NOOP("Said", "where the variances of the FRFs come from")},
      {"identify smooth_variance", QT_TRANSLATE_NOOP("Said", "whether a noise model replaces the variances of files")},
      {"identify priors",
       QT_TRANSLATE_NOOP("Said", "prior knowledge, value and standard deviation: { \"K(1,1)\" = [6.6e5, 1e4] }")},
      {"identify bounds", QT_TRANSLATE_NOOP("Said", "of unknowns: { \"K(1,1)\" = [0, 1e6], \"D.a\" = \"positive\" }")},
      {"identify ties", QT_TRANSLATE_NOOP("Said", "equations between unknowns: [\"K(1,1) = K(3,3)\"]")},
      {"identify inequalities", QT_TRANSLATE_NOOP("Said", "linear, between unknowns: [\"K(1,1) >= 2*K(2,2)\"]")},
      {"identify passive", QT_TRANSLATE_NOOP("Said", "band in Hz over which the damping of every joint is passive: 100, 400")},
      {"identify frequencies", QT_TRANSLATE_NOOP("Said", "eigenfrequencies of the assembly, in Hz: 83.2, 140.6")},
      {"identify loose", QT_TRANSLATE_NOOP("Said", "whether joints with nominal stiffness are tested for being loose")},
      {"identify bootstrap", QT_TRANSLATE_NOOP("Said", "how many replicates: 0, or 100 and more")},
      {"identify bootstrap_seed", QT_TRANSLATE_NOOP("Said", "of the random numbers of the bootstrap")},
      {"noise model", QT_TRANSLATE_NOOP("Said", "model of the measurement noise")},
      {"noise level", QT_TRANSLATE_NOOP("Said", "noise relative to |H|: 0.01")},
      {"noise coherence", QT_TRANSLATE_NOOP("Said", "of a hammer test: 0.998")},
      {"noise averages", QT_TRANSLATE_NOOP("Said", "of a hammer test: 5")},
      {"noise overlap", QT_TRANSLATE_NOOP("Said", "of the averages: 0 to 1")},
      {"noise floor", QT_TRANSLATE_NOOP("Said", "constant noise relative to the rms of the FRF")},
      {"noise gross", QT_TRANSLATE_NOOP("Said", "outlier lines: { share = 0.02, factor = 10 }")},
      {"noise.gross share", QT_TRANSLATE_NOOP("Said", "share of outlier lines: 0.02")},
      {"noise.gross factor", QT_TRANSLATE_NOOP("Said", "factor of their noise: 10")},
      {"noise sign_errors", QT_TRANSLATE_NOOP("Said", "probability of a flipped sensor direction")},
      {"noise position_errors", QT_TRANSLATE_NOOP("Said", "standard deviation of a DOF's position, in m")},
      {"noise gain_errors", QT_TRANSLATE_NOOP("Said", "of studies: standard deviation of the gain of every sensor: 0.01")},
      {"noise mass_errors", QT_TRANSLATE_NOOP("Said", "of studies: standard deviation of the mass of every sensor, in kg")},
      {"noise reciprocal", QT_TRANSLATE_NOOP("Said", "whether reciprocal pairs H_ij, H_ji share their noise")},
  };
  return all;
}

bool is_of_matrices(const std::string& table) {
  return table.starts_with("joint.") || table == "joint" || table == "truth" || table == "identify.start";
}

}  // namespace

QString hint_of(const std::string& table, const std::string& key) {
  for (const std::string& place : {table, std::string(is_of_matrices(table) ? "*" : "")}) {
    const auto found = hints().find(place + " " + key);
    if (found != hints().end()) return said(found->second);
  }
  return {};
}

QString title_of(const std::string& table) {
  const auto found = titles().find(table);
  return found == titles().end() ? q(table) : said(found->second);
}

}  // namespace jointid::gui
