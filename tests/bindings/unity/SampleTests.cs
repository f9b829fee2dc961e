using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR;
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
            StringAssert.IsMatch(@"the hand ended [0-9]\.[0-9] mm from the real target, [01]\.[0-9]{2} degrees beside it",
                                 logged.Single());
            StringAssert.StartsWith("log: ", logged.Single());

            logged.Clear();
            sample.expectedHash.text = "0x0000000000000000";
            sample.Message("Start")();
            StringAssert.StartsWith("error: ", logged.Single());
        }

        // The mouse goes from the start straight to the goblet, 8 degrees to the right, in 3 seconds.
        [Test]
        public void TheDeskFollowsTheMouse()
        {
            HapticRetargeting retargeting = Desk();
            var table = retargeting.gameObject.AddComponent<HrtSamples.MouseReach>();
            table.Message("Start")();
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

        // A hand that rests at the start, slides to the goblet, 8 degrees to the right, in 2 seconds, and rests there. The
        // tracker's space stands 1 m to the right of the world's.
        [Test]
        public void ATrackedHandReachesWithoutAButton()
        {
            var hands = new XRHandSubsystem();
            SubsystemManager.All.Add(hands);
            HapticRetargeting retargeting = Desk();
            Camera.main.transform.parent = new GameObject("origin").transform;
            Camera.main.transform.parent.position = Vector3.right;
            retargeting.virtualTargets.RemoveAt(0);
            var reach = retargeting.gameObject.AddComponent<HrtSamples.HandReach>();
            Time.unscaledTimeAsDouble = 50;
            reach.Message("Start")();
            Assert.IsNull(Camera.main.gameObject.GetComponent<HrtSamples.HeadPose>(), "an XR Origin moves its camera");
            var finger = retargeting.finger.gameObject.GetComponent<HrtSamples.TrackedFinger>();
            StringAssert.Contains("slide to the goblet", logged.Last());
            var states = new List<bool>();
            for (int frame = 0; frame < 90 * 4; ++frame)
            {
                Time.unscaledTimeAsDouble = 50 + frame / 90.0;
                float way = Math.Min(Math.Max(frame / 90f - 1, 0), 2) / 2;
                Vector3 tip = retargeting.start.position + Axes.Direction(-8) * (0.1f * way) - Vector3.right;
                hands.rightHand = new XRHand { isTracked = true, Tip = new Pose(tip, Quaternion.identity) };
                finger.Message("Update")();
                reach.Message("Update")();
                retargeting.Message("LateUpdate")();
                states.Add(retargeting.IsReaching);
            }
            Assert.AreEqual(45, states.IndexOf(true), 2, "after half a second at rest");
            Assert.AreEqual(90 * 3 + 45, states.LastIndexOf(true), 2, "until half a second at rest at the target");
            StringAssert.Contains("To the goblet: 14 mm from the real target", string.Join("\n", logged));

            hands.rightHand = new XRHand();
            finger.Message("Update")();
            Assert.IsFalse(retargeting.FingerTracked);
            finger.side = HrtSamples.TrackedFinger.Side.Left;
            hands.leftHand = new XRHand { isTracked = true, Tip = Pose.identity };
            finger.Skin = HapticRetargetingRegistration.FitFingertip(Touches(new Vector3(0, -0.008f, 0.005f)));
            finger.Message("Update")();
            Assert.IsTrue(retargeting.FingerTracked);
            Assert.AreEqual(0, (finger.transform.position - new Vector3(1, -0.008f, 0.005f)).magnitude, 1e-6);
            hands.running = false;
            SubsystemManager.All.Clear();
            finger.Message("Update")();
            Assert.IsFalse(retargeting.FingerTracked);
            reach.Message("OnDestroy")();
            Camera.main.transform.parent = null;
            UnityEngine.Object.DestroyImmediate(retargeting.gameObject);
        }

        [Test]
        public void TheCameraFollowsTheHeadset()
        {
            var input = new XRInputSubsystem();
            SubsystemManager.All.Add(input);
            var head = new GameObject("camera").AddComponent<HrtSamples.HeadPose>();
            head.Message("Update")();
            Assert.AreEqual(TrackingOriginModeFlags.Floor, input.Mode);
            Assert.AreEqual(Vector3.zero, head.transform.localPosition);
            InputDevices.Head = new Pose(new Vector3(0, 1.6f, 0), Quaternion.AngleAxis(30, Vector3.up));
            Application.Render();
            Assert.AreEqual(1.6f, head.transform.localPosition.y);
            Assert.AreEqual(Quaternion.AngleAxis(30, Vector3.up), head.transform.localRotation);
            head.enabled = false;
            InputDevices.Head = Pose.identity;
            Application.Render();
            Assert.AreEqual(1.6f, head.transform.localPosition.y);
            InputDevices.Head = null;
            SubsystemManager.All.Clear();
        }

        // As the editor adds it, where the scripts stand on the mouse's ground plane.
        static HapticRetargeting Desk()
        {
            var desk = new GameObject("desk").AddComponent<HrtSamples.Desk>();
            desk.Message("Reset")();
            desk.Message("Awake")();
            return desk.Retargeting;
        }

        // Of one mark, by a joint that is turned several ways.
        static JointTouch[] Touches(Vector3 offset)
        {
            return new[]
            {
                Quaternion.identity, Quaternion.Euler(40, 0, 0), Quaternion.Euler(-30, 0, 0),
                Quaternion.Euler(0, 50, 0), Quaternion.Euler(0, 0, 35), Quaternion.Euler(0, -40, -35)
            }.Select(turn => new JointTouch
            {
                rotation = Axes.FromUnity(turn), positionM = Axes.FromUnity(Vector3.zero - turn * offset)
            }).ToArray();
        }

        static void Send(HrtSamples.MouseReach table, EventType type, Vector3 way, KeyCode key = KeyCode.None)
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
