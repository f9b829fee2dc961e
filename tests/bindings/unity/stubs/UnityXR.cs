// Stubs of the types of Unity's XR module and of its package XR Hands that the samples use. They show that the samples are
// right if the engine's types do what these do.
using System.Collections.Generic;

namespace UnityEngine
{
    public struct Pose
    {
        public Vector3 position;
        public Quaternion rotation;

        public Pose(Vector3 position, Quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }

        public static Pose identity => new Pose(Vector3.zero, Quaternion.identity);
    }

    public interface ISubsystem
    {
        bool running { get; }
    }

    public static class SubsystemManager
    {
        /// <summary>Of the stub: what there is.</summary>
        public static readonly List<ISubsystem> All = new List<ISubsystem>();

        public static void GetSubsystems<T>(List<T> subsystems) where T : ISubsystem
        {
            subsystems.Clear();
            foreach (ISubsystem subsystem in All)
                if (subsystem is T found) subsystems.Add(found);
        }
    }
}

namespace UnityEngine.XR
{
    public enum XRNode
    {
        CenterEye = 2
    }

    public struct InputFeatureUsage<T>
    {
    }

    public static class CommonUsages
    {
        public static InputFeatureUsage<Vector3> centerEyePosition;
        public static InputFeatureUsage<Quaternion> centerEyeRotation;
    }

    public struct InputDevice
    {
        internal Pose? Head;

        public bool TryGetFeatureValue(InputFeatureUsage<Vector3> usage, out Vector3 value)
        {
            value = Head.GetValueOrDefault().position;
            return Head.HasValue;
        }

        public bool TryGetFeatureValue(InputFeatureUsage<Quaternion> usage, out Quaternion value)
        {
            value = Head.GetValueOrDefault().rotation;
            return Head.HasValue;
        }
    }

    public static class InputDevices
    {
        /// <summary>Of the stub: where the headset is; null: there is none.</summary>
        public static Pose? Head { get; set; }

        public static InputDevice GetDeviceAtXRNode(XRNode node) => new InputDevice { Head = Head };
    }

    public enum TrackingOriginModeFlags
    {
        Floor = 2
    }

    public sealed class XRInputSubsystem : ISubsystem
    {
        public bool running => true;
        public TrackingOriginModeFlags Mode { get; private set; }

        public bool TrySetTrackingOriginMode(TrackingOriginModeFlags mode)
        {
            Mode = mode;
            return true;
        }
    }
}

namespace UnityEngine.XR.Hands
{
    public enum XRHandJointID
    {
        IndexTip = 11
    }

    public struct XRHandJoint
    {
        internal Pose? Place;

        public bool TryGetPose(out Pose pose)
        {
            pose = Place.GetValueOrDefault();
            return Place.HasValue;
        }
    }

    public struct XRHand
    {
        /// <summary>Of the stub: the tip of the index finger.</summary>
        public Pose? Tip;

        public bool isTracked { get; set; }

        public XRHandJoint GetJoint(XRHandJointID id) => new XRHandJoint { Place = Tip };
    }

    public sealed class XRHandSubsystem : ISubsystem
    {
        public bool running { get; set; } = true;
        public XRHand leftHand { get; set; }
        public XRHand rightHand { get; set; }
    }
}
