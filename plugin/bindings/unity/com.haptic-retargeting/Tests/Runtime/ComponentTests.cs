using System;
using System.Collections.Generic;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;

namespace Hrt.Tests
{
    public sealed class ComponentTests
    {
        readonly List<GameObject> made = new List<GameObject>();
        HapticRetargeting component;
        Transform real, virtualTarget;

        // A plate with an arbitrary pose, a real target 5 degrees to the right and a virtual target 5 degrees to the
        // left, both 10 cm from the start.
        [SetUp]
        public void SetUp()
        {
            component = Make("retargeting").AddComponent<HapticRetargeting>();
            component.plate = Make("plate").transform;
            component.plate.position = new Vector3(1, 0.8f, -2);
            component.plate.rotation = Quaternion.Euler(10, 130, -20);
            component.finger = Make("finger").transform;
            component.finger.position = OnPlate(0, 0);
            real = MakeTarget("cylinder", -5);
            virtualTarget = MakeTarget("bottle", 5);
            component.realTargets.Add(real);
            component.virtualTargets.Add(virtualTarget);
        }

        [TearDown]
        public void TearDown()
        {
            foreach (GameObject gameObject in made) UnityEngine.Object.DestroyImmediate(gameObject);
            made.Clear();
        }

        [Test]
        public void TheRealTargetWithTheLargestMarginIsChosen()
        {
            MoveTarget(real, -20);
            Transform nearer = MakeTarget("cone", 2);
            component.realTargets.Add(nearer);
            component.virtualTargets.Add(real);
            component.BeginReach(virtualTarget);
            component.Step(At(0));
            // The distance is that to the cone: a chord of 3 degrees at 10 cm. The cylinder is further away.
            component.finger.position = virtualTarget.position;
            for (int i = 1; i <= 3; ++i) component.Step(At(60000000L * i));  // a jump is an outlier at first
            Assert.That(component.LastCommand.distanceToGoM, Is.EqualTo(0.0052).Within(1e-4));
        }

        [Test]
        public void CommandsEqualThoseOfAReachInPlateCoordinates()
        {
            component.BeginReach(virtualTarget);
            SessionConfig config = SessionConfig.Default;
            config.guidance = component.guidance;
            config.adaptation = component.adaptation;
            using (var session = new HapticRetargetingSession(config))
            {
                session.BeginReach(session.AddTarget(TargetRole.Real, -5), session.AddTarget(TargetRole.Virtual, 5));
                for (int frame = 0; frame <= 90; ++frame)
                {
                    double right = 0.02 * Math.Sin(frame * 0.05), away = 0.1 * frame / 90;
                    component.finger.position = OnPlate(right, away);
                    component.Step(At(frame * 11111111L));
                    Command expected = session.Update(new Sample
                    {
                        flags = SampleFlags.PlatePosition,
                        timeNs = frame * 11111111L,
                        fingerPositionM = new Double3(right, 0, 0.05 - away)
                    });
                    Command command = component.LastCommand;
                    Assert.AreEqual(expected.paperStep, command.paperStep);
                    Assert.AreEqual(expected.flags, command.flags);
                    // Unity's floats resolve about 0.1 micrometres here, and the controller amplifies the rounding.
                    Assert.That(command.plateOrientationDeg, Is.EqualTo(expected.plateOrientationDeg).Within(0.1));
                    Assert.That(command.distanceToGoM, Is.EqualTo(expected.distanceToGoM).Within(1e-6));
                }
            }
            ReachSummary summary = component.EndReach();
            Assert.AreEqual(91, summary.samples);
            Assert.IsFalse(component.IsReaching);
        }

        [Test]
        public void AReachFollowsAMovingPlate()
        {
            component.BeginReach(virtualTarget);
            component.Step(At(0));
            Assert.That(component.LastCommand.distanceToGoM, Is.EqualTo(0.1).Within(1e-6));
            component.plate.position = new Vector3(-3, 1, 4);
            component.plate.rotation = Quaternion.Euler(-30, 20, 75);
            component.finger.position = OnPlate(0, 0);
            component.Step(At(11111111));
            Assert.That(component.LastCommand.distanceToGoM, Is.EqualTo(0.1).Within(1e-6));
            const CommandFlags away = CommandFlags.Lifted | CommandFlags.OffPlate;
            Assert.AreEqual(CommandFlags.None, component.LastCommand.flags & away);
        }

