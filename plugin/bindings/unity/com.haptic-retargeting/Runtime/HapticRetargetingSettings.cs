// Written by plugin/bindings/generate from the C headers.
using System;
using UnityEngine;

namespace Hrt
{
    // The fields of SessionConfig; a Transform of the scene gives its plate's pose and its start.
    public sealed partial class HapticRetargeting
    {
        [Header("Controller")]
        [Tooltip("Steps that the controller plans ahead. With 1 most reaches miss; more than 3 changes " +
                 "little and costs time. 1 to 50. Default 3.")]
        [Range(1f, 50f)]
        public int horizon = 3;

        [Tooltip("Duration of one step of the model and of the controller. The variances below are per " +
                 "step: scale them with it. 1 ms to 10 s. Default 100 ms. Shown in milliseconds.")]
        [Min(1f)]
        public double stepPeriodMs = 100;

        [Tooltip("Mpc: the model-predictive controller. FixedPlate: a plate that does not turn, as a " +
                 "baseline. Default Control.Mpc.")]
        public Control control = Control.Mpc;

        [Tooltip("FixedDirection: The real target's direction, seen from the start: the controller of the" +
                 " paper, for the person of its model. Arrival: The real target's place, at arrival: the " +
                 "controller for people. It takes the pace of the motion, the whole curve of the " +
                 "illusion, bias, habits and the tracker's noise as unknown, and learns them. Needs " +
                 "positions: in a reach with directions alone this is FIXED_DIRECTION. Measured on " +
                 "simulated people only. Default Guidance.Arrival.")]
        public Guidance guidance = Guidance.Arrival;

        [Tooltip("Off: tactileWeight and biasDeg are taken as known, the illusion as linear. Reach: The " +
                 "person is learnt within each reach, which begins with what the configuration says of " +
                 "them. Carried: As REACH; the end of a reach also writes what it has learnt into the " +
                 "configuration, widened, because people change: personMean and personCovariance, " +
                 "tactileWeight and its deviation. A reach that ends early or that the model does not fit" +
                 " (CommandFlags.Misfit) writes nothing. Under FIXED_DIRECTION it writes tactileWeight " +
                 "and motorVarianceDeg2; one reach changes the latter by a factor of 2 at most. Default " +
                 "Adaptation.Carried.")]
        public Adaptation adaptation = Adaptation.Carried;

        [Tooltip("PlateWaits: The plate stays where it stands until the finger moves. Otherwise it turns " +
                 "to where the first moment of the motion wants it as soon as a reach begins, which " +
                 "brings more fast reaches to the target. Set this if the finger rests on the ridges " +
                 "before a reach: a plate that turns under a resting finger is felt. Registered: The " +
                 "plate's pose is from a registration made at registrationTimeNs. " +
                 "hrt_registration_apply() sets this; hrt_scene_register(), which writes the scene's " +
                 "pose, clears it. Default 0.")]
        public SessionFlags flags;

        [Tooltip("Cost of the error that the user feels. Raising it keeps the felt direction closer to " +
                 "the virtual one and steers more slowly. 1e-6 to 1e6. Default 1.")]
        [Min(0.000001f)]
        public double perceivedWeight = 1;

        [Tooltip("Cost of the finger's actual error. Raising it steers faster, with a larger felt error; " +
                 "0 steers not at all. 0 to 1e6. Default 1.")]
        [Min(0f)]
        public double actualWeight = 1;

        [Tooltip("Largest felt error that Guidance.Arrival asks the plate for: felt minus intended " +
                 "direction, as predicted. Lowering it keeps the illusion less noticeable and reaches " +
                 "somewhat fewer targets: of simulated people, 3.5 costs about 2 reaches in 100. What the" +
                 " person adds, by noise or by being other than estimated, comes on top. 0.1 to 45. " +
                 "Default 5.")]
        [Range(0.1f, 45f)]
        public double maxFeltErrorDeg = 5;

        [Tooltip("Largest angle between the plate orientation and the finger's direction under " +
                 "Guidance.Arrival. Raising it allows larger gaps for people whose illusion still grows " +
                 "there; published data cover 60. Never beyond the peak of the person's illusion. 1 to " +
                 "89. Default 75.")]
        [Range(1f, 89f)]
        public double motionBoundDeg = 75;

        [Tooltip("Largest age of a registration at a sample. Older ones, and a session without " +
                 "SessionFlags.Registered, get CommandFlags.Registration. 0: not checked. Default 0. " +
                 "Shown in milliseconds.")]
        public double maxRegistrationAgeMs;

