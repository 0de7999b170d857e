package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.RenderResources;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.OwnedObjects;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Passes declare the textures that they bind, and read only targets that were written before. */
class TargetReadsGlTest {
    /** Returns a room with every texture that light needs, for any content. */
    private static TestLevel room() {
        return new TestLevel()
                .castingSun(new Vec3(0.2, 1, 0.1), 2)
                .skyLight()
                .sky(new Sky.Gradient(TestLevel.grey(0.1), TestLevel.grey(0.5), TestLevel.grey(0.2)))
                .material("grey", TestLevel.grey(0.5))
                .light(new Light.Point("lamp", new Vec3(0, 2, 0), TestLevel.grey(4), 10, true))
                .box("grey", new Vec3(0, -1, 0), new Vec3(9, 1, 9))
                .box("grey", new Vec3(0, 0, -2), new Vec3(1, 1, 1));
    }

    private static TestLevel withBodies() {
        return room().cube("grey", new Vec3(-1, 0.5, 0), 0.5).cube("grey", new Vec3(1, 0.5, 0), 0.5);
    }

    private static Map<String, Level> levels() {
        return Map.of(
                "nothing moves",
                room().level(),
                "bodies",
                withBodies().level(),
                "portals",
                withBodies()
                        .portal("a", "b", new Vec3(-0.5, 1, -1.4), new Vec3(0, 0, 1), 1, 1)
                        .portal("b", "a", new Vec3(3, 1, -1.4), new Vec3(0, 0, 1), 1, 1)
                        .level(),
                "exposure auto",
                room().autoExposure().level());
    }

    @ParameterizedTest
    @EnumSource
    void everyTargetReadIsWrittenEarlier(CharacterPresence character) {
        try (Offscreen offscreen = new Offscreen(8, 8)) {
            levels().forEach((name, level) -> {
                Set<Target> written = EnumSet.noneOf(Target.class);
                Scene scene = Scene.of(level, TestAssets.NONE);
                FrameRequest request =
                        FrameRequest.of(level, scene.statics(), null, Output.HDR, Quality.LOW, character);
                try (OwnedObjects owned = new OwnedObjects(offscreen.gl)) {
                    var resources = new RenderResources(owned, LevelRenderer.drawn(owned, scene), request, null);
                    for (FramePlan.Step step : FramePlan.of(request).steps()) {
                        if (step.feature().stage() == Stage.IN_VIEWS_AFTER_OPAQUE) {
                            written.addAll(Set.of(Target.VIEW_DEPTH, Target.VIEW_COLOUR));
                        }
                        for (Required required : step.required()) {
                            Pass pass = required.build().apply(resources.context(step.feature()));
                            assertTrue(written.containsAll(pass.reads()), name + ": " + required.because());
                            written.addAll(pass.writes());
                        }
                    }
                }
                assertTrue(written.contains(Target.PICTURE));
            });
        }
    }

    /**
     * A pass binds exactly what it declares; before it draws, each unit has another texture, so OpenGL's state shows
     * the binding.
     */
    @Test
    void whatAPassBindsItDeclares() {
        Level empty = levels().get("nothing moves");
        Level portals = levels().get("portals");
        try (Offscreen offscreen = new Offscreen(16, 9);
                BoundTargets bound = new BoundTargets(offscreen.gl)) {
            assertBinding(offscreen, bound, empty, CharacterPresence.POSSIBLE, Set.of("solid"));
            assertBinding(offscreen, bound, portals, CharacterPresence.NEVER, Set.of("solid", "dynamic"));
            assertBinding(
                    offscreen, bound, portals, CharacterPresence.POSSIBLE, Set.of("solid", "dynamic", "dynamic.held"));
        }
    }

    /** @param expected names of the passes that bind textures */
    private static void assertBinding(
            Offscreen offscreen, BoundTargets bound, Level level, CharacterPresence character, Set<String> expected) {
        RenderSettings settings = RenderSettings.of(Output.PLAIN, Quality.LOW).with(character);
        Set<String> binding = new HashSet<>();
        for (WatchedPass pass : drawWatched(offscreen, bound, level, settings)) {
            if (!pass.bound().isEmpty()) {
                assertEquals(pass.reads(), pass.bound(), pass.toString());
                binding.add(pass.toString());
            }
        }
        assertEquals(expected, binding);
    }

    /** Returns components to the right, up and back. */
    private static Vec3 fromEye(View view, Vec3 place) {
        double x = place.x() - view.eyeX();
        double y = place.y() - view.eyeY();
        double z = place.z() - view.eyeZ();
        return new Vec3(view.alongRight(x, y, z), view.alongUp(x, y, z), view.alongBack(x, y, z));
    }

    private static List<WatchedPass> drawWatched(
            Offscreen offscreen, BoundTargets bound, Level level, RenderSettings settings) {
        List<WatchedPass> passes = new ArrayList<>();
        List<RenderFeature> features = RenderFeatures.ALL.stream()
                .map(feature -> WatchedPass.watch(feature, bound, passes))
                .toList();
        View view = offscreen.view(new Vec3(0, 1, 3), Vec3.ZERO);
        FrameState frameState = FrameState.atStart(level);
        if (!level.bodies().isEmpty()) {
            frameState.held(0, fromEye(view, new Vec3(-1, 0.5, 0)), 1);
        }
        try (Renderer renderer =
                LevelRenderer.load(offscreen.gl, Scene.of(level, TestAssets.NONE), settings, features)) {
            renderer.draw(view, frameState, offscreen.picture);
        }
        return passes;
    }
}
