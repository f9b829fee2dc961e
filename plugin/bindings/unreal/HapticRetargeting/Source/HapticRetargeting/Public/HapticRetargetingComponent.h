#pragma once

#include "Components/SceneComponent.h"
#include "CoreMinimal.h"
#include "haptic_retargeting/gap.h"
#include "haptic_retargeting/haptic_retargeting.h"
#include "haptic_retargeting/host.h"
#include "haptic_retargeting/person.h"
#include "haptic_retargeting/plate.h"
#include "haptic_retargeting/profile.h"
#include "haptic_retargeting/recording.h"
#include "haptic_retargeting/scene.h"
#include "haptic_retargeting/setup.h"
#include "HapticRetargetingTypes.h"
#include "HapticRetargetingComponent.generated.h"

DECLARE_LOG_CATEGORY_EXTERN(LogHapticRetargeting, Log, All);

DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHapticPlateCommanded, double, PlateYaw);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHapticFlagsChanged, int32, Flags);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHapticReachEnded, const FHapticSummary&, Summary);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHapticSetupStepped, const FHapticSetupStep&, Step);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHapticSetupFinished, const FHapticSetupResult&, Result);

/**
 * One user and one plate. The component's transform is the plate's pose, which may change: X away from the user, Y
 * right, Z up. Do not scale it. Calls that fail return false and log the reason.
 */
UCLASS(ClassGroup = "Haptic Retargeting", meta = (BlueprintSpawnableComponent))
class HAPTICRETARGETING_API UHapticRetargetingComponent : public USceneComponent
{
	GENERATED_BODY()

public:
	/** Settings of the session, checked at their next use. Changes during a reach or a set-up apply after its end. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Haptic Retargeting")
	FHapticSettings Settings;

	/** True if Measured Plate Yaw is set before each update and each reach. Otherwise the plate is assumed to follow its
	 *  commands as its speed and latency allow. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Haptic Retargeting")
	bool bPlateIsMeasured = false;

	UPROPERTY(BlueprintReadWrite, Category = "Haptic Retargeting")
	double MeasuredPlateYaw = 0.0;

	/** Broadcasts the orientation to which the plate must turn: a yaw in degrees, clockwise from the mid-line. */
	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticPlateCommanded OnPlateCommanded;

	/** Broadcast when flags of the command other than Held change, for example Saturated, Predicted or Lifted. */
	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticFlagsChanged OnFlagsChanged;

	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticReachEnded OnReachEnded;

	/** Broadcasts a new instruction of a set-up: show its text, and Place, which is in the component's axes. */
	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticSetupStepped OnSetupStepped;

	/** Broadcast when all parts of the set-up have ended, and results are applied. */
	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticSetupFinished OnSetupFinished;

	/** Adds a target by its direction and distance in cm from the start. Names are unique, or empty. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool AddTarget(EHapticTargetRole Role, const FString& Name, double Yaw, double Distance, FHapticTarget& OutTarget);

	/** Adds a target by its position in the world. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool AddTargetAt(EHapticTargetRole Role, const FString& Name, const FVector& Location, FHapticTarget& OutTarget);

	/** Moves a target. A running reach uses the new position after RetargetReach. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool MoveTarget(const FHapticTarget& Target, const FVector& Location);

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool RemoveTarget(const FHapticTarget& Target);

	/** Computes the gap between two targets, and the largest feasible gap. Needs no reach. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool GetGap(const FHapticTarget& Real, const FHapticTarget& Virtual, FHapticGap& OutGap);

	/** Loads plate, start and targets of a glTF file, by its path on disk. The component moves to the scene's plate.
	 *  OutDescriptions has names and positions of the targets in the order of OutTargets. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Scene")
	bool LoadScene(const FString& Path, TArray<FHapticTarget>& OutTargets, TArray<FHapticSceneTarget>& OutDescriptions);

	/** Begins a reach. Duration is the expected duration of the motion in seconds; 0: unknown. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool BeginReach(const FHapticTarget& Real, const FHapticTarget& Virtual, double Duration = 0.0);

	/** Processes the fingertip's position in the world, at a time in seconds that never decreases. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool UpdateFinger(const FVector& Location, double Time);

	/** Processes the pose of a tracked joint of the finger. A set-up measures the offset of the skin from the joint. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool UpdateJoint(const FTransform& Joint, double Time);

	/** Processes a dropout: the finger is not tracked. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool UpdateLost(double Time);

	/** Redirects the reach to other targets, or to the same targets after they were moved. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool RetargetReach(const FHapticTarget& Real, const FHapticTarget& Virtual);

	/** Reports contact with the real object at a position in the world. PositionSd is the SD of a coordinate in cm; 0: the
	 *  radius of the real target, or 1 cm if it is unknown. The contact corrects the tracked positions of later reaches.
	 *  Requires a registration. Allowed once per reach, also after EndReach. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool ReachTouched(const FVector& Location, double PositionSd = 0.0);

	/** Reports contact as ReachTouched does, at the near side of the real target. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool ReachTouchedRealTarget();

	/** Ends the reach without a summary and discards its estimates. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool CancelReach();

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool EndReach(FHapticSummary& OutSummary);

	UFUNCTION(BlueprintPure, Category = "Haptic Retargeting")
	bool IsReaching() const { return bReaching; }

	/** Returns the last command. From BeginReach until the first update, all fields are 0, except PaperStep, -1. */
	UFUNCTION(BlueprintPure, Category = "Haptic Retargeting")
	FHapticCommand GetCommand() const;

