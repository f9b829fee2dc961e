using System;
using System.Text;

namespace Hrt
{
    /// <summary>
    /// One user, one plate, and what the controller assumes of both. Add targets; then, as often as wanted,
    /// begin a reach, stream samples of the finger, end it; dispose of the session.
    /// Disposing of it ends its reach and its recording.
    ///
    /// <see cref="BeginReach(TargetId, TargetId)"/>, <see cref="Update"/>,
    /// <see cref="TryUpdate"/> and <see cref="EndReach"/> make no garbage, and the library takes no lock, allocates
    /// nothing and makes no system call in them.
    /// </summary>
    public sealed class HapticRetargetingSession : NativeObject
    {
        /// <summary>A session with the library's defaults.</summary>
        public HapticRetargetingSession() : this(SessionConfig.Default)
        {
        }

        public HapticRetargetingSession(SessionConfig config)
            : base(value => Native.hrt_session_destroy(new SessionHandle { value = value }))
        {
            HapticRetargetingLibrary.Load();
            config.structSize = SizeOf<SessionConfig>.Value;
            HapticRetargetingLibrary.Check(Native.hrt_session_create(ref config, out SessionHandle handle));
            Own(handle.value);
        }

        /// <summary>The configuration. Setting it is refused during a reach; targets stay.</summary>
        public SessionConfig Config
        {
            get
            {
                var config = new SessionConfig { structSize = SizeOf<SessionConfig>.Value };
                Check(Native.hrt_session_get_config(Handle, ref config));
                return config;
            }
            set
            {
                value.structSize = SizeOf<SessionConfig>.Value;
                Check(Native.hrt_session_set_config(Handle, ref value));
            }
        }

        /// <summary>What the session is about now; None: idle.</summary>
        public StateFlags State
        {
            get
            {
                Check(Native.hrt_session_get_state(Handle, out uint state));
                return (StateFlags)state;
            }
        }

        public TargetId AddTarget(TargetConfig config)
        {
            config.structSize = SizeOf<TargetConfig>.Value;
            Check(Native.hrt_target_add(Handle, ref config, out TargetId target));
            return target;
        }

        /// <summary>Adds a target by its direction from the start, counter-clockwise seen from above.</summary>
        public TargetId AddTarget(TargetRole role, double directionDeg, double distanceM = 0.1, string name = "")
        {
            TargetConfig config = TargetConfig.Default;
            config.role = role;
            config.directionDeg = directionDeg;
            config.distanceM = distanceM;
            config.name = name;
            return AddTarget(config);
        }

        /// <summary>Changes a target; its id stays. A running reach keeps the former target until
        /// <see cref="RetargetReach"/>.</summary>
        public void SetTarget(TargetId target, TargetConfig config)
        {
            config.structSize = SizeOf<TargetConfig>.Value;
            Check(Native.hrt_target_set(Handle, target, ref config));
        }

        public TargetConfig GetTarget(TargetId target)
        {
            var config = new TargetConfig { structSize = SizeOf<TargetConfig>.Value };
            Check(Native.hrt_target_get(Handle, target, ref config));
            return config;
        }

        public void RemoveTarget(TargetId target) => Check(Native.hrt_target_remove(Handle, target));

        public bool TryFindTarget(string name, out TargetId target)
        {
            Result result = Native.hrt_target_find(Handle, Utf8.ZeroEnded(name, nameof(name)), out target);
            if (result == Result.NotFound) return false;
            Check(result);
            return true;
        }

        /// <summary>The targets of both roles, or of one, in the order in which they were added.</summary>
        public TargetId[] GetTargets(TargetRole? role = null)
        {
            uint wanted = role == null ? 0 : (uint)role.Value;
            Check(Native.hrt_target_list(Handle, wanted, 0, null, out ulong count));
            var targets = new TargetId[count];
            if (count > 0) Check(Native.hrt_target_list(Handle, wanted, count, targets, out count));
            return targets;
        }

