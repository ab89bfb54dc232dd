#pragma once

#include "coupling/dependency.hpp"
#include "ident/result/control.hpp"
#include "ident/result/used_model.hpp"
#include "ident/scene/couple_scene.hpp"

namespace jointid::tasks {

/// A result file and its content.
struct CoupledFile {
  ident::Path path;
  std::size_t conditions = 0;         ///< compatibility conditions met on every line, unless a threshold drops some
  std::vector<double> resonances_hz;  ///< of the sum of the point FRFs' squares
};

/// Result of a coupling.
struct CoupleResult {
  ident::Status status = ident::Status::ok;  ///< rank_deficient: no line is usable
  std::string message;
  std::vector<std::string> notes;  ///< what speaks against FRFs of parts, and the origin of joints that other scenes identify
  std::size_t lines = 0, unusable_lines = 0, lines_without_partner = 0;
  std::size_t responses = 0, references = 0;
  std::vector<double> frequency_hz;           ///< [lines]
  std::vector<std::string> conditions;        ///< names of the compatibility conditions, see CoupledFile
  std::vector<coupling::LineRecord> records;  ///< by line
  std::optional<coupling::Dependencies> dependencies;
  std::vector<coupling::LineRecord> survey;  ///< by line, with the alphas of all of `dependencies`
  CoupledFile result;
  std::vector<ident::UsedModel> models{};  ///< of parts
  std::optional<CoupledFile> with_all;  ///< bounds: the same with the redundant conditions
};

/// Couples the parts of a scene line by line into `out` (jointid-frf HDF5). `bounds` finds redundant compatibility conditions and
/// writes FRFs with and without them. The natural frequencies of the real assembly lie between (docs/coupling.md, thesis §5.9.4).
/// The first file is `out`, the second has the name of `out` with .all before its extension. Throws InputError as
/// coupling::AssemblyReader, and Interrupted, with no file.
CoupleResult couple(const ident::CoupleScene& scene, const ident::Path& out, bool bounds, const ident::Control& control = {});

/// The result of a coupling in memory.
struct CoupledSets {
  CoupleResult result;  ///< its files have no paths
  frf::FrfSet frfs;     ///< receptances of the assembly, m/N; with variances if the scene asks for uncertainty
  std::optional<frf::FrfSet> with_all;  ///< bounds: with the redundant conditions
};

/// Couples parts in memory, in the order of `scene.names`; the files of the scene are not opened. Throws InputError also if there
/// are not as many parts as names, and for sets whose sizes do not agree (frf::validate()).
CoupledSets couple(const ident::CoupleScene& scene, std::vector<frf::FrfSet> parts, bool bounds = false,
                   const ident::Control& control = {});

/// Name of the file that `bounds` adds.
ident::Path with_all_path(const ident::Path& out);

}  // namespace jointid::tasks
