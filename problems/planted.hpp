#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ident/result/suspect.hpp"
#include "problems/problem.hpp"

namespace jointid::problems {

/// A measurement with one mistake in it, and what a check should say of it.
struct Planted {
  Measurement data;
  ident::SuspectKind kind = ident::SuspectKind::sign;
  std::vector<std::string> files;  ///< any of these is right
  std::vector<frf::Dof> dofs;      ///< all of them; empty: the whole file
};

/// The mistakes that plant() knows: sign, swap, label, gain, unit, quantity, conjugate, delay, axis, mass, dead, copy, loose,
/// exchange.
const std::vector<ident::SuspectKind>& plantable();

/// The problem's FRFs with `noise` and one mistake; file and channels follow from the seed.
///   sign      a sensor points the other way (one response of one file)
///   swap      two sensors of the assembly have each other's labels
///   label     a sensor of the assembly has the label of a node that does not exist
///   gain      a sensor of the assembly reads 2 % too much
///   unit      the assembly in g (even seeds), or the first part in mm
///   quantity  a file whose FRFs are mobilities taken for what it says, the assembly (even) or the first part
///   conjugate all files (even), or the assembly
///   delay     20 µs in the assembly
///   axis      the assembly's frequencies are 1 % too high
///   mass      sensors of 3 g, on the blocks of `bolts` 20 g, at the translations of the assembly, roving
///   dead      a sensor of the assembly gives zero
///   copy      a sensor of the assembly gives what another gives
///   loose     the assembly is the parts side by side
///   exchange  the FRFs of two parts of equal size are exchanged; else the first part's file holds those of the assembly
Planted plant(const Problem& problem, ident::SuspectKind kind, const frf::NoiseModel& noise, std::uint64_t seed);

/// Whether the first suspect is the planted one: kind, file and, where there are any, DOFs.
bool is_found(const Planted& planted, const std::vector<ident::Suspect>& suspects);

}  // namespace jointid::problems
