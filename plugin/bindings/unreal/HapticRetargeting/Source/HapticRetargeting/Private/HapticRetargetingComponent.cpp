#include "HapticRetargetingComponent.h"

#include "HapticConversions.h"
#include "HapticRetargetingModule.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>

DEFINE_LOG_CATEGORY(LogHapticRetargeting);

using namespace HapticConversions;

/** Returns true if a call of the plugin succeeded. Otherwise logs the reason. */
bool UHapticRetargetingComponent::Succeeded(hrt_result Result) const
{
	if (Result == HRT_OK)
	{
		return true;
	}
	UE_LOG(LogHapticRetargeting, Error, TEXT("%s"), UTF8_TO_TCHAR(hrt_last_error()));
	return false;
}

/** Returns true if the library is loaded. Otherwise logs an error once. */
bool UHapticRetargetingComponent::HasLibrary() const
{
	if (HapticLibraryIsLoaded())
	{
		return true;
	}
	if (!bMissingIsLogged)
	{
		UE_LOG(LogHapticRetargeting, Error, TEXT("%s"), TEXT("the plugin's library is missing: copy the DLLs that an earlier line of the log names to the folder that it names"));
	}
	bMissingIsLogged = true;
	return false;
}

/** Connects the session's log to the engine's log. Lines that the last reach has stored are written immediately. */
bool UHapticRetargetingComponent::TakeLog() const
{
	hrt_host Host = hrt_host_init();
	Host.log = [](void*, uint32_t, const char* Text)
	{
		// Hints on units are for callers of the C interface, who pass metres.
		std::string Line = Text;
		if (const size_t Unit = Line.find("in metres"); Unit != Line.npos)
		{
			Line.insert(Unit + 3, "centi");
		}
		UE_LOG(LogHapticRetargeting, Warning, TEXT("%s"), UTF8_TO_TCHAR(Line.c_str()));
	};
	return HAPTIC_CALL(hrt_host_set_log(Session, &Host));
}

/** Creates the session or updates its configuration, from the settings and the component's pose. Does nothing during a
 *  reach or a set-up. Returns false, and logs the reason, on failure. */
bool UHapticRetargetingComponent::Configure()
{
	if (!HasLibrary())
	{
		return false;
	}
	if (bReaching || bSettingUp)
	{
		return true;
	}
	if (!IsPose(GetComponentTransform()))
	{
		UE_LOG(LogHapticRetargeting, Error, TEXT("%s"), TEXT("the component is scaled; allowed: translation and rotation. Set its scale, and that of its parents, to 1"));
		return false;
	}
	if (bPlacedByPlugin && !IsAtPlate())
	{
		bPlacedByPlugin = false;
		Settings.bRegistered = false;
	}
	hrt_session_config Config = ToConfig(Settings, GetComponentTransform(), Configured);
	PlatePose(Config.plate.position_m, Config.plate.rotation);
	const bool bMade = Session.value == 0;
	const bool bSame = !bMade && std::memcmp(&Config, &Configured, sizeof Config) == 0;
	const bool bTaken = bSame || HAPTIC_CALL(bMade ? hrt_session_create(HRT_VERSION, &Config, &Session) : hrt_session_set(Session, &Config));
	if (bTaken && (!bMade || TakeLog()))
	{
		Configured = Config;
		return true;
	}
	return false;
}

bool UHapticRetargetingComponent::IsAtPlate() const
{
	return bPlacedByPlugin && GetComponentTransform().Equals(PlatePlace, 0.0);
}

void UHapticRetargetingComponent::MoveToPlate()
{
	SetWorldTransform(FTransform(FromQuaternion(Configured.plate.rotation), FromMetres(Configured.plate.position_m)));
	PlatePlace = GetComponentTransform();
	bPlacedByPlugin = true;
}

/** Returns the component's pose; if the plugin has set it, the plugin's numbers, without rounding errors. */
void UHapticRetargetingComponent::PlatePose(double (&OutPosition)[3], double (&OutRotation)[4]) const
{
	if (IsAtPlate())
	{
		std::copy(std::begin(Configured.plate.position_m), std::end(Configured.plate.position_m), OutPosition);
		std::copy(std::begin(Configured.plate.rotation), std::end(Configured.plate.rotation), OutRotation);
		return;
	}
	const FTransform& Plate = GetComponentTransform();
	ToMetres(Plate.GetLocation(), OutPosition);
	ToQuaternion(Plate.GetRotation(), OutRotation);
}

hrt_session UHapticRetargetingComponent::GetSession()
{
	return Configure() ? Session : hrt_session{};
}

void UHapticRetargetingComponent::TakeFromSession()
{
	const hrt_session_config Before = Configured;
	if (!HAPTIC_CALL(hrt_session_get(Session, &Configured, nullptr)))
	{
		return;
	}
	TakeChanges(Before, Configured, Settings);
	if (std::memcmp(Before.plate.position_m, Configured.plate.position_m, sizeof Before.plate.position_m) != 0 ||
		std::memcmp(Before.plate.rotation, Configured.plate.rotation, sizeof Before.plate.rotation) != 0)
	{
		MoveToPlate();
	}
}

void UHapticRetargetingComponent::CloseSession()
{
	ClosePlate();
	if (Person.value != 0)
	{
		hrt_person_destroy(Person);
		Person = {};
	}
	if (Session.value != 0)
	{
		hrt_session_destroy(Session);
		Session = {};
		bReaching = bSettingUp = false;
	}
}

void UHapticRetargetingComponent::OnComponentDestroyed(bool bDestroyingHierarchy)
{
	CloseSession();
	Super::OnComponentDestroyed(bDestroyingHierarchy);
}

/** The engine calls this function, but not OnComponentDestroyed(), for components that were never part of a level. */
void UHapticRetargetingComponent::BeginDestroy()
{
	CloseSession();
	Super::BeginDestroy();
}
