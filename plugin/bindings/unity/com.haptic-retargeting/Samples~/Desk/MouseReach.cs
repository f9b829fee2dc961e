using Hrt;
using UnityEngine;

namespace HrtSamples
{
    /// <summary>
    /// Put this on an empty object of a scene with a camera, and press play. The mouse is the finger: choose an object
    /// with 1, 2 or 3, press the button near the start, drag towards the object, release there. A mouse feels no ridges,
    /// so the plate turns and the hand is not bent. Works with any Active Input Handling: the events are those of OnGUI.
    /// </summary>
    [RequireComponent(typeof(Desk))]
    public sealed class MouseReach : MonoBehaviour
    {
        HapticRetargeting retargeting;
        int chosen;

        void Start()
        {
            retargeting = GetComponent<Desk>().Retargeting;
            retargeting.FlagsChanged += flags => Debug.Log("The controller says: " + flags, this);
            retargeting.ReachEnded += Report;

            Camera.main.transform.position = retargeting.plate.position + new Vector3(0, 0.4f, -0.1f);
            Camera.main.transform.rotation = Quaternion.Euler(70, 0, 0);
            Camera.main.nearClipPlane = 0.01f;
        }

        void OnGUI()
        {
            Event input = Event.current;
            int key = input.type == EventType.KeyDown ? input.keyCode - KeyCode.Alpha1 : -1;
            if (key >= 0 && key < retargeting.virtualTargets.Count) chosen = key;

            var face = new Plane(retargeting.plate.up, retargeting.plate.position);
            // The pixels of OnGUI are counted from the top.
            Ray pointed = Camera.main.ScreenPointToRay(
                new Vector3(input.mousePosition.x, Screen.height - input.mousePosition.y, 0));
            if (face.Raycast(pointed, out float distance)) retargeting.finger.position = pointed.GetPoint(distance);

            if (input.type == EventType.MouseDown && input.button == 0)
                retargeting.BeginReach(retargeting.virtualTargets[chosen]);
            if (input.type == EventType.MouseUp && input.button == 0 && retargeting.IsReaching) retargeting.EndReach();
        }

        void Report(ReachSummary summary)
        {
            Debug.Log($"To the {retargeting.virtualTargets[chosen].name}: " +
                      $"{summary.distanceToTargetM * 1000:0} mm from the cylinder; felt, as the model has it, " +
                      $"{summary.perceivedErrorDeg:0.0} degrees beside", this);
        }
    }
}
