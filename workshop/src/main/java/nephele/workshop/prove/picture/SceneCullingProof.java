package nephele.workshop.prove.picture;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.scenes.fixed.FixedSceneDrawing;
import nephele.scenes.fixed.FixedSceneDrawing.Source;
import nephele.scenes.fixed.FixedSceneDrawing.Sources;
import nephele.scenes.fixed.SceneAppearance;
import nephele.scenes.fixed.SceneAppearance.Culling;
import nephele.scenes.fixed.SceneFolder;
import nephele.scenes.fixed.Shading;
import nephele.scenes.xml.Dialect;
import nephele.scenes.xml.XmlGroup;
import nephele.scenes.xml.XmlGroup.Step;
import nephele.scenes.xml.XmlLight;
import nephele.scenes.xml.XmlModel;
import nephele.scenes.xml.XmlModel.Colours;
import nephele.scenes.xml.XmlScene;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Matrix4d;

/** Compares XML scenes drawn with culling and without, pixel by pixel. */
public final class SceneCullingProof implements Proof {
    private static final int SIZE = 96;
    private static final int VIEWS = 4;
    private static final int MODELS = 25;

    private static final List<String> FILES = List.of(
            "box_2_2.3d",
            "sphere_1_12_8.3d",
            "cone_1_3_9_4.3d",
            "plane_2_3.3d",
            "cylinder_0.5_2_9.3d",
            "torus_1_0.3_12_8.3d",
            "bezier_3.3d");
    private static final Vec3 GREY = new Vec3(0.2, 0.2, 0.2);

