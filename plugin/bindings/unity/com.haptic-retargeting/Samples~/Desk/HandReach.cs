using Hrt;
using UnityEngine;

namespace HrtSamples
{
    /// <summary>
    /// Reaches of a tracked hand without a button: rest the fingertip at the start, slide to the virtual object that the
    /// console names, rest there. The virtual objects follow one another. Put this on an empty object that stands where
    /// your plate is; the camera may be that of an XR Origin, or one of the scene, which then follows the headset.
    /// </summary>
    [RequireComponent(typeof(Desk))]
    public sealed class HandReach : MonoBehaviour
    {
        HapticRetargeting retargeting;

        [Tooltip("Distance from the start, in metres, within which a resting finger begins a reach.")]
        public float startRadiusM = 0.015f;

        [Tooltip("Speed, in metres a second, below which a finger rests.")]
        public float restSpeed = 0.02f;

        [Tooltip("Time in seconds for which the finger rests before a reach begins or ends.")]
        public float restS = 0.5f;

        [Tooltip("Distance from the start, in metres, after which a resting finger ends the reach.")]
        public float minPathM = 0.05f;

        Vector3 last;
        double lastS;
        double restingSinceS;
        int chosen;

        Transform Chosen => retargeting.virtualTargets[chosen];

        void Start()
        {
            retargeting = GetComponent<Desk>().Retargeting;
            var finger = retargeting.finger.gameObject.AddComponent<TrackedFinger>();
            finger.retargeting = retargeting;
            finger.origin = Camera.main.transform.parent;
            if (finger.origin == null) Camera.main.gameObject.AddComponent<HeadPose>();
            retargeting.ReachEnded += Report;
            lastS = restingSinceS = Time.unscaledTimeAsDouble;
            Announce();
        }

        void OnDestroy()
        {
            retargeting.ReachEnded -= Report;
        }

        void Update()
        {
            double nowS = Time.unscaledTimeAsDouble;
            Vector3 finger = retargeting.finger.position;
            bool moves = (finger - last).magnitude > restSpeed * (nowS - lastS);
            if (moves || !retargeting.FingerTracked) restingSinceS = nowS;
            last = finger;
            lastS = nowS;
            if (nowS - restingSinceS < restS) return;

            float fromStartM = (finger - retargeting.start.position).magnitude;
            if (!retargeting.IsReaching && fromStartM < startRadiusM) retargeting.BeginReach(Chosen);
            else if (retargeting.IsReaching && fromStartM > minPathM) retargeting.EndReach();
        }

        void Report(ReachSummary summary)
        {
            Debug.Log($"To the {Chosen.name}: {summary.distanceToTargetM * 1000:0} mm from the real target; felt, as the " +
                      $"model has it, {summary.perceivedErrorDeg:0.0} degrees beside", this);
            chosen = (chosen + 1) % retargeting.virtualTargets.Count;
            Announce();
        }

        void Announce() => Debug.Log($"Rest your fingertip at the start, then slide to the {Chosen.name}", this);
    }
}
