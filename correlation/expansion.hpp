#pragma once

#include <Eigen/Core>
#include <vector>

/// Motions at coordinates that were not measured, from those that were and a model.
namespace jointid::correlation {

using Places = std::vector<Eigen::Index>;

/// System equivalent reduction and expansion (O'Callahan, Avitabile & Riemer 1989): T = Φ Φ_b⁺ [coordinates × b], Φ the kept
/// modes [coordinate × mode] and Φ_b their rows at b. T x_b is the motion of all coordinates. Throws InputError where the modes
/// are not independent at b: then keep fewer.
Eigen::MatrixXcd serep(const Eigen::MatrixXcd& shapes, const Places& b);

/// Ways of system equivalent model mixing (Klaassen, van der Seijs & de Klerk 2018), overlay minus parent at b, removed at
///   basic: b alone, so that the dynamic stiffness changes at b alone;
///   extended: all coordinates, by Y_p(b,:)⁺ and Y_p(:,b)⁺.
enum class Semm { basic, extended };

/// FRFs Y of all coordinates at one line, from a parent model Y_p [n × n] and an overlay Y_o measured at b. Basic:
///   Y = Y_p − Y_p(:,b) Y_p,bb⁻¹ (Y_p,bb − Y_o) Y_p,bb⁻¹ Y_p(b,:).
/// Extended:
///   Y = Y_p − Y_p Y_p(b,:)⁺ (Y_p,bb − Y_o) Y_p(:,b)⁺ Y_p.
/// Both give the overlay at b, and the parent where the overlay is that of the parent. NaN where Y_p,bb is singular.
Eigen::MatrixXcd mixed(const Eigen::MatrixXcd& parent, const Eigen::MatrixXcd& overlay, const Places& b, Semm way);

}  // namespace jointid::correlation
