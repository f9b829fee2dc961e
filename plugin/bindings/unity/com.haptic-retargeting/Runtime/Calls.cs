// Written by plugin/bindings/generate from the C headers. They say more of each call.
using System;
using System.Text;

namespace Hrt
{
    public sealed partial class HapticRetargetingSession
    {
        /// <summary>Returns what the session is about: StateFlags. Later versions may set further bits.
        /// [real-time]</summary>
        public StateFlags GetState()
        {
            Check(Native.hrt_session_get_state(Handle, out uint state));
            return (StateFlags)state;
        }

        /// <summary>Returns the configuration. Set <c>out_config-&gt;structSize</c> before the call.
        /// [one-thread]</summary>
        public SessionConfig GetConfig()
        {
            var config = new SessionConfig { structSize = SizeOf<SessionConfig>.Value };
            Check(Native.hrt_session_get_config(Handle, ref config));
            return config;
        }

        /// <summary>Replaces the configuration; null: by the defaults. Targets stay. Errors: as
        /// hrt_session_create(), and WRONG_STATE during a reach. [one-thread]</summary>
        public void SetConfig(SessionConfig config)
        {
            config.structSize = SizeOf<SessionConfig>.Value;
            Check(Native.hrt_session_set_config(Handle, ref config));
        }

        /// <summary>Adds a target. Errors: OUT_OF_RANGE naming the field, NAME_TAKEN, LIMIT_REACHED,
        /// OUT_OF_MEMORY. [one-thread]</summary>
        public TargetId AddTarget(TargetConfig config)
        {
            config.structSize = SizeOf<TargetConfig>.Value;
            Check(Native.hrt_target_add(Handle, ref config, out TargetId target));
            return target;
        }

        /// <summary>Replaces a target and keeps its id. A running reach keeps the former target until
        /// hrt_reach_retarget(). Allocates nothing if the name stays. Errors: as hrt_target_add().
        /// [one-thread]</summary>
        public void SetTarget(TargetId target, TargetConfig config)
        {
            config.structSize = SizeOf<TargetConfig>.Value;
            Check(Native.hrt_target_set(Handle, target, ref config));
        }

        /// <summary>Returns a target. Set <c>out_config-&gt;structSize</c> before the call.
        /// [one-thread]</summary>
        public TargetConfig GetTarget(TargetId target)
        {
            var config = new TargetConfig { structSize = SizeOf<TargetConfig>.Value };
            Check(Native.hrt_target_get(Handle, target, ref config));
            return config;
        }

        /// <summary>Removes a target. A running reach keeps it. [one-thread]</summary>
        public void RemoveTarget(TargetId target)
        {
            Check(Native.hrt_target_remove(Handle, target));
        }

        /// <summary>Finds a target by name. Errors: NOT_FOUND. [one-thread]</summary>
        public TargetId FindTarget(string name)
        {
            Check(Native.hrt_target_find(Handle, Utf8.ZeroEnded(name, nameof(name)), out TargetId target));
            return target;
        }

        /// <summary>Lists the targets of a role (0: both) in the order of addition. With <c>capacity</c> 0 the
        /// call only counts them, and <c>out_targets</c> may be null. Errors: BUFFER_TOO_SMALL.
        /// [one-thread]</summary>
        public TargetId[] ListTargets(uint role)
        {
            Check(Native.hrt_target_list(Handle, role, 0, null, out ulong count));
            var targets = new TargetId[count];
            if (count == 0) return targets;
            Check(Native.hrt_target_list(Handle, role, (ulong)targets.Length, targets, out count));
            return targets;
        }

        /// <summary>Computes the authority over a pair. [one-thread]</summary>
        public Authority QueryAuthority(TargetId realTarget, TargetId virtualTarget)
        {
            var authority = new Authority { structSize = SizeOf<Authority>.Value };
            Check(Native.hrt_authority_query(Handle, realTarget, virtualTarget, ref authority));
            return authority;
        }

