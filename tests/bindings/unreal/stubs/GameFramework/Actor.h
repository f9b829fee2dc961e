#pragma once

#include "Components/SceneComponent.h"

#include <memory>

class AActor
{
public:
	virtual ~AActor() = default;
	virtual void BeginPlay() {}
	virtual void Tick(float) {}
	USceneComponent* GetRootComponent() const { return RootComponent; }

	struct
	{
		bool bCanEverTick = false;
	} PrimaryActorTick;

protected:
	USceneComponent* RootComponent = nullptr;

	template <typename Component>
	Component* CreateDefaultSubobject(const TCHAR*)
	{
		auto Created = std::make_shared<Component>();
		Components.push_back(Created);
		return Created.get();
	}

private:
	std::vector<std::shared_ptr<USceneComponent>> Components;
};
