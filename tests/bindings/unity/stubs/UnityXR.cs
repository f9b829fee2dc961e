// Stubs of the types of Unity's package XR Hands that the samples use. Tests with them are valid if the engine's
// types behave like these.
using System;
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
        /// <summary>For tests: the existing subsystems.</summary>
        public static readonly List<ISubsystem> All = new List<ISubsystem>();

        public static void GetSubsystems<T>(List<T> subsystems) where T : ISubsystem
        {
            subsystems.Clear();
            foreach (ISubsystem subsystem in All)
                if (subsystem is T found) subsystems.Add(found);
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
        /// <summary>For tests: pose of the tip of the index finger.</summary>
        public Pose? Tip;

        public bool isTracked { get; set; }

        public XRHandJoint GetJoint(XRHandJointID id) => new XRHandJoint { Place = Tip };
    }

    public sealed class XRHandSubsystem : ISubsystem
    {
        public enum UpdateSuccessFlags
        {
            None
        }

        public enum UpdateType
        {
            Dynamic,
            BeforeRender
        }

        public event Action<XRHandSubsystem, UpdateSuccessFlags, UpdateType> updatedHands;

        public bool running { get; set; } = true;
        public XRHand leftHand { get; set; }
        public XRHand rightHand { get; set; }

        /// <summary>For tests: signals an update of the hands.</summary>
        public void Raise(UpdateType type) => updatedHands?.Invoke(this, UpdateSuccessFlags.None, type);

        /// <summary>For tests: true if a script has subscribed.</summary>
        public bool IsHeard => updatedHands != null;
    }
}