        [Test]
        public void AStartTransformIsUsed()
        {
            component.start = Make("start").transform;
            component.start.position = OnPlate(0.01, 0.02);
            component.BeginReach(virtualTarget);
            Vector3 start = Axes.ToUnity(component.Session.Config.startPositionM);
            Assert.That((start - new Vector3(0.01f, 0, -0.03f)).magnitude, Is.EqualTo(0).Within(1e-6));
        }

        [Test]
        public void AnUntrackedFingerIsADropout()
        {
            component.BeginReach(virtualTarget);
            component.Step(At(0));
            component.FingerTracked = false;
            component.Step(At(1000000));
            component.FingerTracked = true;
            component.finger.gameObject.SetActive(false);
            component.Step(At(2000000));
            Assert.AreEqual(2, component.EndReach().droppedSamples);
        }

        [Test]
        public void EventsReportTheCommandAndChanges()
        {
            var commands = new List<Command>();
            var orientations = new List<float>();
            var flags = new List<CommandFlags>();
            int ended = 0;
            component.Commanded += commands.Add;
            component.FlagsChanged += flags.Add;
            component.ReachEnded += summary => ++ended;
            component.onPlateOrientation.AddListener(orientations.Add);

            component.BeginReach(virtualTarget);
            component.Step(At(0));
            component.Step(At(0));
            component.finger.position = OnPlate(0, 0.2);
            component.Step(At(1));
            component.EndReach();

            Assert.AreEqual(3, commands.Count);
            Assert.AreEqual((float)commands[0].plateOrientationDeg, orientations[0]);
            for (int i = 1; i < orientations.Count; ++i) Assert.AreNotEqual(orientations[i - 1], orientations[i]);
            Assert.AreEqual(2, flags.Count);
            Assert.AreEqual(CommandFlags.None, flags[0] & CommandFlags.OffPlate);
            Assert.AreEqual(CommandFlags.OffPlate, flags[1] & CommandFlags.OffPlate);
            Assert.AreEqual(1, ended);
        }

        [Test]
        public void ArrivedIsRaisedOnceForEachEnd()
        {
            int arrived = 0, frame = 0;
            component.Arrived += command =>
            {
                ++arrived;
                Assert.AreEqual(CommandFlags.Arrived, command.flags & CommandFlags.Arrived);
            };
            component.BeginReach(virtualTarget);
            Vector3 start = component.finger.position;
            MoveTo(start, ref frame, 60);
            MoveTo(real.position, ref frame, 100);
            Assert.AreEqual(1, arrived);
            component.CancelReach();
            component.BeginReach(virtualTarget);
            MoveTo(start, ref frame, 60);
            MoveTo(real.position, ref frame, 100);
            Assert.AreEqual(2, arrived);
            MoveTarget(real, -15);
            component.RetargetReach(real, virtualTarget);
            MoveTo(real.position, ref frame, 200);
            Assert.AreEqual(3, arrived);
        }

        // Moves the finger to the target in a second, then rests for `rest` frames.
        void MoveTo(Vector3 target, ref int frame, int rest)
        {
            Vector3 from = component.finger.position, way = target - from;
            for (int i = 1; i <= 90 + rest; ++i)
            {
                component.finger.position = from + way * Math.Min(1, i / 90f) + Vector3.up * (1e-5f * (i % 2)); // a repeated position is a dropout
                component.Step(At(++frame * 11111111L));
            }
        }

        [Test]
        public void SettingsThatChangeInPlayModeAreAppliedToTheNextReach()
        {
            component.BeginReach(virtualTarget);
            component.CancelReach();
            SessionConfig config = component.Session.Config;
            config.tactileWeight = 0.3; // as if learnt or loaded from a profile
            component.Session.Config = config;
            component.maxFeltErrorDeg = 2;
            component.plateLatencyMs = 50;
            component.BeginReach(virtualTarget);
            config = component.Session.Config;
            Assert.AreEqual(2, config.maxFeltErrorDeg);
            Assert.AreEqual(50000000, config.plateLatencyNs);
            Assert.AreEqual(0.3, config.tactileWeight);
        }

        [Test]
        public void RidgesTurnWithTheCommand()
        {
            component.ridges = Make("ridges").transform;
            component.BeginReach(virtualTarget);
            for (int frame = 0; frame <= 30; ++frame)
            {
                component.finger.position = OnPlate(0, 0.1 * frame / 90);
                component.Step(At(frame * 11111111L));
            }
            Assert.Greater(Math.Abs(component.LastCommand.plateOrientationDeg), 10);
            Vector3 normal = component.ridges.localRotation * Vector3.forward;
            Vector3 expected = Axes.Direction(component.LastCommand.plateOrientationDeg);
            Assert.That((normal - expected).magnitude, Is.EqualTo(0).Within(1e-5));
        }

