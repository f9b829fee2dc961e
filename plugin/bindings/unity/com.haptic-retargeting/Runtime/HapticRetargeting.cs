using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Events;

namespace Hrt
{
    /// <summary>
    /// A plate, a finger and targets of the scene, given to the controller each frame. Begin a reach with
    /// <see cref="BeginReach(Transform)"/>; turn the real plate as <see cref="Commanded"/> or
    /// <see cref="onPlateOrientation"/> receives; end it with <see cref="EndReach"/>.
    ///
    /// Samples go out in LateUpdate, after all scripts have moved the finger, with the frame's unscaled time: a
    /// game that is slowed down or paused does not slow the hand. One unit of length is one metre.
    /// </summary>
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

        [Tooltip("The tracked fingertip. While it is inactive, or FingerTracked is false, the plate is held.")]
        public Transform finger;

        [Tooltip("The finger is a tracked joint: a set-up finds where the skin is beside it.")]
        public bool fingerIsJoint;

        [Tooltip("Where reaches start. None: on the plate, 5 cm from its centre towards the user.")]
        public Transform start;

        [Tooltip("What is turned with the real plate's ridges, about its own y axis. May be none.")]
        public Transform ridges;

        [Tooltip("Real objects, which the hand can be led to.")]
        public List<Transform> realTargets = new List<Transform>();

        [Tooltip("Virtual objects, which the user goes to.")]
        public List<Transform> virtualTargets = new List<Transform>();

        [Header("Events")]
        [Tooltip("Where to turn the plate, in degrees counter-clockwise seen from above, when it changes.")]
        public OrientationEvent onPlateOrientation = new OrientationEvent();

        /// <summary>Each command, once a frame during a reach.</summary>
        public event Action<Command> Commanded;

        /// <summary>What the controller says of its command, when it changes. Held, which comes and goes between
        /// steps, is left out.</summary>
        public event Action<CommandFlags> FlagsChanged;

        public event Action<ReachSummary> ReachEnded;

        /// <summary>What the user is to do now, in a set-up, when it changes: show its text, and its place with
        /// <see cref="PlaceOf"/>. At Step.Finish call <see cref="FinishSetup"/>.</summary>
        public event Action<SetupStep> SetupStepped;

        // Of the session's targets. One Transform may be both: a cylinder that also stands for itself.
        readonly Dictionary<Transform, TargetId> realIds = new Dictionary<Transform, TargetId>();
        readonly Dictionary<Transform, TargetId> virtualIds = new Dictionary<Transform, TargetId>();

        SetupStep setupStep;
        bool commanded;
        bool refused;

        /// <summary>The session, from enabling to disabling: for its configuration, profile and recording
        /// between reaches. Null while disabled. Its plate, start and targets are set from the
        /// Transforms when a reach begins.</summary>
        public HapticRetargetingSession Session { get; private set; }

        public bool IsReaching { get; private set; }

        public bool IsSettingUp { get; private set; }

        /// <summary>The last command of the last reach.</summary>
        public Command LastCommand { get; private set; }

        /// <summary>Set this to false while the tracker does not see the finger, and its Transform is
        /// stale.</summary>
        public bool FingerTracked { get; set; } = true;

        /// <summary>Set this to where the device says that the plate stands, each frame; null: it is taken to
        /// follow its commands as its speed and latency allow.</summary>
        public double? MeasuredPlateOrientationDeg { get; set; }

        /// <summary>Begins a reach to a virtual target, served by the real one that can be held best.</summary>
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

        /// <summary>Leads the reach to other targets from now on, or to the same ones, to where their Transforms are
        /// now: each frame, if they move.</summary>
        public void RetargetReach(Transform realTarget, Transform virtualTarget)
        {
            HapticRetargetingSession session = EnabledSession();
            TargetId real = IdOf(realTarget, realIds, nameof(realTarget));
            TargetId seen = IdOf(virtualTarget, virtualIds, nameof(virtualTarget));
            session.SetTarget(real, OnPlate(realTarget, TargetRole.Real));
            session.SetTarget(seen, OnPlate(virtualTarget, TargetRole.Virtual));
            session.RetargetReach(real, seen);
        }

        /// <summary>Ends the reach without a summary; nothing is learnt from it.</summary>
        public void CancelReach()
        {
            EnabledSession().CancelReach();
            IsReaching = false;
        }

        public ReachSummary EndReach()
        {
            ReachSummary summary = EnabledSession().EndReach();
            IsReaching = false;
            ReachEnded?.Invoke(summary);
            return summary;
        }

