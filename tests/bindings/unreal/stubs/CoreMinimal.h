// Stubs of the Unreal types that the plugin uses, to compile and run it without the engine. Tests with these stubs are
// valid if the engine's types behave like them.
#pragma once

#include <cmath>
#include <codecvt>
#include <cstdint>
#include <functional>
#include <locale>
#include <string>
#include <vector>

using int32 = int32_t;
using int64 = long long;
using uint8 = uint8_t;
using TCHAR = char16_t;
#define TEXT(literal) u##literal

#define UENUM(...)
#define UMETA(...)
#define USTRUCT(...)
#define UCLASS(...)
#define UPROPERTY(...)
#define UFUNCTION(...)
#define UPARAM(...)

namespace Stub
{
	inline std::string ToUtf8(const std::u16string& Text)
	{
		return std::wstring_convert<std::codecvt_utf8_utf16<char16_t>, char16_t>().to_bytes(Text);
	}
	inline std::u16string ToUtf16(const std::string& Text)
	{
		return std::wstring_convert<std::codecvt_utf8_utf16<char16_t>, char16_t>().from_bytes(Text);
	}

	/** Result of the conversion macros, which lives until the end of the expression. */
	template <typename String>
	struct Converted
	{
		String Text;
		operator const typename String::value_type*() const { return Text.c_str(); }
	};
}
#define TCHAR_TO_UTF8(text) static_cast<const char*>(Stub::Converted<std::string>{Stub::ToUtf8(text)})
#define UTF8_TO_TCHAR(text) static_cast<const TCHAR*>(Stub::Converted<std::u16string>{Stub::ToUtf16(text)})

class FString
{
public:
	FString() = default;
	FString(const TCHAR* Text) : Data(Text) {}
	const TCHAR* operator*() const { return Data.c_str(); }
	static FString SanitizeFloat(double Value) { return FString(Stub::ToUtf16(std::to_string(Value)).c_str()); }

private:
	std::u16string Data;
};

/** Log lines, "Category: Verbosity: text". The only supported format is one "%s". */
struct FLogCategory
{
	const char* Name;
	static inline std::vector<std::string> Lines;
	void Write(const char* Verbosity, std::u16string Format, const TCHAR* Argument) const
	{
		Format.replace(Format.find(u"%s"), 2, Argument);
		Lines.push_back(std::string(Name) + ": " + Verbosity + ": " + Stub::ToUtf8(Format));
	}
};
#define DECLARE_LOG_CATEGORY_EXTERN(Category, Default, CompileTime) extern const FLogCategory Category
#define DEFINE_LOG_CATEGORY(Category) const FLogCategory Category{#Category}
#define UE_LOG(Category, Verbosity, Format, Argument) Category.Write(#Verbosity, Format, Argument)

/** The used part of TArray. The engine's class has its own allocators. */
template <typename Element>
class TArray
{
public:
	void Reset() { Elements.clear(); }
	void Add(const Element& Item) { Elements.push_back(Item); }
	int32 Num() const { return static_cast<int32>(Elements.size()); }
	const Element& operator[](int32 Index) const { return Elements.at(static_cast<size_t>(Index)); }

private:
	std::vector<Element> Elements;
};

struct FVector
{
	double X = 0.0, Y = 0.0, Z = 0.0;

	FVector() = default;
	FVector(double InX, double InY, double InZ) : X(InX), Y(InY), Z(InZ) {}
	FVector operator+(const FVector& V) const { return {X + V.X, Y + V.Y, Z + V.Z}; }
	FVector operator*(double Scale) const { return {X * Scale, Y * Scale, Z * Scale}; }
	bool Equals(const FVector& V, double Tolerance) const
	{
		return std::abs(X - V.X) <= Tolerance && std::abs(Y - V.Y) <= Tolerance && std::abs(Z - V.Z) <= Tolerance;
	}
	static FVector CrossProduct(const FVector& A, const FVector& B)
	{
		return {A.Y * B.Z - A.Z * B.Y, A.Z * B.X - A.X * B.Z, A.X * B.Y - A.Y * B.X};
	}
};

/** Quaternion with the engine's convention: a rotation about Z turns X to Y. */
struct FQuat
{
	double X = 0.0, Y = 0.0, Z = 0.0, W = 1.0;

	FQuat() = default;
	FQuat(double InX, double InY, double InZ, double InW) : X(InX), Y(InY), Z(InZ), W(InW) {}
	FQuat(const FVector& Axis, double Radians)
		: X(Axis.X * std::sin(Radians / 2)), Y(Axis.Y * std::sin(Radians / 2)), Z(Axis.Z * std::sin(Radians / 2)),
		  W(std::cos(Radians / 2))
	{
	}
	bool Equals(const FQuat& Q, double Tolerance) const
	{
		return std::abs(X - Q.X) <= Tolerance && std::abs(Y - Q.Y) <= Tolerance && std::abs(Z - Q.Z) <= Tolerance &&
			   std::abs(W - Q.W) <= Tolerance;
	}
	FVector RotateVector(const FVector& V) const
	{
		const FVector Q(X, Y, Z);
		const FVector T = FVector::CrossProduct(Q, V) * 2.0;
		return V + T * W + FVector::CrossProduct(Q, T);
	}
};

/** Rotation angles in degrees. */
struct FRotator
{
	double Pitch = 0.0, Yaw = 0.0, Roll = 0.0;

	FRotator() = default;
	FRotator(double InPitch, double InYaw, double InRoll) : Pitch(InPitch), Yaw(InYaw), Roll(InRoll) {}
};

struct FPlatformTime
{
	static inline double Now = 0.0;
	static double Seconds() { return Now; }
};

class FTransform
{
public:
	FTransform() = default;
	FTransform(const FQuat& InRotation, const FVector& InLocation, const FVector& InScale = {1.0, 1.0, 1.0})
		: Rotation(InRotation), Location(InLocation), Scale(InScale)
	{
	}
	FQuat GetRotation() const { return Rotation; }
	FVector GetLocation() const { return Location; }
	FVector GetScale3D() const { return Scale; }
	bool Equals(const FTransform& T, double Tolerance) const
	{
		return Rotation.Equals(T.Rotation, Tolerance) && Location.Equals(T.Location, Tolerance) && Scale.Equals(T.Scale, Tolerance);
	}
	FVector TransformPosition(const FVector& V) const
	{
		return Rotation.RotateVector({V.X * Scale.X, V.Y * Scale.Y, V.Z * Scale.Z}) + Location;
	}

private:
	FQuat Rotation;
	FVector Location;
	FVector Scale{1.0, 1.0, 1.0};
};

/** A delegate for any function; the engine's delegates bind UFUNCTIONs by name. */
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(Delegate, Type, Name)            \
	class Delegate                                                                   \
	{                                                                                \
	public:                                                                          \
		void Add(std::function<void(Type)> Handler) { Handlers.push_back(Handler); } \
		void Broadcast(Type Name) const                                              \
		{                                                                            \
			for (const auto& Handler : Handlers)                                     \
			{                                                                        \
				Handler(Name);                                                       \
			}                                                                        \
		}                                                                            \
                                                                                     \
	private:                                                                         \
		std::vector<std::function<void(Type)>> Handlers;                             \
	}
#define AddDynamic(Object, Function) Add([Object](auto Argument) { (Object->*Function)(Argument); })
