#pragma once

/** Returns false if the plugin's libraries are not loaded: calls of the libraries would then end the game. */
bool HapticLibraryIsLoaded();

/** Makes a call in a member of UHapticRetargetingComponent. False if the library is missing or the call fails. */
#define HAPTIC_CALL(Call) (HasLibrary() && Succeeded(Call))
