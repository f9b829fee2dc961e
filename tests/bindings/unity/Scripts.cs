using System;
using System.Threading;
using Hrt;
using UnityEngine;

/// <summary>Scripts that dispose of nothing: they create the maximum number of sessions, and record one session until a
/// write fails at the file size limit, which small_files_run sets. The library reports the failed write on its own
/// thread.</summary>
sealed class Scripts : MarshalByRefObject
{
    volatile string logged;
    volatile Thread logThread;

    /// <summary>Returns an error, or an empty text.</summary>
    public string LeaveEverythingOpen(string path)
    {
        Debug.Logged += Hear;
        var sessions = new HapticRetargetingSession[Constants.SessionsMax];
        for (int i = 0; i < sessions.Length; ++i)
        {
            sessions[i] = new HapticRetargetingSession();
            if (i == 0) sessions[i].StartRecording(path);
            sessions[i].BeginReach(sessions[i].AddTarget(TargetRole.Real, -5),
                                   sessions[i].AddTarget(TargetRole.Virtual, 5));
        }
        DateTime end = DateTime.Now.AddSeconds(20);
        for (int i = 0; logged == null && DateTime.Now < end; ++i)
        {
            sessions[0].Update(new Sample { timeNs = i });
            if (i % 1000 == 0) Thread.Sleep(1);
        }
        if (logged == null) return "the failed write of the recording was not logged";
        if (!logged.StartsWith("error: Haptic retargeting: session ") ||
            !logged.Contains(": the recording has stopped"))
            return "logged: " + logged;
        if (logThread == Thread.CurrentThread) return "logged on the caller's thread";
        return "";
    }

    void Hear(string level, string text)
    {
        if (level == "warning") return; // calls that the recording lacks, because the disk is slower than this loop
        logThread = Thread.CurrentThread;
        logged = level + ": " + text;
        throw new InvalidOperationException("an exception that must not propagate into the library");
    }
}
