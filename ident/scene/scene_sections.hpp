#pragma once

#include "ident/scene/scene.hpp"
#include "scene/if_readable.hpp"
#include "scene/reader.hpp"

namespace jointid::ident {

/// The keys of [data.files."NAME"] that put the FRFs of a file right, and what they say.
std::vector<std::string> correction_keys();
frf::Corrections read_corrections(const scene::Table& table);

/// [data]; paths are resolved against `folder`.
DataSection read_data(const scene::Item& item, const Path& folder);

using scene::if_readable;

/// The files of [data] that can be read, with the options and corrections that can; none of them need be there. `parts` are
/// substructures, too.
DataSection readable_data(const scene::Item& item, const Path& folder);

/// A file, or a run of it, as [data] names it.
struct PlacedFile {
  std::string name;
  bool of_assembly = false;
  std::size_t number = 0;  ///< in the list of its system; of all its runs the same
};

/// [[data.gains]] and [[data.masses]]; masses become corrections of their files.
void read_systematic_errors(const scene::Table& table, const std::vector<PlacedFile>& files, DataSection& data);

/// A file that another section of the scene names; [data.files] may speak of it.
struct FurtherFile {
  std::string name;  ///< as written
  DataFile* file = nullptr;
};

/// [data] of a coupling scene: `substructures` are its parts, and `names` gets their names as written; `beside`: keys that the
/// caller reads.
DataSection read_parts_section(const scene::Item& item, const Path& folder, std::vector<std::string>& names,
                               const std::vector<FurtherFile>& further = {}, const std::vector<std::string>& beside = {});

/// [frequency]
FrequencySection read_frequency(const scene::Item& item);

/// [joint] or [[joints]] with the positions of [nodes] handed to every joint that uses them; checked by building each
/// matrix's restriction. Pattern free without positions passes: the data files may have them.
std::vector<restrictions::JointSpec> read_joints(const scene::Table& scene);

/// [nodes]: positions by node number, m.
std::map<std::int64_t, std::array<double, 3>> read_nodes(const scene::Item& item);

/// [[virtual_points]] of the scene, with the positions of [nodes], into those of `files` that they are for, whose paths are in `folder`.
void read_virtual_points(const scene::Table& scene, const Path& folder, const std::vector<DataFile*>& files);

/// The files of a section, runs of repeats one by one.
std::vector<DataFile*> all_files(DataSection& data);

/// The law of [noise] of the FRFs that virtual points take, where it is one of single FRFs.
void set_virtual_noise(const std::optional<NoiseSection>& noise, const std::vector<DataFile*>& files);

/// couple_first of [joint] or all of [[joints]].
std::vector<std::array<frf::Dof, 2>> read_couple_first(const scene::Table& scene);

/// [identify]; `joints` are needed to check the start values.
IdentifySection read_identify(const scene::Item& item, const std::vector<restrictions::JointSpec>& joints);

/// Makes the stiffness of every joint its numbers times one unknown "share", and its hysteretic damping, where it has none, the
/// same numbers times "loss". Throws InputError where a stiffness is not given by numbers.
void make_nominal(const scene::Item& item, std::vector<restrictions::JointSpec>& joints);

/// [identify] priors: a table of [value, standard deviation]; the names are checked against the unknowns by the plan.
std::vector<Prior> read_priors(const scene::Item& item);

/// [identify] bounds: a table of [lowest, highest] or of the words "positive" and "negative".
std::vector<Bound> read_bounds(const scene::Item& item);

/// [identify] ties and inequalities: a list of them, whose names the plan reads.
std::vector<std::string> read_ties(const scene::Item& item);

/// [identify] frequencies: eigenfrequencies, Hz, each > 0 and none twice.
std::vector<double> read_frequencies(const scene::Item& item);

/// The keys bootstrap and bootstrap_seed of [identify].
void read_bootstrap(const scene::Table& table, IdentifySection& identify);

/// How many starts an iterative method follows.
std::size_t read_starts(const scene::Item& item);

/// [noise]
NoiseSection read_noise(const scene::Item& item);

/// A table of matrices by kind over all joint DOFs, each square ([truth], start).
std::map<restrictions::Kind, Matrix> read_matrices(const scene::Item& item, std::size_t size);

/// Number of DOFs of all joints.
std::size_t joint_size(const std::vector<restrictions::JointSpec>& joints);

/// The keys "stiffness", "mass", "viscous_damping" and "hysteretic_damping".
std::vector<std::string> kind_keys();

}  // namespace jointid::ident
