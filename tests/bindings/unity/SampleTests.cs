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
        public void TearDown() => Debug.Logged -= Log;

        [Test]
        public void TheScriptedReachReportsWhetherItsHashMatches()
        {
            string bindings = Environment.GetEnvironmentVariable("HRT_BINDINGS");
            var sample = new GameObject("sample").AddComponent<HrtSamples.RunScriptedReach>();
            sample.expectedHash = new TextAsset { text = File.ReadAllText(Path.Combine(bindings, "reach.hash")) };
            sample.Message("Start")();
            StringAssert.EndsWith("as on every host", logged.Single());
            StringAssert.IsMatch(@"the hand ended [0-9]\.[0-9] mm from the real target, [01]\.[0-9]{2} degrees off its bearing",
                                 logged.Single());
            StringAssert.StartsWith("log: ", logged.Single());

            logged.Clear();
            sample.expectedHash.text = "0x0000000000000000";
            sample.Message("Start")();
            StringAssert.StartsWith("error: ", logged.Single());
        }

        [Test]
        public void TheHandOnTheDeskIsSteered()
        {
            var desk = new GameObject("desk").AddComponent<HrtSamples.Desk>();
            desk.Message("Reset")();
            desk.Message("Awake")();
            HapticRetargeting retargeting = desk.Retargeting;
            retargeting.virtualTargets.RemoveAt(2); // its gap is not feasible for this person
            var simulated = retargeting.gameObject.AddComponent<HrtSamples.SimulatedReach>();
            int ended = 0;
            retargeting.ReachEnded += summary =>
            {
                ++ended;
                Assert.Less(summary.distanceToTargetM, 0.005);
                Assert.Less(summary.peakFeltErrorDeg, 6);
            };
            simulated.Message("Start")();
            for (int frame = 0; frame < 90 * 6; ++frame)
            {
                Time.unscaledTimeAsDouble = 50 + frame / 90.0;
                simulated.Message("Update")();
                retargeting.Message("LateUpdate")();
            }
            Assert.AreEqual(2, ended);
            StringAssert.Contains("To the goblet, simulated: the hand ended", logged.Last());
            simulated.Message("OnDestroy")();
            UnityEngine.Object.DestroyImmediate(retargeting.gameObject);
        }

        void Log(string level, string text) => logged.Add(level + ": " + text);
    }
}
