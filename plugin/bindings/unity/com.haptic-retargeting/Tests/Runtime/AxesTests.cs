using System;
using NUnit.Framework;
using UnityEngine;

namespace Hrt.Tests
{
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
            var rotation = new Quaternion(0.1f, -0.2f, 0.3f, (float)Math.Sqrt(0.86));
            Quaternion again = Axes.ToUnity(Axes.FromUnity(rotation));
            Assert.That(again.x * rotation.x + again.y * rotation.y + again.z * rotation.z + again.w * rotation.w,
                        Is.EqualTo(1).Within(1e-6));
            var place = new Vector3(1, -2, 3.5f);
            Assert.AreEqual(place, Axes.ToUnity(Axes.FromUnity(place)));
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
    }
}