        /// <summary>Begins a set-up: of where the plate is, the skin beside a tracked joint, the user. Until it is over,
        /// frames are its samples.</summary>
        public void BeginSetup(SetupFlags what = SetupFlags.AllMissing)
        {
            HapticRetargetingSession session = EnabledSession();
            session.Config = Placed(session.Config);
            session.BeginSetup(what, SetupConfig.Default);
            IsSettingUp = true;
            commanded = false;
            refused = false;
        }

        /// <summary>At Step.Finish: applies what was found, and moves the plate to where it was touched. Takes up to a
        /// second. The set-up is over if nothing is left.</summary>
        public SetupResult FinishSetup()
        {
            SetupResult result = EnabledSession().FinishSetup();
            IsSettingUp = result.left != 0;
            if ((result.done & SetupFlags.Registration) != 0)
            {
                SessionConfig found = Session.Config;
                plate.position = Axes.ToUnity(found.platePositionM);
                plate.rotation = Axes.ToUnity(found.plateRotation);
            }
            return result;
        }

        /// <summary>Ends the set-up. What was finished before stays.</summary>
        public void CancelSetup()
        {
            EnabledSession().CancelSetup();
            IsSettingUp = false;
        }

        /// <summary>A place of the plate's, such as a step's, in Unity's world.</summary>
        public Vector3 PlaceOf(Double3 placeM) => plate.TransformPoint(Axes.ToUnity(placeM));

        /// <summary>The finger and the plate of this frame, as they go into a reach and a set-up.</summary>
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

        void OnEnable() => Session = new HapticRetargetingSession(Configuration());

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

        // Makes no garbage: it runs each frame.
        internal void Step(Sample sample)
        {
            if (Session.TryUpdate(sample, out Command command)) Apply(command);
            else Refuse(HapticRetargetingLibrary.LastError);
        }

        // The command stays as it was. Said once in a reach or set-up, not in each frame.
        void Refuse(string why)
        {
            if (!refused) Debug.LogError("Haptic retargeting: " + why, this);
            refused = true;
        }

        internal void Guide(Sample sample)
        {
            SetupStep last = setupStep;
            try
            {
                setupStep = Session.UpdateSetup(sample);
            }
            catch (HapticRetargetingException e)
            {
                Refuse(e.Message);
                return;
            }
            bool first = !commanded;
            commanded = true;
            if (first || setupStep.plateOrientationDeg != last.plateOrientationDeg) Turn(setupStep.plateOrientationDeg);
            if (first || setupStep.instruction != last.instruction || setupStep.part != last.part ||
                setupStep.problem != last.problem || setupStep.done != last.done || setupStep.number != last.number)
                SetupStepped?.Invoke(setupStep);
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
            if (first || flags != (last.flags & ~CommandFlags.Held)) FlagsChanged?.Invoke(flags);
        }

        void PrepareReach()
        {
            HapticRetargetingSession session = EnabledSession();
            if (finger == null) throw new InvalidOperationException($"{name}: finger is not set");
            session.Config = Placed(session.Config);
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
            if (Session == null) throw new InvalidOperationException($"{name}: the component is not enabled");
            return Session;
        }

        /// <summary>The session's id of a virtual target, from the first reach on.</summary>
        public TargetId IdOf(Transform virtualTarget) => IdOf(virtualTarget, virtualIds, nameof(virtualTarget));

        TargetId IdOf(Transform target, Dictionary<Transform, TargetId> ids, string argument)
        {
            if (target != null && ids.TryGetValue(target, out TargetId id)) return id;
            throw new ArgumentException($"{name}: not one of the component's targets of this role", argument);
        }

        // The configuration with plate and start where the Transforms are now.
        SessionConfig Placed(SessionConfig config)
        {
            if (plate == null) throw new InvalidOperationException($"{name}: plate is not set");
            config.platePositionM = Axes.FromUnity(plate.position);
            config.plateRotation = Axes.FromUnity(plate.rotation);
            if (start != null)
                config.startPositionM =
                    Axes.FromUnity(Quaternion.Inverse(plate.rotation) * (start.position - plate.position));
            return config;
        }

        // Where a target is on the plate, which may have moved since the reach began.
        TargetConfig OnPlate(Transform target, TargetRole role)
        {
            TargetConfig config = TargetConfig.Default;
            config.role = role;
            config.place = Place.PlatePosition;
            config.positionM =
                Axes.FromUnity(Quaternion.Inverse(plate.rotation) * (target.position - plate.position));
            return config;
        }

        // Adds targets, moves them to where their Transforms are now, and removes those that are no longer listed or
        // are destroyed.
        static void SetTargets(HapticRetargetingSession session, List<Transform> targets, TargetRole role,
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
                TargetConfig config = TargetConfig.Default;
                config.role = role;
                config.place = Place.WorldPosition;
                config.positionM = Axes.FromUnity(target.position);
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
