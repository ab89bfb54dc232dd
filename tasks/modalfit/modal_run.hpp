#pragma once

#include <complex>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "frf/uff/uff55.hpp"
#include "ident/scene/scene.hpp"
#include "modalfit/model/fit.hpp"
#include "modalfit/model/symmetric_model.hpp"
#include "modalfit/model/synthesis.hpp"

namespace jointid::tasks {

/// A modal fit and its quality: the result of `jointid modalfit`.
struct ModalRun {
  std::string files;  ///< as given by the user
  frf::FrfHeader header;
  modalfit::Band band;     ///< the receptances that were fitted, m/N, [response × reference, line]
  modalfit::ModalFit fit;  ///< poles (Hz, damping ratios or loss factors) with standard deviations, residues, status
  std::optional<modalfit::SymmetricModel> symmetric;
  std::string obstacle;     ///< the reason if there is no symmetric model
  frf::FrfSet regenerated;  ///< synthesised FRFs at the band's lines and entries, by the symmetric model if there is one
  std::vector<modalfit::SynthesisError> of_fit, of_model;  ///< per entry; of_model is empty without a symmetric model
  double read_s = 0.0, fit_s = 0.0;                        ///< seconds that reading and fitting took
};

/// Fits the FRFs of a set and judges the fit. Stopped by `options.interrupted` it returns the modes found so far, marked as such;
/// without modes it throws Interrupted. Throws InputError as modalfit::make_band().
ModalRun run_modal(const std::string& name, const frf::FrfSet& set, const modalfit::FitOptions& options);

/// The same for the files of one structure (frf::open_as_one()), with their names.
ModalRun run_modal_files(const std::vector<std::filesystem::path>& files, const frf::OpenOptions& open,
                         const modalfit::FitOptions& options);

/// All FRFs of the files of a structure, corrected as a scene says, repeats as their mean. Throws InputError.
frf::FrfSet load_structure(const std::vector<ident::DataFile>& files);

/// Shapes over some coordinates, one per mode: those of the symmetric model, else the largest residues of one reference (of
/// arbitrary scale).
struct Shapes {
  std::vector<frf::Dof> dofs;
  std::vector<std::vector<std::complex<double>>> of_mode;
};
Shapes shapes(const ModalRun& run);

/// The modes for dataset 55 (docs/modal-models.md).
std::vector<frf::Uff55Mode> uff_modes(const ModalRun& run);

/// Write the files of `jointid modalfit --regenerate` and `--shapes`. Throw InputError.
void write_regenerated(const ModalRun& run, const std::filesystem::path& path);
void write_shapes(const ModalRun& run, const std::filesystem::path& path);

}  // namespace jointid::tasks
