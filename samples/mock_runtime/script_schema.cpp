// Prints what may stand in a script: hrtx-run --schema, made when the runtime is built.
#include <cstdio>

#include "samples/mock_runtime/script/script.h"

int main() { return std::puts(hrt::mock::script_schema().c_str()) < 0 ? 1 : 0; }
