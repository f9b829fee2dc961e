using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Hrt
{
    public partial struct TargetId : IEquatable<TargetId>
    {
        public bool Equals(TargetId other) => value == other.value;
        public override bool Equals(object other) => other is TargetId target && Equals(target);
        public override int GetHashCode() => value.GetHashCode();
        public static bool operator ==(TargetId left, TargetId right) => left.Equals(right);
        public static bool operator !=(TargetId left, TargetId right) => !left.Equals(right);
        public override string ToString() => $"target {value}";
    }

    /// <summary>Value of structSize, computed once for each struct.</summary>
    internal static class SizeOf<T> where T : struct
    {
        internal static readonly uint Value = (uint)Marshal.SizeOf(typeof(T));
    }

    internal static class Utf8
    {
        /// <summary>Encodes a text as UTF-8 with a terminating NUL. Throws if the text contains a NUL.</summary>
        internal static byte[] NullTerminated(string text, string argument)
        {
            byte[] bytes = Bytes(text, argument);
            int at = Array.IndexOf(bytes, (byte)0);
            if (at >= 0) throw new ArgumentException($"The text has a NUL character (U+0000) at byte {at}; remove it", argument);
            Array.Resize(ref bytes, bytes.Length + 1);
            return bytes;
        }

        /// <summary>Encodes a name as words of eight bytes, the first byte lowest.</summary>
        internal static ulong[] Words(string text, string argument)
        {
            byte[] bytes = NullTerminated(text, argument);
            if (bytes.Length > Constants.NameSize)
                throw new ArgumentException(
                    $"\"{text}\" has {bytes.Length - 1} bytes of UTF-8; allowed: at most {Constants.NameSize - 1}", argument);
            Array.Resize(ref bytes, Constants.NameSize);
            return Array.ConvertAll(new[] {0, 8, 16, 24, 32, 40, 48, 56}, at => BitConverter.ToUInt64(bytes, at));
        }

        internal static byte[] Bytes(string text, string argument)
        {
            if (text == null) throw new ArgumentNullException(argument);
            return Encoding.UTF8.GetBytes(text);
        }

        /// <summary>Decodes a text in words of eight bytes, the first byte lowest, up to its first zero.</summary>
        internal static string Read(params ulong[] words)
        {
            var bytes = new byte[8 * words.Length];
            for (int i = 0; i < words.Length; ++i) BitConverter.GetBytes(words[i]).CopyTo(bytes, 8 * i);
            int end = Array.IndexOf(bytes, (byte)0);
            return Encoding.UTF8.GetString(bytes, 0, end < 0 ? bytes.Length : end);
        }

        /// <summary>Decodes a C string in UTF-8. A null pointer becomes an empty text.</summary>
        internal static string Read(IntPtr text)
        {
            if (text == IntPtr.Zero) return "";
            int length = 0;
            while (Marshal.ReadByte(text, length) != 0) ++length;
            var bytes = new byte[length];
            Marshal.Copy(text, bytes, 0, length);
            return Encoding.UTF8.GetString(bytes);
        }
    }
}