        [Tooltip("Largest standard deviation that plateCovariance may give the bearing of the real " +
                 "target. Worse ones, and a session without SessionFlags.Registered, get " +
                 "CommandFlags.Registration. 0 to 180; 0: not checked. Default 0.")]
        [Range(0f, 180f)]
        public double maxRegistrationSdDeg;

        [Tooltip("Rate at which the person corrects an error that they feel. Found by calibration.h, kept" +
                 " in the profile; the controller does not read it, as it gains nothing by it. 0 to 50 " +
                 "1/s; 0: not known. Default 0.")]
        [Range(0f, 50f)]
        public double steeringRatePerS;

        [Tooltip("Time from what the person feels to their answer, kept likewise. 0 to 0.5 s; 0: not " +
                 "known. Default 0.")]
        [Range(0f, 0.5f)]
        public double steeringDelayS;

        [Header("Plate")]
        [Tooltip("Maximum angle, modulo 180, between the plate orientation and the virtual direction plus" +
                 " biasDeg. Raising it allows larger gaps; near 90 the ridges run along the motion and " +
                 "signal nothing. 0.1 to 90. Default 84.5.")]
        [Range(0.1f, 90f)]
        public double plateBoundDeg = 84.5;

        [Tooltip("Maximum speed of the plate's servo, within which the controller plans. 0 to 1e6 degrees" +
                 " a second; 0: no limit. Default 0.")]
        [Min(0f)]
        public double plateMaxSpeedDegS;

        [Tooltip("Maximum acceleration of the servo, within which the controller plans. 0 to 1e8 degrees " +
                 "a second squared; 0: no limit. Default 0.")]
        [Min(0f)]
        public double plateMaxAccelerationDegS2;

        [Tooltip("Time from a command to the plate's first motion. The controller plans from where the " +
                 "plate will be by then. 0 to 1 s, and at most 8 step periods. Default 0. Shown in " +
                 "milliseconds.")]
        [Min(0f)]
        public double plateLatencyMs;

        [Tooltip("Mechanical stops, as plate orientations: no command lies beyond them. -3600 to 3600, " +
                 "the upper at least 180 above the lower; both 0: no stops. Default 0 and 0.")]
        [Min(-3600f)]
        public double plateLowerStopDeg;

        [Tooltip("Mechanical stops, as plate orientations: no command lies beyond them. -3600 to 3600, " +
                 "the upper at least 180 above the lower; both 0: no stops. Default 0 and 0.")]
        [Min(-3600f)]
        public double plateUpperStopDeg;

        [Tooltip("Plate orientation under Control.FixedPlate. With stops, the plate goes to the nearest " +
                 "orientation with the same ridges. -180 to 180. Default 0.")]
        [Range(-180f, 180f)]
        public double fixedPlateOrientationDeg;

        [Tooltip("Radius of the plate: positions beyond it get CommandFlags.OffPlate. 0.001 to 1000. " +
                 "Default 0.075.")]
        [Min(0.001f)]
        public double plateRadiusM = 0.075;

        [Tooltip("Height above the plate: positions above it count as lifted. 0.0001 to 1000. Default " +
                 "0.015.")]
        [Min(0.0001f)]
        public double liftHeightM = 0.015;

        [Tooltip("Length in the engine's world of 1 m on the plate: other than 1 if the tracker's unit is" +
                 " off. Divides positions and targets in the world, as seen from the plate's centre. 0.5 " +
                 "to 2. Default 1. This and the following: since version 0.3.")]
        [Range(0.5f, 2f)]
        public double plateScale = 1;

        [Header("User")]
        [Tooltip("Share of touch in the direction that the user feels. At a higher weight, the same turn " +
                 "of the plate steers the hand further. Under Guidance.Arrival it is that of an illusion " +
                 "taken as linear, at 60 degrees; personMean overrides it. 0.001 to 0.499. Default 0.2.")]
        [Range(0.001f, 0.499f)]
        public double tactileWeight = 0.2;

        [Tooltip("Standard deviation of tactileWeight, from which adaptation starts. Raising it makes " +
                 "adaptation faster and less steady; under Guidance.Arrival it also makes the illusion's " +
                 "curve as uncertain in proportion. 0.001 to 0.49. Default 0.05.")]
        [Range(0.001f, 0.49f)]
        public double tactileWeightSd = 0.05;

        [Tooltip("Variance of the user's motor command per step. Raising it makes the estimator follow " +
                 "the samples more closely. 1e-9 to 1e4. Default 0.5.")]
        [Min(0.000000001f)]
        public double motorVarianceDeg2 = 0.5;

        [Tooltip("Variance of the felt direction per step. Raising it models a user who reacts to touch " +
                 "more slowly. 1e-9 to 1e4. Default 0.1.")]
        [Min(0.000000001f)]
        public double sensoryVarianceDeg2 = 0.1;

