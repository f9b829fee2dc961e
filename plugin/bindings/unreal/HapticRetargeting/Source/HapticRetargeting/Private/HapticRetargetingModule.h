#pragma once

/** Returns true if the plugin's library is loaded. If it is not, a call of the library would end the game. */
bool HapticLibraryIsLoaded();

/** Makes a call in a member of UHapticRetargetingComponent. False if the library is missing or the call fails. */
#define HAPTIC_CALL(Call) (HasLibrary() && Succeeded(Call))
