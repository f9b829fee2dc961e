using System;

namespace Hrt
{
    /// <summary>A call that the library refused. <see cref="Exception.Message"/> is the library's own text: the
    /// call, the field, its value and what is allowed.</summary>
    public sealed class HapticRetargetingException : Exception
    {
        public Result Result { get; }

        public HapticRetargetingException(Result result, string message) : base(message) => Result = result;
    }
}
