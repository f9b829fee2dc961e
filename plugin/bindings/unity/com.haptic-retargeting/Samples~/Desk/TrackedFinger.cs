using Hrt;
using UnityEngine;
#if HRT_XR_HANDS
using System.Collections.Generic;
using UnityEngine.XR.Hands;
#endif

namespace HrtSamples
{
    /// <summary>
    /// Moves this object to the tip joint of a tracked index finger, and reports a lost hand. Needs the package XR Hands 1.1
    /// or later: the sample's assembly definition defines HRT_XR_HANDS if it is installed.
    /// </summary>
    public sealed class TrackedFinger : MonoBehaviour
    {
        [Tooltip("The component whose finger this is.")]
        public HapticRetargeting retargeting;

        public bool left;

        [Tooltip("Tracking space, such as the Camera Offset of an XR Origin. None: the world.")]
        public Transform origin;

#if HRT_XR_HANDS
        readonly List<XRHandSubsystem> subsystems = new List<XRHandSubsystem>();
        XRHandSubsystem hands;

        // Reads hands in the callback of their update, because Update may still have the poses of the previous frame.
        void Update()
        {
            if (hands != null && hands.running) return;
            Release();
            SubsystemManager.GetSubsystems(subsystems);
            hands = subsystems.Find(one => one.running);
            if (hands != null) hands.updatedHands += Read;
        }

        void OnDisable() => Release();

        void Release()
        {
            if (hands != null) hands.updatedHands -= Read;
            hands = null;
            retargeting.FingerTracked = false;
        }

        void Read(XRHandSubsystem updated, XRHandSubsystem.UpdateSuccessFlags flags, XRHandSubsystem.UpdateType type)
        {
            if (type != XRHandSubsystem.UpdateType.Dynamic) return; // poses just before rendering are too late for this frame
            Pose tip = Pose.identity;
            XRHand hand = left ? updated.leftHand : updated.rightHand;
            retargeting.FingerTracked = hand.isTracked && hand.GetJoint(XRHandJointID.IndexTip).TryGetPose(out tip);
            if (!retargeting.FingerTracked) return;
            if (origin != null) tip = new Pose(origin.TransformPoint(tip.position), origin.rotation * tip.rotation);
            transform.position = tip.position;
            transform.rotation = tip.rotation;
            retargeting.fingerIsJoint = true;
        }
#else
        void Start() =>
            Debug.LogError("Install the package XR Hands (com.unity.xr.hands, 1.1 or later), which has the tracked hands", this);
#endif
    }
}
