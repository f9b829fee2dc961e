// A session of the plugin, as a component: a user and a plate.
#pragma once

#include "Components/SceneComponent.h"
#include "CoreMinimal.h"
#include "haptic_retargeting/haptic_retargeting.h"
#include "HapticRetargetingTypes.h"
#include "HapticRetargetingComponent.generated.h"

DECLARE_LOG_CATEGORY_EXTERN(LogHapticRetargeting, Log, All);

DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHapticPlateCommanded, double, PlateYaw);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHapticFlagsChanged, int32, Flags);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHapticReachEnded, const FHapticSummary&, Summary);

/** A touch of a mark on the plate, whose place on it is known. */
USTRUCT(BlueprintType)
struct FHapticMarkTouch
{
	GENERATED_BODY()

	/** The mark in the plate's coordinates: X away from the user, Y right, Z up, from its centre. In cm. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Haptic Retargeting")
	FVector Mark = FVector(0.0, 0.0, 0.0);

	/** Where the tracker saw the fingertip, in the world. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Haptic Retargeting")
	FVector Touched = FVector(0.0, 0.0, 0.0);
};

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

	/** The controller has decided: turn the plate here. */
	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticPlateCommanded OnPlateCommanded;

	/** The command is saturated, predicted, lifted ... or no longer. */
	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticFlagsChanged OnFlagsChanged;

	UPROPERTY(BlueprintAssignable, Category = "Haptic Retargeting")
	FHapticReachEnded OnReachEnded;

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

	/** The largest gap that the plate can sustain, computed before a reach. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool GetAuthority(const FHapticTarget& Real, const FHapticTarget& Virtual, FHapticAuthority& OutAuthority);

	/** Of the real target that serves a virtual one best. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool GetBestAuthority(const FHapticTarget& Virtual, FHapticAuthority& OutAuthority);

	/** The real target that serves each virtual one, so that the largest needed share of the authority is the smallest;
	 *  each real one serves one at most if Exclusive. One that cannot be served has Reachable false and no real target. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool AssignTargets(const TArray<FHapticTarget>& Virtual, const TArray<FHapticTarget>& Real, bool bExclusive,
		TArray<FHapticAuthority>& OutAuthorities);

	/** Plate, start and targets of a glTF file, at its path on disk. The component moves to the scene's plate. The targets'
	 *  names and places come in the order of their ids. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Scene")
	bool LoadScene(const FString& Path, TArray<FHapticTarget>& OutTargets, TArray<FHapticSceneTarget>& OutDescriptions);

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool BeginReach(const FHapticTarget& Real, const FHapticTarget& Virtual);

	/** As Begin Reach, with the plate at Plate Yaw, as measured, and the expected duration of the motion in seconds; 0 if
	 *  it is unknown. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool BeginReachAt(const FHapticTarget& Real, const FHapticTarget& Virtual, double PlateYaw, double Duration);

	/** The fingertip in the world, at a time in seconds that does not run backwards. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool UpdateFinger(const FVector& Location, double Time);

	/** As Update Finger, with the plate's yaw as its servo reports it. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool UpdateFingerAndPlate(const FVector& Location, double PlateYaw, double Time);

	/** The tracker does not see the finger. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool UpdateLost(double Time);

	/** Leads the reach to other targets from now on, or to the same ones after they were moved. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool RetargetReach(const FHapticTarget& Real, const FHapticTarget& Virtual);

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

	/** Forgets a calibration that there may be, and begins another: the user is asked to go to Goal Yaw. For each slide
	 *  GetNextAngle() has the plate's yaw; the plate is at rest, and so is the finger for half a second before. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool BeginCalibration(double GoalYaw);

	/** As above, with the range of GetNextAngle() about Goal Yaw, to either side, and the width of the 95 % interval of
	 *  the share of touch that is enough. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool BeginCalibrationWithin(double GoalYaw, double MaxPlateAngle, double EnoughWeightWidth);

	/** Where the plate should stand for the next slide, and whether the slides so far are enough. Takes some tenths of a
	 *  second. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool GetNextAngle(double& OutPlateYaw, bool& bOutEnough);

	/** The plate stands at Plate Yaw, until the trial ends or Add Trial Sample And Plate says otherwise. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool BeginTrial(double PlateYaw);

	/** The fingertip in the world, at rest and then sliding. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool AddTrialSample(const FVector& Location, double Time);

	/** As Add Trial Sample, with the plate's yaw as its servo reports it: of a plate that turns within the slide, which
	 *  shows how fast and how late the user steers. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool AddTrialSampleAndPlate(const FVector& Location, double PlateYaw, double Time);

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool EndTrial();

	/** As when the user has slipped. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool CancelTrial();

	/** Takes half a second for 20000 samples. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool SolveCalibration(FHapticCalibration& OutCalibration);

	/** A slide of the last solution, from 0 to Trials Used less 1: seen, fitted, and whether it was left out. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool GetSlide(int32 Number, FHapticSlide& OutSlide);

	/** What was solved last becomes the settings. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool ApplyCalibration();

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool EndCalibration();

	/** The component's last solved calibration against the one before it: which values differ. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Calibration")
	bool CompareCalibrations(FHapticCalibrationComparison& OutComparison);

	/** Where the plate is, from touches of its marks: five or more let one bad touch be found. A verdict other than Holds is
	 *  no failure; Advice says what to do about it. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Registration")
	bool FitRegistration(const TArray<FHapticMarkTouch>& Touches, FHapticRegistration& OutRegistration, FString& OutAdvice);

	/** The component moves to the plate of the last fit; Time is when the touches were made, on the clock of the samples.
	 *  Moving the component elsewhere ends the registration. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Registration")
	bool ApplyRegistration(double Time);

	/** Whether a touch of a mark, as before each reach, agrees with the registration; if not, the session is unregistered. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Registration")
	bool ConfirmRegistration(const FHapticMarkTouch& Touch, double Time, FHapticTouchCheck& OutCheck);

	/** The offset from a tracked joint to the skin, from touches of one mark with the finger held differently each time. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Registration")
	bool FitFingertip(const TArray<FTransform>& Joints, FHapticFingertip& OutFingertip);

	/** Where the skin is, by the offset of the last fit: for Update Finger and for touches. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting|Registration")
	bool PlaceFingertip(const FTransform& Joint, FVector& OutLocation) const;

	/** What is known of the user, as JSON. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool SaveProfile(FString& OutJson);

	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool LoadProfile(const FString& Json);

	/** Plate and tracker of now, and the time in seconds since 1970: what a calibration is measured under. The log warns if
	 *  those of the profile are others. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool SetConditions(const FString& Plate, const FString& Tracker, int64 Time);

	/** Those of the profile, and whether plate or tracker are others now. */
	UFUNCTION(BlueprintCallable, Category = "Haptic Retargeting")
	bool GetConditions(FString& OutPlate, FString& OutTracker, int64& OutTime, bool& bOutPlateDiffers, bool& bOutTrackerDiffers);

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