        /// <summary>Sets plate and start from a glTF file and adds its targets, all by their place on the plate.
        /// They come in the order of the file.</summary>
        public TargetId[] LoadScene(string path)
        {
            Check(Native.hrt_scene_load_file(Utf8.ZeroEnded(path, nameof(path)), out SceneHandle scene));
            try
            {
                var info = new SceneInfo { structSize = SizeOf<SceneInfo>.Value };
                Check(Native.hrt_scene_get_info(scene, ref info));
                var targets = new TargetId[info.targetCount];
                Check(Native.hrt_scene_register(scene, Handle, info.targetCount, targets));
                return targets;
            }
            finally
            {
                Native.hrt_scene_destroy(scene);
            }
        }

        /// <summary>The largest gap that the plate can sustain for a pair, computed before a reach.</summary>
        public Authority QueryAuthority(TargetId realTarget, TargetId virtualTarget)
        {
            var authority = new Authority { structSize = SizeOf<Authority>.Value };
            Check(Native.hrt_authority_query(Handle, realTarget, virtualTarget, ref authority));
            return authority;
        }

        /// <summary>What can be held for every pair, by virtual target and then by real one.</summary>
        public Authority[] QueryAllAuthorities()
        {
            Check(Native.hrt_authority_query_all(Handle, 0, null, out ulong count));
            var authorities = new Authority[count];
            if (count == 0) return authorities;
            authorities[0].structSize = SizeOf<Authority>.Value;
            Check(Native.hrt_authority_query_all(Handle, count, authorities, out count));
            return authorities;
        }

        /// <summary>The real target that serves a virtual one with the greatest margin. It may still be out of
        /// reach.</summary>
        public Authority QueryBestAuthority(TargetId virtualTarget)
        {
            var authority = new Authority { structSize = SizeOf<Authority>.Value };
            Check(Native.hrt_authority_query_best(Handle, virtualTarget, ref authority));
            return authority;
        }

        /// <summary>The real target that serves each virtual one, so that the largest needed share of the authority is
        /// smallest; each real one serves one at most if exclusive. What cannot be served is not reachable and has
        /// no real target.</summary>
        public Authority[] AssignTargets(TargetId[] virtualTargets, TargetId[] realTargets, bool exclusive = false)
        {
            if (virtualTargets == null) throw new ArgumentNullException(nameof(virtualTargets));
            if (realTargets == null) throw new ArgumentNullException(nameof(realTargets));
            var authorities = new Authority[virtualTargets.Length];
            if (authorities.Length > 0) authorities[0].structSize = SizeOf<Authority>.Value;
            AssignFlags flags = exclusive ? AssignFlags.Exclusive : AssignFlags.None;
            Check(Native.hrt_target_assign(Handle, virtualTargets, (ulong)virtualTargets.Length, realTargets,
                                           (ulong)realTargets.Length, (uint)flags, (ulong)authorities.Length,
                                           authorities));
            return authorities;
        }

        public void BeginReach(TargetId realTarget, TargetId virtualTarget) =>
            BeginReach(new ReachConfig { realTarget = realTarget, virtualTarget = virtualTarget });

        public void BeginReach(ReachConfig config)
        {
            config.structSize = SizeOf<ReachConfig>.Value;
            Check(Native.hrt_reach_begin(Handle, ref config));
        }

        /// <summary>Processes one sample of the finger and returns the command for the plate.</summary>
        public Command Update(Sample sample)
        {
            Check(Exchange(ref sample, out Command command));
            return command;
        }

        /// <summary>As <see cref="Update"/>, for a loop that must make no garbage when a sample is refused:
        /// returns false then; <see cref="HapticRetargetingLibrary.LastError"/> is the reason.</summary>
        public bool TryUpdate(Sample sample, out Command command) =>
            Exchange(ref sample, out command) == Result.Ok;

        /// <summary>Leads the reach to other targets from now on, or to the same ones after
        /// <see cref="SetTarget"/> has moved them.</summary>
        public void RetargetReach(TargetId realTarget, TargetId virtualTarget) =>
            Check(Native.hrt_reach_retarget(Handle, realTarget, virtualTarget));

        /// <summary>Ends the reach without a summary; nothing is learnt from it.</summary>
        public void CancelReach() => Check(Native.hrt_reach_cancel(Handle));

