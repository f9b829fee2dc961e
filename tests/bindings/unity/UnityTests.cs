using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Hrt.HostTests
{
    // What only stubs let one look at: Unity's clock, its console, what is drawn.
    public sealed class UnityTests
    {
        HapticRetargeting component;
        Transform real, bottle;

        [SetUp]
        public void SetUp()
        {
            component = new GameObject("retargeting").AddComponent<HapticRetargeting>();
            component.plate = new GameObject("plate").transform;
            component.finger = new GameObject("finger").transform;
            real = Place("cylinder", -5);
            bottle = Place("bottle", 5);
            component.realTargets.Add(real);
            component.virtualTargets.Add(bottle);
            Gizmos.Lines.Clear();
            UnityEditor.EditorGUILayout.Drawn.Clear();
        }

        [TearDown]
        public void TearDown()
        {
            UnityEngine.Object.DestroyImmediate(component.gameObject);
        }

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
            var logged = new List<string>();
            Action<string, string> listener = (level, text) => logged.Add(level + ": " + text);
            Debug.Logged += listener;
            component.BeginReach(bottle);
            component.finger.position = new Vector3(float.NaN, 0, 0);
            for (int i = 0; i < 3; ++i) component.Message("LateUpdate")();
            component.finger.position = Vector3.zero;
            component.Message("LateUpdate")();
            Debug.Logged -= listener;
            Assert.AreEqual(1, logged.Count);
            StringAssert.StartsWith("error: Haptic retargeting: ", logged[0]);
            StringAssert.Contains("finger_position_m", logged[0]);
            Assert.AreEqual(1, component.EndReach().samples);
        }

        [Test]
        public void APlateThatIsDestroyedIsADropout()
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
        public void GizmosShowWhatCanBeHeld()
        {
            component.Message("OnDrawGizmosSelected")();
            Assert.AreEqual(1, Count(Color.cyan, bottle.position));
            Assert.AreEqual(1, Count(Color.green, real.position));
            Assert.AreEqual(0, Count(Color.red));

            Gizmos.Lines.Clear();
            Put(real, -20);
            component.Message("OnDrawGizmosSelected")();
            Assert.AreEqual(0, Count(Color.green));
            Assert.AreEqual(1, Count(Color.red, real.position));
            Assert.AreEqual(2, Count(Color.red), "the target, and where the finger settles");
        }

        [Test]
        public void GizmosShowThePlateWithoutTargets()
        {
            component.virtualTargets.Clear();
            component.Message("OnDrawGizmosSelected")();
            Assert.Greater(Count(Color.grey), 50);
            Gizmos.Lines.Clear();
            component.plate = null;
            component.Message("OnDrawGizmosSelected")();
            Assert.AreEqual(0, Gizmos.Lines.Count);
        }

        // At orientation 0 ridges are parallel to the frontal plane; at 90 along the mid-line.
        [Test]
        public void GizmosShowTheRidgesAcrossTheOrientation()
        {
            component.Message("OnDrawGizmosSelected")();
            Gizmos.Line[] ridges = Gizmos.Lines.Where(line => line.colour.Equals(Color.grey)).Skip(48).ToArray();
            Assert.AreEqual(15, ridges.Length);
            foreach (Gizmos.Line ridge in ridges) Assert.That(ridge.to.z - ridge.from.z, Is.EqualTo(0).Within(1e-6));
        }

        [Test]
        public void TheInspectorSaysWhatCanBeHeldAndWhatIsWrong()
        {
            UnityEditor.Editor editor = UnityEditor.Editor.CreateEditor(component);
            Assert.IsInstanceOf<Hrt.Editor.HapticRetargetingEditor>(editor);
            List<string> drawn = UnityEditor.EditorGUILayout.Drawn;
            editor.OnInspectorGUI();
            CollectionAssert.Contains(drawn, "bottle: by cylinder: gap +10.0, margin +5.0 deg");

            component.BeginReach(bottle);
            component.Message("LateUpdate")();
            editor.OnInspectorGUI();
            CollectionAssert.Contains(drawn, "Step: -1");

            component.plate = null;
            editor.OnInspectorGUI();
            Assert.IsTrue(drawn.Any(line => line.StartsWith("Error: ") && line.Contains("plate is not set")));
        }

        // The scene is the repository's own, which says where its plate is and what is on it.
        [Test]
        public void ScenesBringPlateAndTargets()
        {
            TargetId[] targets = component.Session.LoadScene(Environment.GetEnvironmentVariable("HRT_DESK_SCENE"));
            Assert.Greater(targets.Length, 2);
            Assert.AreEqual(targets.Length, component.Session.GetTargets().Length);
            Assert.IsTrue(component.Session.TryFindTarget("bottle", out TargetId found));
            Assert.AreEqual(TargetRole.Virtual, component.Session.GetTarget(found).role);
        }

        static int Count(Color colour) => Gizmos.Lines.Count(line => line.colour.Equals(colour));

        static int Count(Color colour, Vector3 to) =>
            Gizmos.Lines.Count(line => line.colour.Equals(colour) && (line.to - to).magnitude < 1e-6);

        static Transform Place(string name, double directionDeg)
        {
            Transform target = new GameObject(name).transform;
            Put(target, directionDeg);
            return target;
        }

        static void Put(Transform target, double directionDeg)
        {
            target.position = new Vector3(0, 0, -0.05f) + Axes.Direction(directionDeg) * 0.1f;
        }
    }
}
