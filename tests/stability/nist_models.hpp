#pragma once

#include <complex>
#include <span>
#include <string>

namespace jointid::stability {

/// The model functions of NIST's nonlinear problems, y = f(x; b); of Nelson ln y. Of complex b too, for derivatives by complex steps.
double nist_model(const std::string& name, std::span<const double> x, std::span<const double> b);
std::complex<double> nist_model(const std::string& name, std::span<const double> x, std::span<const std::complex<double>> b);

}  // namespace jointid::stability
