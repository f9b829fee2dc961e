using Hrt;
using UnityEngine;
#if HRT_XR_HANDS
using System.Collections.Generic;
using UnityEngine.XR.Hands;
#endif

namespace HrtSamples
{
    /// <summary>
    /// Puts this object at the tip of a tracked index finger, and reports a hand that is lost. Needs the package XR Hands,
    /// 1.1 or later: the sample's assembly definition defines HRT_XR_HANDS where it is installed.
    /// </summary>
    public sealed class TrackedFinger : MonoBehaviour
    {
        public enum Side
        {
            Right,
            Left
        }

        [Tooltip("What this finger is given to.")]
        public HapticRetargeting retargeting;

        public Side side = Side.Right;

        [Tooltip("Tracking space, such as the Camera Offset of an XR Origin. None: it is the world.")]
        public Transform origin;

        /// <summary>The offset from the tracked joint to the skin, of
        /// HapticRetargetingRegistration.FitFingertip; null: the skin is at the joint.</summary>
        public Fingertip? Skin { get; set; }

        void Update()
        {
            bool tracked = TryGetTip(out Pose tip);
            retargeting.FingerTracked = tracked;
            if (!tracked) return;
            if (origin != null)
                tip = new Pose(origin.TransformPoint(tip.position), origin.rotation * tip.rotation);
            transform.rotation = tip.rotation;
            transform.position = Skin.HasValue ? SkinOf(tip, Skin.Value) : tip.position;
        }

        static Vector3 SkinOf(Pose tip, Fingertip fingertip)
        {
            var joint = new JointTouch
            {
                positionM = Axes.FromUnity(tip.position), rotation = Axes.FromUnity(tip.rotation)
            };
            var sample = new Sample();
            HapticRetargetingRegistration.Place(fingertip, joint, ref sample);
            return Axes.ToUnity(sample.fingerPositionM);
        }

#if HRT_XR_HANDS
        readonly List<XRHandSubsystem> subsystems = new List<XRHandSubsystem>();
        XRHandSubsystem hands;

        bool TryGetTip(out Pose tip)
        {
            tip = Pose.identity;
            if (hands == null || !hands.running)
            {
                SubsystemManager.GetSubsystems(subsystems);
                hands = subsystems.Find(one => one.running);
                if (hands == null) return false;
            }
            XRHand hand = side == Side.Right ? hands.rightHand : hands.leftHand;
            return hand.isTracked && hand.GetJoint(XRHandJointID.IndexTip).TryGetPose(out tip);
        }
#else
        void Start()
        {
            Debug.LogError("Install the package XR Hands (com.unity.xr.hands, 1.1 or later): without it there is no hand",
                           this);
        }

        static bool TryGetTip(out Pose tip)
        {
            tip = Pose.identity;
            return false;
        }
#endif
    }
}
