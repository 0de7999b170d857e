package nephele.workshop.prove.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.reference.TracedLevel;
import nephele.engine.reference.VisibleSurface;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import nephele.host.named.Viewpoints;
import nephele.lab.bake.TracedPictures;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Compares drawn shadows with rays, pixel by pixel: a pixel that differs from the twin must be within a texel of the
 * edge of the twin's shadow, measured across the light.
 */
public final class ShadowEdgesProof implements Proof {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 180;
    private static final double FOV_DEGREES = 80;

    /** The greatest distance of a wrong pixel that is measured, in texels. */
    private static final double FARTHEST_TEXELS = 4;

    /** The fraction of pixels that may remain dark because their surface falls between texels. */
    private static final double MOST_NARROW = 1e-3;

    private static final double[] RADII = {0.25, 0.5, 0.75, 1, 1.5, 2, 3, FARTHEST_TEXELS};
    private static final int DIRECTIONS = 24;
    private static final String PIXELS = "pixels";
    private static final String NARROW = "pixels that stay dark on narrower parts";

    @Override
    public Claim claim() {
        return new Claim(
                "shadow-edges",
                "Among walls of 10 cm, a pixel away from edges is lit by sun, point lights and spots exactly if a"
                        + " shadow ray says so, except within one texel of a shadow's edge; at most one in a thousand"
                        + " stays dark where the lit part of a face, seen from the light, is narrower than a texel's"
                        + " diagonal; no pixel of a closed room is lit, joints included.",
                "pictures",
                1000,
                100);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult result = ProofResult.NOTHING;
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, WIDTH, HEIGHT)) {
            for (long unit = from; unit < from + count; unit++) {
                result = result.and(compared(unit, gl, picture)).and(dark(unit, litPixels(unit, 0, gl, picture)));
                progress.unitsDone(unit + 1 - from);
            }
        }
        double narrow = result.value(NARROW);
        double pixels = result.value(PIXELS);
        return narrow <= MOST_NARROW * pixels
                ? result
                : result.and(ProofResult.of(
                        0,
                        List.of(String.format(
                                Locale.ROOT, "%.0f of %.0f pixels stay dark on narrow parts", narrow, pixels))));
    }

    private static ProofResult compared(long unit, GlContext gl, RenderTarget picture) {
        List<String> failures = new ArrayList<>();
        long pixels = 0;
        long nearEdge = 0;
        long onNarrowFaces = 0;
        var scene = new ShadowScene(unit / 5).fitted(Quality.HIGH);
        Vec3[] camera = scene.camera((int) (unit % 5));
        View view = Viewpoints.between(camera[0], camera[1], FOV_DEGREES, (double) WIDTH / HEIGHT);
        float[] shaded = radiance(scene.level(), view, gl, picture);
        float[] open = radiance(scene.levelWithoutShadows(), view, gl, picture);
        var assets = new ResourceAssets(LevelAssets.JAR_LEVELS);
        var traced = TracedLevel.of(PlacedLevel.of(scene.level(), assets), ColourDecoding.SRGB);
        var sights = new SightPicture(traced, view, WIDTH, HEIGHT);
        VisibleSurface sight = traced.sight(TracedPictures.pinhole(view));
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            int column = i % WIDTH;
            int row = i / WIDTH;
            if (open[3 * i] > 1e-4 && sights.isPlain(column, row)) {
                sight.at((column + 0.5) / WIDTH, (row + 0.5) / HEIGHT);
                boolean isLit = shaded[3 * i] / open[3 * i] > 0.5;
                double texels = offTexels(scene, sight, isLit);
                pixels++;
                if (texels > 1 && !isLit && scene.isTooNarrow(sight.place())) {
                    onNarrowFaces++;
                } else if (texels > 1) {
                    failures.add(String.format(
                            Locale.ROOT,
                            "picture %d pixel (%d, %d): %.2f texels off",
                            unit,
                            column,
                            HEIGHT - 1 - row,
                            texels));
                } else {
                    nearEdge += texels > 0 ? 1 : 0;
                }
            }
        }
        return ProofResult.of(
                1,
                failures,
                Figure.sum(PIXELS, pixels, ""),
                Figure.sum("pixels that differ within a texel of an edge", nearEdge, ""),
                Figure.sum("pixels that differ farther off", failures.size(), ""),
                Figure.sum(NARROW, onNarrowFaces, ""));
    }

    private static ProofResult dark(long unit, int lit) {
        List<String> failures = lit == 0 ? List.of() : List.of("closed room " + unit + ": " + lit + " pixels are lit");
        return ProofResult.of(0, failures, Figure.sum("lit pixels of closed rooms", lit, ""));
    }

    /** Returns the number of lit pixels, seen from inside a room that is closed except for a gap under its ceiling. */
    static int litPixels(long unit, double gapMetres, GlContext gl, RenderTarget picture) {
        var room = new DarkRoom(unit / 5, gapMetres);
        Vec3[] camera = room.camera((int) (unit % 5));
        View view = Viewpoints.between(camera[0], camera[1], FOV_DEGREES, (double) WIDTH / HEIGHT);
        float[] radiance = radiance(room.level(), view, gl, picture);
        int lit = 0;
        for (int i = 0; i < radiance.length; i += 3) {
            lit += radiance[i] > 0 ? 1 : 0;
        }
        return lit;
    }

    private static float[] radiance(Level level, View view, GlContext gl, RenderTarget picture) {
        var settings = RenderSettings.of(Output.HDR, Quality.HIGH.with("samples", 1));
        var assets = new ResourceAssets(LevelAssets.JAR_LEVELS);
        try (var renderer = LevelRenderer.load(gl, level, assets, settings)) {
            renderer.draw(view, picture);
            gl.requireNoError("shadows");
            return renderer.readRadiance();
        }
    }

    /** Returns 0 if the ray agrees, else the distance across the light, in texels, to a place at which a ray agrees. */
    private static double offTexels(ShadowScene scene, VisibleSurface sight, boolean isLit) {
        Vec3 towards = scene.towardsLight(sight.place());
        if (sight.isLit(Vec3.ZERO, towards, scene.limit()) == isLit) {
            return 0;
        }
        Vec3 unit = Directions.unit(towards);
        Vec3 across = Directions.perpendicular(unit);
        Vec3 up = unit.cross(across);
        double texel = scene.texelMetres(sight.place());
        for (double radius : RADII) {
            for (int i = 0; i < DIRECTIONS; i++) {
                double x = radius * texel * StrictMath.cos(2 * Math.PI * i / DIRECTIONS);
                double y = radius * texel * StrictMath.sin(2 * Math.PI * i / DIRECTIONS);
                Vec3 shift = Directions.combined(across, x, up, y);
                if (sight.isLit(shift, towards, scene.limit()) == isLit) {
                    return radius;
                }
            }
        }
        return Double.POSITIVE_INFINITY;
    }
}
