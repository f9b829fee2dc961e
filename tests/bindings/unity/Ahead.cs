// What scripts do, where all code is compiled ahead and none can be made while it runs, as under IL2CPP: a
// component's frames and events, what the library refuses, set-ups, a call from one of the library's threads, and
// the scripted reach. usage: Ahead.exe RECORDING_CSV
using System;
using System.IO;
using Hrt;
using HrtSamples;
using UnityEngine;

static class Ahead
{
    static int Main(string[] arguments)
    {
        string path = Path.GetTempFileName();
        try
        {
            RunFrames();
            SetUp();
            ScriptedReach reach = ScriptedReach.Run(File.ReadAllText(arguments[0]));
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
        var component = new GameObject("retargeting").AddComponent<HapticRetargeting>();
        component.plate = new GameObject("plate").transform;
        component.finger = new GameObject("finger").transform;
        Transform real = new GameObject("cylinder").transform, bottle = new GameObject("bottle").transform;
        real.position = new Vector3(0.01f, 0, 0.05f);
        bottle.position = new Vector3(-0.01f, 0, 0.05f);
        component.realTargets.Add(real);
        component.virtualTargets.Add(bottle);
        int commands = 0, flags = 0, orientations = 0, ended = 0;
        component.Commanded += command => ++commands;
        component.FlagsChanged += changed => ++flags;
        component.onPlateOrientation.AddListener(orientation => ++orientations);
        component.ReachEnded += summary => ++ended;

        component.BeginReach(bottle);
        for (int frame = 0; frame <= 270; ++frame)
        {
            component.finger.position = new Vector3(0, 0, -0.05f + 0.1f * frame / 270);
            component.Message("LateUpdate")();
            Time.unscaledTimeAsDouble += 1 / 90.0;
        }
        component.EndReach();
        Expect(commands == 271 && flags > 0 && orientations > 1 && ended == 1, "events were not raised");

        TargetId target = component.Session.AddTarget(TargetRole.Virtual, 3, 0.1, "goblet");
        Expect(component.Session.FindTarget("goblet") == target, "no target of this name");
        Expect(component.Session.AssignTargets(new[] { target }, component.Session.ListTargets(TargetRole.Real), 0).Length == 1,
               "no assignment");
        component.Session.LoadProfile(component.Session.SaveProfile());
        component.gameObject.SetActive(false);
    }

    static void SetUp()
    {
        using (var session = new HapticRetargetingSession())
        {
            session.BeginSetup(SetupFlags.Registration, SetupConfig.Default);
            try
            {
                session.FinishSetup();
                Expect(false, "nothing was touched");
            }
            catch (HapticRetargetingException e)
            {
                Expect(e.Result == Result.WrongState, e.Message);
            }
        }
    }

    static void Expect(bool fulfilled, string otherwise)
    {
        if (!fulfilled) throw new InvalidOperationException(otherwise);
    }
}
