#pragma once

/** Returns true if the plugin's library is loaded. Otherwise a call of it would end the game. */
bool HapticLibraryIsLoaded();

/** Calls the plugin from a component, if its library is loaded. */
#define HAPTIC_CALL(Call) (HasLibrary() && Succeeded(Call))
