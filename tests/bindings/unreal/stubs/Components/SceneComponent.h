#pragma once

#include "CoreMinimal.h"

class USceneComponent
{
public:
	virtual ~USceneComponent() = default;
	const FTransform& GetComponentTransform() const { return Transform; }
	FVector GetComponentLocation() const { return Transform.GetLocation(); }
	void SetupAttachment(USceneComponent*) {}
	void SetRelativeRotation(const FRotator& Rotation) { RelativeRotation = Rotation; }
	FRotator GetRelativeRotation() const { return RelativeRotation; }
	void SetWorldLocation(const FVector& Location) { Transform = FTransform(Transform.GetRotation(), Location); }
	void SetWorldTransform(const FTransform& NewTransform) { Transform = NewTransform; }
	virtual void OnComponentDestroyed(bool) {}
	virtual void BeginDestroy() {}

private:
	FTransform Transform;
	FRotator RelativeRotation;
};
