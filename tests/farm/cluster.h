// A Slurm of its own for one test: munged, slurmctld and two slurmds of one core each, on ports of
// the loopback, with all their files in a folder. Nothing of it outlives this object.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/child_process.h"
#include "processes.h"

namespace isomotion::farm {

class Cluster {
public:
    // The first of its programs that this machine lacks.
    static std::optional<std::string> missing();

    // `folder` exists and is empty. Throws std::runtime_error if it doesn't come up in a minute.
    explicit Cluster(std::filesystem::path folder);
    ~Cluster();
    Cluster(const Cluster&) = delete;
    Cluster& operator=(const Cluster&) = delete;

    // What clients find it by, in $SLURM_CONF.
    std::string configuration() const { return folder_ / "slurm.conf"; }

    // What a command of Slurm's, such as sinfo or squeue, prints.
    std::string output_of(std::vector<std::string> command) const;

    // Jobs that wait or run.
    std::string queue() const { return output_of({"squeue", "-r", "-h", "-o", "%i %T %R"}); }

    static constexpr int nodes = 2;
    static std::string node_name(int node) { return "node" + std::to_string(node); }
    // "idle", "mixed", "allocated", "down" and others, with a mark if it doesn't answer.
    std::string state_of_node(int node) const {
        return output_of({"sinfo", "-h", "-n", node_name(node), "-o", "%T"});
    }
    // Processes of jobs there.
    std::vector<Process> jobs_on(int node) const;
    // As if the power went: its slurmd and all it started are gone.
    void kill_node(int node);
    void start_node(int node);

private:
    using Daemon = std::unique_ptr<base::ChildProcess>;
    Daemon start(const std::string& program, std::vector<std::string> arguments) const;
    void write_configuration() const;
    void wait_until_up();
    std::string last_words() const;

    std::filesystem::path folder_;
    Daemon munge_, controller_;
    std::array<Daemon, nodes> slurmds_;
};

} // namespace isomotion::farm