        /// <summary>Computes the authority over every pair, by virtual target and then by real one, in the order
        /// of addition. <c>out_authorities[0].structSize</c> is the size of every element. With <c>capacity</c> 0
        /// the call only counts the pairs, and <c>out_authorities</c> may be null. Errors: BUFFER_TOO_SMALL.
        /// [one-thread]</summary>
        public Authority[] QueryAllAuthorities()
        {
            Check(Native.hrt_authority_query_all(Handle, 0, null, out ulong count));
            var authorities = new Authority[count];
            if (authorities.Length > 0) authorities[0].structSize = SizeOf<Authority>.Value;
            if (count == 0) return authorities;
            Check(Native.hrt_authority_query_all(Handle, (ulong)authorities.Length, authorities, out count));
            return authorities;
        }

        /// <summary>Finds the real target with the greatest margin for a virtual one; the first added among
        /// equals. The margin may be negative. Errors: NOT_FOUND without a real target. [one-thread]</summary>
        public Authority QueryBestAuthority(TargetId virtualTarget)
        {
            var authority = new Authority { structSize = SizeOf<Authority>.Value };
            Check(Native.hrt_authority_query_best(Handle, virtualTarget, ref authority));
            return authority;
        }

        /// <summary>Assigns a real target to each virtual one. As many virtual targets as possible are served,
        /// and of all such assignments the largest share of the authority that a pair needs, the size of gapDeg
        /// over maxGapDeg, is the smallest; exactly so. <c>out_authorities[i]</c> is the authority over
        /// virtual_targets[i] and the real target that serves it; <c>out_authorities[0].structSize</c> is the
        /// size of every element. A virtual target that cannot be served has <c>reachable</c> 0 and a null
        /// realTarget, and the other numbers are those of the nearest real target, of the first among equals.
        /// Takes up to half a second for 1000 of each with EXCLUSIVE. <c>flags</c> is AssignFlags. Errors:
        /// BUFFER_TOO_SMALL if <c>capacity</c> is below <c>virtual_count</c>; INVALID_HANDLE or OUT_OF_RANGE
        /// naming the argument and the index of an id that is not of its role or is there twice, also for a count
        /// of 0 or above Constants.AssignTargetsMax; OUT_OF_MEMORY. [one-thread]</summary>
        public Authority[] AssignTargets(TargetId[] virtualTargets, TargetId[] realTargets, AssignFlags flags)
        {
            if (virtualTargets == null) throw new ArgumentNullException(nameof(virtualTargets));
            if (realTargets == null) throw new ArgumentNullException(nameof(realTargets));
            var authorities = new Authority[virtualTargets.Length];
            if (authorities.Length > 0) authorities[0].structSize = SizeOf<Authority>.Value;
            Check(Native.hrt_target_assign(Handle, virtualTargets, (ulong)virtualTargets.Length, realTargets, (ulong)realTargets.Length, (uint)flags, (ulong)authorities.Length, authorities));
            return authorities;
        }

        /// <summary>Begins a reach. The targets are copied. Its directions are measured from
        /// SessionConfig.startPositionM, wherever the finger is, unless ReachFlags.StartAtFinger is set. Errors:
        /// INVALID_HANDLE or OUT_OF_RANGE naming the target, WRONG_STATE during a reach. [real-time]</summary>
        public void BeginReach(ReachConfig config)
        {
            config.structSize = SizeOf<ReachConfig>.Value;
            Check(Native.hrt_reach_begin(Handle, ref config));
        }

        /// <summary>Leads the reach to other targets from now on, or to the same ones after hrt_target_set() has
        /// moved them: every frame, if they move. The plan continues from where the finger is, with all that was
        /// learnt. Directions are then seen from the finger, that of the virtual target from where the person
        /// feels that the finger is; in a reach of directions alone, from the start. The command follows with the
        /// next sample, and its flags say UNREACHABLE if the plate cannot sustain the gap that is left,
        /// OFF_TARGET if the path that is left is too short. Distances, predictedMissDeg and bearingErrorDeg are
        /// those of the new real target. Errors, after which the reach continues as before: INVALID_HANDLE,
        /// OUT_OF_RANGE naming the target, also if, seen from the start, the pair is 90 degrees apart;
        /// WRONG_STATE without a reach. [real-time]</summary>
        public void RetargetReach(TargetId realTarget, TargetId virtualTarget)
        {
            Check(Native.hrt_reach_retarget(Handle, realTarget, virtualTarget));
        }

