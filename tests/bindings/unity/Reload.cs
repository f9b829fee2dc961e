// What Unity's editor does when scripts are recompiled: their domain goes, with sessions that nobody has disposed
// of, and the library stays. Each domain takes all the sessions and calibrations
// that there can be; one of them records until the
// disk is full, and the library says so from a thread of its own. Run it where files can't grow beyond 1 MiB.
using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;
using Hrt;
using UnityEngine;

sealed class Scripts : MarshalByRefObject
{
    volatile string logged;
    volatile Thread logThread;

    /// <summary>What is wrong; empty if nothing is.</summary>
    public string LeaveEverythingOpen(string path)
    {
        Debug.Logged += Hear;
        var sessions = new HapticRetargetingSession[Constants.SessionsMax];
        for (int i = 0; i < sessions.Length; ++i)
        {
            sessions[i] = new HapticRetargetingSession();
            if (i == 0) sessions[i].StartRecording(path);
            if (i < Constants.CalibrationsMax) new HapticRetargetingCalibration(sessions[i]).BeginTrial(30);
            sessions[i].BeginReach(sessions[i].AddTarget(TargetRole.Real, -5),
                                   sessions[i].AddTarget(TargetRole.Virtual, 5));
        }
        DateTime end = DateTime.Now.AddSeconds(20);
        for (int i = 0; logged == null && DateTime.Now < end; ++i)
        {
            sessions[0].Update(new Sample { timeNs = i });
            if (i % 1000 == 0) Thread.Sleep(1);
        }
        if (logged == null) return "nothing was logged of a disk that is full";
        if (!logged.StartsWith("error: Haptic retargeting: the recording ends here")) return "logged: " + logged;
        if (logThread == Thread.CurrentThread) return "logged on the caller's thread";
        return "";
    }

    void Hear(string level, string text)
    {
        if (level == "warning") return; // calls lost on the way, as the disk is slower than this loop
        logThread = Thread.CurrentThread;
        logged = level + ": " + text;
        throw new InvalidOperationException("of a listener, which must not reach the library");
    }
}

static class Reload
{
    const int Reloads = 10;

    [DllImport("haptic_retargeting")]
    static extern Result hrt_session_config_default(ref SessionConfig config, uint structSize);

    [DllImport("haptic_retargeting")]
    static extern Result hrt_session_create(ref SessionConfig config, out ulong session);

    [DllImport("haptic_retargeting")]
    static extern Result hrt_session_destroy(ulong session);

    [DllImport("haptic_retargeting")]
    static extern Result hrt_recording_start(ulong session, string path);

    [DllImport("haptic_retargeting")]
    static extern Result hrt_recording_get_status(ulong session, ref RecordingStatus status);

    [DllImport("haptic_retargeting")]
    static extern Result hrt_reach_update(ulong session, ref Sample sample, ref Command command);

    static int Main()
    {
        string path = Path.GetTempFileName();
        string wrong = "";
        for (int i = 0; i < Reloads && wrong == ""; ++i)
        {
            AppDomain domain = AppDomain.CreateDomain("scripts");
            var scripts = (Scripts)domain.CreateInstanceAndUnwrap(typeof(Scripts).Assembly.FullName,
                                                                  typeof(Scripts).FullName);
            wrong = scripts.LeaveEverythingOpen(path);
            AppDomain.Unload(domain);
        }
        if (wrong == "") wrong = FillTheDiskUnheard(path);
        File.Delete(path);
        if (wrong != "") Console.Error.WriteLine(wrong);
        else Console.WriteLine("{0} domains unloaded, each with {1} sessions open", Reloads, Constants.SessionsMax);
        return wrong == "" ? 0 : 1;
    }

    // Where no scripts are left: the library must not call into what was unloaded, which would end the process.
    static string FillTheDiskUnheard(string path)
    {
        var config = default(SessionConfig);
        var sample = new Sample { structSize = (uint)Marshal.SizeOf(typeof(Sample)) };
        var command = new Command { structSize = (uint)Marshal.SizeOf(typeof(Command)) };
        var status = new RecordingStatus { structSize = (uint)Marshal.SizeOf(typeof(RecordingStatus)) };
        ulong session;
        if (hrt_session_config_default(ref config, (uint)Marshal.SizeOf(typeof(SessionConfig))) != Result.Ok ||
            hrt_session_create(ref config, out session) != Result.Ok ||
            hrt_recording_start(session, path) != Result.Ok)
            return "the library does not take a session after the scripts";
        DateTime end = DateTime.Now.AddSeconds(20);
        while (status.systemError == 0 && DateTime.Now < end)
        {
            // Refused, as there is no reach, and recorded.
            for (int i = 0; i < 1000; ++i) hrt_reach_update(session, ref sample, ref command);
            Thread.Sleep(1);
            hrt_recording_get_status(session, ref status);
        }
        Thread.Sleep(50);
        hrt_session_destroy(session);
        return status.systemError == 0 ? "the disk did not become full" : "";
    }
}