        [Tooltip("Variance of the user's felt direction before the first step. Raising it models a user " +
                 "who trusts touch more in the first steps. 0 to 1e4. Default 0.")]
        [Min(0f)]
        public double initialVarianceDeg2;

        [Tooltip("Perceptual bias: perceived minus true direction of a virtual target. The user goes to " +
                 "the virtual direction plus this bias. Found by calibration.h; Guidance.Arrival learns " +
                 "the rest. -45 to 45. Default 0.")]
        [Range(-45f, 45f)]
        public double biasDeg;

        [Tooltip("Standard deviation of motorVarianceDeg2, from which adaptation starts. Raising it makes" +
                 " adaptation faster and less steady. 0.001 to 10. Default 0.5.")]
        [Range(0.001f, 10f)]
        public double motorVarianceSdDeg2 = 0.5;

        [Header("Tracker")]
        [Tooltip("Standard deviation of white noise in each tracked coordinate; under Guidance.Arrival of" +
                 " all noise, unless trackerCorrelatedNoiseM says how much of it is correlated. Raising " +
                 "it smooths positions more. 0 to 0.1, less than 1e-9 as 1e-9; 0: learnt from the " +
                 "samples. Default 0.")]
        [Range(0f, 0.1f)]
        public double trackerNoiseM;

        [Tooltip("Time from a motion to the timeNs of its sample, under Guidance.Arrival. 0 to 0.5 s. " +
                 "Default 0. Shown in milliseconds.")]
        [Min(0f)]
        public double trackerLatencyMs;

        [Tooltip("When the plate was registered, on the clock of the samples; read if " +
                 "SessionFlags.Registered. Default 0. Shown in milliseconds.")]
        public double registrationTimeMs;

        [Tooltip("Standard deviation of the correlated part of the tracker's noise in each coordinate, " +
                 "under Guidance.Arrival; trackerNoiseM is then the white part alone. Found by " +
                 "calibration.h. 0 to 0.1; 0: not known. Default 0.")]
        [Range(0f, 0.1f)]
        public double trackerCorrelatedNoiseM;

        [Tooltip("Time in which that part decays to 1/e; read if it is not 0. 0.01 to 2 s. Default 0.1.")]
        [Range(0.01f, 2f)]
        public double trackerCorrelationS = 0.1;

        SessionConfig Configuration()
        {
            SessionConfig config = SessionConfig.Default;
            config.horizon = (uint)horizon;
            config.stepPeriodNs = (long)Math.Round(stepPeriodMs * 1e6);
            config.control = control;
            config.guidance = guidance;
            config.adaptation = adaptation;
            config.flags = flags;
            config.perceivedWeight = perceivedWeight;
            config.actualWeight = actualWeight;
            config.maxFeltErrorDeg = maxFeltErrorDeg;
            config.motionBoundDeg = motionBoundDeg;
            config.maxRegistrationAgeNs = (long)Math.Round(maxRegistrationAgeMs * 1e6);
            config.maxRegistrationSdDeg = maxRegistrationSdDeg;
            config.steeringRatePerS = steeringRatePerS;
            config.steeringDelayS = steeringDelayS;
            config.plateBoundDeg = plateBoundDeg;
            config.plateMaxSpeedDegS = plateMaxSpeedDegS;
            config.plateMaxAccelerationDegS2 = plateMaxAccelerationDegS2;
            config.plateLatencyNs = (long)Math.Round(plateLatencyMs * 1e6);
            config.plateLowerStopDeg = plateLowerStopDeg;
            config.plateUpperStopDeg = plateUpperStopDeg;
            config.fixedPlateOrientationDeg = fixedPlateOrientationDeg;
            config.plateRadiusM = plateRadiusM;
            config.liftHeightM = liftHeightM;
            config.plateScale = plateScale;
            config.tactileWeight = tactileWeight;
            config.tactileWeightSd = tactileWeightSd;
            config.motorVarianceDeg2 = motorVarianceDeg2;
            config.sensoryVarianceDeg2 = sensoryVarianceDeg2;
            config.initialVarianceDeg2 = initialVarianceDeg2;
            config.biasDeg = biasDeg;
            config.motorVarianceSdDeg2 = motorVarianceSdDeg2;
            config.trackerNoiseM = trackerNoiseM;
            config.trackerLatencyNs = (long)Math.Round(trackerLatencyMs * 1e6);
            config.registrationTimeNs = (long)Math.Round(registrationTimeMs * 1e6);
            config.trackerCorrelatedNoiseM = trackerCorrelatedNoiseM;
            config.trackerCorrelationS = trackerCorrelationS;
            return config;
        }
    }
}