        public ReachSummary EndReach()
        {
            var summary = new ReachSummary { structSize = SizeOf<ReachSummary>.Value };
            Check(Native.hrt_reach_end(Handle, ref summary));
            return summary;
        }

        /// <summary>What is known of the participant, as JSON that can be kept and loaded tomorrow.</summary>
        public string SaveProfile()
        {
            Check(Native.hrt_profile_save(Handle, 0, null, out ulong length));
            var text = new byte[length + 1];
            Check(Native.hrt_profile_save(Handle, length + 1, text, out length));
            return Encoding.UTF8.GetString(text, 0, (int)length);
        }

        /// <summary>Takes a profile into the configuration. Refused during a reach.</summary>
        public void LoadProfile(string json)
        {
            if (json == null) throw new ArgumentNullException(nameof(json));
            byte[] text = Encoding.UTF8.GetBytes(json);
            Check(Native.hrt_profile_load(Handle, text, (ulong)text.Length));
        }

        /// <summary>Plate, tracker and time of now: what a calibration is measured under, and profiles are compared with.
        /// Refused during a reach.</summary>
        public void SetConditions(Conditions now)
        {
            now.structSize = SizeOf<Conditions>.Value;
            Check(Native.hrt_profile_set_conditions(Handle, ref now));
        }

        /// <summary>Under which conditions the person of the profile was measured, and which of them are others now.
        /// </summary>
        public Conditions MeasuredUnder
        {
            get
            {
                var conditions = new Conditions { structSize = SizeOf<Conditions>.Value };
                Check(Native.hrt_profile_get_conditions(Handle, ref conditions));
                return conditions;
            }
        }

        /// <summary>Copies the known values of a calibration into the configuration, and so into the profile.
        /// Refused during a reach.</summary>
        public void Apply(CalibrationResult calibrated)
        {
            calibrated.structSize = SizeOf<CalibrationResult>.Value;
            Check(Native.hrt_calibration_apply(Handle, ref calibrated));
        }

        /// <summary>Copies a registered pose and its uncertainty into the configuration: the touches were made at this
        /// time, on the clock of the samples. Refused during a reach.</summary>
        public void Apply(Registration registered, long timeNs)
        {
            registered.structSize = SizeOf<Registration>.Value;
            Check(Native.hrt_registration_apply(Handle, ref registered, timeNs));
        }

        /// <summary>Checks the registration that was applied by a touch of a mark, as before each reach. One that agrees
        /// counts as made at this time; one that does not makes the session unregistered. Refused during a reach.
        /// </summary>
        public TouchCheck Confirm(Registration registered, MarkTouch touch, long timeNs)
        {
            registered.structSize = SizeOf<Registration>.Value;
            var check = new TouchCheck { structSize = SizeOf<TouchCheck>.Value };
            Check(Native.hrt_registration_confirm(Handle, ref registered, ref touch, timeNs, ref check));
            return check;
        }

        /// <summary>Records all that crosses the interface into a CSV file, which is created or replaced; not
        /// during a reach. A full or slow disk never delays a call: it is logged, and the status says.</summary>
        public void StartRecording(string path) =>
            Check(Native.hrt_recording_start(Handle, Utf8.ZeroEnded(path, nameof(path))));

        public RecordingStatus GetRecordingStatus()
        {
            var status = new RecordingStatus { structSize = SizeOf<RecordingStatus>.Value };
            Check(Native.hrt_recording_get_status(Handle, ref status));
            return status;
        }

        /// <summary>Completes the file; may wait for the disk.</summary>
        public RecordingStatus StopRecording()
        {
            var status = new RecordingStatus { structSize = SizeOf<RecordingStatus>.Value };
            Check(Native.hrt_recording_stop(Handle, ref status));
            return status;
        }

        internal SessionHandle Handle => new SessionHandle { value = Value };

        Result Exchange(ref Sample sample, out Command command)
        {
            sample.structSize = SizeOf<Sample>.Value;
            command = new Command { structSize = SizeOf<Command>.Value };
            Result result = Native.hrt_reach_update(Handle, ref sample, ref command);
            GC.KeepAlive(this);
            return result;
        }
    }
}
