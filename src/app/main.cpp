#include "app/ample_stack.h"
#include "app/commands.h"

int main(int argc, char** argv) {
    return isomotion::app::run_on_ample_stack(isomotion::app::run, argc, argv);
}
