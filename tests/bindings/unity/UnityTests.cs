using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Hrt.HostTests
{
    // Tests that need the stubs of Unity's clock and console.
    public sealed class UnityTests
    {
        HapticRetargeting component;
        Transform bottle;
        readonly List<string> logged = new List<string>();

        [SetUp]
        public void SetUp()
        {
            logged.Clear();
            Debug.Logged += Log;
            component = Component();
            bottle = component.virtualTargets[0];
        }

        [TearDown]
        public void TearDown()
        {
            UnityEngine.Object.DestroyImmediate(component.gameObject);
            Debug.Logged -= Log;
        }

        void Log(string level, string text) => logged.Add(level + ": " + text);

        [Test]
        public void FramesAreStampedWithUnitysUnscaledTime()
        {
            string path = Path.GetTempFileName();
            component.Session.StartRecording(path);
            component.BeginReach(bottle);
            foreach (double time in new[] {1.5, 1.5, 86400.25})
            {
                Time.unscaledTimeAsDouble = time;
                component.Message("LateUpdate")();
            }
            component.EndReach();
            component.Message("LateUpdate")();
            component.Session.StopRecording();
            string[] times = File.ReadAllLines(path).Where(line => line.StartsWith("update,"))
                .Select(line => line.Split(',')[2]).ToArray();
            File.Delete(path);
            CollectionAssert.AreEqual(new[] {"1500000000", "1500000000", "86400250000000"}, times);
        }

        [Test]
        public void ARefusedSampleIsLoggedOnceInAReach()
        {
            component.BeginReach(bottle);
            component.finger.position = new Vector3(float.NaN, 0, 0);
            for (int i = 0; i < 3; ++i) component.Message("LateUpdate")();
            component.finger.position = Vector3.zero;
            component.Message("LateUpdate")();
            StringAssert.StartsWith("error: Haptic retargeting: ", logged.Single());
            StringAssert.Contains("finger_position_m", logged.Single());
            Assert.AreEqual(1, component.EndReach().samples);
        }

        // A script whose LateUpdate moves the finger runs before the sample is taken.
        [Test]
        public void SamplesAreTakenAfterOtherScripts()
        {
            var order = (DefaultExecutionOrder)Attribute.GetCustomAttribute(typeof(HapticRetargeting), typeof(DefaultExecutionOrder));
            Assert.Greater(order.order, 0);
        }

        [Test]
        public void ASettingThatChangesDuringAReachIsReported()
        {
            component.Message("OnValidate")();
            Assert.AreEqual(0, logged.Count);
            component.BeginReach(bottle);
            component.Message("OnValidate")();
            StringAssert.Contains("take effect when the next reach", logged.Single());
        }

        [Test]
        public void ADestroyedPlateIsADropout()
        {
            component.BeginReach(bottle);
            UnityEngine.Object.DestroyImmediate(component.plate.gameObject);
            component.Message("LateUpdate")();
            Assert.AreEqual(1, component.EndReach().droppedSamples);
        }

        [Test]
        public void DisablingEndsTheReachAndTheSession()
        {
            component.BeginReach(bottle);
            HapticRetargetingSession session = component.Session;
            component.gameObject.SetActive(false);
            Assert.IsTrue(session.IsDisposed);
            Assert.IsFalse(component.IsReaching);
            component.gameObject.SetActive(true);
            component.BeginReach(bottle);
            Assert.IsTrue(component.IsReaching);
        }

        [Test]
        public void ScenesSetPlateAndTargets()
        {
            TargetId[] targets = component.Session.LoadScene(Environment.GetEnvironmentVariable("HRT_DESK_SCENE"));
            Assert.Greater(targets.Length, 2);
            Assert.AreEqual(targets.Length, component.Session.ListTargets(0).Length);
            TargetId found = component.Session.FindTarget("bottle");
            Assert.AreEqual(TargetRole.Virtual, component.Session.GetTarget(found).role);
            Assert.Throws<KeyNotFoundException>(() => component.Session.FindTarget("glas"));
            var refusal = Assert.Throws<HapticRetargetingException>(() => component.Session.LoadScene("/nowhere/désk.gltf"));
            StringAssert.Contains("/nowhere/désk.gltf", refusal.Message);
        }

        internal static HapticRetargeting Component()
        {
            var made = new GameObject("retargeting").AddComponent<HapticRetargeting>();
            made.plate = new GameObject("plate").transform;
            made.finger = new GameObject("finger").transform;
            made.realTargets.Add(Place("cylinder", -5));
            made.virtualTargets.Add(Place("bottle", 5));
            return made;
        }

        static Transform Place(string name, double directionDeg)
        {
            Transform target = new GameObject(name).transform;
            target.position = new Vector3(0, 0, -0.05f) + Axes.Direction(directionDeg) * 0.1f;
            return target;
        }
    }
}
