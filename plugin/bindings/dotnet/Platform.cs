// For .NET without Unity: the attribute and the log that the C# sources in ../unity/com.haptic-retargeting/Runtime use.
using System;

namespace AOT
{
    // Ahead-of-time compilers of Mono and Unity look for this name on methods that native code calls.
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

        /// <summary>Receives lines of the library's log on any thread. Default: standard error. Null: no log.</summary>
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
