using System;

namespace Hrt
{
    /// <summary>Thrown when the library refuses a call. <see cref="Exception.Message"/> is the library's text, which
    /// names the call, what is wrong and what is allowed.</summary>
    public sealed class HapticRetargetingException : Exception
    {
        public Result Result { get; }

        public HapticRetargetingException(Result result, string message) : base(message) => Result = result;
    }
}
