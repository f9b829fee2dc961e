using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using AOT;

namespace Hrt
{
    /// <summary>The native library: its version, its log, and what must be put away before managed code
    /// goes.</summary>
    public static partial class HapticRetargetingLibrary
    {
        // What this application domain has made and not destroyed, and how to destroy it. Guarded by itself.
        static readonly Dictionary<ulong, Func<ulong, Result>> open = new Dictionary<ulong, Func<ulong, Result>>();

        // The native side keeps a pointer to this; the field keeps it from being collected.
        static readonly HostLog onLog = OnLog;

        static volatile bool loaded;

        /// <summary>The library's version.</summary>
        public static Version Version
        {
            get
            {
                Load();
                Native.hrt_get_version(out uint major, out uint minor, out uint patch);
                return new Version((int)major, (int)minor, (int)patch);
            }
        }

        /// <summary>What went wrong in this thread's last failed call; empty if none has failed.</summary>
        public static string LastError
        {
            get
            {
                Load();
                return Utf8.Read(Native.hrt_last_error());
            }
        }

        /// <summary>Comes before the first call into the library: refuses one that is missing or of another
        /// version, and takes its log.</summary>
        internal static void Load()
        {
            if (loaded) return;
            lock (open)
            {
                if (loaded) return;
                CheckVersion();
                // The editor keeps the library and all that it holds when it reloads the scripts' domain. What is
                // left of them would call a delegate that is gone.
                AppDomain.CurrentDomain.DomainUnload += (sender, arguments) => Shutdown();
                AppDomain.CurrentDomain.ProcessExit += (sender, arguments) => Shutdown();
                Result result = SetLog(Marshal.GetFunctionPointerForDelegate(onLog));
                if (result != Result.Ok)
                    Log(LogLevel.Warning, "the library's log does not come here: " + Utf8.Read(Native.hrt_last_error()));
                loaded = true;
            }
        }

        /// <summary>Runs a recording's calls again, and compares what comes out, bit for bit.</summary>
        public static ReplayReport Replay(string path)
        {
            Load();
            var report = new ReplayReport { structSize = SizeOf<ReplayReport>.Value };
            Check(Native.hrt_recording_replay(Utf8.ZeroEnded(path, nameof(path)), null, 0, ref report));
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
                    $"The native library {Native.Library} was not found. The package needs it for " +
                    "the platform that it runs on; its documentation says where to put it.",
                    e);
            }
            if (major != Constants.VersionMajor || minor != Constants.VersionMinor)
                throw new InvalidOperationException(
                    $"The native library {Native.Library} is version {major}.{minor}.{patch}; this package needs " +
                    $"{Constants.VersionMajor}.{Constants.VersionMinor}.");
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

        /// <summary>Where the library's log goes: Unity's console, or what .NET programs choose.</summary>
        static partial void Log(LogLevel level, string message);

        [MonoPInvokeCallback(typeof(HostLog))]
        static void OnLog(IntPtr context, uint level, IntPtr text)
        {
            // Called by a thread of the library's own, which no exception may get into.
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
