using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Events;

namespace Hrt
{
    /// <summary>
    /// Passes the finger and the plate to the controller in each frame of a reach or a set-up. Begin a reach with
    /// <see cref="BeginReach(Transform)"/>, turn the real plate to the orientation of <see cref="Commanded"/> or
    /// <see cref="onPlateOrientation"/>, and call <see cref="EndReach"/> when <see cref="Arrived"/> is raised.
    ///
    /// Samples are taken in LateUpdate, with a late execution order, so that other scripts have moved the finger. Their
    /// time is the unscaled time of the frame, because a game that is slowed down or paused does not slow the hand. One
    /// unit of length is one metre.
    /// </summary>
    [DefaultExecutionOrder(10000)]
    [AddComponentMenu("Haptic Retargeting/Haptic Retargeting")]
    [DisallowMultipleComponent]
    public sealed partial class HapticRetargeting : MonoBehaviour
    {
        [Serializable]
        public sealed class OrientationEvent : UnityEvent<float>
        {
        }

        [Header("Scene")]
        [Tooltip("The plate's mount: at the plate's centre, y out of the ridged face, z straight away from the " +
                 "user. It does not turn with the ridges.")]
        public Transform plate;

        [Tooltip("The tracked fingertip. While it is inactive, or FingerTracked is false, the plate keeps its orientation.")]
        public Transform finger;

        [Tooltip("The finger is a tracked joint: a set-up measures the offset of the skin from the joint.")]
        public bool fingerIsJoint;

        [Tooltip("Start of reaches. None: on the plate, 5 cm from its centre towards the user.")]
        public Transform start;

        [Tooltip("Object that shows the commanded plate orientation: it turns about its y axis. Optional.")]
        public Transform ridges;

        [Tooltip("Real objects, to which the hand is steered.")]
        public List<Transform> realTargets = new List<Transform>();

        [Tooltip("Virtual objects, which are displayed to the user.")]
        public List<Transform> virtualTargets = new List<Transform>();

        [Header("Events")]
        [Tooltip("Raised at the first command, and when the commanded plate orientation changes; in degrees, " +
                 "counter-clockwise seen from above.")]
        public OrientationEvent onPlateOrientation = new OrientationEvent();

        /// <summary>Raised in each frame of a reach with the command, unless the sample is refused.</summary>
        public event Action<Command> Commanded;

        /// <summary>Raised at the first command of a reach, and when flags other than Held change.</summary>
        public event Action<CommandFlags> FlagsChanged;

        /// <summary>Raised when a command gets the flag Arrived: the motion has ended. Call <see cref="EndReach"/>,
        /// here or later. With the flag OffTarget, the finger has probably missed.</summary>
        public event Action<Command> Arrived;

        public event Action<ReachSummary> ReachEnded;

        /// <summary>Raised when a step of a set-up differs from the previous one in more than the plate orientation: show
        /// its text, and its position with <see cref="PlaceOf"/>. At Step.Finish the user waits for a fit, which continues
        /// in each frame.</summary>
        public event Action<SetupStep> SetupStepped;

        /// <summary>Raised when all parts of the set-up have ended, and results are applied.</summary>
        public event Action<SetupResult> SetupFinished;

        // Ids of the session's targets. A Transform may have both roles: a cylinder may be its own virtual target.
        readonly Dictionary<Transform, TargetId> realIds = new Dictionary<Transform, TargetId>();
        readonly Dictionary<Transform, TargetId> virtualIds = new Dictionary<Transform, TargetId>();

        SessionConfig settings; // values of the inspector that were applied last
        SetupStep setupStep;
        SetupFlags setupDone;
        bool commanded;
        bool refused;

        /// <summary>The session, for its configuration, profile and recording between reaches. Null while the component
        /// is disabled. BeginReach sets plate, start and targets from the Transforms, and applies changed settings of
        /// the inspector.</summary>
        public HapticRetargetingSession Session { get; private set; }

        public bool IsReaching { get; private set; }

        public bool IsSettingUp { get; private set; }

        /// <summary>The last command, of this reach or else of the previous one; zeros before the first.</summary>
        public Command LastCommand { get; private set; }

        /// <summary>Set this to false while the finger is not tracked and its Transform is outdated.</summary>
        public bool FingerTracked { get; set; } = true;

        /// <summary>Set this in each frame to the orientation that the device reports. Null: the plate is assumed to
        /// follow its commands as its speed and latency allow.</summary>
        public double? MeasuredPlateOrientationDeg { get; set; }

        /// <summary>Begins a reach to a virtual target, with the real target that has the largest
        /// <see cref="Gap.marginDeg"/>.</summary>
        public void BeginReach(Transform virtualTarget)
        {
            PrepareReach();
            TargetId seen = IdOf(virtualTarget);
            Gap best = default(Gap);
            foreach (TargetId real in Session.ListTargets(TargetRole.Real))
            {
                Gap gap = Session.QueryGap(real, seen);
                if (best.structSize == 0 || gap.marginDeg > best.marginDeg) best = gap;
            }
            BeginReach(best.realTarget, seen);
        }

