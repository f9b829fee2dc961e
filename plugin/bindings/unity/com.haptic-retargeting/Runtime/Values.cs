using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Hrt
{
    /// <summary>Three numbers, as the library has them: a position in metres, x right, y up, z towards the user,
    /// right-handed. <see cref="Axes"/> converts to and from Unity's.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public struct Double3
    {
        public double x, y, z;

        public Double3(double x, double y, double z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        public override string ToString() => $"({x}, {y}, {z})";
    }

    /// <summary>Four numbers, as the library has them: a unit quaternion in right-handed axes.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public struct Double4
    {
        public double x, y, z, w;

        public Double4(double x, double y, double z, double w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        public override string ToString() => $"({x}, {y}, {z}, {w})";
    }

    /// <summary>A name of at most 63 bytes of UTF-8, ended by a zero: the library's char[64], as eight words of
    /// eight bytes, the first byte lowest.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public struct Name
    {
        public ulong word0, word1, word2, word3, word4, word5, word6, word7;

        public Name(string text)
        {
            this = default(Name);
            byte[] bytes = Utf8.ZeroEnded(text, nameof(text));
            if (bytes.Length > Constants.NameSize)
                throw new ArgumentException(
                    $"\"{text}\" has {bytes.Length - 1} bytes of UTF-8; allowed: at most {Constants.NameSize - 1}",
                    nameof(text));
            Array.Resize(ref bytes, Constants.NameSize);
            word0 = BitConverter.ToUInt64(bytes, 0);
            word1 = BitConverter.ToUInt64(bytes, 8);
            word2 = BitConverter.ToUInt64(bytes, 16);
            word3 = BitConverter.ToUInt64(bytes, 24);
            word4 = BitConverter.ToUInt64(bytes, 32);
            word5 = BitConverter.ToUInt64(bytes, 40);
            word6 = BitConverter.ToUInt64(bytes, 48);
            word7 = BitConverter.ToUInt64(bytes, 56);
        }

        public static implicit operator Name(string text) => new Name(text);

        public override string ToString() =>
            Utf8.Read(word0, word1, word2, word3, word4, word5, word6, word7);
    }

    public partial struct TargetId : IEquatable<TargetId>
    {
        public bool Equals(TargetId other) => value == other.value;
        public override bool Equals(object other) => other is TargetId target && Equals(target);
        public override int GetHashCode() => value.GetHashCode();
        public static bool operator ==(TargetId left, TargetId right) => left.Equals(right);
        public static bool operator !=(TargetId left, TargetId right) => !left.Equals(right);
        public override string ToString() => $"target {value}";
    }

    public partial struct Interval
    {
        /// <summary>Whether the data determine the value; otherwise it is only the likeliest point of what was
        /// searched.</summary>
        public bool IsKnown => known != 0;
    }

    public partial struct Gap
    {
        /// <summary>Whether the finger can be held on the real target's direction.</summary>
        public bool IsReachable => reachable != 0;
    }

    /// <summary>What goes into structSize, computed once for each struct.</summary>
    internal static class SizeOf<T> where T : struct
    {
        internal static readonly uint Value = (uint)Marshal.SizeOf(typeof(T));
    }

    internal static class Utf8
    {
        /// <summary>UTF-8 with a zero behind it. A text with a zero in it, which would be cut there, is
        /// refused.</summary>
        internal static byte[] ZeroEnded(string text, string argument)
        {
            byte[] bytes = Bytes(text, argument);
            if (Array.IndexOf(bytes, (byte)0) >= 0) throw new ArgumentException("The text has a zero in it", argument);
            Array.Resize(ref bytes, bytes.Length + 1);
            return bytes;
        }

        internal static byte[] Bytes(string text, string argument)
        {
            if (text == null) throw new ArgumentNullException(argument);
            return Encoding.UTF8.GetBytes(text);
        }

        /// <summary>A text in words of eight bytes, the first byte lowest, up to its first zero.</summary>
        internal static string Read(params ulong[] words)
        {
            var bytes = new byte[8 * words.Length];
            for (int i = 0; i < words.Length; ++i) BitConverter.GetBytes(words[i]).CopyTo(bytes, 8 * i);
            int end = Array.IndexOf(bytes, (byte)0);
            return Encoding.UTF8.GetString(bytes, 0, end < 0 ? bytes.Length : end);
        }

        /// <summary>A C string; UTF-8 on every platform, which Marshal's own conversions are not.</summary>
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
