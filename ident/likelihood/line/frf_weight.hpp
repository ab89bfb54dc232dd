#pragma once

#include <complex>

namespace jointid::ident {

/// 1/σ of both parts of an FRF; 0 for a variance of 0 of an FRF of 0, which nothing is to be learnt from. No part is taken to be
/// more than 10⁴ times as exact as the other, and no FRF exact to more than 8 digits: weights beyond that say nothing that
/// arithmetic could use.
std::complex<double> frf_weight(std::complex<double> variance, std::complex<double> value);

/// `now` within a factor of two of `before`, part by part; `before` where `now` is no positive number.
std::complex<double> near_weight(std::complex<double> now, std::complex<double> before);

}  // namespace jointid::ident
