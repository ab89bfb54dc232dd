#pragma once

#include "coupling/dependency.hpp"
#include "ident/result/control.hpp"
#include "ident/scene/couple_scene.hpp"

namespace jointid::tasks {

/// A result file and what stands in it.
struct CoupledFile {
  ident::Path path;
  std::size_t conditions = 0;         ///< met on every line, unless a threshold drops some
  std::vector<double> resonances_hz;  ///< of the sum of the point FRFs' squares
};

/// What coupling did.
struct CoupleResult {
  ident::Status status = ident::Status::ok;  ///< rank_deficient: no line is usable
  std::string message;
  std::vector<std::string> notes;  ///< where joints came from that other scenes identify
  std::size_t lines = 0, unusable_lines = 0, lines_without_partner = 0;
  std::size_t responses = 0, references = 0;
  std::vector<double> frequency_hz;
  std::vector<std::string> conditions;        ///< names of those met on every line, unless a threshold drops some
  std::vector<coupling::LineRecord> records;  ///< by line
  std::optional<coupling::Dependencies> dependencies;
  std::vector<coupling::LineRecord> survey;  ///< by line, with the alphas of all of `dependencies`
  CoupledFile result;
  std::optional<CoupledFile> with_all;  ///< bounds: the same with the dependent conditions
};

/// Couples the parts of a scene line by line into `out` (jointid-frf HDF5). `bounds`: finds conditions that the others nearly
/// imply, and writes FRFs with and without them; the natural frequencies of the real assembly lie between (docs/coupling.md,
/// thesis §5.9.4). The first is `out`, the second has the name of `out` with .all before its extension. Throws InputError as
/// coupling::AssemblyReader, and Interrupted, with no file.
CoupleResult couple(const ident::CoupleScene& scene, const ident::Path& out, bool bounds, const ident::Control& control = {});

/// The file that `bounds` adds.
ident::Path with_all_path(const ident::Path& out);

}  // namespace jointid::tasks
