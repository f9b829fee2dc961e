// What the C# of the Unity package takes from Unity, for .NET without it.
using System;

namespace AOT
{
    // Compilers ahead of time look for this name at what native code calls.
    [AttributeUsage(AttributeTargets.Method)]
    sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        public MonoPInvokeCallbackAttribute(Type type)
        {
        }
    }
}

namespace Hrt
{
    public static partial class HapticRetargetingLibrary
    {
        static volatile Action<LogLevel, string> logged = ToStandardError;

        /// <summary>Takes a line of the library's log, on any thread, from its own too. Default: standard error. Null: none.</summary>
        public static Action<LogLevel, string> Logged
        {
            get => logged;
            set => logged = value;
        }

        static partial void Log(LogLevel level, string message) => logged?.Invoke(level, message);

        static void ToStandardError(LogLevel level, string message) =>
            Console.Error.WriteLine($"Haptic retargeting: {level}: {message}");
    }
}
