#include "app/ample_stack.h"

#include <cstddef>
#include <system_error>
#include <thread>

#include <pthread.h>
#include <sys/resource.h>

namespace isomotion::app {
namespace {

constexpr std::size_t ample = std::size_t(8) << 20;

// glibc sets the stack of threads from the limit when the program starts.
bool make_default_of_threads() {
    pthread_attr_t attributes;
    if (::pthread_attr_init(&attributes) != 0) return false;
    const bool is_set = ::pthread_attr_setstacksize(&attributes, ample) == 0 &&
                        ::pthread_setattr_default_np(&attributes) == 0;
    ::pthread_attr_destroy(&attributes);
    return is_set;
}

} // namespace

int run_on_ample_stack(int (*run)(int, char**), int argc, char** argv) {
    rlimit limit{};
    if (::getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= ample) return run(argc, argv);
    if (!make_default_of_threads()) return run(argc, argv);
    int code = 0;
    try {
        std::thread([&] { code = run(argc, argv); }).join();
    } catch (const std::system_error&) { // no thread is to be had
        return run(argc, argv);
    }
    return code;
}

} // namespace isomotion::app
