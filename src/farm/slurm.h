// Renders a sequence as jobs of Slurm: an array whose tasks render one chunk each, and a later job
// that joins the results. One script serves both.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "farm/chunks.h"
#include "farm/job.h"

namespace isomotion::farm {

struct Slurm {
    std::filesystem::path script; // out/name.slurm.sh; logs go to out/name.slurm/
    std::size_t workers = 0;      // largest number of tasks at a time; 0: as many as Slurm allows
    int tries = 3;                // attempts per chunk
    std::vector<std::string> options = {}; // additional options of sbatch
};

// The text of the script. Tasks of the array count from 1.
std::string slurm_script(const Job& job, std::span<const Chunk> chunks, const std::string& frames,
                         const Slurm& slurm);

// The calls of sbatch: for the array, and for the job that begins when all tasks of the job `array`
// have succeeded.
std::vector<std::string> sbatch_array(const Slurm& slurm, std::size_t chunks);
std::vector<std::string> sbatch_joining(const Slurm& slurm, const std::string& array);

// The largest number of tasks that Slurm on this machine accepts in one array; Slurm's default if
// it can't be asked.
std::size_t largest_array();

// Runs sbatch and returns the job's number. Throws an Error (device) if Slurm isn't installed
// or refuses, with alternatives.
std::string submit(const std::vector<std::string>& sbatch);

} // namespace isomotion::farm