	/** Begins a set-up of the parts What: the plate's pose, the offset of the skin from a joint, the user. Until the
	 *  set-up is over, updates pass their samples to it, and broadcast OnPlateCommanded. A registration sets the
	 *  component's transform to the plate's pose. At the step Finish the user waits for a fit, which each update
	 *  continues. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Setup")
	bool BeginSetup(UPARAM(meta = (Bitmask, BitmaskEnum = "/Script/HapticRetargeting.EHapticSetupFlags")) int32 What);

	/** Cancels the set-up. Results of finished parts remain. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Setup")
	bool CancelSetup();

	/** Resets the parameters of the user, for another person, whom a set-up of all missing parts then measures. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Setup")
	bool NewPerson();

	UFUNCTION(BlueprintPure, Category = "Haptic Retargeting|Setup")
	bool IsSettingUp() const { return bSettingUp; }

	/** Replaces finger and servo by a simulated person, who moves towards the virtual target and is deflected by the
	 *  plate, or follows the set-up if the target's Id is 0. The same seed gives the same person. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Simulation")
	bool BeginSimulatedFinger(const FHapticTarget& Virtual, int64 Seed);

	/** Advances the simulated finger to Time, instead of UpdateFinger. OutLocation: tracked position in the world. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Simulation")
	bool UpdateSimulatedFinger(double Time, FVector& OutLocation);

	/** Opens the device that turns the plate: "serial:COM3", "dynamixel:/dev/ttyUSB0?id=1", or the file that `hrt-plate
	 *  commission` writes. Some seconds later, the device is ready: from then on, it receives each command, and
	 *  UpdateFinger, UpdateJoint and BeginReach set bPlateIsMeasured and MeasuredPlateYaw by its report. Its speed,
	 *  acceleration, latency and stops are copied to Settings once, outside of reaches and set-ups. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Plate")
	bool OpenPlate(const FString& Device);

	/** True if the plate accepts commands. The plate stops after 0.3 s without this call, UpdateFinger or UpdateJoint. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Plate")
	bool IsPlateReady();

	/** Stops the plate and closes the device. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Plate")
	void ClosePlate();

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool SaveProfile(FString& OutJson);

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool LoadProfile(const FString& Json);

	/** Records reaches and set-ups to a file, which is created or replaced. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool StartRecording(const FString& Path);

	/** Returns the numbers of written and lost rows so far. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool GetRecordingStatus(int64& OutRowsWritten, int64& OutRowsLost);

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool StopRecording();

	/** For C++: processes a sample of the C interface. */
	bool UpdateSample(const hrt_sample& Sample);
	const hrt_command& GetRawCommand() const { return Command; }
	/** For C++: returns the session for calls of the C headers, with the value 0 on failure. After a call that changes the
	 *  configuration, call TakeFromSession(). */
	hrt_session GetSession();
	/** Copies changes that C calls made in the session's configuration to Settings. If they changed the plate's pose,
	 *  moves the component. */
	void TakeFromSession();

	virtual void OnComponentDestroyed(bool bDestroyingHierarchy) override;
	virtual void BeginDestroy() override;

private:
	bool Succeeded(hrt_result Result) const;
	bool HasLibrary() const;
	bool TakeLog() const;
	bool Configure();
	bool IsAtPlate() const;
	void MoveToPlate();
	void PlatePose(double (&OutPosition)[3], double (&OutRotation)[4]) const;
	bool Add(const hrt_target_config& Config, FHapticTarget& OutTarget);
	hrt_sample FingerSample(const FVector& Location, double Time);
	void TurnPlate(double OrientationDeg);
	void RefusePlate(const char* Reason);
	bool Guide(const hrt_sample& Sample);
	bool ContinueFit();
	bool TakeContact(const hrt_contact* Contact);
	void CloseSession();

	hrt_session Session{};
	hrt_person Person{};
	int64 PersonSeed = 0;
	hrt_plate Device{};
	bool bDeviceIsTaken = false;
	bool bDeviceIsRefused = false;
	/** Transform to which the plugin has moved the component, if bPlacedByPlugin. Configured has the exact pose. */
	FTransform PlatePlace;
	bool bPlacedByPlugin = false;
	hrt_session_config Configured{};
	hrt_command Command{};
	hrt_setup_step Step{};
	uint32_t SetupDone = 0;
	bool bReaching = false;
	bool bSettingUp = false;
	mutable bool bMissingIsLogged = false;
};
