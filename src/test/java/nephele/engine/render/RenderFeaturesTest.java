package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.TestLevel;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.host.draw.QualityChoice;
import org.junit.jupiter.api.Test;

/** The plan contains only what the scene requires, with a reason for each pass. */
class RenderFeaturesTest {
    @Test
    void theEmptyLevelRequiresNothing() {
        FramePlan plan =
                FramePlan.of(FrameRequest.of(PlacedLevel.of(new TestLevel().level(), NoFiles.AT_ALL), Output.DIRECT));
        assertEquals(List.of(), plan.required());
        assertEquals(RenderFeatures.ALL.size(), plan.explain().size());
        assertTrue(plan.explain().stream().allMatch(line -> line.endsWith(": not required")));
    }

    @Test
    void aConstantSkyRequiresNothing() {
        Level level = new TestLevel().sky(new Sky.Constant(new Vec3(1, 0, 0))).level();
        assertEquals(
                List.of(),
                FramePlan.of(FrameRequest.of(PlacedLevel.of(level, NoFiles.AT_ALL), Output.DIRECT))
                        .required());
    }

    @Test
    void takingTheCauseAwayTakesThePassAway() {
        Level without = new TestLevel().level();
        causes().forEach((feature, level) -> {
            assertTrue(required(level).contains(feature), feature);
            assertFalse(required(without).contains(feature), feature);
        });
    }

    private static Map<String, Level> causes() {
        Map<String, Level> causes = new LinkedHashMap<>();
        causes.put(
                "solid", new TestLevel().box(null, Vec3.ZERO, TestLevel.grey(1)).level());
        causes.put(
                "sky.gradient",
                new TestLevel().sky(skies().get(Sky.Gradient.class)).level());
        causes.put(
                "sky.skybox", new TestLevel().sky(skies().get(Sky.Skybox.class)).level());
        causes.put("dynamic", new TestLevel().cube(null, Vec3.ZERO, 1).level());
        causes.put(
                "shadow.dynamic",
                new TestLevel()
                        .castingSun(new Vec3(0, 1, 0), 1)
                        .cube(null, Vec3.ZERO, 1)
                        .level());
        Billboards bush = Billboards.at("b", "b.png", Billboards.Facing.CYLINDRICAL, 1, 1, List.of(Vec3.ZERO));
        causes.put("impostor", new TestLevel().impostor("box_1_1.3d", null).level());
        causes.put("billboard", new TestLevel().billboards(bush).level());
        causes.put(
                "billboard.blended",
                new TestLevel().billboards(bush.asBlended()).level());
        return causes;
    }

    /** The clear colour draws the constant sky; exactly one feature draws each other kind. */
    @Test
    void everyKindOfSkyIsClaimedExactlyOnce() {
        Set<Class<?>> permitted =
                Arrays.stream(Sky.class.getPermittedSubclasses()).collect(Collectors.toSet());
        assertEquals(permitted, skies().keySet());
        skies().forEach((kind, sky) -> {
            List<String> lines = FramePlan.of(FrameRequest.of(
                            PlacedLevel.of(new TestLevel().sky(sky).level(), NoFiles.AT_ALL), Output.DIRECT))
                    .explain()
                    .stream()
                    .filter(line -> line.contains(": required by environment.sky: "))
                    .toList();
            assertEquals(kind == Sky.Constant.class ? 0 : 1, lines.size(), kind + " " + lines);
        });
    }

    private static Map<Class<?>, Sky> skies() {
        return Map.of(
                Sky.Constant.class, new Sky.Constant(Vec3.ZERO),
                Sky.Gradient.class, new Sky.Gradient(Vec3.ZERO, Vec3.ZERO, Vec3.ZERO),
                Sky.Skybox.class, new Sky.Skybox(SkyboxLayout.CROSS, List.of("cross.png")),
                Sky.Atmosphere.class, Sky.Atmosphere.CLEAR);
    }

    private static Set<String> required(Level level) {
        return FramePlan.of(FrameRequest.of(PlacedLevel.of(level, NoFiles.AT_ALL), Output.DIRECT)).steps().stream()
                .filter(step -> !step.required().isEmpty())
                .map(step -> step.feature().name())
                .collect(Collectors.toSet());
    }

    /** The pass for held bodies is required by a player in a level with bodies. */
    @Test
    void whatIsHeldIsDrawnOnlyForWhoeverPlaysWithBodies() {
        Level bodies = new TestLevel().cube(null, Vec3.ZERO, 1).level();
        assertTrue(isHeldDrawn(bodies, CharacterPresence.POSSIBLE));
        assertFalse(isHeldDrawn(bodies, CharacterPresence.NEVER));
        assertFalse(isHeldDrawn(new TestLevel().level(), CharacterPresence.POSSIBLE));
    }

    private static boolean isHeldDrawn(Level level, CharacterPresence character) {
        return FramePlan.of(FrameRequest.of(
                        level, StaticShapes.of(level, NoFiles.AT_ALL), null, Output.DIRECT, Quality.HIGH, character))
                .explain()
                .contains("dynamic.held: required by player: a body that is held");
    }

    @Test
    void outputHdrRequiresTheToneMapAndDirectDoesNot() {
        Level level = new TestLevel().level();
        assertTrue(FramePlan.of(FrameRequest.of(PlacedLevel.of(level, NoFiles.AT_ALL), Output.HDR))
                .explain()
                .contains("tonemap: required by output: hdr was asked for"));
        assertTrue(FramePlan.of(FrameRequest.of(PlacedLevel.of(level, NoFiles.AT_ALL), Output.DIRECT))
                .explain()
                .contains("tonemap: not required"));
    }

    @Test
    void featureNamesAreUnique() {
        assertEquals(
                RenderFeatures.ALL.size(),
                RenderFeatures.ALL.stream().map(f -> f.name()).distinct().count());
    }

    /** Exposure auto requires linear light and the metering of it; stops written as a number require neither. */
    @Test
    void exposureIsMeteredOnlyWhereTheLevelSaysSo() {
        Level auto = new TestLevel().autoExposure().level();
        assertEquals(Output.HDR, QualityChoice.defaultOutput(auto));
        List<String> lines = FramePlan.of(FrameRequest.of(PlacedLevel.of(auto, NoFiles.AT_ALL), Output.HDR))
                .explain();
        assertTrue(lines.contains("exposure: required by environment.exposureStops: auto, metered from the picture"));
        assertTrue(lines.contains("tonemap: required by environment.exposureStops: auto meters linear light"));
        Level fixed = new TestLevel().toneMapping(ToneCurve.CLIP, 3).level();
        assertEquals(Output.DIRECT, QualityChoice.defaultOutput(fixed));
        assertTrue(FramePlan.of(FrameRequest.of(PlacedLevel.of(fixed, NoFiles.AT_ALL), Output.HDR))
                .explain()
                .contains("exposure: not required"));
    }
}
