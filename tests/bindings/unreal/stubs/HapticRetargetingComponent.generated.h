#define HAPTICRETARGETING_API
#undef GENERATED_BODY
#define GENERATED_BODY() using Super = USceneComponent;
