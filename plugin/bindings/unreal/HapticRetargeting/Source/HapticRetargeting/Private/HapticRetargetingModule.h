#pragma once

/** Returns true if the plugin's library is loaded. If it is not, a call of the library would end the game. */
bool HapticLibraryIsLoaded();

/** Calls the plugin from a component, if its library is loaded. */
#define HAPTIC_CALL(Call) (HasLibrary() && Succeeded(Call))
