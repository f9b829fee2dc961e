// Runs typical code of scripts, compiled ahead of time and without code generation at run time, as under IL2CPP: frames
// and events of a component, errors of the library, a callback on a thread of the library, and the scripted reach.
using System;
using System.IO;
using Hrt;
using HrtSamples;
using UnityEngine;

static class Ahead
{
    static int Main()
    {
        string path = Path.GetTempFileName();
        try
        {
            RunFrames();
            ScriptedReach reach = ScriptedReach.Run();
            string wrong = new Scripts().LeaveEverythingOpen(path);
            Expect(wrong == "", wrong);
            Console.WriteLine("hash 0x{0:x16}", reach.Hash);
            return 0;
        }
        catch (Exception e)
        {
            Console.Error.WriteLine(e);
            return 1;
        }
        finally
        {
            File.Delete(path);
        }
    }

    static void RunFrames()
    {
        var desk = new GameObject("desk").AddComponent<Desk>();
        desk.Message("Awake")();
        HapticRetargeting component = desk.Retargeting;
        var simulated = desk.gameObject.AddComponent<SimulatedReach>();
        int commands = 0, flags = 0, orientations = 0, ended = 0;
        component.Commanded += command => ++commands;
        component.FlagsChanged += changed => ++flags;
        component.onPlateOrientation.AddListener(orientation => ++orientations);
        component.ReachEnded += summary => ++ended;
        simulated.Message("Start")();
        for (; ended == 0 && commands < 900; Time.unscaledTimeAsDouble += 1 / 90.0)
        {
            simulated.Message("Update")();
            component.Message("LateUpdate")();
        }
        Expect(commands > 100 && flags > 0 && orientations > 1 && ended == 1, "events were not raised");

        component.CancelReach();
        try
        {
            component.Session.FinishSetup();
            Expect(false, "a refused call does not throw");
        }
        catch (HapticRetargetingException e)
        {
            Expect(e.Result == Result.WrongState, e.Message);
        }
        simulated.Message("OnDestroy")();
        component.gameObject.SetActive(false);
    }

    static void Expect(bool fulfilled, string otherwise)
    {
        if (!fulfilled) throw new InvalidOperationException(otherwise);
    }
}
