using Hrt;
using UnityEngine;

namespace HrtSamples
{
    /// <summary>
    /// Add this to an empty object of a scene with a camera, and press play: a simulated person slides to one virtual
    /// object after the other, feels the ridges, and is steered to the cylinder.
    /// </summary>
    [RequireComponent(typeof(Desk))]
    public sealed class SimulatedReach : MonoBehaviour
    {
        public int seed = 7;

        HapticRetargeting retargeting;
        HapticRetargetingPerson person;
        int chosen;

        void Start()
        {
            retargeting = GetComponent<Desk>().Retargeting;
            retargeting.Arrived += Next;
            person = new HapticRetargetingPerson((ulong)seed);
            Camera.main.transform.position = retargeting.plate.position + new Vector3(0, 0.4f, -0.1f);
            Camera.main.transform.rotation = Quaternion.Euler(70, 0, 0);
            Camera.main.nearClipPlane = 0.01f;
            Begin();
        }

        void OnDestroy()
        {
            retargeting.Arrived -= Next;
            person.Dispose();
        }

        void Begin()
        {
            Transform target = retargeting.virtualTargets[chosen];
            retargeting.BeginReach(target);
            person.Begin(retargeting.Session, retargeting.IdOf(target));
        }

        void Update()
        {
            Sample sample = person.Move((long)(Time.unscaledTimeAsDouble * 1e9), retargeting.LastCommand.plateOrientationDeg);
            retargeting.finger.position = retargeting.PlaceOf(sample.fingerPositionM);
            retargeting.MeasuredPlateOrientationDeg = sample.plateOrientationDeg;
        }

        void Next(Command arrived)
        {
            ReachSummary summary = retargeting.EndReach();
            Debug.Log($"To the {retargeting.virtualTargets[chosen].name}, simulated: the hand ended " +
                      $"{summary.distanceToTargetM * 1000:0} mm from the cylinder; by the model, the perceived direction was " +
                      $"at most {summary.peakFeltErrorDeg:0.0} degrees from the intended one", this);
            chosen = (chosen + 1) % retargeting.virtualTargets.Count;
            Begin();
        }
    }
}
