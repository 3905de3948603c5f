// One of the targets, as the fuzzer's.
#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    isomotion::fuzz::ISOMOTION_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
    return 0;
}
