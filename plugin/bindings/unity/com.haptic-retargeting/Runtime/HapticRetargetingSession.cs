using System;
using System.Collections.Generic;

namespace Hrt
{
    /// <summary>
    /// One user, one plate, and the assumptions of the controller about both. Add targets. For each reach, begin it,
    /// pass samples of the finger, and end it. Dispose of the session, which cancels its reach and ends its recording.
    ///
    /// <see cref="BeginReach(TargetId, TargetId)"/>, <see cref="Update"/>, <see cref="TryUpdate"/> and
    /// <see cref="EndReach"/> allocate no managed memory, unless they throw.
    /// </summary>
    public sealed partial class HapticRetargetingSession : NativeObject
    {
        public HapticRetargetingSession() : this(SessionConfig.Default)
        {
        }

        public HapticRetargetingSession(SessionConfig config)
            : base(value => Native.hrt_session_destroy(new SessionHandle { value = value }))
        {
            HapticRetargetingLibrary.Load();
            config.structSize = SizeOf<SessionConfig>.Value;
            Own((out ulong created) => Native.hrt_session_create(Constants.Version, ref config, out created));
        }

        /// <summary>The configuration, to be set between reaches. Setting it keeps the targets.</summary>
        public SessionConfig Config
        {
            get => Get(out _);
            set => Set(value);
        }

        /// <summary>The state of the session; 0: idle, but the real or the virtual target is missing.</summary>
        public StateFlags State
        {
            get
            {
                Get(out StateFlags state);
                return state;
            }
        }

        /// <summary>Returns the target with this name, or throws KeyNotFoundException.</summary>
        public TargetId FindTarget(string name)
        {
            foreach (TargetId target in ListTargets(0))
                if (GetTarget(target).name.ToString() == name) return target;
            throw new KeyNotFoundException($"No target has the name \"{name}\"; ListTargets() returns all targets");
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

        /// <summary>Sets plate and start from a glTF file and adds its targets by their positions on the plate. Returns
        /// the targets' ids in the order of the file's node tree.</summary>
        public TargetId[] LoadScene(string path)
        {
            Check(Native.hrt_scene_load(Utf8.NullTerminated(path, nameof(path)), null, 0, out SceneHandle scene));
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

        public void BeginReach(TargetId realTarget, TargetId virtualTarget) =>
            BeginReach(new ReachConfig { realTarget = realTarget, virtualTarget = virtualTarget });

        /// <summary>Processes one sample of the finger and returns the command for the plate.</summary>
        public Command Update(Sample sample)
        {
            Check(Exchange(ref sample, out Command command));
            return command;
        }

        /// <summary>Does the same as <see cref="Update"/>, but returns false if the sample is refused, and does not
        /// throw. <see cref="HapticRetargetingLibrary.LastError"/> is the reason.</summary>
        public bool TryUpdate(Sample sample, out Command command) =>
            Exchange(ref sample, out command) == Result.Ok;

        /// <summary>Writes log messages that updates have stored because they must not block, for example that a clock
        /// or unit is probably wrong. Call it after a reach; it is not real-time.</summary>
        public void WriteLog()
        {
            var none = new Host { structSize = SizeOf<Host>.Value };
            Check(Native.hrt_host_set_log(Handle, ref none));
        }

        SessionConfig Get(out StateFlags state)
        {
            var config = new SessionConfig { structSize = SizeOf<SessionConfig>.Value };
            Check(Native.hrt_session_get(Handle, ref config, out uint bits));
            state = (StateFlags)bits;
            return config;
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