        /// <summary>Ends the reach without a summary and learns nothing from it. The plate is where the last
        /// command left it. Errors: WRONG_STATE without a reach. [real-time]</summary>
        public void CancelReach()
        {
            Check(Native.hrt_reach_cancel(Handle));
        }

        /// <summary>Ends the reach. Errors: WRONG_STATE without a reach. [real-time]</summary>
        public ReachSummary EndReach()
        {
            var summary = new ReachSummary { structSize = SizeOf<ReachSummary>.Value };
            Check(Native.hrt_reach_end(Handle, ref summary));
            return summary;
        }

        /// <summary>Copies the known values into the session's configuration, and so into its profile; unknown
        /// ones are unchanged. The deviation of tactileWeight comes from its interval, with the minimum of
        /// Adaptation.Carried. A known weight or bias replaces what reaches have learnt of the person
        /// (personMean, personCovariance). If personWeight, personCurve, biasDeg and habitDeg are known, they
        /// become what is believed of the person, and peakOffsetDeg becomes motionBoundDeg. A known
        /// correlatedNoiseM above 0 goes in with noiseCorrelationS if that is known; else trackerNoiseM becomes
        /// that of all noise. The conditions that hrt_profile_set_conditions() gave become those of the profile.
        /// Errors: OUT_OF_RANGE naming the field, WRONG_STATE during a reach. [one-thread]</summary>
        public void ApplyCalibration(CalibrationResult result)
        {
            result.structSize = SizeOf<CalibrationResult>.Value;
            Check(Native.hrt_calibration_apply(Handle, ref result));
        }

        /// <summary>Sets the session's conditions of now: what hrt_calibration_apply() measures under, and what
        /// profiles are compared with. If those of the profile differ, the log has a warning, here or when the
        /// profile is loaded. Errors: OUT_OF_RANGE naming the field, WRONG_STATE during a reach.
        /// [one-thread]</summary>
        public void SetProfileConditions(Conditions conditions)
        {
            conditions.structSize = SizeOf<Conditions>.Value;
            Check(Native.hrt_profile_set_conditions(Handle, ref conditions));
        }

        /// <summary>Returns the conditions under which the person was measured: of the loaded profile, or of now
        /// if a calibration was applied since; unknown without both. <c>differing</c> compares them with those of
        /// now. Set <c>structSize</c> before the call. [one-thread]</summary>
        public Conditions GetProfileConditions()
        {
            var conditions = new Conditions { structSize = SizeOf<Conditions>.Value };
            Check(Native.hrt_profile_get_conditions(Handle, ref conditions));
            return conditions;
        }

        /// <summary>Writes the session's profile as UTF-8 with a terminating zero, and its length without the
        /// zero. With <c>capacity</c> 0 the call only returns the length, and <c>out_text</c> may be null.
        /// Errors: BUFFER_TOO_SMALL unless <c>capacity</c> exceeds the length. [one-thread]</summary>
        public string SaveProfile()
        {
            Check(Native.hrt_profile_save(Handle, 0, null, out ulong count));
            var text = new byte[count + 1];
            Check(Native.hrt_profile_save(Handle, (ulong)text.Length, text, out count));
            return Encoding.UTF8.GetString(text, 0, (int)count);
        }

        /// <summary>Copies a profile of <c>length</c> bytes into the session's configuration. Fields missing in
        /// the profile keep their values; unknown fields are refused. Errors: BAD_FORMAT, OUT_OF_RANGE naming the
        /// field, WRONG_STATE during a reach. [one-thread]</summary>
        public void LoadProfile(string text)
        {
            byte[] bytes = Utf8.Bytes(text, nameof(text));
            Check(Native.hrt_profile_load(Handle, bytes, (ulong)bytes.Length));
        }

