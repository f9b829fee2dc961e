#pragma once

#include "CoreMinimal.h"

class USceneComponent
{
public:
	virtual ~USceneComponent() = default;
	const FTransform& GetComponentTransform() const { return Transform; }
	void SetWorldTransform(const FTransform& NewTransform) { Transform = NewTransform; }
	virtual void OnComponentDestroyed(bool) {}
	virtual void BeginDestroy() {}

private:
	FTransform Transform;
};
