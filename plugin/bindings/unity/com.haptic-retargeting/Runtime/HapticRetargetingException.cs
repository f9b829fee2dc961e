using System;

namespace Hrt
{
    /// <summary>Thrown when a call of a native library fails. <see cref="Exception.Message"/> has the library's text,
    /// which names the call and what is wrong.</summary>
    public sealed class HapticRetargetingException : Exception
    {
        public Result Result { get; }

        public HapticRetargetingException(Result result, string message) : base(message) => Result = result;
    }
}