        /// <summary>Starts recording the session into a file, which is created or replaced. Errors: SYSTEM if the
        /// file cannot be created, is not a regular file, or another recording is written to it, in this process
        /// or another; WRONG_STATE during a reach or while recording; OUT_OF_MEMORY. In the child of a fork,
        /// which has the parent's sessions but not its recordings, calls of these sessions are not recorded, the
        /// two calls below return WRONG_STATE, and this one may start a recording of the child.
        /// [one-thread]</summary>
        public void StartRecording(string path)
        {
            Check(Native.hrt_recording_start(Handle, Utf8.ZeroEnded(path, nameof(path))));
        }

        /// <summary>Returns the state of the recording. Errors: WRONG_STATE without a recording.
        /// [real-time]</summary>
        public RecordingStatus GetRecordingStatus()
        {
            var status = new RecordingStatus { structSize = SizeOf<RecordingStatus>.Value };
            Check(Native.hrt_recording_get_status(Handle, ref status));
            return status;
        }

        /// <summary>Writes the remaining rows, closes the file and returns the final state. The call may wait for
        /// the disk. Destroying the session also stops its recording. Errors: WRONG_STATE without a recording.
        /// [one-thread]</summary>
        public RecordingStatus StopRecording()
        {
            var status = new RecordingStatus { structSize = SizeOf<RecordingStatus>.Value };
            Check(Native.hrt_recording_stop(Handle, ref status));
            return status;
        }

        /// <summary>Copies pose, scale and uncertainty into the session's configuration (platePositionM,
        /// plateRotation, plateScale, plateCovariance) with <c>timeNs</c>, when the touches were made on the
        /// clock of the samples, and sets SessionFlags.Registered. A profile holds none of it: it is of a place,
        /// not of a person. Errors: OUT_OF_RANGE naming the field, or unless the registration HOLDS; WRONG_STATE
        /// during a reach. [one-thread]</summary>
        public void ApplyRegistration(Registration registration, long timeNs)
        {
            registration.structSize = SizeOf<Registration>.Value;
            Check(Native.hrt_registration_apply(Handle, ref registration, timeNs));
        }

        /// <summary>Checks the session's registration by a touch of a mark, as before each reach, and writes the
        /// outcome into the session's configuration. A touch that agrees sets registrationTimeNs to
        /// <c>timeNs</c>, so maxRegistrationAgeNs counts from this touch. One that does not clears
        /// SessionFlags.Registered: wherever a limit of the registration is set, samples get
        /// CommandFlags.Registration until the next hrt_registration_apply(). A check that a host leaves out is
        /// flagged once the last one is older than maxRegistrationAgeNs. <c>registration</c> is the one that was
        /// applied. Errors: OUT_OF_RANGE naming the field, or if the session's plate is not where
        /// <c>registration</c> has it; WRONG_STATE during a reach. [one-thread]</summary>
        public TouchCheck ConfirmRegistration(Registration registration, MarkTouch touch, long timeNs)
        {
            registration.structSize = SizeOf<Registration>.Value;
            var check = new TouchCheck { structSize = SizeOf<TouchCheck>.Value };
            Check(Native.hrt_registration_confirm(Handle, ref registration, ref touch, timeNs, ref check));
            return check;
        }
    }

    public sealed partial class HapticRetargetingCalibration
    {
        /// <summary>Begins a trial, with the plate at <c>plateOrientationDeg</c> (base.h), -3600 to 3600. Errors:
        /// OUT_OF_RANGE, WRONG_STATE during a trial, LIMIT_REACHED. [real-time]</summary>
        public void BeginTrial(double plateOrientationDeg)
        {
            Check(Native.hrt_calibration_begin_trial(Handle, plateOrientationDeg));
        }

        /// <summary>Adds one sample: of the finger at rest, then of its slide. Dropouts, lifted fingers and
        /// repeated times are ignored without an error. Without SampleFlags.PlateOrientation the plate stands
        /// where it stood at the trial's last sample, first where the trial began. Errors: WRONG_STATE without a
        /// trial, OUT_OF_RANGE naming the field, or flags with SampleFlags.Direction: positions are needed;
        /// TIME_REVERSED within a trial, LIMIT_REACHED after maxSamples. [real-time]</summary>
        public void AddSample(Sample sample)
        {
            sample.structSize = SizeOf<Sample>.Value;
            Check(Native.hrt_calibration_add_sample(Handle, ref sample));
        }

