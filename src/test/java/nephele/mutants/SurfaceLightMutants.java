package nephele.mutants;

import static nephele.mutants.Mutant.Area.LIGHT;
import static nephele.mutants.Mutant.Area.SHADOW;
import static nephele.mutants.Mutants.ENGINE;
import static nephele.mutants.Mutants.SHADERS;

import java.util.List;

/** Faults in surface lighting and its shadows. */
final class SurfaceLightMutants {
    static final List<Mutant> ALL = List.of(
            new Mutant(
                    LIGHT,
                    "a spot light is two hundredths narrower than written",
                    ENGINE + "level/appearance/PunctualLight.java",
                    "double outer = Math.min(spot.outerConeDegrees(), 180);",
                    "double outer = 0.98 * Math.min(spot.outerConeDegrees(), 180);",
                    "DirectLightTest"),
            new Mutant(
                    SHADOW,
                    "the sun's shadow takes a falling slope for none",
                    SHADERS + "include/sun-shadow.glsl",
                    "abs(gradient.x) + abs(gradient.y)",
                    "gradient.x + abs(gradient.y)",
                    "GrazingSunGlTest"),
            new Mutant(
                    SHADOW,
                    "shadows of what moves take a falling slope for none",
                    SHADERS + "include/dynamic-shadows.glsl",
                    "abs(gradient.x) + abs(gradient.y)",
                    "abs(gradient.x) + gradient.y",
                    "GrazingSunGlTest"),
            new Mutant(
                    LIGHT,
                    "fog hides what is near and shows what is far",
                    SHADERS + "include/fog.glsl",
                    "mix(fog.rgb, radiance,",
                    "mix(radiance, fog.rgb,",
                    "FogGlTest"),
            new Mutant(
                    LIGHT,
                    "a face asks the lamps behind it",
                    SHADERS + "include/punctual-lights.glsl",
                    "dot(faceNormal, along) < 0.0 ? 1.0 : 0.0",
                    "dot(faceNormal, along) < 0.0 ? 0.0 : 1.0",
                    "PunctualLightGlTest"),
            new Mutant(
                    LIGHT,
                    "highlights are twice as bright",
                    SHADERS + "include/brdf.glsl",
                    "float visibility = 0.5 /",
                    "float visibility = 1.0 /",
                    "LightTwinsGlTest"),
            new Mutant(
                    LIGHT,
                    "a sky lights from below what it should light from the side",
                    SHADERS + "include/sky-ambient.glsl",
                    "skyCoefficients[8] * (n.x * n.x - n.y * n.y)",
                    "skyCoefficients[8] * (n.x * n.x + n.y * n.y)",
                    "LightTwinsGlTest"));

    private SurfaceLightMutants() {}
}