        // With the flag PlateWaits the first command is the measured orientation.
        [Test]
        public void MeasuredOrientationsAreUsed()
        {
            SessionConfig config = component.Session.Config;
            config.flags = SessionFlags.PlateWaits;
            component.Session.Config = config;
            component.MeasuredPlateOrientationDeg = 33;
            component.BeginReach(virtualTarget);
            component.Step(At(0));
            Assert.AreEqual(33, component.LastCommand.plateOrientationDeg);
            Sample sample = component.ReadFinger();
            Assert.AreEqual(SampleFlags.PlateOrientation, sample.flags & SampleFlags.PlateOrientation);
            Assert.AreEqual(33, sample.plateOrientationDeg);
        }

        [Test]
        public void InvalidArgumentsThrowWithTheirName()
        {
            real.position = OnPlate(0, 0);
            var refusal = Assert.Throws<HapticRetargetingException>(() => component.BeginReach(virtualTarget));
            StringAssert.Contains("cylinder", refusal.Message);
            StringAssert.Contains("position_m", refusal.Message);
            Assert.IsFalse(component.IsReaching);

            MoveTarget(real, -5);
            Assert.Throws<ArgumentException>(() => component.BeginReach(real));
            Assert.Throws<ArgumentException>(() => component.BeginReach(null));
            component.finger = null;
            component.plate = null;
            AssertInvalid("finger is not set", () => component.BeginReach(virtualTarget));
            component.finger = Make("finger").transform;
            AssertInvalid("plate is not set", () => component.BeginReach(virtualTarget));
            component.enabled = false;
            Assert.IsNull(component.Session);
            AssertInvalid("not enabled", () => component.BeginReach(virtualTarget));
        }

        static void AssertInvalid(string message, TestDelegate call) =>
            StringAssert.Contains(message, Assert.Throws<InvalidOperationException>(call).Message);

        [Test]
        public void DestroyedTargetsAreRemoved()
        {
            Transform other = MakeTarget("goblet", -3);
            component.virtualTargets.Add(other);
            component.BeginReach(virtualTarget);
            component.CancelReach();
            Assert.AreEqual(3, component.Session.ListTargets(0).Length);
            component.virtualTargets.Remove(other);
            UnityEngine.Object.DestroyImmediate(other.gameObject);
            component.BeginReach(virtualTarget);
            component.CancelReach();
            Assert.AreEqual(2, component.Session.ListTargets(0).Length);

            other = MakeTarget("cone", 5);
            component.realTargets.Add(other);
            component.BeginReach(other, virtualTarget);
            component.CancelReach();
            UnityEngine.Object.DestroyImmediate(other.gameObject);
            component.BeginReach(virtualTarget);
            Assert.AreEqual(2, component.Session.ListTargets(0).Length);
        }

        [Test]
        public void SettingsAreTheLibrarysDefaults()
        {
            object config = Make("fresh").AddComponent<HapticRetargeting>().Session.Config;
            object defaults = SessionConfig.Default;
            foreach (FieldInfo field in typeof(SessionConfig).GetFields())
                Assert.AreEqual(field.GetValue(defaults), field.GetValue(config), field.Name);
        }

        // Sets each setting of the component to another allowed value, and expects another configuration.
        [Test]
        public void EverySettingReachesTheConfiguration()
        {
            object defaults = SessionConfig.Default;
            int settings = 0;
            foreach (FieldInfo field in typeof(HapticRetargeting).GetFields())
            {
                string name = field.Name.EndsWith("Ms") ? field.Name.Substring(0, field.Name.Length - 2) + "Ns" : field.Name;
                FieldInfo configured = typeof(SessionConfig).GetField(name);
                if (configured == null) continue;
                var fresh = Make(name).AddComponent<HapticRetargeting>();
                fresh.enabled = false;
                object value = field.GetValue(fresh);
                if (value is double number) field.SetValue(fresh, number > 0 ? number * 0.9 : 0.01);
                else if (value is int steps) field.SetValue(fresh, steps + 1);
                else field.SetValue(fresh, Enum.ToObject(field.FieldType, Convert.ToInt32(value) == 1 ? 0 : 1));
                if (name.EndsWith("StopDeg")) fresh.plateUpperStopDeg = 190 + (fresh.plateLowerStopDeg = -10);
                fresh.enabled = true;
                object config = fresh.Session.Config;
                Assert.AreNotEqual(configured.GetValue(defaults), configured.GetValue(config), name);
                ++settings;
            }
            Assert.Greater(settings, 20);
        }

