using System;
using NUnit.Framework;
using UnityEngine;

namespace Hrt.HostTests
{
    public sealed class MemoryTests
    {
        const int Updates = 1000000;

        [Test]
        public void UpdatesMakeNoGarbage()
        {
            using (var session = new HapticRetargetingSession())
            {
                session.BeginReach(session.AddTarget(TargetRole.Real, -5), session.AddTarget(TargetRole.Virtual, 5));
                AssertNoGarbage(i => session.Update(StraightAhead(i)));
                AssertNoGarbage(i => session.TryUpdate(StraightAhead(Updates + 1), out Command command));
                session.EndReach();
                AssertNoGarbage(i => session.TryUpdate(StraightAhead(i), out Command refused));
            }
        }

        [Test]
        public void FurtherCallsPerFrameMakeNoGarbage()
        {
            using (var session = new HapticRetargetingSession())
            using (var person = new HapticRetargetingPerson(1))
            using (var plate = new HapticRetargetingPlate("serial:/nonexistent"))
            {
                TargetId real = session.AddTarget(TargetRole.Real, -5);
                TargetId seen = session.AddTarget(TargetRole.Virtual, 5);
                AssertNoGarbage(i =>
                {
                    session.BeginReach(real, seen);
                    session.Update(StraightAhead(i));
                    session.EndReach();
                    person.Begin(session, seen);
                    person.Move(i, 0);
                    plate.Get();
                });
                session.BeginSetup(SetupFlags.Calibration, SetupConfig.Default);
                AssertNoGarbage(i => session.UpdateSetup(StraightAhead(i)));
            }
        }

        [Test]
        public void FramesMakeNoGarbage()
        {
            HapticRetargeting component = UnityTests.Component();
            component.ridges = new GameObject("ridges").transform;
            int commands = 0, orientations = 0, flags = 0;
            component.Commanded += command => ++commands;
            component.onPlateOrientation.AddListener(orientation => ++orientations);
            component.FlagsChanged += changed => ++flags;
            component.MeasuredPlateOrientationDeg = 0;
            Time.unscaledTimeAsDouble = 0;
            component.BeginReach(component.virtualTargets[0]);
            Action lateUpdate = component.Message("LateUpdate");
            AssertNoGarbage(i =>
            {
                Time.unscaledTimeAsDouble = i / 90.0;
                component.finger.position = new Vector3(0, 0, -0.05f + i % 300 * 0.0003f);
                component.FingerTracked = i % 100 != 0;
                lateUpdate();
            });
            Assert.AreEqual(Updates, commands);
            Assert.Greater(orientations, 1);
            Assert.Greater(flags, 1);
            UnityEngine.Object.DestroyImmediate(component.gameObject);
        }

        // Creates more sessions than can exist at a time, without disposing of them.
        [Test]
        public void UnreferencedSessionsAreFinalised()
        {
            for (int i = 0; i < 5 * Constants.SessionsMax; ++i) Forget();
            GC.Collect();
            GC.WaitForPendingFinalizers();
            var used = new HapticRetargetingSession[Constants.SessionsMax];
            for (int i = 0; i < used.Length; ++i) used[i] = new HapticRetargetingSession();
            var refusal = Assert.Throws<HapticRetargetingException>(() => new HapticRetargetingSession());
            Assert.AreEqual(Result.LimitReached, refusal.Result);
            foreach (HapticRetargetingSession session in used) session.Dispose();
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }

        static void Forget() => new HapticRetargetingSession().AddTarget(TargetRole.Real, 0);

        static void AssertNoGarbage(Action<int> step)
        {
            for (int i = 0; i < 100; ++i) step(i); // until the code is compiled
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 100; i < Updates; ++i) step(i);
            Assert.AreEqual(0, GC.GetAllocatedBytesForCurrentThread() - before);
            byte[] garbage = new byte[100];
            Assert.Greater(GC.GetAllocatedBytesForCurrentThread() - before, garbage.Length);
        }

        static Sample StraightAhead(int frame) => new Sample
        {
            flags = SampleFlags.PlatePosition,
            timeNs = frame * 11111111L,
            fingerPositionM = new Double3(0, 0, 0.05 - frame % 300 * 0.1 / 300)
        };
    }
}
