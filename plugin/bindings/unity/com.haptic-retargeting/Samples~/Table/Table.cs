using Hrt;
using UnityEngine;

namespace HrtSamples
{
    /// <summary>
    /// A plate, a real cylinder and three virtual objects, to see how the component is used: those of the prefab, or, on
    /// an empty object in a scene with a camera, made from code. Press play. The mouse is the finger: choose
    /// an object with 1, 2 or 3, press the button near the start, drag towards the object, release there. A mouse
    /// feels no ridges, so the plate turns and the hand is not bent. Works with any Active Input Handling: the
    /// events are those of OnGUI.
    /// </summary>
    public sealed class Table : MonoBehaviour
    {
        static readonly string[] virtualNames = {"bottle", "goblet", "pawn"};
        static readonly double[] virtualDirectionsDeg = {6, -8, 12};

        HapticRetargeting retargeting;
        int chosen;

        void Start()
        {
            retargeting = gameObject.GetComponent<HapticRetargeting>();
            if (retargeting == null) MakeDesk();
            retargeting.FlagsChanged += flags => Debug.Log("The controller says: " + flags, this);
            retargeting.ReachEnded += Report;

            Camera.main.transform.position = retargeting.plate.position + new Vector3(0, 0.4f, -0.1f);
            Camera.main.transform.rotation = Quaternion.Euler(70, 0, 0);
            Camera.main.nearClipPlane = 0.01f;
        }

        void MakeDesk()
        {
            retargeting = gameObject.AddComponent<HapticRetargeting>();
            retargeting.plate = new GameObject("plate").transform;
            retargeting.plate.position = new Vector3(0, 0.75f, 0.4f);
            retargeting.ridges = MakeRidges();
            retargeting.finger = Make(PrimitiveType.Sphere, "finger", new Vector3(0.01f, 0.01f, 0.01f));
            retargeting.realTargets.Add(MakeTarget("cylinder", 0));
            for (int i = 0; i < virtualNames.Length; ++i)
                retargeting.virtualTargets.Add(MakeTarget(virtualNames[i], virtualDirectionsDeg[i]));
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

        // Children of the plate's mount, which turn while the mount stays.
        Transform MakeRidges()
        {
            Transform ridges = new GameObject("ridges").transform;
            ridges.SetParent(retargeting.plate, false);
            for (int i = -7; i <= 7; ++i)
            {
                float across = i * 0.01f, length = 2 * Mathf.Sqrt(0.075f * 0.075f - across * across);
                Transform ridge = Make(PrimitiveType.Cube, "ridge", new Vector3(length, 0.001f, 0.001f));
                ridge.SetParent(ridges, false);
                ridge.localPosition = new Vector3(0, 0, across);
            }
            return ridges;
        }

        // 10 cm from the start, which is 5 cm from the plate's centre towards the user.
        Transform MakeTarget(string targetName, double directionDeg)
        {
            Transform target = Make(PrimitiveType.Cylinder, targetName, new Vector3(0.015f, 0.02f, 0.015f));
            target.position = retargeting.plate.position + new Vector3(0, 0, -0.05f) +
                              Axes.Direction(directionDeg) * 0.1f;
            return target;
        }

        static Transform Make(PrimitiveType shape, string objectName, Vector3 size)
        {
            GameObject made = GameObject.CreatePrimitive(shape);
            made.name = objectName;
            made.transform.localScale = size;
            return made.transform;
        }
    }
}
