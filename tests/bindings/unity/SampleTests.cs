using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Hrt.HostTests
{
    public sealed class SampleTests
    {
        readonly List<string> logged = new List<string>();

        [SetUp]
        public void SetUp()
        {
            logged.Clear();
            Debug.Logged += Log;
        }

        [TearDown]
        public void TearDown()
        {
            Debug.Logged -= Log;
        }

        [Test]
        public void TheScriptedReachSaysWhetherTheHashIsThatOfAllHosts()
        {
            string bindings = Environment.GetEnvironmentVariable("HRT_BINDINGS");
            var sample = new GameObject("sample").AddComponent<HrtSamples.RunScriptedReach>();
            sample.recording = new TextAsset { text = File.ReadAllText(Path.Combine(bindings, "reach.csv")) };
            sample.expectedHash = new TextAsset { text = File.ReadAllText(Path.Combine(bindings, "reach.hash")) };
            sample.Message("Start")();
            StringAssert.EndsWith("as on every host", logged.Single());
            StringAssert.StartsWith("log: ", logged.Single());

            logged.Clear();
            sample.expectedHash.text = "0x0000000000000000";
            sample.Message("Start")();
            StringAssert.StartsWith("error: ", logged.Single());
        }

        // The mouse goes from the start straight to the goblet, 8 degrees to the right, in 3 seconds.
        [Test]
        public void TheTableFollowsTheMouse()
        {
            var table = new GameObject("table").AddComponent<HrtSamples.Table>();
            table.Message("Start")();
            var retargeting = table.gameObject.GetComponent<HapticRetargeting>();
            Send(table, EventType.KeyDown, new Vector3(), KeyCode.Alpha1 + 1);
            Send(table, EventType.MouseDown, new Vector3());
            for (int frame = 0; frame <= 270; ++frame)
            {
                Time.unscaledTimeAsDouble = 100 + frame / 90.0;
                Send(table, EventType.Repaint, Axes.Direction(-8) * (0.1f * frame / 270));
                retargeting.Message("LateUpdate")();
            }
            Send(table, EventType.MouseUp, Axes.Direction(-8) * 0.1f);
            Assert.IsFalse(retargeting.IsReaching);
            // From the goblet's place to the cylinder's: a chord of 8 degrees at 10 cm.
            StringAssert.Contains("To the goblet: 13 mm from the cylinder", logged.Last());
            UnityEngine.Object.DestroyImmediate(table.gameObject);
        }

        static void Send(HrtSamples.Table table, EventType type, Vector3 way, KeyCode key = KeyCode.None)
        {
            Event.current = new Event
            {
                type = type, keyCode = key, mousePosition = new Vector2(way.x, Screen.height - (0.35f + way.z))
            };
            table.Message("OnGUI")();
        }

        void Log(string level, string text) => logged.Add(level + ": " + text);
    }
}
