#undef GENERATED_BODY
#define GENERATED_BODY() using Super = AActor;
