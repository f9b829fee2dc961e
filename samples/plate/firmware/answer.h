/* Lines to the host. */
#pragma once

#include "samples/plate/firmware/plate.h"

/** Bits of Plate.due. */
enum { DUE_BOOT = 1, DUE_PLATE = 2, DUE_INFO = 4, DUE_SAVED = 8, DUE_AT = 16 };

/** Lines of a self-test. */
enum { TEST_LINES = 6 };

/** Sends what is due, once a millisecond; what finds no room waits for the next one. */
void answer(Plate* plate);
