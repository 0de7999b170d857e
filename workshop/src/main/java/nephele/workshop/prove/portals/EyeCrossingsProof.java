package nephele.workshop.prove.portals;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.asset.LevelAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.Portals;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/** Moves eyes through a portal in steps of 0.1 mm and looks for a frame that shows a wall that must not be visible. */
public final class EyeCrossingsProof implements Proof {
    @Override
    public Claim claim() {
        return new Claim(
                "eye-crossings",
                "No frame of an eye that passes through a portal in steps of 0.1 mm shows the wall of the"
                        + " portal or an empty pixel.",
                "crossings",
                10_000,
                1_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        long frames = 0;
        long bad = 0;
        long crossed = 0;
        for (PortalTechnique technique : PortalTechnique.values()) {
            try (Crossings crossings = new Crossings(technique)) {
                for (long i = technique.ordinal(); i < count; i += PortalTechnique.values().length) {
                    crossings.cross(from + i);
                    progress.unitsDone((i + technique.ordinal() * count) / 2);
                }
                frames += crossings.frames;
                bad += crossings.badFrames;
                crossed += crossings.crossed;
            }
        }
        return new ProofResult(
                count,
                bad + (count - crossed),
                List.of(
                        Figure.sum("frames", frames, ""),
                        Figure.sum("frames that show a wall or nothing", bad, ""),
                        Figure.sum("eyes that came through", crossed, "")),
                List.of());
    }

    /**
     * Moves eyes through a portal in steps of 0.1 mm, looking in the direction of motion. The walls with the portals are
     * red and the closed room is under a blue sky: either colour in the picture is a hole.
     */
    private static final class Crossings implements AutoCloseable {
        private static final int WIDTH = 32;
        private static final int HEIGHT = 18;
        private static final double STEP_METRES = 1e-4;
        private static final int STEPS_EACH_SIDE = 3;
        private static final Vec3 RED = new Vec3(1, 0, 0);
        private static final Vec3 UP = new Vec3(0, 1, 0);

        private final GlContext gl = GlContext.offscreen();
        private final RenderTarget picture = RenderTarget.picture(gl, "crossings", PixelFormat.RGBA8, WIDTH, HEIGHT);
        private final Level level = level();
        private final Portals portals = Portals.of(level);
        private final PathTrace trace = new PathTrace(portals, Obstacles.NONE);
        private final Renderer renderer;
        private long frames;
        /** The number of frames in which a wall with a portal or the sky was visible. */
        private long badFrames;

        /** The number of eyes that ended behind the portal. */
        private long crossed;

        Crossings(PortalTechnique technique) {
            Quality quality = Quality.HIGH.with("portalTechnique", technique).with("viewBudget", 6);
            renderer = LevelRenderer.load(
                    gl,
                    level,
                    LevelAssets.inJar("/levels/none.json"),
                    RenderSettings.of(Output.PLAIN, quality).with(Decoration.OFF));
        }

        /** Returns a room of 8 m with one portal in its north wall and one, rotated by a quarter turn, in its east wall. */
        private static Level level() {
            Environment environment = new Environment(
                    null,
                    new Sky.Constant(new Vec3(0, 0, 1)),
                    new Vec3(1, 1, 1),
                    Exposure.NEUTRAL,
                    ToneCurve.CLIP,
                    null,
                    List.of());
            return Level.of("crossings", "", environment, List.of())
                    .with(
                            List.of(material("red", RED), material("grey", new Vec3(0.5, 0.5, 0.5))),
                            List.of(
                                    box("north", "red", new Vec3(0, 0, -5), new Vec3(12, 12, 2)),
                                    box("east", "red", new Vec3(5, 0, 0), new Vec3(2, 12, 8)),
                                    box("south", "grey", new Vec3(0, 0, 5), new Vec3(12, 12, 2)),
                                    box("west", "grey", new Vec3(-5, 0, 0), new Vec3(2, 12, 8)),
                                    box("floor", "grey", new Vec3(0, -5, 0), new Vec3(8, 2, 8)),
                                    box("ceiling", "grey", new Vec3(0, 5, 0), new Vec3(8, 2, 8))))
                    .withPortals(List.of(
                            new PortalSpec(
                                    "n",
                                    "e",
                                    new Vec3(0.3, 0.1, -4),
                                    new Vec3(0, 0, 1),
                                    UP,
                                    3,
                                    3,
                                    PortalShape.RECTANGLE),
                            new PortalSpec(
                                    "e",
                                    "n",
                                    new Vec3(4, -0.2, 0.7),
                                    new Vec3(-1, 0, 0),
                                    new Vec3(0, 0, 1),
                                    3,
                                    3,
                                    PortalShape.RECTANGLE)));
        }

        private static Material material(String id, Vec3 colour) {
            return new Material(id, colour, null, null, null, null, Vec3.ZERO, 1);
        }

        private static Solid box(String id, String material, Vec3 centre, Vec3 size) {
            return new Solid.Box(id, material, false, null, centre, size, Map.of());
        }

        /**
         * Moves one eye through the portal: three frames before the plane and three behind it, at a random phase of the
         * step.
         */
        void cross(long seed) {
            SplittableRandom random = new SplittableRandom(seed);
            double phase = random.nextDouble();
            Vec3 forward = direction(random);
            double perStep = STEP_METRES / -forward.z();
            Vector3d start =
                    new Vector3d(0.3 + 1.6 * random.nextDouble() - 0.8, 0.1 + 1.6 * random.nextDouble() - 0.8, -4);
            start.fma(-perStep * (STEPS_EACH_SIDE - 1 + phase), forward.toVector());
            Vector3d moved = new Vector3d();
            for (int step = 0; step < 2 * STEPS_EACH_SIDE; step++) {
                trace.trace(
                        start, moved.set(forward.x(), forward.y(), forward.z()).mul(perStep * step));
                crossed += trace.crossings() > 0 && step == 2 * STEPS_EACH_SIDE - 1 ? 1 : 0;
                look(start, moved, forward);
            }
        }

        /** Returns a direction close to the portal's axis, so that the walls with the portals are outside the picture. */
        private static Vec3 direction(SplittableRandom random) {
            double x = 0.2 * random.nextDouble() - 0.1;
            double y = 0.2 * random.nextDouble() - 0.1;
            double length = Math.sqrt(x * x + y * y + 1);
            return new Vec3(x / length, y / length, -1 / length);
        }

        private void look(Vector3d start, Vector3d moved, Vec3 forward) {
            Vec3 eye = new Vec3(start.x + moved.x, start.y + moved.y, start.z + moved.z);
            Vec3 ahead = forward;
            if (trace.crossings() > 0) {
                eye = portals.transform(0).point(eye);
                ahead = portals.transform(0).direction(forward);
            }
            Vec3 target = eye.addScaled(1, ahead);
            Projection projection =
                    new Projection(Math.toRadians(20), WIDTH / (double) HEIGHT, 0.05, Double.POSITIVE_INFINITY);
            renderer.draw(View.lookAt(eye, target, UP, projection), picture);
            frames++;
            badFrames += isWhole(picture.readBytes()) ? 0 : 1;
        }

        private static boolean isWhole(ByteBuffer rgba) {
            for (int i = 0; i < rgba.capacity(); i += 4) {
                boolean red = (rgba.get(i) & 0xff) > 200;
                boolean blue = (rgba.get(i + 2) & 0xff) > 200;
                if (red || blue) {
                    return false;
                }
            }
            return true;
        }

        @Override
        public void close() {
            renderer.close();
            picture.close();
            gl.close();
        }
    }
}
