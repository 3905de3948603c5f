// Preloaded, it makes the driver say that it was reset, once, when the file named by RESET_WHEN is
// there: what no driver at hand does of itself. GLFW finds OpenGL's functions by way of dlsym() and
// the function of that name in libGL, so both are stood in for.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define GUILTY_CONTEXT_RESET 0x8253

typedef void (*Procedure)(void);
typedef Procedure (*Finder)(const unsigned char*);
static Finder find;

static unsigned reset_status(void) {
    const char* file = getenv("RESET_WHEN");
    return file && unlink(file) == 0 ? GUILTY_CONTEXT_RESET : 0;
}

static Procedure procedure(const unsigned char* name) {
    if (strcmp((const char*)name, "glGetGraphicsResetStatus") == 0) {
        return (Procedure)reset_status;
    }
    return find(name);
}

void* dlsym(void* library, const char* name) {
    static void* (*real)(void*, const char*);
    if (!real) real = dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34");
    if (!real) real = dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.2.5");
    void* found = real(library, name);
    if (found && (strcmp(name, "glXGetProcAddress") == 0 ||
                  strcmp(name, "glXGetProcAddressARB") == 0)) {
        find = (Finder)found;
        return (void*)procedure;
    }
    return found;
}
