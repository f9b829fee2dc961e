using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.Hands;

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
            StringAssert.IsMatch(@"the hand ended [0-9]\.[0-9] mm from the real target, [01]\.[0-9]{2} degrees beside it",
                                 logged.Single());
            StringAssert.StartsWith("log: ", logged.Single());

            logged.Clear();
            sample.expectedHash.text = "0x0000000000000000";
            sample.Message("Start")();
            StringAssert.StartsWith("error: ", logged.Single());
        }

        [Test]
        public void ALikelyMistakeIsLogged()
        {
            using (var session = new HapticRetargetingSession())
            {
                session.BeginReach(session.AddTarget(TargetRole.Real, -5), session.AddTarget(TargetRole.Virtual, 5));
                for (int frame = 0; frame < 200; ++frame)
                    session.Update(new Sample
                    {
                        flags = SampleFlags.PlatePosition, timeNs = frame * 11111111L, fingerPositionM = new Double3(0, 0, 5)
                    });
                session.EndReach();
                session.WriteLog();
            }
            StringAssert.StartsWith("warning: ", logged.Single());
            StringAssert.Contains("set positions in metres", logged.Single());
        }

        // For each of the three virtual objects, the hand ends at the cylinder (within 1.5 degrees at 10 cm), or the
        // controller reports that the gap is not feasible.
        [Test]
        public void TheHandOnTheDeskIsSteered()
        {
            HapticRetargeting retargeting = Desk();
            retargeting.virtualTargets.RemoveAt(2); // not reachable
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

        // The origin of the tracker's space is 1 m to the right of the world's.
        [Test]
        public void ATrackedHandMovesTheFinger()
        {
            var hands = new XRHandSubsystem();
            SubsystemManager.All.Add(hands);
            HapticRetargeting retargeting = Desk();
            var finger = retargeting.finger.gameObject.AddComponent<HrtSamples.TrackedFinger>();
            finger.retargeting = retargeting;
            finger.origin = new GameObject("origin").transform;
            finger.origin.position = Vector3.right;
            finger.Message("Update")();
            Assert.IsFalse(retargeting.FingerTracked);
            hands.rightHand = new XRHand { isTracked = true, Tip = new Pose(Vector3.up, Quaternion.identity) };
            hands.Raise(XRHandSubsystem.UpdateType.Dynamic);
            Assert.IsTrue(retargeting.FingerTracked);
            Assert.AreEqual(Vector3.right + Vector3.up, finger.transform.position);
            hands.rightHand = new XRHand { isTracked = true, Tip = Pose.identity };
            hands.Raise(XRHandSubsystem.UpdateType.BeforeRender); // does not take another sample
            Assert.AreEqual(Vector3.right + Vector3.up, finger.transform.position);
            finger.left = true;
            hands.Raise(XRHandSubsystem.UpdateType.Dynamic);
            Assert.IsFalse(retargeting.FingerTracked);
            hands.leftHand = new XRHand { isTracked = true, Tip = Pose.identity };
            hands.Raise(XRHandSubsystem.UpdateType.Dynamic);
            Assert.AreEqual(Vector3.right, finger.transform.position);
            Assert.IsTrue(retargeting.fingerIsJoint);
            hands.running = false;
            finger.Message("Update")();
            Assert.IsFalse(retargeting.FingerTracked || hands.IsHeard);
            hands.running = true;
            finger.Message("Update")();
            Assert.IsTrue(hands.IsHeard);
            finger.enabled = false;
            Assert.IsFalse(hands.IsHeard);
            SubsystemManager.All.Clear();
            UnityEngine.Object.DestroyImmediate(retargeting.gameObject);
        }

        static HapticRetargeting Desk()
        {
            var desk = new GameObject("desk").AddComponent<HrtSamples.Desk>();
            desk.Message("Reset")();
            desk.Message("Awake")();
            return desk.Retargeting;
        }

        void Log(string level, string text) => logged.Add(level + ": " + text);
    }
}
