#pragma once

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"

/// FRFs as curves of a page.
namespace jointid::report {

/// |H|; NaN for zero, which has no place on a logarithmic axis.
std::vector<double> magnitudes(std::span<const std::complex<double>> frf);

/// Phases in degrees at some of the points.
std::vector<double> phases_deg(std::span<const std::complex<double>> frf, std::span<const std::size_t> indices);

/// "receptance (m/N)", with rad and N·m for rotations.
std::string receptance_label(const frf::Dof& response, const frf::Dof& reference);

/// "16 of 256 FRFs, …" where not all are drawn, else empty.
std::string drawn_text(std::size_t drawn, std::size_t all);

}  // namespace jointid::report
