// Preloaded into the program: one system call fails as FAILING_CALL in the environment says, as
// `write:7:28`: the seventh call of write() by the program itself fails with errno 28. Calls by the
// C library and by drivers go through. `COUNT_CALLS` names a file that gets, at the end, how many
// calls of each kind there were.
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

enum Call {
    call_open,
    call_write,
    call_fsync,
    call_rename,
    call_ftruncate,
    call_flock,
    call_fstat,
    call_unlink,
    call_spawn,
    call_socketpair,
    call_memfd,
    call_read,
    call_pread,
    call_send,
    call_stat,
    call_mmap,
    call_thread,
    calls
};
constexpr const char* names[calls] = {
    "open",       "write", "fsync", "rename", "ftruncate", "flock", "fstat", "unlink", "spawn",
    "socketpair", "memfd", "read",  "pread",  "send",      "stat",  "mmap",  "thread"};

std::array<std::atomic<int>, calls> counts{};

struct Fault {
    int call = -1, at = 0, code = 0;
};

Fault fault_asked_for() {
    Fault fault;
    const char* text = std::getenv("FAILING_CALL");
    char name[32] = "";
    if (!text || std::sscanf(text, "%31[^:]:%d:%d", name, &fault.at, &fault.code) != 3) return {};
    for (int call = 0; call < calls; ++call) {
        if (std::strcmp(name, names[call]) == 0) fault.call = call;
    }
    return fault;
}

enum class Owner { program, standard_library, another };

Owner owner_of(void* caller) {
    Dl_info where = {};
    // The program itself is the object without an address to be loaded from others.
    static const void* const program = [] {
        Dl_info info = {};
        dladdr(dlsym(RTLD_DEFAULT, "main"), &info);
        return info.dli_fbase;
    }();
    if (dladdr(caller, &where) == 0) return Owner::another;
    const char* base = std::strrchr(where.dli_fname, '/');
    base = base ? base + 1 : where.dli_fname;
    if (where.dli_fbase == program || std::strncmp(base, "isomotion", 9) == 0)
        return Owner::program;
    return std::strncmp(base, "libstdc++", 9) == 0 ? Owner::standard_library : Owner::another;
}

// The standard library starts the threads of every library of C++, and takes its memory.
bool is_of_the_program_in_the_end() {
    std::array<void*, 8> callers{};
    const int count = backtrace(callers.data(), int(callers.size()));
    for (int k = 2; k < count; ++k) {
        const Owner owner = owner_of(callers[std::size_t(k)]);
        if (owner != Owner::standard_library) return owner == Owner::program;
    }
    return false;
}

bool is_of_the_program(Call call, void* caller) {
    if (call == call_thread || call == call_mmap) return is_of_the_program_in_the_end();
    return owner_of(caller) != Owner::another;
}

bool fails(Call call, void* caller) {
    if (!is_of_the_program(call, caller)) return false;
    static const Fault fault = fault_asked_for();
    const int count = ++counts[call];
    if (fault.call != call || fault.at != count) return false;
    errno = fault.code;
    return true;
}

template<class Function> Function real(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

struct Report {
    ~Report() {
        const char* file = std::getenv("COUNT_CALLS");
        if (!file) return;
        std::FILE* stream = std::fopen(file, "w");
        for (int call = 0; stream && call < calls; ++call)
            std::fprintf(stream, "%s %d\n", names[call], counts[std::size_t(call)].load());
        if (stream) std::fclose(stream);
    }
} report;

} // namespace

#define CALLER __builtin_return_address(0)
#define HAND_ON(call, name, failed, signature, arguments)                                          \
    if (fails(call, CALLER)) return failed;                                                        \
    static const auto next = real<signature>(#name);                                               \
    return next arguments;

extern "C" {

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const int mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, int) : 0;
    va_end(rest);
    HAND_ON(call_open, open, -1, int (*)(const char*, int, ...), (path, flags, mode))
}
int openat(int folder, const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const int mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, int) : 0;
    va_end(rest);
    HAND_ON(call_open, openat, -1, int (*)(int, const char*, int, ...), (folder, path, flags, mode))
}
ssize_t write(int descriptor, const void* bytes, size_t size) {
    HAND_ON(call_write, write, -1, ssize_t(*)(int, const void*, size_t), (descriptor, bytes, size))
}
int fsync(int descriptor) { HAND_ON(call_fsync, fsync, -1, int (*)(int), (descriptor)) }
int rename(const char* from, const char* to) noexcept {
    HAND_ON(call_rename, rename, -1, int (*)(const char*, const char*), (from, to))
}
int ftruncate(int descriptor, off_t size) noexcept {
    HAND_ON(call_ftruncate, ftruncate, -1, int (*)(int, off_t), (descriptor, size))
}
int flock(int descriptor, int how) noexcept {
    HAND_ON(call_flock, flock, -1, int (*)(int, int), (descriptor, how))
}
int fstat(int descriptor, struct stat* found) noexcept {
    HAND_ON(call_fstat, fstat, -1, int (*)(int, struct stat*), (descriptor, found))
}
int unlink(const char* path) noexcept {
    HAND_ON(call_unlink, unlink, -1, int (*)(const char*), (path))
}
int posix_spawn(pid_t* id, const char* path, const posix_spawn_file_actions_t* actions,
                const posix_spawnattr_t* attributes, char* const* words, char* const* variables) {
    if (fails(call_spawn, CALLER)) return errno;
    static const auto next = real<decltype(&posix_spawn)>("posix_spawn");
    return next(id, path, actions, attributes, words, variables);
}
int socketpair(int domain, int type, int protocol, int* ends) noexcept {
    HAND_ON(call_socketpair, socketpair, -1, int (*)(int, int, int, int*),
            (domain, type, protocol, ends))
}
int memfd_create(const char* name, unsigned flags) noexcept {
    HAND_ON(call_memfd, memfd_create, -1, int (*)(const char*, unsigned), (name, flags))} ssize_t
    read(int descriptor, void* bytes,
         size_t size){HAND_ON(call_read, read, -1, ssize_t (*)(int, void*, size_t),
                              (descriptor, bytes, size))} ssize_t
    pread(int descriptor, void* bytes, size_t size,
          off_t from){HAND_ON(call_pread, pread, -1, ssize_t (*)(int, void*, size_t, off_t),
                              (descriptor, bytes, size, from))} ssize_t
    send(int socket, const void* bytes, size_t size, int flags) {
    HAND_ON(call_send, send, -1, ssize_t(*)(int, const void*, size_t, int),
            (socket, bytes, size, flags))
}
int stat(const char* path, struct stat* found) noexcept {
    HAND_ON(call_stat, stat, -1, int (*)(const char*, struct stat*), (path, found))
}
// What takes pages of its own from the system, by operator new.
extern void* __libc_malloc(size_t size) noexcept;
void* malloc(size_t size) noexcept {
    constexpr size_t least_of_pages = 128 << 10;
    if (size >= least_of_pages && fails(call_mmap, CALLER)) return nullptr;
    return __libc_malloc(size);
}
int pthread_create(pthread_t* id, const pthread_attr_t* attributes, void* (*run)(void*),
                   void* given) noexcept {
    if (fails(call_thread, CALLER)) return errno;
    static const auto next = real<decltype(&pthread_create)>("pthread_create");
    return next(id, attributes, run, given);
}

} // extern "C"
