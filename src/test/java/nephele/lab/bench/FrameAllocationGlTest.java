package nephele.lab.bench;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.math.Vec3;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/**
 * The render path allocates at most 2 KiB a frame, with portals, with moving bodies and a moving character, and without
 * them.
 */
class FrameAllocationGlTest {
    private static final int MOST_BYTES_A_FRAME = 2048;
    private static final int WARM_FRAMES = 40;
    private static final int FRAMES = 40;

    /**
     * Returns the bytes allocated by a frame of {@code level} while the eye, every body and the character move, which
     * holds a body.
     */
    private static long bytesPerFrame(String level, Output output, Quality quality) {
        OpenedLevel opened = new LevelName("levels/" + level).open();
        RenderSettings settings = RenderSettings.of(output, quality).with(CharacterPresence.POSSIBLE);
        try (GlContext gl = GlContext.offscreen();
                RenderTarget picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, 64, 36);
                Renderer renderer = LevelRenderer.load(gl, Scene.of(opened.level(), opened.assets()), settings)) {
            List<View> views = views(opened);
            List<FrameState.Posture> postures = postures(opened, views);
            FrameState frameState = FrameState.atStart(opened.level());
            List<Vec3> held = fromEyes(frameState, views);
            Stopwatch stopwatch = new Stopwatch();
            long before = 0;
            for (int frame = 0; frame < WARM_FRAMES + FRAMES; frame++) {
                if (frame == WARM_FRAMES) {
                    before = stopwatch.allocatedBytes();
                }
                move(frameState, frame);
                if (frameState.bodies() > 0) {
                    frameState.held(0, held.get(frame), 1);
                }
                frameState.character(postures.get(frame));
                renderer.draw(views.get(frame), frameState, picture);
            }
            long bytes = (stopwatch.allocatedBytes() - before) / FRAMES;
            gl.requireNoError("frames");
            return bytes;
        }
    }

    /** Returns views that move 0.25 m forward and back from the start. */
    private static List<View> views(OpenedLevel opened) {
        View start =
                Viewpoints.standard(opened.level(), opened.file(), 16.0 / 9).apply(0);
        List<View> views = new ArrayList<>();
        for (int frame = 0; frame < WARM_FRAMES + FRAMES; frame++) {
            Vector3d eye = start.eye()
                    .toVector()
                    .fma(0.25 * Math.sin(0.3 * frame), start.back().toVector());
            views.add(new View(Vec3.of(eye), start.right(), start.up(), start.back(), start.projection()));
        }
        return views;
    }

    /** Returns the first body's place relative to each eye; its small motion is neglected. */
    private static List<Vec3> fromEyes(FrameState frameState, List<View> views) {
        List<Vec3> places = new ArrayList<>();
        for (View view : frameState.bodies() == 0 ? List.<View>of() : views) {
            Vector3d way = frameState.centre(0, new Vector3d()).sub(view.eye().toVector());
            places.add(new Vec3(
                    view.alongRight(way.x, way.y, way.z),
                    view.alongUp(way.x, way.y, way.z),
                    view.alongBack(way.x, way.y, way.z)));
        }
        return places;
    }

    private static List<FrameState.Posture> postures(OpenedLevel opened, List<View> views) {
        List<FrameState.Posture> postures = new ArrayList<>();
        for (int frame = 0; frame < views.size(); frame++) {
            Vector3d feet = views.get(frame)
                    .eye()
                    .toVector()
                    .fma(-3, views.get(0).back().toVector());
            postures.add(new FrameState.Posture(
                    Vec3.of(feet), new Vec3(0, 1, 0), 0.01 * frame, 0, 1.8, 0.02 * frame % 1, 0.7, 0, 0, 0));
        }
        return postures;
    }

    private static void move(FrameState frameState, int frame) {
        frameState.seconds(frame / 60.0);
        Vector3d centre = new Vector3d();
        Quaterniond turn = new Quaterniond();
        for (int body = 0; body < frameState.bodies(); body++) {
            frameState.centre(body, centre);
            frameState.body(body, centre.add(0.004 * Math.sin(0.2 * frame), 0, 0), turn.rotationY(0.05 * frame));
        }
    }

    private static void assertLittle(String level, Output output, Quality quality) {
        long bytes = bytesPerFrame(level, output, quality);
        assertTrue(bytes <= MOST_BYTES_A_FRAME, level + ": " + bytes + " bytes a frame");
    }

    @Test
    void withoutPortals() {
        assertLittle("bench/boxes-1000.json", Output.PLAIN, Quality.HIGH);
    }

    @Test
    void throughFewPortals() {
        assertLittle("bench/boxes-1000-portals.json", Output.PLAIN, Quality.HIGH.with("viewBudget", 12));
    }

    @Test
    void throughManyPortals() {
        assertLittle("bench/portals-64.json", Output.DIRECT, Quality.HIGH.with("viewBudget", 24));
    }

    @Test
    void withPicturesOfTheirOwn() {
        Quality quality =
                Quality.HIGH.with("portalTechnique", PortalTechnique.TEXTURE).with("viewBudget", 8);
        assertLittle("bench/boxes-1000-portals.json", Output.HDR, quality);
    }

    @Test
    void whileManyDynamicObjectsMove() {
        assertLittle("bench/bodies-200.json", Output.DIRECT, Quality.HIGH);
    }

    @Test
    void withThousandsOfBillboards() {
        assertLittle("bench/billboards-10000.json", Output.DIRECT, Quality.HIGH);
    }

    @Test
    void whileDynamicObjectsMoveThroughPortals() {
        assertLittle("samples/straddling-cube.json", Output.DIRECT, Quality.HIGH);
    }
}
