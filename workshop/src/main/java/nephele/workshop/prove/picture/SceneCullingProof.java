package nephele.workshop.prove.picture;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import nephele.scenes.fixed.FixedSceneDrawing;
import nephele.scenes.fixed.FixedSceneDrawing.Source;
import nephele.scenes.fixed.FixedSceneDrawing.Sources;
import nephele.scenes.fixed.SceneAppearance;
import nephele.scenes.fixed.SceneAppearance.Culling;
import nephele.scenes.fixed.SceneFolder;
import nephele.scenes.fixed.Shading;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Matrix4d;

/** Compares XML scenes drawn with culling and without, pixel by pixel. */
public final class SceneCullingProof implements Proof {
    private static final int SIZE = 96;
    private static final int VIEWS = 4;

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
        var tally = new Tally();
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, SIZE, SIZE)) {
            for (long unit = from; unit < from + count; unit++) {
                compare(unit, gl, picture, tally);
                progress.unitsDone(unit + 1 - from);
            }
        }
        return tally.result(count);
    }

    private static void compare(long unit, GlContext gl, RenderTarget picture, Tally tally) {
        var models = new TransformedModels(unit);
        var scene = models.scene();
        var files = new SceneFolder("scene " + unit, new ResourceAssets(LevelAssets.JAR_LEVELS), complaint -> {
            throw new IllegalStateException(complaint);
        });
        var sources = new Sources(new Source(scene, files), null, null);
        try (var drawing = FixedSceneDrawing.load(gl, sources)) {
            for (int number = 0; number < VIEWS; number++) {
                // A wireframe shows models that faces would hide.
                var look = SceneAppearance.USUAL.with(number % 2 == 0 ? Shading.WIREFRAME : Shading.FLAT);
                View view = models.view();
                double seconds = models.seconds();
                ByteBuffer all = pixels(drawing, view, seconds, look.with(Culling.OFF), picture);
                long trianglesOfAll = takeTriangles(gl);
                ByteBuffer culled = pixels(drawing, view, seconds, look, picture);
                tally.take(all, culled, "scene " + unit + " from " + view);
                tally.takeTriangles(trianglesOfAll, takeTriangles(gl));
                gl.requireNoError("culling");
            }
        }
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

    /** The results of pictures. */
    private static final class Tally {
        private final List<String> failures = new ArrayList<>();
        private long drawnPixels;
        private long wrongPixels;
        private long triangles;
        private long culledTriangles;

        void take(ByteBuffer all, ByteBuffer culled, String where) {
            int wrong = 0;
            for (int at = 0; at < all.capacity(); at += 4) {
                drawnPixels += (all.get(at) | all.get(at + 1) | all.get(at + 2)) != 0 ? 1 : 0;
                wrong += all.getInt(at) != culled.getInt(at) ? 1 : 0;
            }
            wrongPixels += wrong;
            if (wrong > 0) {
                failures.add(where + ": " + wrong + " pixels differ");
            }
        }

        void takeTriangles(long all, long submitted) {
            triangles += all;
            culledTriangles += all - submitted;
        }

        ProofResult result(long units) {
            return ProofResult.of(
                    units,
                    failures,
                    Figure.sum("models", units * TransformedModels.MODELS, ""),
                    Figure.sum("pixels that show something", drawnPixels, ""),
                    Figure.sum("pixels that differ", wrongPixels, ""),
                    Figure.sum("triangles", triangles, ""),
                    Figure.sum("triangles culled", culledTriangles, ""));
        }
    }
}
