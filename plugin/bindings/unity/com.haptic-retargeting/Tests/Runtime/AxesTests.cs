using System;
using NUnit.Framework;
using UnityEngine;

namespace Hrt.Tests
{
    // Expected values are derived by hand: mirroring z keeps x and y of a position, and z and w of a rotation.
    public sealed class AxesTests
    {
        [Test]
        public void ForwardIsAwayFromTheUser()
        {
            Assert.AreEqual(new Double3(1, 2, -3), Axes.FromUnity(new Vector3(1, 2, 3)));
        }

        [Test]
        public void ConversionsRoundTrip()
        {
            var random = new System.Random(2);
            for (int i = 0; i < 100; ++i)
            {
                Quaternion rotation = RandomRotation(random), again = Axes.ToUnity(Axes.FromUnity(rotation));
                Assert.That(again.x, Is.EqualTo(rotation.x).Within(1e-6));
                Assert.That(again.y, Is.EqualTo(rotation.y).Within(1e-6));
                Assert.That(again.z, Is.EqualTo(rotation.z).Within(1e-6));
                Assert.That(again.w, Is.EqualTo(rotation.w).Within(1e-6));
                Vector3 place = RandomPlace(random);
                Assert.AreEqual(place, Axes.ToUnity(Axes.FromUnity(place)));
            }
        }

        [Test]
        public void RotationsAreOfLengthOneInDoublePrecision()
        {
            Double4 r = Axes.FromUnity(new Quaternion(0.1f, 0.2f, 0.3f, 0.9f));
            Assert.That(r.x * r.x + r.y * r.y + r.z * r.z + r.w * r.w, Is.EqualTo(1).Within(1e-15));
        }

        [TestCase(0, 0, 1)]
        [TestCase(90, -1, 0)]
        [TestCase(-90, 1, 0)]
        public void DirectionsAreCounterClockwiseSeenFromAbove(double directionDeg, float right, float forward)
        {
            Vector3 expected = new Vector3(right, 0, forward);
            Assert.That((Axes.Direction(directionDeg) - expected).magnitude, Is.EqualTo(0).Within(1e-6));
        }

        [Test]
        public void RidgeRotationTurnsTheNormal()
        {
            foreach (double orientationDeg in new double[] {0, 30, -30, 84.5, 135})
            {
                Vector3 turned = Axes.RidgeRotation(orientationDeg) * Vector3.forward;
                Vector3 normal = Axes.Direction(orientationDeg);
                Assert.That((turned - normal).magnitude, Is.EqualTo(0).Within(1e-6));
            }
        }

        // The library's geometry gives the expected direction of a position in Unity's world, for a plate with an
        // arbitrary pose.
        [Test]
        public void WorldPositionsAreConvertedForEveryPlatePose()
        {
            var random = new System.Random(3);
            for (int i = 0; i < 200; ++i)
            {
                Vector3 platePosition = RandomPlace(random);
                Quaternion plateRotation = i == 0 ? Quaternion.identity : RandomRotation(random);
                double bearingDeg = random.NextDouble() * 160 - 80;
                Vector3 onPlate = new Vector3(0, 0, -0.05f) + Axes.Direction(bearingDeg) * 0.1f;
                onPlate.y = (float)random.NextDouble() * 0.1f;

                SessionConfig config = SessionConfig.Default;
                config.platePositionM = Axes.FromUnity(platePosition);
                config.plateRotation = Axes.FromUnity(plateRotation);
                using (var session = new HapticRetargetingSession(config))
                {
                    TargetId ahead = session.AddTarget(TargetRole.Real, 0);
                    TargetConfig target = TargetConfig.Default;
                    target.role = TargetRole.Virtual;
                    target.place = Place.WorldPosition;
                    target.positionM = Axes.FromUnity(platePosition + plateRotation * onPlate);
                    Gap gap = session.QueryGap(ahead, session.AddTarget(target));
                    Assert.That(gap.gapDeg, Is.EqualTo(bearingDeg).Within(2e-3));
                }
            }
        }

        internal static Vector3 RandomPlace(System.Random random) =>
            new Vector3((float)(random.NextDouble() * 4 - 2), (float)(random.NextDouble() * 4 - 2),
                        (float)(random.NextDouble() * 4 - 2));

        internal static Quaternion RandomRotation(System.Random random) =>
            Quaternion.Euler((float)(random.NextDouble() * 360), (float)(random.NextDouble() * 360),
                             (float)(random.NextDouble() * 360));
    }
}
