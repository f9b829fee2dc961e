using UnityEngine;

namespace Hrt
{
    public static partial class HapticRetargetingLibrary
    {
        static partial void Log(LogLevel level, string message)
        {
            message = "Haptic retargeting: " + message;
            if (level == LogLevel.Error) Debug.LogError(message);
            else Debug.LogWarning(message);
        }
    }
}
