using System;
using System.Threading;
using Hrt;
using UnityEngine;

/// <summary>Scripts that dispose of nothing: the maximum number of sessions, one of which records until the disk
/// is full, which the library reports on its own thread. Run it with a file size limit of 1 MiB.</summary>
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
        if (logged == null) return "nothing was logged of a disk that is full";
        if (!logged.StartsWith("error: Haptic retargeting: session ") ||
            !logged.Contains(": the recording has stopped"))
            return "logged: " + logged;
        if (logThread == Thread.CurrentThread) return "logged on the caller's thread";
        return "";
    }

    void Hear(string level, string text)
    {
        if (level == "warning") return; // lost calls, because the disk is slower than this loop
        logThread = Thread.CurrentThread;
        logged = level + ": " + text;
        throw new InvalidOperationException("of a listener, which must not reach the library");
    }
}
