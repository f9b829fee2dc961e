using System;

namespace Hrt
{
    /// <summary>
    /// Who is this user? The curve of their illusion, bias and habit, and the tracker's noise, from slides over a
    /// plate that stands still. Have them slide to one target; <see cref="NextAngle"/> has the plate's orientation for
    /// each slide, and whether the slides are enough. Each is after half a second at rest: begin a trial, add samples,
    /// end it; then solve and apply. Tried on simulated people only.
    ///
    /// <see cref="BeginTrial"/>, <see cref="AddSample"/>, <see cref="EndTrial"/> and <see cref="CancelTrial"/> make
    /// no garbage.
    /// </summary>
    public sealed class HapticRetargetingCalibration : NativeObject
    {
        /// <summary>A calibration without trials. It takes the plate's place, the lift height and the step period
        /// from the session's configuration as it is now; the two then know nothing of each other.</summary>
        public HapticRetargetingCalibration(HapticRetargetingSession session)
            : this(session, CalibrationConfig.Default)
        {
        }

        public HapticRetargetingCalibration(HapticRetargetingSession session, CalibrationConfig config)
            : base(value => Native.hrt_calibration_destroy(new CalibrationHandle { value = value }))
        {
            if (session == null) throw new ArgumentNullException(nameof(session));
            config.structSize = SizeOf<CalibrationConfig>.Value;
            session.Check(Native.hrt_calibration_create(session.Handle, ref config, out CalibrationHandle handle));
            Own(handle.value);
        }

        /// <summary>The plate stands at this orientation until the trial ends.</summary>
        public void BeginTrial(double plateOrientationDeg) =>
            Check(Native.hrt_calibration_begin_trial(Handle, plateOrientationDeg));

        /// <summary>Takes one sample in: the finger at rest, then its slide. A component's is
        /// <see cref="HapticRetargeting.ReadFinger"/>.</summary>
        public void AddSample(Sample sample)
        {
            sample.structSize = SizeOf<Sample>.Value;
            Check(Native.hrt_calibration_add_sample(Handle, ref sample));
        }

        public void EndTrial() => Check(Native.hrt_calibration_end_trial(Handle));

        /// <summary>Ends the trial and forgets it, as when the user has slipped.</summary>
        public void CancelTrial() => Check(Native.hrt_calibration_cancel_trial(Handle));

        /// <summary>Fits the user to the trials, which stay. Takes half a second for 20000 samples: call it on a
        /// thread that draws no frames. Throws <see cref="Result.InsufficientData"/>, with what is needed, if the
        /// trials have too little data.</summary>
        public CalibrationResult Solve()
        {
            var result = new CalibrationResult { structSize = SizeOf<CalibrationResult>.Value };
            Check(Native.hrt_calibration_solve(Handle, ref result));
            return result;
        }

        /// <summary>Plate orientation for the next slide, degrees, by what it is expected to show; and whether the
        /// slides so far are enough. Takes some tenths of a second, as <see cref="Solve"/>.</summary>
        public double NextAngle(out bool enough)
        {
            Check(Native.hrt_calibration_next_angle(Handle, out double orientationDeg, out uint isEnough));
            enough = isEnough != 0;
            return orientationDeg;
        }

        /// <summary>A slide of the last <see cref="Solve"/>, from 0 to trialsUsed - 1: seen and fitted direction,
        /// and whether it was left out.</summary>
        public CalibrationSlide Residual(uint slide)
        {
            var result = new CalibrationSlide { structSize = SizeOf<CalibrationSlide>.Value };
            Check(Native.hrt_calibration_get_residual(Handle, slide, ref result));
            return result;
        }

        /// <summary>Test and retest: which values of two calibrations differ, and the differences, second less first,
        /// with their 95 % intervals.</summary>
        public static CalibrationComparison Compare(CalibrationResult first, CalibrationResult second)
        {
            HapticRetargetingLibrary.Load();
            first.structSize = second.structSize = SizeOf<CalibrationResult>.Value;
            var comparison = new CalibrationComparison { structSize = SizeOf<CalibrationComparison>.Value };
            HapticRetargetingLibrary.Check(Native.hrt_calibration_compare(ref first, ref second, ref comparison));
            return comparison;
        }

        CalibrationHandle Handle => new CalibrationHandle { value = Value };
    }
}
