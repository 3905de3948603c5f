/* In place of OSMesa: a driver that crashes while a context is made. */
#include <signal.h>

#include "osmesa.h"

void* OSMesaCreateContextAttribs(const int* attributes, void* shared) {
    (void)attributes, (void)shared;
    raise(SIGSEGV);
    return 0;
}