        /// <summary>Ends the trial and keeps it. Errors: WRONG_STATE without a trial. [real-time]</summary>
        public void EndTrial()
        {
            Check(Native.hrt_calibration_end_trial(Handle));
        }

        /// <summary>Ends the trial and discards it, for example after a slip. Errors: WRONG_STATE without a
        /// trial. [real-time]</summary>
        public void CancelTrial()
        {
            Check(Native.hrt_calibration_cancel_trial(Handle));
        }

        /// <summary>Chooses the plate orientation of the next slide, in plate coordinates, by what it is expected
        /// to show given the trials so far; the first nine open the range. <c>*out_enough</c> is 1 if the trials
        /// so far determine the tactile weight within enoughWeightWidth and the model fits them, else 0. Takes as
        /// long as hrt_calibration_solve(). Errors: NULL_ARGUMENT, WRONG_STATE during a trial, OUT_OF_MEMORY.
        /// [one-thread]</summary>
        public double NextAngle(out uint enough)
        {
            Check(Native.hrt_calibration_next_angle(Handle, out double plateOrientationDeg, out enough));
            return plateOrientationDeg;
        }

        /// <summary>Fits the user's parameters to the trials. The trials stay: more can be added, and the fit
        /// repeated. Takes about 25 microseconds a sample, half a second for 20000: too long for a thread that
        /// draws frames. Errors: INSUFFICIENT_DATA naming what is missing: at least 10 slides of 30 mm, three
        /// plate orientations that span 40 degrees, an interval of the tactile weight within 0.02 to 0.48;
        /// WRONG_STATE during a trial, OUT_OF_MEMORY. [one-thread]</summary>
        public CalibrationResult Solve()
        {
            var result = new CalibrationResult { structSize = SizeOf<CalibrationResult>.Value };
            Check(Native.hrt_calibration_solve(Handle, ref result));
            return result;
        }

        /// <summary>Returns a slide of the last hrt_calibration_solve(), <c>slide</c> from 0 to trialsUsed minus
        /// 1. Errors: WRONG_STATE before a solve that succeeded, OUT_OF_RANGE. [one-thread]</summary>
        public CalibrationSlide GetResidual(uint slide)
        {
            var foundSlide = new CalibrationSlide { structSize = SizeOf<CalibrationSlide>.Value };
            Check(Native.hrt_calibration_get_residual(Handle, slide, ref foundSlide));
            return foundSlide;
        }
    }

    public static partial class HapticRetargetingLibrary
    {
        /// <summary>Compares two results of hrt_calibration_solve(), which the host has kept. Errors:
        /// OUT_OF_RANGE naming the field, OUT_OF_MEMORY. [any-thread]</summary>
        public static CalibrationComparison CompareCalibrations(CalibrationResult first, CalibrationResult second)
        {
            Load();
            first.structSize = SizeOf<CalibrationResult>.Value;
            second.structSize = SizeOf<CalibrationResult>.Value;
            var comparison = new CalibrationComparison { structSize = SizeOf<CalibrationComparison>.Value };
            Check(Native.hrt_calibration_compare(ref first, ref second, ref comparison));
            return comparison;
        }

        /// <summary>Repeats the recorded calls and compares results, commands, summaries, angles and solutions.
        /// Errors: BAD_FORMAT naming the line, or a version that is not supported. [any-thread]</summary>
        public static ReplayReport ReplayText(string text)
        {
            Load();
            byte[] bytes = Utf8.Bytes(text, nameof(text));
            var report = new ReplayReport { structSize = SizeOf<ReplayReport>.Value };
            Check(Native.hrt_replay_text(bytes, (ulong)bytes.Length, ref report));
            return report;
        }

