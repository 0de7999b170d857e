package nephele.mutants;

import static nephele.mutants.Mutant.Area.LEVEL;
import static nephele.mutants.Mutant.Area.LIGHT;
import static nephele.mutants.Mutant.Area.MODEL;
import static nephele.mutants.Mutants.ENGINE;
import static nephele.mutants.Mutants.SHADERS;

import java.util.List;

/** Faults in clouds, weather and particles, and in numbers that reach shaders. */
final class WeatherMutants {
    static final List<Mutant> ALL = List.of(
            new Mutant(
                    MODEL,
                    "the oldest particle of the window is left out",
                    ENGINE + "particle/EmitterParticles.java",
                    "(clock - longest) * rate - 1",
                    "(clock - longest) * rate",
                    "LevelParticlesTest"),
            new Mutant(
                    MODEL,
                    "rain whose box ends above a portal does not enter it",
                    ENGINE + "particle/Rainfall.java",
                    "Aabb.of(portal.corners()).grown(FLUSH_METRES)",
                    "Aabb.of(portal.corners())",
                    "RainfallTest"),
            new Mutant(
                    MODEL,
                    "a portal just under a floor catches no rain",
                    ENGINE + "particle/Rainfall.java",
                    "> end - FLUSH_METRES",
                    "> end",
                    "RainfallTest"),
            new Mutant(
                    LIGHT,
                    "a cloud's shade drifts the other way",
                    ENGINE + "cloud/cells/ShadingClouds.java",
                    "shaded.drift.minus(cast.drift)",
                    "cast.drift.minus(shaded.drift)",
                    "CloudTimelineTest"),
            new Mutant(
                    LIGHT,
                    "the boxes of a cloud follow an eye that the wind carries the other way",
                    ENGINE + "cloud/drawn/CloudTimeline.java",
                    "focus.minus(cloud.drift(seconds))",
                    "focus.plus(cloud.drift(seconds))",
                    "CloudTimelineTest"),
            new Mutant(
                    LIGHT,
                    "a thick cloud does not see another one's shade",
                    ENGINE + "cloud/cells/ThickCloudLight.java",
                    "fraction * Math.exp(-medium.depthFactor() * shades[i])",
                    "fraction",
                    "ThickCloudLightTest"),
            new Mutant(
                    LEVEL,
                    "clouds are not sampled at the weather's keyframes",
                    ENGINE + "cloud/drawn/SampleInstants.java",
                    "course.changes() ? times : new double[0]",
                    "new double[0]",
                    "SampleInstantsTest"),
            new Mutant(
                    LEVEL,
                    "a fading weather fades twice as fast",
                    ENGINE + "level/appearance/WeatherCourse.java",
                    "s * s * (3 - 2 * s)",
                    "Math.min(1, 2 * s)",
                    "WeatherCourseTest"),
            new Mutant(
                    MODEL,
                    "terrain begins to morph later in the shader than in Java",
                    SHADERS + "include/terrain-detail.glsl",
                    "MORPH_START = java(math.heightfield.DetailRanges.MORPH_START)",
                    "MORPH_START = 0.7",
                    "ShaderConstantsTest"));

    private WeatherMutants() {}
}