        public void BeginReach(Transform realTarget, Transform virtualTarget)
        {
            PrepareReach();
            BeginReach(IdOf(realTarget, realIds, nameof(realTarget)),
                       IdOf(virtualTarget, virtualIds, nameof(virtualTarget)));
        }

        /// <summary>Redirects the reach to other or moved targets. Call it each frame while they move.</summary>
        public void RetargetReach(Transform realTarget, Transform virtualTarget)
        {
            HapticRetargetingSession session = EnabledSession();
            TargetId real = IdOf(realTarget, realIds, nameof(realTarget));
            TargetId seen = IdOf(virtualTarget, virtualIds, nameof(virtualTarget));
            session.SetTarget(real, ConfigOf(realTarget, TargetRole.Real));
            session.SetTarget(seen, ConfigOf(virtualTarget, TargetRole.Virtual));
            session.RetargetReach(real, seen);
        }

        /// <summary>Ends the reach without a summary and discards its estimates.</summary>
        public void CancelReach()
        {
            EnabledSession().CancelReach();
            EnabledSession().WriteLog();
            IsReaching = false;
        }

        public ReachSummary EndReach()
        {
            ReachSummary summary = EnabledSession().EndReach();
            EnabledSession().WriteLog();
            IsReaching = false;
            ReachEnded?.Invoke(summary);
            return summary;
        }

        /// <summary>Begins a set-up, which measures the pose of the plate, the offset of the skin from a tracked joint,
        /// and the user. Until the set-up is over, the component passes a sample to it in each frame.</summary>
        public void BeginSetup(SetupFlags what = SetupFlags.AllMissing)
        {
            HapticRetargetingSession session = EnabledSession();
            Configure(session);
            session.BeginSetup(what, SetupConfig.Default);
            IsSettingUp = true;
            setupDone = 0;
            commanded = false;
            refused = false;
        }

        /// <summary>Ends the set-up. Results of finished parts are kept.</summary>
        public void CancelSetup()
        {
            EnabledSession().CancelSetup();
            IsSettingUp = false;
        }

        /// <summary>Converts a position in plate coordinates, such as that of a step, to Unity's world.</summary>
        public Vector3 PlaceOf(Double3 placeM) => plate.position + plate.rotation * Axes.ToUnity(placeM);

        /// <summary>Returns finger and plate in this frame as a sample for a reach or a set-up.</summary>
        public Sample ReadFinger()
        {
            var sample = new Sample { timeNs = (long)(Time.unscaledTimeAsDouble * 1e9) };
            if (FingerTracked && plate != null && finger != null && finger.gameObject.activeInHierarchy)
            {
                sample.flags = SampleFlags.WorldPosition | SampleFlags.PlatePose;
                sample.fingerPositionM = Axes.FromUnity(finger.position);
                sample.platePositionM = Axes.FromUnity(plate.position);
                sample.plateRotation = Axes.FromUnity(plate.rotation);
                if (fingerIsJoint)
                {
                    sample.flags |= SampleFlags.JointRotation;
                    sample.jointRotation = Axes.FromUnity(finger.rotation);
                }
            }
            if (MeasuredPlateOrientationDeg.HasValue)
            {
                sample.flags |= SampleFlags.PlateOrientation;
                sample.plateOrientationDeg = MeasuredPlateOrientationDeg.Value;
            }
            return sample;
        }

        void OnEnable() => Session = new HapticRetargetingSession(settings = Configuration());

        // The editor calls this when a setting changes, in play mode too.
        void OnValidate()
        {
            if (IsReaching || IsSettingUp)
                Debug.LogWarning("Haptic retargeting: settings that change now take effect when the next reach or set-up begins", this);
        }

        void OnDisable()
        {
            IsReaching = false;
            IsSettingUp = false;
            realIds.Clear();
            virtualIds.Clear();
            Session?.Dispose();
            Session = null;
        }

        void LateUpdate()
        {
            if (IsReaching) Step(ReadFinger());
            if (IsSettingUp) Guide(ReadFinger());
        }

        // Allocates no managed memory, unless the sample is refused.
        internal void Step(Sample sample)
        {
            if (Session.TryUpdate(sample, out Command command)) Apply(command);
            else Refuse(HapticRetargetingLibrary.LastError);
        }

        // Reports only the first error of a reach or set-up, because it may recur in each frame.
        void Refuse(string why)
        {
            if (!refused) Debug.LogError("Haptic retargeting: " + why, this);
            refused = true;
        }

        internal void Guide(Sample sample)
        {
            SetupStep last = setupStep;
            SetupResult result = default(SetupResult);
            bool fits = false;
            try
            {
                setupStep = Session.UpdateSetup(sample);
                fits = setupStep.instruction == Hrt.Step.Finish;
                if (fits) result = Session.FinishSetup();
            }
            catch (HapticRetargetingException e)
            {
                Refuse(e.Message);
                return;
            }
            bool first = !commanded;
            commanded = true;
            if (first || setupStep.plateOrientationDeg != last.plateOrientationDeg) Turn(setupStep.plateOrientationDeg);
            last.plateOrientationDeg = setupStep.plateOrientationDeg;
            if (first || !setupStep.Equals(last)) SetupStepped?.Invoke(setupStep);
            if (fits && IsSettingUp) TakeResult(result);
        }

