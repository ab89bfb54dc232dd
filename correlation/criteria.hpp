#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// Criteria by which two FRFs or two sets of shapes look alike: 1 for equal ones. None knows of noise: an FRAC of 0.99 may be ten
/// standard deviations. Numbers that are NaN in either are left out; a criterion of nothing, or of zeros alone, is NaN.
namespace jointid::correlation {

using Complex = std::complex<double>;

/// Neither part is NaN or infinite.
bool is_number(Complex a);

/// Frequency response assurance criterion of one FRF over its lines, |Σ a b*|²/(Σ|a|² Σ|b|²) (Heylen & Lammens 1996). It does not
/// see a factor. Noise of level p leaves 1 − FRAC ≈ p²(1 − Σ|a|⁴/(Σ|a|²)²): the highest peak alone counts.
double frac(std::span<const Complex> a, std::span<const Complex> b);

/// Frequency domain assurance criterion (Pascual, Golinval & Razeto 1997) of two columns of FRFs [responses × lines],
/// |a(ω₁)ᴴ b(ω₂)|²/(|a|²|b|²), lines of a in rows. Its diagonal is the shape criterion of each line. It does not see a factor.
Eigen::MatrixXd fdac(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b);

/// Amplitude criterion of one line over responses, 2|aᴴb|/(aᴴa + bᴴb): it sees a factor.
double amplitude_criterion(std::span<const Complex> a, std::span<const Complex> b);

/// Local amplitude criterion of one value, 2|a* b|/(|a|² + |b|²): it does not see phase.
double lac(Complex a, Complex b);

/// Coherence criterion of one value, |a + b|²/(2(|a|² + |b|²)): it sees amplitude and phase.
double coherence_criterion(Complex a, Complex b);

/// Modal assurance criteria of two sets of shapes [coordinate × mode], those of the first in rows.
Eigen::MatrixXd mac_matrix(const Eigen::MatrixXcd& one, const Eigen::MatrixXcd& other);

/// Of every mode of the rows its partner among the columns: pairs by falling MAC, each once, down to `least`.
std::vector<std::optional<std::size_t>> paired(const Eigen::MatrixXd& mac, double least = 0.0);

/// Coordinate MAC of paired shapes [coordinate × pair], (Σ_r|φ_pr ψ_pr*|)²/(Σ_r|φ_pr|² Σ_r|ψ_pr|²) (Lieven & Ewins 1988). It sees
/// the factor between the shapes of a pair where that differs from pair to pair.
Eigen::VectorXd comac(const Eigen::MatrixXcd& one, const Eigen::MatrixXcd& other);

/// Enhanced CoMAC of paired shapes, Σ_r|φ_pr − ψ_pr|/(2R) over R pairs of shapes of unit length and matched phase (Hunt 1992): 0
/// for equal ones.
Eigen::VectorXd ecomac(const Eigen::MatrixXcd& one, const Eigen::MatrixXcd& other);

}  // namespace jointid::correlation
