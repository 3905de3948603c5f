// A sequence as jobs of Slurm: an array whose tasks render a chunk each, and a job after it that
// joins what they made. One script is both.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "farm/chunks.h"
#include "farm/job.h"

namespace isomotion::farm {

// Slurm isn't here or refuses; the message says which, and what else there is.
class SlurmError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Slurm {
    std::filesystem::path script;          // out/name.slurm.sh; logs go to out/name.slurm/
    std::size_t workers = 0;               // tasks at a time, at most; 0: as many as Slurm lets
    int tries = 3;                         // of a chunk
    std::vector<std::string> options = {}; // more of sbatch's
};

// The text of the script. Tasks of the array count from 1.
std::string slurm_script(const Job& job, std::span<const Chunk> chunks, const std::string& frames,
                         const Slurm& slurm);

// The calls of sbatch: of the array, and of what begins when all of its tasks, of the job `array`,
// ended well.
std::vector<std::string> sbatch_array(const Slurm& slurm, std::size_t chunks);
std::vector<std::string> sbatch_joining(const Slurm& slurm, const std::string& array);

// The most tasks that the Slurm of this machine takes as one array; Slurm's default where it can't
// be asked.
std::size_t largest_array();

// Runs sbatch and returns the job's number. Throws SlurmError.
std::string submit(const std::vector<std::string>& sbatch);

} // namespace isomotion::farm