        // A registration moves the plate's Transform to the measured pose.
        void TakeResult(SetupResult result)
        {
            IsSettingUp = result.left != 0;
            if ((result.done & ~setupDone & SetupFlags.Registration) != 0)
            {
                SessionConfig found = Session.Config;
                plate.position = Axes.ToUnity(found.platePositionM);
                plate.rotation = Axes.ToUnity(found.plateRotation);
            }
            setupDone = result.done;
            if (!IsSettingUp) SetupFinished?.Invoke(result);
        }

        void Turn(double orientationDeg)
        {
            if (ridges != null) ridges.localRotation = Axes.RidgeRotation(orientationDeg);
            onPlateOrientation.Invoke((float)orientationDeg);
        }

        void Apply(Command command)
        {
            Command last = LastCommand;
            LastCommand = command;
            Commanded?.Invoke(command);
            bool first = !commanded;
            commanded = true;
            if (first || command.plateOrientationDeg != last.plateOrientationDeg) Turn(command.plateOrientationDeg);
            CommandFlags flags = command.flags & ~CommandFlags.Held;
            CommandFlags before = first ? CommandFlags.None : last.flags;
            if (first || flags != (before & ~CommandFlags.Held)) FlagsChanged?.Invoke(flags);
            if ((flags & ~before & CommandFlags.Arrived) != 0) Arrived?.Invoke(command);
        }

        void PrepareReach()
        {
            HapticRetargetingSession session = EnabledSession();
            if (finger == null) throw new InvalidOperationException($"{name}: finger is not set; assign its Transform in the inspector");
            Configure(session);
            SetTargets(session, realTargets, TargetRole.Real, realIds);
            SetTargets(session, virtualTargets, TargetRole.Virtual, virtualIds);
        }

        void BeginReach(TargetId realTarget, TargetId virtualTarget)
        {
            var config = new ReachConfig { realTarget = realTarget, virtualTarget = virtualTarget };
            if (MeasuredPlateOrientationDeg.HasValue)
            {
                config.flags = ReachFlags.PlateOrientation;
                config.plateOrientationDeg = MeasuredPlateOrientationDeg.Value;
            }
            Session.BeginReach(config);
            IsReaching = true;
            commanded = false;
            refused = false;
        }

        HapticRetargetingSession EnabledSession()
        {
            if (Session == null) throw new InvalidOperationException($"{name}: the component is not enabled; enable it before this call");
            return Session;
        }

        /// <summary>Returns the session's id of a virtual target. Targets get their ids when a reach begins.</summary>
        public TargetId IdOf(Transform virtualTarget) => IdOf(virtualTarget, virtualIds, nameof(virtualTarget));

        TargetId IdOf(Transform target, Dictionary<Transform, TargetId> ids, string argument)
        {
            if (target != null && ids.TryGetValue(target, out TargetId id)) return id;
            throw new ArgumentException($"{name}: the Transform is not a target of this role; add it to the component's list, and begin a reach", argument);
        }

        // Sets plate and start from the Transforms, and the settings that have changed.
        void Configure(HapticRetargetingSession session)
        {
            if (plate == null) throw new InvalidOperationException($"{name}: plate is not set; assign its Transform in the inspector");
            SessionConfig now = Configuration(), config = Changed(session.Config, settings, now);
            config.platePositionM = Axes.FromUnity(plate.position);
            config.plateRotation = Axes.FromUnity(plate.rotation);
            if (start != null)
                config.startPositionM =
                    Axes.FromUnity(Quaternion.Inverse(plate.rotation) * (start.position - plate.position));
            session.Config = config;
            settings = now;
        }

        TargetConfig ConfigOf(Transform target, TargetRole role)
        {
            TargetConfig config = TargetConfig.Default;
            config.role = role;
            config.place = Place.PlatePosition;
            config.positionM =
                Axes.FromUnity(Quaternion.Inverse(plate.rotation) * (target.position - plate.position));
            return config;
        }

        // Adds and moves targets as their Transforms require, and removes those that are not listed or are destroyed.
        void SetTargets(HapticRetargetingSession session, List<Transform> targets, TargetRole role,
                        Dictionary<Transform, TargetId> ids)
        {
            foreach (Transform known in new List<Transform>(ids.Keys))
            {
                if (known != null && targets.Contains(known)) continue;
                session.RemoveTarget(ids[known]);
                ids.Remove(known);
            }
            foreach (Transform target in targets)
            {
                if (target == null) continue;
                TargetConfig config = ConfigOf(target, role);
                try
                {
                    if (ids.TryGetValue(target, out TargetId id)) session.SetTarget(id, config);
                    else ids[target] = session.AddTarget(config);
                }
                catch (HapticRetargetingException e)
                {
                    throw new HapticRetargetingException(e.Result, $"{target.name}: {e.Message}");
                }
            }
        }
    }
}
