#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "frf/hdf5/record_journal.hpp"
#include "study/study_options.hpp"

namespace jointid::study {

/// "3/16". Throws InputError (usage) for what is none, and unless 1 ≤ number ≤ count.
StudyPart parse_part(const std::string& text);

/// The trials of a part, about as many as any other part has: [n(k−1)/K, nk/K) of n trials for part k of K.
frf::IndexRange trials_of(const StudyPart& part, std::size_t trials);

/// Texts that the file of a part has beside those of the study; none of a whole study.
std::map<std::string, std::string> texts_of(const StudyPart& part, std::size_t trials, const std::string& title,
                                            const std::vector<std::string>& notes);

/// A study put together of its parts.
struct MergedStudy {
  std::string title, scene_hash;
  std::vector<std::string> notes;  ///< of the data
  std::uint64_t seed = 1;
  std::size_t trials = 0;
};

/// Writes the study of which `files` are the parts, in any order: the same bytes as a study in one run. Throws InputError that names
/// the file or part for a part that is missing, there twice or of another study, and for files that are no whole parts.
MergedStudy merge_parts(std::span<const ident::Path> files, const ident::Path& out);

}  // namespace jointid::study