        /// <summary>Replays a file of at most 1 GiB. Errors: as hrt_replay_text(), and SYSTEM if the file cannot
        /// be read. [any-thread]</summary>
        public static ReplayReport ReplayFile(string path)
        {
            Load();
            var report = new ReplayReport { structSize = SizeOf<ReplayReport>.Value };
            Check(Native.hrt_replay_file(Utf8.ZeroEnded(path, nameof(path)), ref report));
            return report;
        }

        /// <summary>Fits the plate's pose to touches of its marks: least squares in closed form.
        /// <c>out_residuals_m</c> takes the distance of each touch from its mark under the pose, 0 if there is
        /// none; with <c>capacity</c> 0 it may be null. A verdict other than HOLDS is no error. With 5 touches or
        /// more one bad one is found and left out. <c>config</c> may be null: the defaults. Errors: OUT_OF_RANGE
        /// naming the field and the touch, or for a count above Constants.TouchesMax; BUFFER_TOO_SMALL if
        /// <c>capacity</c> is neither 0 nor at least <c>touch_count</c>. [any-thread]</summary>
        public static Registration FitRegistration(RegistrationConfig config, MarkTouch[] touches, out double[] residualsM)
        {
            Load();
            config.structSize = SizeOf<RegistrationConfig>.Value;
            if (touches == null) throw new ArgumentNullException(nameof(touches));
            residualsM = new double[touches.Length];
            var registration = new Registration { structSize = SizeOf<Registration>.Value };
            Check(Native.hrt_registration_fit(ref config, touches, (ulong)touches.Length, (ulong)residualsM.Length, residualsM, ref registration));
            return registration;
        }

        /// <summary>Checks a registration by a later touch of a mark, as before a reach. The start dimple shows
        /// that the plate has moved, a mark far from it that the plate has turned. Errors: OUT_OF_RANGE naming
        /// the field, or unless the registration HOLDS. [any-thread]</summary>
        public static TouchCheck CheckTouch(Registration registration, MarkTouch touch)
        {
            Load();
            registration.structSize = SizeOf<Registration>.Value;
            var check = new TouchCheck { structSize = SizeOf<TouchCheck>.Value };
            Check(Native.hrt_registration_check(ref registration, ref touch, ref check));
            return check;
        }

        /// <summary>Fits the offset from a joint to the skin to touches of one and the same mark, wherever it is,
        /// with the finger held differently each time: leant and turned about two axes at least. Each hand has
        /// its own. <c>config</c> as in hrt_registration_fit(); only touchSdM is read. Errors: OUT_OF_RANGE
        /// naming the field and the touch, or for a count above Constants.TouchesMax. [any-thread]</summary>
        public static Fingertip FitFingertip(RegistrationConfig config, JointTouch[] touches)
        {
            Load();
            config.structSize = SizeOf<RegistrationConfig>.Value;
            if (touches == null) throw new ArgumentNullException(nameof(touches));
            var fingertip = new Fingertip { structSize = SizeOf<Fingertip>.Value };
            Check(Native.hrt_fingertip_fit(ref config, touches, (ulong)touches.Length, ref fingertip));
            return fingertip;
        }

        /// <summary>Puts the skin that touches in place of the joint into a sample: fingerPositionM becomes
        /// position + rotation * offsetM, and SampleFlags.WorldPosition replaces SampleFlags.Direction and
        /// SampleFlags.PlatePosition. Other fields are unchanged. For every sample of that hand, and for the
        /// touches of a registration that its reaches use. Errors: OUT_OF_RANGE naming the field, or if the
        /// offset is not <c>known</c>. [any-thread] [real-time]</summary>
        public static Sample PlaceFingertip(Fingertip fingertip, JointTouch joint)
        {
            Load();
            fingertip.structSize = SizeOf<Fingertip>.Value;
            var sample = new Sample { structSize = SizeOf<Sample>.Value };
            Check(Native.hrt_fingertip_place(ref fingertip, ref joint, ref sample));
            return sample;
        }

