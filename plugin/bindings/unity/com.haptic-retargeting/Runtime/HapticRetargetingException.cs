using System;

namespace Hrt
{
    /// <summary>Thrown when the library refuses a call. <see cref="Exception.Message"/> is the library's text, with the
    /// call, the field, its value and the allowed values.</summary>
    public sealed class HapticRetargetingException : Exception
    {
        public Result Result { get; }

        public HapticRetargetingException(Result result, string message) : base(message) => Result = result;
    }
}
