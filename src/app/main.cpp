#include "app/commands.h"

int main(int argc, char** argv) { return isomotion::app::run(argc, argv); }
