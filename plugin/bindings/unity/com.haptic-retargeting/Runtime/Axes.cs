using System;
using UnityEngine;

namespace Hrt
{
    /// <summary>
    /// Converts between Unity's axes and the library's. Unity is left-handed: x right, y up, z forward. The library is
    /// right-handed: x right, y up, z towards the user. Both use metres, and z is mirrored. Mirroring reverses
    /// rotations: a rotation about the axis (x, y, z) becomes a rotation by the same angle about (-x, -y, z).
    ///
    /// The y axis of a plate's Transform points out of the ridged face, and its z axis (forward) straight away from the
    /// user, along the mid-line from which directions are measured. The scale is ignored.
    /// </summary>
    public static class Axes
    {
        /// <summary>Converts a position in Unity's world, or in a Transform's axes, to the library's axes.</summary>
        public static Double3 FromUnity(Vector3 position) => new Double3(position.x, position.y, -(double)position.z);

        public static Vector3 ToUnity(Double3 position) =>
            new Vector3((float)position.x, (float)position.y, (float)-position.z);

        /// <summary>Converts a rotation to the library's axes, with length 1 in double precision.</summary>
        public static Double4 FromUnity(Quaternion rotation)
        {
            double x = rotation.x, y = rotation.y, z = rotation.z, w = rotation.w;
            double length = Math.Sqrt(x * x + y * y + z * z + w * w);
            return new Double4(-x / length, -y / length, z / length, w / length);
        }

        public static Quaternion ToUnity(Double4 rotation) =>
            new Quaternion((float)-rotation.x, (float)-rotation.y, (float)rotation.z, (float)rotation.w);

        /// <summary>Converts a direction of the library (degrees from the mid-line, counter-clockwise seen from above)
        /// to a unit vector in the plate's Transform: forward at 0, left at 90.</summary>
        public static Vector3 Direction(double directionDeg)
        {
            double angle = directionDeg * (Math.PI / 180);
            return new Vector3((float)-Math.Sin(angle), 0, (float)Math.Cos(angle));
        }

        /// <summary>Returns the rotation about the plate's y axis for a plate orientation. Unity's angles are
        /// clockwise, the library's counter-clockwise.</summary>
        public static Quaternion RidgeRotation(double orientationDeg) =>
            Quaternion.Euler(0, (float)-orientationDeg, 0);
    }
}
