using System;
using UnityEngine;

namespace Hrt
{
    /// <summary>
    /// Between Unity's axes and the library's. Unity: left-handed, x right, y up, z forward. The library:
    /// right-handed, x right, y up, z towards the user. Both have y up, and metres for one unit of length; z is
    /// mirrored. A mirror turns rotations around: that by an angle about the axis (x, y, z) becomes that by the
    /// same angle about (-x, -y, z).
    ///
    /// A plate's Transform has its y axis out of the ridged face and its z axis (forward) straight away from the
    /// user, along the mid-line that directions are measured from. Its scale is not looked at.
    /// </summary>
    public static class Axes
    {
        /// <summary>A place in Unity's world, or in a Transform's axes, as the library has it.</summary>
        public static Double3 FromUnity(Vector3 position) => new Double3(position.x, position.y, -(double)position.z);

        public static Vector3 ToUnity(Double3 position) =>
            new Vector3((float)position.x, (float)position.y, (float)-position.z);

        /// <summary>A rotation as the library has it, of length 1 in double precision.</summary>
        public static Double4 FromUnity(Quaternion rotation)
        {
            double x = rotation.x, y = rotation.y, z = rotation.z, w = rotation.w;
            double length = Math.Sqrt(x * x + y * y + z * z + w * w);
            return new Double4(-x / length, -y / length, z / length, w / length);
        }

        public static Quaternion ToUnity(Double4 rotation) =>
            new Quaternion((float)-rotation.x, (float)-rotation.y, (float)rotation.z, (float)rotation.w);

        /// <summary>A direction of the library's (degrees from the mid-line, counter-clockwise seen from above)
        /// as a unit vector in the plate's Transform: forward at 0, left at 90.</summary>
        public static Vector3 Direction(double directionDeg)
        {
            double angle = directionDeg * (Math.PI / 180);
            return new Vector3((float)-Math.Sin(angle), 0, (float)Math.Cos(angle));
        }

        /// <summary>The rotation, about the plate's y axis, of ridges that stand at an orientation of the
        /// library's. Unity counts clockwise where the library counts counter-clockwise.</summary>
        public static Quaternion RidgeRotation(double orientationDeg) =>
            Quaternion.Euler(0, (float)-orientationDeg, 0);
    }
}
