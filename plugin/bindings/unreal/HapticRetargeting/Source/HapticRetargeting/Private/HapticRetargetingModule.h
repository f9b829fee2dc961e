#pragma once

/** Whether the plugin's library is there. Otherwise a call of it would end the game. */
bool HapticLibraryIsLoaded();