    @Override
    public Claim claim() {
        return new Claim(
                "scene-culling",
                "In XML scenes of models that are moved, turned, scaled by axes, mirrored, nested and carried about, a"
                    + " picture with culling is, pixel for pixel, the one without; each scene has 25 such models, seen"
                    + " four times.",
                "scenes",
                400,
                100);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, SIZE, SIZE)) {
            return ProofResult.ofUnits(from, count, progress, unit -> compared(unit, gl, picture));
        }
    }

    private static ProofResult compared(long unit, GlContext gl, RenderTarget picture) {
        List<String> failures = new ArrayList<>();
        long drawnPixels = 0;
        long wrongPixels = 0;
        long triangles = 0;
        long submitted = 0;
        var random = new SplittableRandom(unit);
        XmlScene scene = scene(random);
        var files = new SceneFolder("scene " + unit, new ResourceAssets(LevelAssets.JAR_LEVELS), complaint -> {
            throw new IllegalStateException(complaint);
        });
        var sources = new Sources(new Source(scene, files), null, null);
        try (var drawing = FixedSceneDrawing.load(gl, sources)) {
            for (int number = 0; number < VIEWS; number++) {
                // A wireframe shows models that faces would hide.
                var look = SceneAppearance.USUAL.with(number % 2 == 0 ? Shading.WIREFRAME : Shading.FLAT);
                View view = view(random);
                double seconds = 100 * random.nextDouble();
                ByteBuffer all = pixels(drawing, view, seconds, look.with(Culling.OFF), picture);
                triangles += takeTriangles(gl);
                ByteBuffer culled = pixels(drawing, view, seconds, look, picture);
                submitted += takeTriangles(gl);
                int wrong = 0;
                for (int at = 0; at < all.capacity(); at += 4) {
                    drawnPixels += (all.get(at) | all.get(at + 1) | all.get(at + 2)) != 0 ? 1 : 0;
                    wrong += all.getInt(at) != culled.getInt(at) ? 1 : 0;
                }
                wrongPixels += wrong;
                if (wrong > 0) {
                    failures.add("scene " + unit + " from " + view + ": " + wrong + " pixels differ");
                }
                gl.requireNoError("culling");
            }
        }
        return ProofResult.of(
                1,
                failures,
                Figure.sum("models", MODELS, ""),
                Figure.sum("pixels that show something", drawnPixels, ""),
                Figure.sum("pixels that differ", wrongPixels, ""),
                Figure.sum("triangles", triangles, ""),
                Figure.sum("triangles culled", triangles - submitted, ""));
    }

    private static ByteBuffer pixels(
            FixedSceneDrawing drawing, View view, double seconds, SceneAppearance look, RenderTarget picture) {
        drawing.draw(view, seconds, new Matrix4d(), look, picture);
        return picture.readBytes();
    }

    private static long takeTriangles(GlContext gl) {
        long triangles = gl.state().triangles();
        gl.state().resetCounts();
        return triangles;
    }

    /**
     * Returns a scene of models in groups up to four deep, moved, rotated, scaled along the axes, mirrored and animated,
     * around a random view.
     */
    private static XmlScene scene(SplittableRandom random) {
        List<XmlGroup> groups = new ArrayList<>();
        for (int i = 0; i < MODELS; i++) {
            groups.add(group(random, random.nextInt(4)));
        }
        var root = new XmlGroup(1, List.of(), List.of(), List.of(), groups);
        var eye = new XmlScene.Eye(Vec3.ZERO, new Vec3(0, 0, 1), new Vec3(0, 1, 0), 60, 1, 1000);
        List<XmlLight> lights = List.of(new XmlLight.Directional(new Vec3(1, 2, 3)));
        return new XmlScene(Dialect.WORLD, new XmlScene.Window(64, 64), eye, lights, root, List.of());
    }

    private static XmlGroup group(SplittableRandom random, int groupsBelow) {
        if (groupsBelow > 0) {
            return new XmlGroup(1, steps(random), List.of(), List.of(), List.of(group(random, groupsBelow - 1)));
        }
        var colours = new Colours(point(random, 1), GREY, Vec3.ZERO, Vec3.ZERO, 0);
        var model = new XmlModel(1, FILES.get(random.nextInt(FILES.size())), null, colours);
        return new XmlGroup(1, steps(random), List.of(), List.of(model), List.of());
    }

    private static List<Step> steps(SplittableRandom random) {
        List<Step> steps = new ArrayList<>();
        int count = 1 + random.nextInt(3);
        for (int i = 0; i < count; i++) {
            steps.add(step(random));
        }
        return steps;
    }

    private static Step step(SplittableRandom random) {
        return switch (random.nextInt(7)) {
            case 0, 1, 2 -> new Step.Translate(point(random, 8));
            case 3 -> new Step.Rotate(point(random, 1), 720 * random.nextDouble() - 360);
            case 4 -> new Step.Spin(point(random, 1), 1 + 9 * random.nextDouble());
            case 5 -> new Step.Scale(new Vec3(factor(random), factor(random), factor(random)));
            default ->
                new Step.Follow(
                        1 + 9 * random.nextDouble(),
                        List.of(point(random, 6), point(random, 6), point(random, 6), point(random, 6)),
                        random.nextBoolean());
        };
    }

    /** Returns a scale, negative in half of the cases and sometimes nearly zero. */
    private static double factor(SplittableRandom random) {
        double size = random.nextInt(12) == 0 ? 0.01 : 0.2 + 2 * random.nextDouble();
        return random.nextBoolean() ? size : -size;
    }

    private static View view(SplittableRandom random) {
        var projection = new Projection(
                Math.toRadians(20 + 80 * random.nextDouble()),
                1,
                0.05 + random.nextDouble(),
                3 + 30 * random.nextDouble());
        return View.lookAt(point(random, 6), point(random, 6), point(random, 1), projection);
    }

    private static Vec3 point(SplittableRandom random, double reach) {
        return new Vec3(coordinate(random, reach), coordinate(random, reach), coordinate(random, reach));
    }

    private static double coordinate(SplittableRandom random, double reach) {
        return reach * (2 * random.nextDouble() - 1);
    }
}
