package nephele.mutants;

import static nephele.mutants.Mutant.Area.CLOUD;
import static nephele.mutants.Mutant.Area.PARTICLE;
import static nephele.mutants.Mutant.Area.SKY;
import static nephele.mutants.Mutants.ENGINE;

import java.util.List;

/** Faults in clouds, the light of the sky, exposure, lightning and particles. */
final class SkyMutants {
    static final List<Mutant> ALL = List.of(
            new Mutant(
                    CLOUD,
                    "a slab's light from below has the sign of that from above",
                    ENGINE + "cloud/TwoStreamSlab.java",
                    "fromTop = (atTop * deep + through * atBottom) / determinant;",
                    "fromTop = (atTop * deep - through * atBottom) / determinant;",
                    "TwoStreamSlabTest"),
            new Mutant(
                    CLOUD,
                    "a slab's directly transmitted beam is left out",
                    ENGINE + "cloud/TwoStreamSlab.java",
                    "return Math.max(0, sum(depth)) + beam(depth);",
                    "return Math.max(0, sum(depth));",
                    "TwoStreamSlabTest"),
            new Mutant(
                    CLOUD,
                    "the mean of an exponential has a wrong third term of its series",
                    ENGINE + "cloud/TwoStreamSlab.java",
                    "x / 3 * (1 - x / 4)",
                    "x / 4 * (1 - x / 4)",
                    "ExponentialMeanTest"),
            new Mutant(
                    CLOUD,
                    "a picture's densities are not interpolated along z",
                    ENGINE + "cloud/field/PlanMap.java",
                    "* (w - floorW);",
                    "* 0;",
                    "PlanMapTest"),
            new Mutant(
                    CLOUD,
                    "the greatest density of a block leaves out its last row",
                    ENGINE + "cloud/field/PlanMap.java",
                    "return greatestOfBlocks(firstI, firstK, lastI, lastK);",
                    "return greatestOfBlocks(firstI, firstK, lastI, firstK);",
                    "PlanMapTest"),
            new Mutant(
                    CLOUD,
                    "a layer of clouds drifts up with the wind",
                    ENGINE + "cloud/field/CloudFields.java",
                    "drift = new Vec3(drifted.x(), 0, drifted.z());",
                    "drift = drifted;",
                    "CloudMotionTest"),
            new Mutant(
                    CLOUD,
                    "a planet's shell is met from its inner ball only",
                    ENGINE + "cloud/field/ShellField.java",
                    "Math.min(outer.toMetres(), inner.fromMetres())",
                    "outer.toMetres()",
                    "ShellFieldTest"),
            new Mutant(
                    CLOUD,
                    "the altitude over a curved planet falls with the distance",
                    ENGINE + "cloud/field/ShellField.java",
                    "y + across / (distance + up)",
                    "y - across / (distance + up)",
                    "ShellFieldTest"),
            new Mutant(
                    CLOUD,
                    "filled puffs keep only half of their count",
                    ENGINE + "cloud/field/PuffFilling.java",
                    "Math.round(fill.count() * after / all)",
                    "Math.round(fill.count() * after / all / 2)",
                    "PuffFillingTest"),
            new Mutant(
                    CLOUD,
                    "the span of a stack ignores the sides of its box along z",
                    ENGINE + "cloud/cells/StackSpan.java",
                    ".between(ray.originZ(), ray.directionZ(), box.minZ(), box.maxZ());",
                    ".between(ray.originX(), ray.directionX(), box.minX(), box.maxX());",
                    "StackSpanTest"),
            new Mutant(
                    CLOUD,
                    "a beam that is scattered forwards loses all that is scattered",
                    ENGINE + "cloud/light/BeamLight.java",
                    "1 - optics.albedo() * fraction",
                    "1",
                    "BeamLightTest"),
            new Mutant(
                    CLOUD,
                    "clouds that fade in begin at once",
                    ENGINE + "level/appearance/WeatherCourse.java",
                    "double risen = s * s * (3 - 2 * s);",
                    "double risen = 1;",
                    "WeatherCourseTest"),
            new Mutant(
                    CLOUD,
                    "a technique that has not enough precision is chosen if it is cheap",
                    ENGINE + "choice/TechniqueChoice.java",
                    "errorPixels <= by.maxErrorPixels() && errorPercent <= by.maxErrorPercent()",
                    "errorPixels <= by.maxErrorPixels()",
                    "TechniqueChoiceTest"),
            new Mutant(
                    CLOUD,
                    "a moving cloud is baked into a skybox",
                    ENGINE + "choice/TechniqueChoice.java",
                    " && !isPastBaking;",
                    ";",
                    "TechniqueChoiceTest"),
            new Mutant(
                    CLOUD,
                    "drawn octaves of noise are not cut off below the threshold",
                    ENGINE + "cloud/octave/OctaveSheet.java",
                    "return Math.max(0, sum) / greatest;",
                    "return sum / greatest;",
                    "OctaveSheetTest"),
            new Mutant(
                    SKY,
                    "the moon is brightest when it is new",
                    ENGINE + "level/appearance/Moonlight.java",
                    "Math.min(1, -cosine)",
                    "Math.min(1, cosine)",
                    "MoonlightTest"),
            new Mutant(
                    SKY,
                    "moonlight stays by day",
                    ENGINE + "level/appearance/Moonlight.java",
                    "return 1 - t * t * (3 - 2 * t);",
                    "return 1;",
                    "MoonlightTest"),
            new Mutant(
                    SKY,
                    "a bright picture gets more exposure",
                    ENGINE + "level/appearance/AutoExposure.java",
                    "Math.log(DISPLAYED_PER_KEY * key(log2)) / LOG_2 - log2;",
                    "Math.log(DISPLAYED_PER_KEY * key(log2)) / LOG_2 + log2;",
                    "AutoExposureTest"),
            new Mutant(
                    SKY,
                    "exposure adapts to the dark as fast as to the light",
                    ENGINE + "level/appearance/AutoExposure.java",
                    "target > stops ? BRIGHTENING_PER_SECOND : DARKENING_PER_SECOND",
                    "DARKENING_PER_SECOND",
                    "AutoExposureTest"),
            new Mutant(
                    SKY,
                    "the darkest half of a picture counts for its exposure",
                    ENGINE + "level/appearance/LuminanceHistogram.java",
                    "LOW_SHARE = 0.5;",
                    "LOW_SHARE = 0;",
                    "LuminanceHistogramTest"),
            new Mutant(
                    SKY,
                    "every strike of lightning has the first one's strokes",
                    ENGINE + "lightning/LevelLightning.java",
                    "if (isVisible && now != strike) {",
                    "if (isVisible && strike == NO_STRIKE) {",
                    "LevelLightningTest"),
            new Mutant(
                    SKY,
                    "strikes of lightning come at equal times",
                    ENGINE + "lightning/LevelLightning.java",
                    "late * (intervalSeconds",
                    "0 * late * (intervalSeconds",
                    "LevelLightningTest"),
            new Mutant(
                    PARTICLE,
                    "particles are drawn front to back",
                    ENGINE + "particle/BackToFront.java",
                    "keys[count] = ~(Float",
                    "keys[count] = (Float",
                    "BackToFrontTest"),
            new Mutant(
                    PARTICLE,
                    "the radix sort forgets the high digits",
                    ENGINE + "particle/BackToFront.java",
                    "order[high[keys[entry] >>> DIGIT_BITS & DIGITS - 1]++] = items[entry];",
                    "order[i] = items[entry];",
                    "BackToFrontTest"),
            new Mutant(
                    PARTICLE,
                    "a polynomial sine folds only one of its sides",
                    ENGINE + "particle/Waves.java",
                    "x < -0.25 ? -0.5 - x : x",
                    "x",
                    "WavesTest"),
            new Mutant(
                    SKY,
                    "half of the sun on the horizon sends all of its light",
                    ENGINE + "atmosphere/SunOverLimb.java",
                    "double fraction = 0.5 + (d * half + angle) / Math.PI;",
                    "double fraction = 1;",
                    "SunOverLimbTest"));

    private SkyMutants() {}
}
