// Where the options of a job stand in its file, for faults that are found while they are read or
// when the run has begun.
#pragma once

#include <mrsim/job_file.h>

#include <string>
#include <vector>

namespace mrsim::cli {

struct JobPlaces {
  std::string path;  ///< of the job, empty without one
  std::vector<JobOption>
      options;  ///< options of the job that are not typed as well; "": the program
};

/// Throws `fault` as a PlacedError where it speaks of an option of the job whose place is known: by
/// the option's name, or by the name of its file where that is missing, unreadable or unwritable.
void show_in_job(const Error& fault, const JobPlaces& job);

}  // namespace mrsim::cli