        /// <summary>Finds the tracker's latency from a finger that rests on a mark near the rim while the plate
        /// turns under it to and fro by 10 to 40 degrees, at uneven times, for 5 to 10 s: the finger is carried.
        /// Samples need PLATE_ORIENTATION, as the plate reports it, and PLATE_POSITION or WORLD_POSITION, all the
        /// same; others are left out. The pose of the plate has no effect. The result is relative to the plate's
        /// report: if that is late too, the difference. It cannot be found from a reach, where it adds to the
        /// person's own delay, nor while the plate turns at constant speed or repeats its turns; not <c>known</c>
        /// then, nor if the finger slips, nor within 2 s. A skin that yields counts as latency.
        /// <c>samples[0].structSize</c> is the size of every element. Takes about 0.1 s for 8 s at 1000 Hz.
        /// Errors: OUT_OF_RANGE naming the sample and the field, or for a count above
        /// Constants.LatencySamplesMax; TIME_REVERSED; OUT_OF_MEMORY. [any-thread]</summary>
        public static Latency FitLatency(Sample[] samples)
        {
            Load();
            if (samples == null) throw new ArgumentNullException(nameof(samples));
            samples = (Sample[])samples.Clone();
            for (int i = 0; i < samples.Length; ++i) samples[i].structSize = SizeOf<Sample>.Value;
            var latency = new Latency { structSize = SizeOf<Latency>.Value };
            Check(Native.hrt_latency_fit(samples, (ulong)samples.Length, ref latency));
            return latency;
        }
    }

    public sealed partial class HapticRetargetingPerson
    {
        /// <summary>Puts the finger at rest at the session's start. The person means to slide to where the
        /// session's virtual target is now, after a rest of 0.6 s. Each call is a further reach, with noise of
        /// its own. Errors: INVALID_HANDLE, OUT_OF_RANGE naming the target. [one-thread]</summary>
        public void Begin(HapticRetargetingSession session, TargetId virtualTarget)
        {
            Check(Native.hrt_person_begin(Handle, session.Handle, virtualTarget));
        }

        /// <summary>Commands the servo to the plate orientation (base.h), lets time pass until <c>timeNs</c>, and
        /// returns what tracker and servo then report: a sample with PLATE_POSITION and PLATE_ORIENTATION. Set
        /// <c>out_sample-&gt;structSize</c> before the call. The first call after hrt_person_begin() has the rest
        /// begin, and the plate stand where it says. Errors: OUT_OF_RANGE naming plateOrientationDeg,
        /// TIME_REVERSED, WRONG_STATE before hrt_person_begin(). [one-thread]</summary>
        public Sample Move(long timeNs, double plateOrientationDeg)
        {
            var sample = new Sample { structSize = SizeOf<Sample>.Value };
            Check(Native.hrt_person_move(Handle, timeNs, plateOrientationDeg, ref sample));
            return sample;
        }

        /// <summary>Returns where the person is. Errors: WRONG_STATE before hrt_person_begin().
        /// [one-thread]</summary>
        public PersonState GetState()
        {
            var state = new PersonState { structSize = SizeOf<PersonState>.Value };
            Check(Native.hrt_person_get_state(Handle, ref state));
            return state;
        }
    }

    public sealed partial class HapticRetargetingPlate
    {
        /// <summary>Turns the plate to this orientation, -3600 to 3600 degrees, or to one that feels the same
        /// (ridges repeat every 180 degrees): the nearest within the stops; if there is none, the nearest stop.
        /// Holds until the next one, or hrt_plate_stop(). Sent within 5 ms, unless the computer is busy. Errors:
        /// WRONG_STATE unless the plate is READY. [real-time]</summary>
        public void Set(double orientationDeg)
        {
            Check(PlateNative.hrt_plate_set(Handle, orientationDeg));
        }

        /// <summary>Stops the plate where it is; it holds. Errors: as hrt_plate_set(). [real-time]</summary>
        public void Stop()
        {
            Check(PlateNative.hrt_plate_stop(Handle));
        }

        /// <summary>Fills <c>*out_report</c>. Set its <c>structSize</c> before the call. Reads the monotonic
        /// clock. [real-time]</summary>
        public PlateReport Get()
        {
            var report = new PlateReport { structSize = SizeOf<PlateReport>.Value };
            Check(PlateNative.hrt_plate_get(Handle, ref report));
            return report;
        }
    }
}
