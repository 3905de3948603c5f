#include "cluster.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <random>
#include <stdexcept>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <pwd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/file_descriptor.h"
#include "program.h"

namespace isomotion::farm {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// Debian has the daemons in /usr/sbin, which is not on everybody's PATH.
std::optional<fs::path> found(const std::string& program) {
    if (auto file = base::find_program(program)) return file;
    const fs::path file = fs::path("/usr/sbin") / program;
    if (fs::exists(file)) return file;
    return std::nullopt;
}

// Ports of the loopback that nobody has, all held until all are known.
template<std::size_t count> std::array<int, count> free_ports() {
    std::array<int, count> ports{};
    std::array<base::FileDescriptor, count> sockets;
    for (std::size_t k = 0; k < count; ++k) {
        sockets[k] = base::FileDescriptor(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
        sockaddr_in address = {};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        auto* const any = reinterpret_cast<sockaddr*>(&address);
        if (::bind(sockets[k].number(), any, size) != 0 ||
            ::getsockname(sockets[k].number(), any, &size) != 0) {
            throw std::runtime_error("no port of 127.0.0.1 is free");
        }
        ports[k] = ntohs(address.sin_port);
    }
    return ports;
}

std::string host() {
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    const std::string text = name.data();
    return text.substr(0, text.find('.'));
}

std::string user() {
    const passwd* entry = ::getpwuid(::getuid());
    return entry ? entry->pw_name : std::to_string(::getuid());
}

void kill_all(const std::vector<Process>& processes) {
    for (const Process& process : processes) ::kill(process.id, SIGKILL);
}

} // namespace

std::optional<std::string> Cluster::missing() {
    for (const char* program :
         {"setpriv", "munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo", "scontrol"}) {
        if (!found(program)) return program;
    }
    return std::nullopt;
}

Cluster::Cluster(fs::path folder)
    : folder_(std::move(folder)) {
    fs::create_directories(folder_ / "state");
    {
        std::ofstream key(folder_ / "munge.key", std::ios::binary);
        std::random_device random;
        for (int k = 0; k < 128; ++k) key << char(random());
    }
    fs::permissions(folder_ / "munge.key", fs::perms::owner_read);
    write_configuration();
    const auto file = [this](const char* option, const char* name) {
        return fmt::format("--{}={}", option, (folder_ / name).string());
    };
    munge_ = start("munged", {"--foreground", "--force", file("key-file", "munge.key"),
                              file("socket", "munge.socket"), file("pid-file", "munge.pid"),
                              file("seed-file", "munge.seed"), file("log-file", "munge.log")});
    while (!fs::exists(folder_ / "munge.socket") && !munge_->ended()) {
        std::this_thread::sleep_for(5ms);
    }
    controller_ = start("slurmctld", {"-D", "-c", "-f", configuration()});
    for (int node = 0; node < nodes; ++node) start_node(node);
    wait_until_up();
}

Cluster::~Cluster() {
    for (int node = 0; node < nodes; ++node) kill_node(node);
    // What is left knows the folder by its environment.
    kill_all(processes([this](const Process& process) {
        return process.environment.find("SLURM_CONF=" + configuration()) != std::string::npos &&
               process.environment.find("SLURM_JOB_ID=") != std::string::npos;
    }));
}

Cluster::Daemon Cluster::start(const std::string& program,
                               std::vector<std::string> arguments) const {
    // They end with this process even if it is killed.
    arguments.insert(arguments.begin(), {"--pdeathsig", "KILL", found(program).value()});
    return std::make_unique<base::ChildProcess>(found("setpriv").value(), arguments);
}

void Cluster::write_configuration() const {
    const auto ports = free_ports<nodes + 1>();
    std::ofstream file(folder_ / "slurm.conf");
    // cred_expire is also how long a job that is tried again has to wait, at least 5 s.
    file << fmt::format(R"(ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=1
SchedulerParameters=batch_sched_delay=0,bf_interval=1,sched_interval=1
)",
                        fmt::arg("host", host()), fmt::arg("port", ports[0]),
                        fmt::arg("user", user()), fmt::arg("folder", folder_.string()));
    for (int node = 0; node < nodes; ++node) {
        file << fmt::format("NodeName={} NodeHostname={} NodeAddr=127.0.0.1 Port={} CPUs=1\n",
                            node_name(node), host(), ports[std::size_t(node) + 1]);
    }
    file << "PartitionName=all Nodes=ALL Default=YES State=UP\n";
}

void Cluster::wait_until_up() {
    for (const auto end = std::chrono::steady_clock::now() + 60s;
         std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(50ms)) {
        if (output_of({"sinfo", "-h", "-N", "-o", "%T"}) == "idle\nidle\n") return;
    }
    throw std::runtime_error("Slurm doesn't come up:\n" + last_words());
}

std::string Cluster::output_of(std::vector<std::string> command) const {
    command.front() = found(command.front()).value();
    return cli::run(command, {.environment = {{"SLURM_CONF", configuration()}}}).out;
}

std::vector<Process> Cluster::jobs_on(int node) const {
    return processes([&](const Process& process) {
        const auto has = [&](const std::string& entry) {
            return ('\0' + process.environment).find('\0' + entry + '\0') != std::string::npos;
        };
        return has("SLURM_CONF=" + configuration()) && has("SLURMD_NODENAME=" + node_name(node));
    });
}

void Cluster::kill_node(int node) {
    Daemon& slurmd = slurmds_[std::size_t(node)];
    if (!slurmd) return;
    slurmd.reset(); // by SIGKILL
    const std::vector<Process> jobs = jobs_on(node);
    // slurmstepd, which started them, has written its title over its environment.
    kill_all(processes([&](const Process& process) {
        return process.words.starts_with("slurmstepd") &&
               std::ranges::find(jobs, process.id, &Process::parent) != jobs.end();
    }));
    kill_all(jobs);
}

void Cluster::start_node(int node) {
    slurmds_[std::size_t(node)] =
        start("slurmd", {"-D", "-f", configuration(), "-N", node_name(node)});
}

std::string Cluster::last_words() const {
    std::string text;
    for (const auto* daemon : {&munge_, &controller_, &slurmds_[0], &slurmds_[1]}) {
        if (*daemon) text += (*daemon)->last_words(5) + '\n';
    }
    return text;
}

} // namespace isomotion::farm
