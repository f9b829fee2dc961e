using Hrt;
using UnityEngine;
#if HRT_XR_HANDS
using System.Collections.Generic;
using UnityEngine.XR.Hands;
#endif

namespace HrtSamples
{
    /// <summary>
    /// Puts this object at the tip joint of a tracked index finger, and reports a hand that is lost. Needs the package XR Hands,
    /// 1.1 or later: the sample's assembly definition defines HRT_XR_HANDS where it is installed.
    /// </summary>
    public sealed class TrackedFinger : MonoBehaviour
    {
        [Tooltip("What this finger is given to.")]
        public HapticRetargeting retargeting;

        public bool left;

        [Tooltip("Tracking space, such as the Camera Offset of an XR Origin. None: it is the world.")]
        public Transform origin;

#if HRT_XR_HANDS
        readonly List<XRHandSubsystem> subsystems = new List<XRHandSubsystem>();

        void Update()
        {
            SubsystemManager.GetSubsystems(subsystems);
            XRHandSubsystem hands = subsystems.Find(one => one.running);
            Pose tip = Pose.identity;
            XRHand hand = hands == null ? default(XRHand) : left ? hands.leftHand : hands.rightHand;
            retargeting.FingerTracked = hand.isTracked && hand.GetJoint(XRHandJointID.IndexTip).TryGetPose(out tip);
            if (!retargeting.FingerTracked) return;
            if (origin != null) tip = new Pose(origin.TransformPoint(tip.position), origin.rotation * tip.rotation);
            transform.position = tip.position;
            transform.rotation = tip.rotation;
            retargeting.fingerIsJoint = true;
        }
#else
        void Start() =>
            Debug.LogError("Install the package XR Hands (com.unity.xr.hands, 1.1 or later): without it there is no hand", this);
#endif
    }
}
