// Reloads scripts as Unity's editor does: unloads their domain with all open objects, and keeps the library loaded.
using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;
using Hrt;

static class Reload
{
    const int Reloads = 10;

    [DllImport("haptic_retargeting")]
    static extern Result hrt_session_create(uint version, IntPtr config, out ulong session);

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
        if (wrong == "") wrong = RecordUntilFailure(path);
        File.Delete(path);
        if (wrong != "") Console.Error.WriteLine(wrong);
        else Console.WriteLine("{0} domains unloaded, each with {1} sessions open", Reloads, Constants.SessionsMax);
        return wrong == "" ? 0 : 1;
    }

    // Records until a write fails. The library logs this, and must not call a delegate of an unloaded domain.
    static string RecordUntilFailure(string path)
    {
        var sample = new Sample { structSize = (uint)Marshal.SizeOf(typeof(Sample)) };
        var command = new Command { structSize = (uint)Marshal.SizeOf(typeof(Command)) };
        var status = new RecordingStatus { structSize = (uint)Marshal.SizeOf(typeof(RecordingStatus)) };
        ulong session;
        if (hrt_session_create(Constants.Version, IntPtr.Zero, out session) != Result.Ok ||
            hrt_recording_start(session, path) != Result.Ok)
            return "the library refuses a session after the domains were unloaded";
        DateTime end = DateTime.Now.AddSeconds(20);
        while (status.systemError == 0 && DateTime.Now < end)
        {
            // Without a reach these calls are refused. The recording contains them too.
            for (int i = 0; i < 1000; ++i) hrt_reach_update(session, ref sample, ref command);
            Thread.Sleep(1);
            hrt_recording_get_status(session, ref status);
        }
        Thread.Sleep(50);
        hrt_session_destroy(session);
        return status.systemError == 0 ? "no write of the recording failed" : "";
    }
}
