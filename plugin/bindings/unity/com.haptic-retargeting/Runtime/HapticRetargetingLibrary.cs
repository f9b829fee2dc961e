using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using AOT;

namespace Hrt
{
    /// <summary>The native library: calls without a session, the log, and the release of objects before code is
    /// unloaded.</summary>
    public static partial class HapticRetargetingLibrary
    {
        // The existing native objects of this application domain, and the call that destroys each. Lock it before use.
        static readonly Dictionary<ulong, Func<ulong, Result>> open = new Dictionary<ulong, Func<ulong, Result>>();

        // The native library has a pointer to this delegate, which must not be collected.
        static readonly HostLog onLog = OnLog;

        static volatile bool loaded;

        public static Version Version
        {
            get
            {
                Load();
                Native.hrt_get_version(out uint major, out uint minor, out uint patch);
                return new Version((int)major, (int)minor, (int)patch);
            }
        }

        /// <summary>Error text of this thread's last failed call; empty if no call has failed.</summary>
        public static string LastError
        {
            get
            {
                Load();
                return Utf8.Read(Native.hrt_last_error());
            }
        }

        /// <summary>Call it before any call of the library. Connects the library's log, once. Throws if the library is
        /// missing or has another major or minor version.</summary>
        internal static void Load()
        {
            if (loaded) return;
            lock (open)
            {
                if (loaded) return;
                CheckVersion();
                // The editor reloads scripts without unloading the library, which would then call a collected delegate.
                AppDomain.CurrentDomain.DomainUnload += (sender, arguments) => Shutdown();
                AppDomain.CurrentDomain.ProcessExit += (sender, arguments) => Shutdown();
                Result result = SetLog(Marshal.GetFunctionPointerForDelegate(onLog));
                if (result != Result.Ok)
                    Log(LogLevel.Warning, "the library's log is not available: " + Utf8.Read(Native.hrt_last_error()));
                loaded = true;
            }
        }

        /// <summary>Replays the calls of a recording and compares the results bit for bit.</summary>
        public static ReplayReport Replay(string path)
        {
            Load();
            var report = new ReplayReport { structSize = SizeOf<ReplayReport>.Value };
            Check(Native.hrt_recording_replay(Utf8.NullTerminated(path, nameof(path)), null, 0, ref report));
            return report;
        }

        internal static void Check(Result result)
        {
            if (result != Result.Ok)
                throw new HapticRetargetingException(result, Utf8.Read(Native.hrt_last_error()));
        }

        internal static void Opened(ulong handle, Func<ulong, Result> destroy)
        {
            lock (open) open.Add(handle, destroy);
        }

        internal static void Closed(ulong handle)
        {
            lock (open) open.Remove(handle);
        }

        static void CheckVersion()
        {
            uint major, minor, patch;
            try
            {
                Native.hrt_get_version(out major, out minor, out patch);
            }
            catch (DllNotFoundException e)
            {
                throw new DllNotFoundException(
                    $"The native library {Native.Library} was not found. Add it for each platform on which the program " +
                    "runs: see \"The native libraries\" in the manual (Unity), or \"Installing\" in the README (.NET).",
                    e);
            }
            if (major != Constants.VersionMajor || minor != Constants.VersionMinor)
                throw new InvalidOperationException(
                    $"The native library {Native.Library} is version {major}.{minor}.{patch}; this package needs " +
                    $"{Constants.VersionMajor}.{Constants.VersionMinor}. Build or install the library of that version.");
        }

        static void Shutdown()
        {
            lock (open)
            {
                foreach (KeyValuePair<ulong, Func<ulong, Result>> one in open) one.Value(one.Key);
                open.Clear();
                SetLog(IntPtr.Zero);
            }
        }

        static Result SetLog(IntPtr log)
        {
            var host = new Host { structSize = SizeOf<Host>.Value, log = log };
            return Native.hrt_host_set(ref host);
        }

        /// <summary>Writes a line of the library's log to Unity's console or, in .NET, to <c>Logged</c>.</summary>
        static partial void Log(LogLevel level, string message);

        [MonoPInvokeCallback(typeof(HostLog))]
        static void OnLog(IntPtr context, uint level, IntPtr text)
        {
            // Native code calls this method; no exception may propagate into it.
            try
            {
                Log((LogLevel)level, Utf8.Read(text));
            }
            catch (Exception)
            {
            }
        }
    }
}
