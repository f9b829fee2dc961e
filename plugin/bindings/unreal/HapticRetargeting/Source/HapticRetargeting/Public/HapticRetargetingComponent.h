// A session of the plugin, as a component: a user and a plate.
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
 * Put it where the plate is: its transform is the plate's, X away from the user, Y right, Z up, and it may move. Do not
 * scale it. Calls that are refused return false, change nothing, and log what was wrong and what is allowed.
 */
UCLASS(ClassGroup = "Haptic Retargeting", meta = (BlueprintSpawnableComponent))
class HAPTICRETARGETING_API UHapticRetargetingComponent : public USceneComponent
{
	GENERATED_BODY()

public:
	/** Checked when they are first needed; during a reach they wait until its end. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Haptic Retargeting")
	FHapticSettings Settings;

	/** The servo reports Measured Plate Yaw, before each update and each reach. Otherwise the plate is taken to follow its
	 *  commands as its speed and latency allow. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Haptic Retargeting")
	bool bPlateIsMeasured = false;

	UPROPERTY(BlueprintReadWrite, Category = "Haptic Retargeting")
	double MeasuredPlateYaw = 0.0;

	/** The controller has decided: turn the plate here. */
	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticPlateCommanded OnPlateCommanded;

	/** The command is saturated, predicted, lifted ... or no longer. */
	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticFlagsChanged OnFlagsChanged;

	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticReachEnded OnReachEnded;

	/** In a set-up the user is to do something else now: show the text, and Place, which is in the component's axes. */
	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticSetupStepped OnSetupStepped;

	/** The set-up is over. What it found is applied. */
	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticSetupFinished OnSetupFinished;

	/** Adds a target by its direction and distance in cm from the start. Names are unique, or empty. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool AddTarget(EHapticTargetRole Role, const FString& Name, double Yaw, double Distance, FHapticTarget& OutTarget);

	/** Adds a target by its place in the world. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool AddTargetAt(EHapticTargetRole Role, const FString& Name, const FVector& Location, FHapticTarget& OutTarget);

	/** Moves a target; a running reach follows with RetargetReach. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool MoveTarget(const FHapticTarget& Target, const FVector& Location);

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool RemoveTarget(const FHapticTarget& Target);

	/** The gap between two targets, and the largest that the plate can hold, computed before a reach. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool GetGap(const FHapticTarget& Real, const FHapticTarget& Virtual, FHapticGap& OutGap);

	/** Plate, start and targets of a glTF file, at its path on disk. The component moves to the scene's plate. The targets'
	 *  names and places come in the order of their ids. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Scene")
	bool LoadScene(const FString& Path, TArray<FHapticTarget>& OutTargets, TArray<FHapticSceneTarget>& OutDescriptions);

	/** Duration is the expected one of the motion in seconds; 0: unknown. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool BeginReach(const FHapticTarget& Real, const FHapticTarget& Virtual, double Duration = 0.0);

	/** The fingertip in the world, at a time in seconds that does not run backwards. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool UpdateFinger(const FVector& Location, double Time);

	/** A tracked joint of the finger, with its rotation: a set-up finds where the skin is beside it. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool UpdateJoint(const FTransform& Joint, double Time);

	/** The tracker does not see the finger. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool UpdateLost(double Time);

	/** Leads the reach to other targets from now on, or to the same ones after they were moved. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool RetargetReach(const FHapticTarget& Real, const FHapticTarget& Virtual);

	/** The finger has met the real object, at a place that is known to Deviation (cm; 0: to the real target's radius): later
	 *  reaches correct the tracker's frame, about a registration. Once a reach, at Arrived or after EndReach. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool ReachTouched(const FVector& Location, double Deviation = 0.0);

	/** The same at the near side of the real target. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool ReachTouchedRealTarget();

	/** Ends the reach without a summary; nothing is learnt from it. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool CancelReach();

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool EndReach(FHapticSummary& OutSummary);

	UFUNCTION(BlueprintPure, Category = "Haptic Retargeting")
	bool IsReaching() const { return bReaching; }

	/** Of the running reach, or else the last. */
	UFUNCTION(BlueprintPure, Category = "Haptic Retargeting")
	FHapticCommand GetCommand() const;

