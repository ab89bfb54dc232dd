#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::gui {

/// An FRF to draw: receptance over frequency, NaN where it is not known.
struct Curve {
  std::string name;  ///< "assembly.h5 1:+Y / 5:+Y"
  frf::Dof response, reference;
  std::vector<double> frequency_hz;
  std::vector<Complex> values;
  std::vector<double> coherence;  ///< as long as values, or empty
  bool is_measured = true;        ///< false: computed, drawn dashed
  bool has_phase = true;          ///< false: the values are magnitudes
  std::string file{};             ///< where it is from
};

/// What is drawn of curves.
enum class View { magnitude_phase, real_imaginary, nyquist, coherence, difference, sum, cmif };

/// Views of many FRFs in a few curves, which are indicators() of them.
inline bool is_indicator(View view) { return view == View::sum || view == View::cmif; }

/// A diagram over frequency: one ordinate per curve, empty where a curve has none.
struct Panel {
  std::string label;
  bool logarithmic = false;
  std::vector<std::vector<double>> ordinates;
  double top = 0.0;  ///< of phases, the end of the period that they are in
};

inline constexpr const char* phase_label = "phase (°)";
inline constexpr const char* coherence_label = "coherence";

/// The diagrams of a view, one below the other, of FRFs as `quantity`; none for nyquist; for sum and CMIF the magnitudes. The
/// difference, in dB, is that of each curve that is not measured from the last one before it that is, which has to be over the
/// same lines.
/// `decibel`: magnitudes in dB over one unit, on a linear axis.
std::vector<Panel> panels(const std::vector<Curve>& curves, View view, frf::Quantity quantity, bool decibel = false);

/// The FRF as `quantity`.
std::vector<Complex> converted(const Curve& curve, frf::Quantity quantity);

/// "m/N", "rad/s²/(N·m)"; "SI" where the curves differ.
std::string unit_of(const std::vector<Curve>& curves, frf::Quantity quantity);

/// The line nearest to a frequency; curves have one at least.
std::size_t nearest_line(const Curve& curve, double frequency_hz);

/// What a readout states beside the values.
struct ReadoutStyle {
  bool decibel = false;
  std::optional<double> mark_hz{};  ///< a second cursor: the difference of the frequencies, and of every curve that of the magnitudes in dB
  std::size_t most = 6;             ///< curves
};

/// "1.23e-06 m/N ∠ −12.3°" of every curve at a frequency, a line each, below the frequency.
std::string readout(const std::vector<Curve>& curves, double frequency_hz, frf::Quantity quantity, const ReadoutStyle& style = {});

/// frequency_hz and the real and imaginary part of every curve, a column each; lines that a curve lacks are empty. Columns are
/// parted by a comma in files and a tab for spreadsheets.
std::string curves_table(const std::vector<Curve>& curves, frf::Quantity quantity, char separator);

}  // namespace jointid::gui