        // The simulated person touches a plate at (0.3, 0.75, 0.4) in Unity's axes, rotated by 20° to the left.
        [Test]
        public void ASetupMovesThePlateToItsMeasuredPose()
        {
            component.fingerIsJoint = true;
            var result = default(SetupResult);
            int steps = 0;
            double plateDeg = 0;
            component.SetupStepped += next => ++steps;
            component.SetupFinished += found => result = found;
            component.onPlateOrientation.AddListener(orientation => plateDeg = orientation);
            component.BeginSetup(SetupFlags.Fingertip | SetupFlags.Registration);
            using (var person = new HapticRetargetingPerson(1))
            {
                person.Begin(component.Session, default(TargetId));
                for (long timeNs = 0; component.IsSettingUp && timeNs < 60000000000; timeNs += 11111111)
                {
                    Sample sample = person.Move(timeNs, plateDeg);
                    component.finger.position = Axes.ToUnity(sample.fingerPositionM);
                    component.finger.rotation = Axes.ToUnity(sample.jointRotation);
                    component.Guide(At(timeNs));
                }
            }
            Assert.AreEqual(SetupFlags.Fingertip | SetupFlags.Registration, result.done);
            var at = new Vector3(0.3f, 0.75f, 0.4f);
            Assert.That((component.plate.position - at).magnitude, Is.EqualTo(0).Within(3e-3));
            Vector3 ahead = Axes.Direction(20);
            Assert.That((component.plate.rotation * Vector3.forward - ahead).magnitude, Is.EqualTo(0).Within(0.03));
            Assert.That(component.Session.Config.fingertipOffsetM.z, Is.EqualTo(-0.012).Within(3e-3));
            Assert.Less(steps, 100);
            Assert.That((component.PlaceOf(new Double3(0, 0, 0)) - at).magnitude, Is.EqualTo(0).Within(3e-3));

            component.BeginSetup(SetupFlags.Check);
            component.CancelSetup();
            Assert.IsFalse(component.IsSettingUp);
        }

        [Test]
        public void AStepIsReportedIfOnlyTheObservedMistakeChanges()
        {
            var steps = new List<SetupStep>();
            component.SetupStepped += steps.Add;
            component.BeginSetup(SetupFlags.Calibration);
            for (int frame = 0; frame <= 2000; ++frame) // 22 s
            {
                component.finger.position = OnPlate(0.04 + 1e-5 * (frame % 2), 0); // a repeated position is a dropout
                component.Guide(At(frame * 11111111L));
            }
            SetupStep last = steps[steps.Count - 1];
            Assert.AreEqual(Observed.Elsewhere, last.observed);
            StringAssert.Contains("from the requested position", last.text.ToString());
            component.CancelSetup();
        }

        [Test]
        public void PlacesIgnoreTheScaleOfThePlate()
        {
            component.plate.localScale = new Vector3(2, 3, 4);
            Vector3 place = component.PlaceOf(new Double3(0.01, 0, 0.05));
            Assert.That((place - OnPlate(0.01, 0)).magnitude, Is.EqualTo(0).Within(1e-6));
        }

        Sample At(long timeNs)
        {
            Sample sample = component.ReadFinger();
            sample.timeNs = timeNs;
            return sample;
        }

        // Converts a position to the world: metres to the right of the start and ahead of it. The start is 5 cm from
        // the plate's centre towards the user.
        Vector3 OnPlate(double right, double away) =>
            component.plate.position + component.plate.rotation * new Vector3((float)right, 0, (float)(away - 0.05));

        Transform MakeTarget(string name, double directionDeg)
        {
            Transform target = Make(name).transform;
            MoveTarget(target, directionDeg);
            return target;
        }

        void MoveTarget(Transform target, double directionDeg)
        {
            Vector3 direction = Axes.Direction(directionDeg);
            target.position = OnPlate(0.1 * direction.x, 0.1 * direction.z);
        }

        GameObject Make(string name)
        {
            var gameObject = new GameObject(name);
            made.Add(gameObject);
            return gameObject;
        }
    }
}