	/** Begins a set-up of What: where the plate is, the skin beside a joint, the user. Until it is over,
	 *  updates are its samples, and OnPlateCommanded turns the plate for it. A registration moves the component to the touched
	 *  plate. At the step Finish the user waits for a fit, which takes at most 1 ms of each update. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Setup")
	bool BeginSetup(UPARAM(meta = (Bitmask, BitmaskEnum = "/Script/HapticRetargeting.EHapticSetupFlags")) int32 What);

	/** Ends the set-up. What was finished before stays. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Setup")
	bool CancelSetup();

	/** Forgets the user, who is another one from now on: a set-up of all that is missing asks for them. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Setup")
	bool NewPerson();

	UFUNCTION(BlueprintPure, Category = "Haptic Retargeting|Setup")
	bool IsSettingUp() const { return bSettingUp; }

	/** A simulated person takes the finger's place, and the servo's: they mean to go to the virtual target, feel the plate and
	 *  are bent by it. With a target whose Id is 0 they do what the set-up asks for. A model, and no measurement of people; the
	 *  same seed is the same person. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Simulation")
	bool BeginSimulatedFinger(const FHapticTarget& Virtual, int64 Seed);

	/** In place of Update Finger: the simulated finger moves until Time, and Out Location is where the tracker sees it. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Simulation")
	bool UpdateSimulatedFinger(double Time, FVector& OutLocation);

	/** Opens the device that turns the plate: "serial:COM3", "dynamixel:/dev/ttyUSB0?id=1", or the file of `hrt-plate
	 *  commission`. When it is ready, seconds later, it takes each command, sets bPlateIsMeasured and MeasuredPlateYaw if it
	 *  knows where it stands, and what it can do goes into Settings, between reaches. Begin reaches from then on. The log has why
	 *  it fails. False if the name is malformed. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Plate")
	bool OpenPlate(const FString& Device);

	/** Whether it takes commands. It stops by itself if nothing asks this, and no update comes, for 0.3 s. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Plate")
	bool IsPlateReady();

	/** Stops the plate where it is, and leaves it. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Plate")
	void ClosePlate();

	/** What is known of the user, as JSON. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool SaveProfile(FString& OutJson);

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool LoadProfile(const FString& Json);

	/** Records all calls to a file that is created or replaced. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool StartRecording(const FString& Path);

	/** Rows so far. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool GetRecordingStatus(int64& OutRowsWritten, int64& OutRowsLost);

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool StopRecording();

	/** For C++: a sample as the C interface has it, in the plate's coordinates, and the command likewise. */
	bool UpdateSample(const hrt_sample& Sample);
	const hrt_command& GetRawCommand() const { return Command; }
	/** For C++: the session, for the calls of the C headers; its value is 0 if it is refused. After one that changes the
	 *  configuration, call TakeFromSession(). */
	hrt_session GetSession();
	/** Takes what C calls have changed into the settings; the component moves to where the session has the plate. */
	void TakeFromSession();

	virtual void OnComponentDestroyed(bool bDestroyingHierarchy) override;
	virtual void BeginDestroy() override;

private:
	bool Succeeded(hrt_result Result) const;
	bool HasLibrary() const;
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
	/** The component's transform where the plugin has placed it: the session has the same to the last bit. */
	FTransform PlatePlace;
	bool bPlacedByPlugin = false;
	hrt_session_config Configured{};
	hrt_command Command{};
	hrt_setup_step Step{};
	uint32_t SetupDone = 0;
	bool bReaching = false;
	bool bSettingUp = false;
	mutable bool bSaidMissing = false;
};
