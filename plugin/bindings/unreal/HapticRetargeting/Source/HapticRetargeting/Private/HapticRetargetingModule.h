#pragma once

/** Returns true if the plugin's library is loaded. If it is not, a call of the library would end the game. */
bool HapticLibraryIsLoaded();

/** For members of UHapticRetargetingComponent: makes a call, if the library is loaded. True if the call succeeds;
 *  otherwise, the reason is logged. */
#define HAPTIC_CALL(Call) (HasLibrary() && Succeeded(Call))
