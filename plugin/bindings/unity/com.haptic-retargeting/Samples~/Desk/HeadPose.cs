using System.Collections.Generic;
using UnityEngine;
using UnityEngine.XR;

namespace HrtSamples
{
    /// <summary>Moves a camera with the headset, its floor at y 0, whichever Input System the project has. A scene with an
    /// XR Origin does not need it.</summary>
    public sealed class HeadPose : MonoBehaviour
    {
        readonly List<XRInputSubsystem> subsystems = new List<XRInputSubsystem>();
        bool floored;

        void OnEnable()
        {
            Application.onBeforeRender += Follow;
        }

        void OnDisable()
        {
            Application.onBeforeRender -= Follow;
        }

        void Update()
        {
            Follow();
            if (floored) return;
            SubsystemManager.GetSubsystems(subsystems);
            foreach (XRInputSubsystem input in subsystems)
                floored |= input.TrySetTrackingOriginMode(TrackingOriginModeFlags.Floor);
        }

        void Follow()
        {
            InputDevice head = InputDevices.GetDeviceAtXRNode(XRNode.CenterEye);
            if (head.TryGetFeatureValue(CommonUsages.centerEyePosition, out Vector3 position))
                transform.localPosition = position;
            if (head.TryGetFeatureValue(CommonUsages.centerEyeRotation, out Quaternion rotation))
                transform.localRotation = rotation;
        }
    }
}