	virtual void OnComponentDestroyed(bool bDestroyingHierarchy) override;
	virtual void BeginDestroy() override;

private:
	bool Succeeded(hrt_result Result) const;
	bool HasLibrary() const;
	bool Configure();
	bool CreateCalibration(const hrt_calibration_config& Config);
	bool Begin(const hrt_reach_config& Config);
	bool HasResult(uint32_t StructSize, const TCHAR* Message) const;
	bool IsAtPlate() const;
	void MoveToPlate();
	void PlatePose(double (&OutPosition)[3], double (&OutRotation)[4]) const;
	bool Add(const hrt_target_config& Config, FHapticTarget& OutTarget);
	hrt_sample FingerSample(const FVector& Location, double Time) const;
	hrt_sample FingerAndPlateSample(const FVector& Location, double PlateYaw, double Time) const;
	void TakeFromSession();
	void CloseSession();

	hrt_session Session{};
	hrt_calibration Calibration{};
	/** Its struct_size is 0 while nothing is solved. */
	hrt_calibration_result User{};
	/** Of the calibration before. */
	hrt_calibration_result UserBefore{};
	hrt_registration Registration{};
	hrt_fingertip Fingertip{};
	/** The component's transform where the plugin has placed it: the session has the same to the last bit. */
	FTransform PlatePlace;
	bool bPlacedByPlugin = false;
	hrt_session_config Configured{};
	hrt_command Command{};
	bool bReaching = false;
	mutable bool bSaidMissing = false;
};
