#pragma once

/** Whether the plugin's library is there. Otherwise a call of it would end the game. */
bool HapticLibraryIsLoaded();

/** A component's call of the plugin, not made without its library. */
#define HAPTIC_CALL(Call) (HasLibrary() && Succeeded(Call))
